#include "app/studies/paper_experiments.h"

#include "app/studies/reproduction_plots.h"
#include "app/studies/study_output.h"
#include "engine/base/json_text.h"
#include "engine/base/message_code.h"
#include "engine/base/plain_text.h"
#include "engine/experiment/experiment_file.h"

#include <QDir>

#include <nlohmann/json.hpp>

#include <algorithm>

namespace bask {
namespace {

using nlohmann::json;

constexpr std::uintmax_t kMaxBytes = 1U << 20;
constexpr RunEnding kEndings[] = {RunEnding::Settled, RunEnding::NotSettled, RunEnding::Compromise,
                                  RunEnding::Fault};

constexpr const char* kAtTheEdge = "at the edge";
constexpr double kEdge_K = 1.0;

/// A word that names no ending; caught where the file is read.
struct UnknownEnding {
    std::string word;
};

ExpectedEnding endingFrom(const json& j) {
    const auto word = j.at("outcome").get<std::string>();
    if (word == kAtTheEdge)
        return {RunEnding::NotSettled, j.at("reason").get<std::string>(), true};
    const auto* found = std::ranges::find(kEndings, word, runEndingName);
    if (found == std::end(kEndings))
        throw UnknownEnding{word};
    return {*found, j.at("reason").get<std::string>()};
}

/// Names its files and those of its runs: no way out of the folder.
bool isFileName(const std::string& name) {
    return !name.empty() && name.front() != '.' && std::ranges::none_of(name, [](char c) {
        return c == '/' || c == '\\' || static_cast<unsigned char>(c) < 0x20;
    });
}

/// Every plot is known, and has the experiments that it shows.
Result<void> checkPlots(const PaperFigure& figure, const json& experiments, const std::string& path) {
    std::string known;
    for (const ReportPlot& plot : reportPlots())
        known += (known.empty() ? "" : ", ") + std::string(plot.name);
    for (const std::string& name : figure.plots) {
        const auto plots = reportPlots();
        const auto plot = std::ranges::find(plots, name, &ReportPlot::name);
        if (plot == plots.end())
            return Error(MessageCode::ValueUnknown, path + ": plots", {name, known});
        if (plot->showsExperiments && experiments.empty())
            return Error(MessageCode::JsonWrongType, path + ": experiments",
                         {"a list of what \"" + name + "\" is to show", "an empty list"});
    }
    return {};
}

Result<PaperExperiment> experimentFrom(const json& j, const std::string& folder) {
    PaperExperiment experiment;
    experiment.name = j.at("name").get<std::string>();
    if (!isFileName(experiment.name))
        return Error(MessageCode::JsonWrongType, folder + "/expected.json: name",
                     {"the name of a file beside it", '"' + experiment.name + '"'});
    auto read = readExperiment(folder + '/' + experiment.name + ".json");
    if (!read)
        return read.error();
    experiment.experiment = std::move(*read);
    experiment.paper = endingFrom(j.at("paper"));
    experiment.expected = {endingFrom(j.at("paper_controller")), endingFrom(j.at("level_servo"))};
    return experiment;
}

/// Empty experiments where `only` names none of them.
Result<PaperFigure> figureFrom(const json& j, const std::string& folder, const std::string& only) {
    PaperFigure figure;
    figure.name = j.at("name").get<std::string>();
    figure.title = j.at("title").get<std::string>();
    figure.paper = j.at("paper").get<std::string>();
    figure.plots = j.at("plots").get<std::vector<std::string>>();
    figure.with = j.value("with", std::vector<std::string>());
    if (auto plots = checkPlots(figure, j.at("experiments"), folder + "/expected.json"); !plots)
        return plots.error();
    for (const json& each : j.at("experiments")) {
        if (!only.empty() && only != figure.name && only != each.at("name").get<std::string>())
            continue;
        auto experiment = experimentFrom(each, folder);
        if (!experiment)
            return experiment.error();
        figure.experiments.push_back(std::move(*experiment));
    }
    return figure;
}

std::string knownNames(const json& figures) {
    std::string names;
    for (const json& figure : figures) {
        names += (names.empty() ? "" : ", ") + figure.at("name").get<std::string>();
        for (const json& experiment : figure.at("experiments"))
            names += ", " + experiment.at("name").get<std::string>();
    }
    return names;
}

Result<std::vector<PaperFigure>> figuresFrom(const json& j, const std::string& path,
                                             const std::string& folder, const std::string& only) {
    std::vector<PaperFigure> figures;
    for (const json& each : j.at("figures")) {
        auto figure = figureFrom(each, folder, only);
        if (!figure)
            return figure.error();
        if (only.empty() || only == figure->name || !figure->experiments.empty())
            figures.push_back(std::move(*figure));
    }
    if (figures.empty())
        return Error(MessageCode::ValueUnknown, only.empty() ? path : "--only",
                     {only, knownNames(j.at("figures"))});
    return figures;
}

} // namespace

bool ExpectedEnding::holds(RunEnding ended, double largestError_K) const {
    if (!atTheEdge)
        return ended == ending;
    return (ended == RunEnding::Settled || ended == RunEnding::NotSettled) && largestError_K < kEdge_K;
}

const char* ExpectedEnding::name() const {
    return atTheEdge ? kAtTheEdge : runEndingName(ending);
}

const char* runEndingName(RunEnding ending) {
    switch (ending) {
    case RunEnding::Settled:
        return "settled";
    case RunEnding::NotSettled:
        return "not settled";
    case RunEnding::Compromise:
        return "best compromise";
    case RunEnding::Fault:
        return "fault";
    }
    return "";
}

Result<std::vector<PaperFigure>> readPaperFigures(const std::string& folder, const std::string& only) {
    const std::string path = folder + "/expected.json";
    const auto text = readTextFile(path, kMaxBytes);
    if (!text)
        return text.error();
    try {
        Result<std::vector<PaperFigure>> figures = Error();
        const Failure failed = readJsonTree(
            *text, path, [&](const json& j, Failure&) { figures = figuresFrom(j, path, folder, only); });
        return failed ? *failed : figures;
    } catch (const UnknownEnding& unknown) {
        std::string known;
        for (const RunEnding ending : kEndings)
            known += std::string(runEndingName(ending)) + ", ";
        known += kAtTheEdge;
        return Error(MessageCode::ValueUnknown, path + ": outcome", {unknown.word, known});
    }
}

Result<std::string> unpackPaperExperiments(const QString& folder) {
    QStringList names{QStringLiteral("contours/bunny_1200.png"), QStringLiteral("contours/hand_1200.png")};
    for (const QString& name : studyResources(QStringLiteral("paper")))
        names << QStringLiteral("paper/") + name;
    if (const auto copied = copyStudyFiles(folder, names); !copied)
        return copied.error();
    return QDir(folder).filePath(QStringLiteral("paper")).toStdString();
}

} // namespace bask
