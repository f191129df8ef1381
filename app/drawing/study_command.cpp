// bask study: which study. A shard of one, which draws nothing, is a command of its own (study_work.cpp).

#include "app/commands/command_line.h"
#include "app/drawing/studies.h"

namespace bask {
namespace {

int run(const StudyRequest& request, const StudyWay& way) {
    if (const auto* viewFactor = std::get_if<ViewFactorRequest>(&request.study))
        return viewFactorStudyCommand(*viewFactor, request.folder);
    if (const auto* closedLoop = std::get_if<ClosedLoopRequest>(&request.study))
        return closedLoopStudyCommand(*closedLoop, request.folder, way);
    return alarmStudyCommand(std::get<AlarmRequest>(request.study), request.folder, way);
}

} // namespace

int studyCommand(const QStringList& arguments) {
    const AskedStudy asked = readStudy(arguments);
    if (const int* exitCode = std::get_if<int>(&asked))
        return *exitCode;
    const auto& request = std::get<StudyRequest>(asked);
    return run(request, {request.shard.threads, nullptr});
}

int mergeStudy(const MergedParts& parts, const nlohmann::json& work, const QString& folder) {
    const AskedStudy asked = readMergedStudy(work, folder);
    const auto* request = std::get_if<StudyRequest>(&asked);
    return request != nullptr ? run(*request, {0, &parts}) : std::get<int>(asked);
}

} // namespace bask
