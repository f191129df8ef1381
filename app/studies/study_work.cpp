#include "app/studies/study_work.h"

#include "app/commands/command_line.h"
#include "app/commands/parse_command.h"
#include "app/studies/paper_experiments.h"
#include "engine/base/hidden_folder.h"
#include "engine/experiment/experiment_file.h"
#include "engine/studies/row_bytes.h"

#include <QDir>

namespace bask {
namespace {

/// Rigs of the program's own, by their files' names.
Result<std::vector<Experiment>> ownRigs(const QStringList& names) {
    const auto folder = HiddenFolder::temporary();
    if (!folder)
        return folder.error();
    const auto copied = copyStudyFiles(QString::fromStdString(folder->path()), names);
    if (!copied)
        return copied.error();
    std::vector<Experiment> rigs;
    for (const QString& name : names) {
        auto rig = readExperiment(folder->place(name.toStdString()));
        if (!rig)
            return rig.error();
        rigs.push_back(std::move(*rig));
    }
    return rigs;
}

Result<std::vector<Experiment>> paperRigs() {
    const auto folder = HiddenFolder::temporary();
    if (!folder)
        return folder.error();
    const auto unpacked = unpackPaperExperiments(QString::fromStdString(folder->path()));
    if (!unpacked)
        return unpacked.error();
    auto figures = readPaperFigures(*unpacked, {});
    if (!figures)
        return figures.error();
    std::vector<Experiment> rigs;
    for (PaperFigure& figure : *figures)
        for (PaperExperiment& each : figure.experiments)
            rigs.push_back(std::move(each.experiment));
    return rigs;
}

Result<std::string> caseBytes(const ClosedLoopStudy& study, int index) {
    const auto row = runClosedLoopCase(study, index);
    return row ? Result<std::string>(bytesOf(*row)) : row.error();
}

Result<std::string> caseBytes(const AlarmStudy& study, int index) {
    return bytesOf(runAlarmCase(study, index));
}

template <class Request>
int runShardOf(const Request& request, const QString& folder, const ShardOptions& shard) {
    const StudyNames names = namesOf(request);
    if (!studyFiles("study", folder, names))
        return kExitBadInput;
    const auto study = studyOf(request);
    if (!study)
        return refuseStudy(study.error());
    if (const auto valid = check(*study); !valid)
        return refuseStudy(valid.error());
    const auto compute = [&](std::int64_t index) { return caseBytes(*study, static_cast<int>(index)); };
    return runShard("study", QDir(folder).filePath(QLatin1String(names.stem)).toStdString(),
                    {request.asked, request.count, "runs", compute}, shard);
}

} // namespace

StudyNames namesOf(const ClosedLoopRequest&) {
    return {"closed_loop_study",
            "Bask closed-loop study",
            {".csv", "_settling.png", "_ratio.png", "_overshoot.png"}};
}

StudyNames namesOf(const AlarmRequest& request) {
    static constexpr const char* kStems[] = {"alarm_study_healthy", "alarm_study_faulty",
                                             "alarm_study_paper"};
    return {kStems[static_cast<int>(request.draw)], "Bask alarm study", {".csv"}};
}

Result<ClosedLoopStudy> studyOf(const ClosedLoopRequest& request) {
    static constexpr StudyMountings kMountings[] = {StudyMountings::AsGiven, StudyMountings::AsGiven,
                                                    StudyMountings::InPlane, StudyMountings::Heights};
    auto rigs = ownRigs({request.mounting == StudyMounting::Line ? "line.json" : "triangle.json"});
    if (!rigs)
        return rigs.error();
    ClosedLoopStudy study{std::move(rigs->front()),
                          kMountings[static_cast<std::size_t>(request.mounting)],
                          request.count,
                          request.seed,
                          request.convection_W_m2K,
                          request.sensorLag_s,
                          request.robotLatency_s,
                          request.uneven};
    study.rig.controller.kind = request.controller;
    study.rig.controller.estimatedRateErrorFactor = request.rateError;
    study.rig.source.model = request.sourceModel;
    return study;
}

Result<AlarmStudy> studyOf(const AlarmRequest& request) {
    auto rigs = request.draw == AlarmDraw::Paper ? paperRigs() : ownRigs({"triangle.json", "line.json"});
    if (!rigs)
        return rigs.error();
    return AlarmStudy{std::move(*rigs), request.draw,  request.count,
                      request.seed,     request.first, request.readBy};
}

std::optional<int> studyShardCommand(const QStringList& arguments) {
    const AskedStudy asked = readStudy(arguments);
    if (const int* exitCode = std::get_if<int>(&asked))
        return *exitCode;
    const auto& [study, folder, shard] = std::get<StudyRequest>(asked);
    if (!shard.shard)
        return std::nullopt;
    if (const auto* closedLoop = std::get_if<ClosedLoopRequest>(&study))
        return runShardOf(*closedLoop, folder, shard);
    return runShardOf(std::get<AlarmRequest>(study), folder, shard);
}

} // namespace bask
