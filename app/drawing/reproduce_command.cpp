// bask reproduce: the paper's experiments by the paper's controllers and by the level servo, as one report.

#include "app/commands/command_line.h"
#include "app/commands/parse_command.h"
#include "app/commands/progress.h"
#include "app/drawing/reproduction_report.h"
#include "app/studies/study_output.h"
#include "engine/base/hidden_folder.h"
#include "engine/base/whole_file.h"

#include <QCommandLineParser>

#include <algorithm>
#include <cstdio>
#include <unistd.h>

namespace bask {
namespace {

constexpr const char* kCommand = "reproduce";
constexpr std::size_t kReport = 0; // index of the report among the files

/// All that is asked for, each experiment once, in the figures' order.
std::vector<PaperExperiment> experimentsOf(const std::vector<PaperFigure>& figures) {
    std::vector<PaperExperiment> all;
    for (const PaperFigure& figure : figures)
        all.insert(all.end(), figure.experiments.begin(), figure.experiments.end());
    return all;
}

/// The report, then the runs in pairs.
QStringList fileNames(const std::vector<PaperExperiment>& experiments) {
    QStringList names{QStringLiteral("report.html")};
    for (const PaperExperiment& each : experiments)
        for (const ControllerKind kind : {each.experiment.controller.kind, ControllerKind::LevelServo})
            names << QString::fromStdString(each.name + '_' + kind.key() + ".csv");
    return names;
}

Result<std::vector<ReportFigure>> drawn(const std::vector<PaperFigure>& figures,
                                        const std::vector<ReproducedExperiment>& results) {
    std::vector<ReportFigure> out;
    std::size_t next = 0;
    for (const PaperFigure& figure : figures) {
        ReportFigure& report = out.emplace_back();
        report.figure = &figure;
        for (std::size_t k = 0; k < figure.experiments.size(); ++k)
            report.experiments.push_back(&results[next++]);
        auto shown = report.experiments;
        for (const ReproducedExperiment& each : results)
            if (std::ranges::find(figure.with, each.paper.name) != figure.with.end())
                shown.push_back(&each);
        for (const std::string& plot : figure.plots) {
            std::fprintf(stderr, "drawing %s, %s\n", figure.name.c_str(), plot.c_str());
            auto pictures = reportPictures(plot, shown);
            if (!pictures)
                return pictures.error();
            std::ranges::move(*pictures, std::back_inserter(report.pictures));
        }
    }
    return out;
}

/// All or nothing, in the order of fileNames().
Result<void> writeAll(const std::vector<ReproducedExperiment>& results, const std::string& report,
                      const std::vector<OutputFile>& files) {
    std::vector<WholeFile> whole{{files[kReport].path, report}};
    for (const ReproducedExperiment& each : results)
        for (const std::size_t by : {kByThePaper, kByTheLevelServo})
            whole.push_back({files[whole.size()].path, reproductionCsv(each, by, kReproductionMark)});
    return writeWholeFiles(whole);
}

/// The table on standard output. Returns whether everything is as recorded.
bool printSummary(const std::vector<ReproducedExperiment>& results) {
    bool allExpected = true;
    if (!results.empty())
        std::printf("%-34s %-12s %-16s %9s %8s  %s\n", "experiment", "controller", "outcome", "settled_s",
                    "x_bound", "final errors (K)");
    for (const ReproducedExperiment& each : results)
        for (const std::size_t by : {kByThePaper, kByTheLevelServo}) {
            const ReproducedRun& run = each.runs[by];
            std::string settled = "-", ratio = "-";
            if (run.settling_s) {
                settled = formatNumber(*run.settling_s, 6);
                ratio = formatNumber(*run.settling_s / each.bound.bound_s, 3);
            }
            std::printf("%-34s %-12s %-16s %9s %8s  %s\n", each.paper.name.c_str(), run.controller.key(),
                        runEndingName(run.ending), settled.c_str(), ratio.c_str(),
                        finalErrorWords(run).c_str());
        }
    for (const ReproducedExperiment& each : results)
        for (const std::size_t by : {kByThePaper, kByTheLevelServo})
            if (!each.asExpected(by)) {
                allExpected = false;
                std::printf("not as recorded: %s, %s: %s instead of %s\n", each.paper.name.c_str(),
                            each.runs[by].controller.key(), runEndingName(each.runs[by].ending),
                            each.paper.expected[by].name());
            }
    if (allExpected && !results.empty())
        std::printf("all outcomes are as recorded\n");
    return allExpected;
}

int reproduceInto(const QString& folder, const std::vector<PaperFigure>& figures) {
    const std::vector<PaperExperiment> experiments = experimentsOf(figures);
    const auto files = filesIn(folder, kCommand, kReproductionMark, fileNames(experiments));
    if (!files)
        return kExitBadInput;
    std::optional<Progress> progress;
    const auto results = reproduce(experiments, 0, [&](int done, int all) {
        if (!progress)
            progress.emplace(all, "runs");
        progress->tell(done);
    });
    progress.reset();
    if (!results)
        return refuse(kCommand, results.error());
    const auto report = drawn(figures, *results);
    if (!report)
        return refuse(kCommand, report.error());
    if (const auto written = writeAll(*results, reproductionHtml(*report), *files); !written)
        return refuse(kCommand, written.error());
    std::fprintf(stderr, "wrote %s and the runs beside it\n", (*files)[kReport].path.c_str());
    return printSummary(*results) ? kExitDone : kExitNegative;
}

/// From the folder that is named, or from the program itself. What is unpacked is gone before the runs, which
/// may be interrupted.
Result<std::vector<PaperFigure>> figuresOf(const QCommandLineParser& parser) {
    const std::string only = parser.value("only").toStdString();
    if (parser.isSet("experiments"))
        return readPaperFigures(parser.value("experiments").toStdString(), only);
    const auto unpacked = HiddenFolder::temporary();
    if (!unpacked)
        return unpacked.error();
    const auto from = unpackPaperExperiments(QString::fromStdString(unpacked->path()));
    return from ? readPaperFigures(*from, only) : from.error();
}

} // namespace

int reproduceCommand(const QStringList& arguments) {
    QCommandLineParser parser;
    parser.setApplicationDescription(
        "Runs the paper's experiments on the simulated rig, by the paper's controllers and by the level "
        "servo,\n"
        "and writes one report with the paper's figures, and each run as CSV.\n"
        "Exit code: 0 every outcome is the recorded one, 2 bad input or unwritable output, 3 some are not.");
    parser.addOptions({{{"h", "help"}, "Displays this help."},
                       {{"o", "output"}, "Folder for the files; made if it is not there. Required.", "DIR"},
                       {"only", "One figure or one experiment; an unknown name lists them.", "NAME"},
                       {"experiments", "Take expected.json and the experiments from this folder.", "DIR"}});
    if (const auto code = parseCommand(parser, kCommand, arguments, 0))
        return *code;
    const QString folder = parser.value("output");
    if (folder.isEmpty())
        return refuse(kCommand, QStringLiteral("-o DIR is needed"));
    const auto figures = figuresOf(parser);
    if (!figures)
        return refuse(kCommand, figures.error());
    return reproduceInto(folder, *figures);
}

} // namespace bask
