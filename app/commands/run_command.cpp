#include "app/commands/command_line.h"
#include "engine/base/message_code.h"

#include "app/commands/allowed_programs.h"
#include "app/commands/engine_thread.h"
#include "app/commands/experiment_arguments.h"
#include "app/commands/live_run.h"
#include "app/commands/output_file.h"
#include "app/commands/parse_command.h"
#include "app/commands/progress.h"
#include "app/commands/recipe_command.h"
#include "engine/base/units.h"
#include "engine/experiment/experiment_file.h"
#include "engine/experiment/text_file.h"
#include "engine/model/limits_widened.h"
#include "engine/model/mounting_check.h"
#include "engine/rig/rig_setup.h"
#include "engine/runtime/simulated_run.h"

#include <nlohmann/json.hpp>

#include <QCommandLineParser>
#include <QElapsedTimer>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <optional>
#include <unistd.h>

namespace bask {
namespace {

/// Everything asked for on the command line, checked.
struct RunArguments {
    Experiment experiment;
    SimulatedRunOptions options;
    std::string summaryPath;
};

Result<void> readOutputs(const QCommandLineParser& parser, const std::string& path, RunArguments& request) {
    request.options.sessionPath = parser.value("o").toStdString();
    request.summaryPath = parser.value("summary").toStdString();
    std::vector<OutputFile> outputs;
    if (parser.isSet("o"))
        outputs.push_back({request.options.sessionPath}); // SessionWriter has its rule for what is replaced
    if (parser.isSet("summary"))
        outputs.push_back({request.summaryPath, "objects", "a summary written by Bask"});
    auto checked = checkOutputs(inputsOf(path, request.experiment), outputs);
    request.options.mayReplace = parser.isSet("overwrite");
    std::error_code isNotThere;
    const auto size = std::filesystem::file_size(request.options.sessionPath, isNotThere);
    if (checked && parser.isSet("o") && !request.options.mayReplace && !isNotThere && size > 0)
        return Error(MessageCode::FileUnwritable, request.options.sessionPath,
                     {"there is a file of that name; choose another name, or take --overwrite to replace a "
                      "recording"});
    return checked;
}

Result<RunArguments> readRunArguments(const QCommandLineParser& parser) {
    const std::string path = parser.positionalArguments().first().toStdString();
    auto experiment = readExperiment(path);
    if (!experiment)
        return experiment.error();
    RunArguments request;
    request.experiment = std::move(*experiment);
    bool ok = true;
    if (parser.isSet("seed")) {
        request.experiment.simulation.seed = parser.value("seed").toULongLong(&ok);
        if (!ok)
            return badValue("seed", parser.value("seed"), "a whole number from 0");
    }
    if (const auto targets = replaceTargets(parser, request.experiment); !targets)
        return targets.error();
    if (parser.isSet("duration")) {
        const double duration_s = parser.value("duration").toDouble(&ok);
        if (!ok || !(duration_s >= request.experiment.sampling.period_s) || duration_s > 1e7)
            return badValue("duration", parser.value("duration"),
                            "seconds, at least one sampling period and at most 1e7,");
        request.options.duration_s = duration_s;
    }
    if (const auto valid = validate(request.experiment); !valid)
        return valid.error();
    if (const auto mounting = checkMounting(request.experiment); !mounting)
        return mounting.error();
    if (const auto place = readOutputs(parser, path, request); !place)
        return place.error();
    return request;
}

std::string summaryJson(const RunOutcome& outcome, double wall_s) {
    nlohmann::ordered_json summary;
    summary["objects"] = nlohmann::ordered_json::array();
    for (const ObjectOutcome& object : outcome.objects) {
        nlohmann::ordered_json row;
        row["name"] = object.name;
        row["target_C"] = celsiusFromKelvin(object.target_K);
        row["final_C"] = celsiusFromKelvin(object.final_K);
        row["error_K"] = object.final_K - object.target_K;
        row["settling_time_s"] =
            object.settlingTime_s ? nlohmann::ordered_json(*object.settlingTime_s) : nullptr;
        summary["objects"].push_back(std::move(row));
    }
    summary["settled"] = outcome.settled;
    summary["simulated_s"] = outcome.simulated_s;
    summary["wall_s"] = wall_s;
    if (const Lateness& late = outcome.lateness; late.count() > 0)
        summary["control_steps"] = {{"count", late.count()},
                                    {"late_ms_p50", 1e3 * late.quantile_s(0.5)},
                                    {"late_ms_p99_9", 1e3 * late.quantile_s(0.999)},
                                    {"late_ms_worst", 1e3 * late.worst_s()}};
    return summary.dump(2) + "\n";
}

void printOutcome(const RunOutcome& outcome, double wall_s) {
    std::printf("%-16s %10s %10s %9s %12s\n", "object", "target_C", "final_C", "error_K", "settled_at_s");
    for (const ObjectOutcome& object : outcome.objects) {
        const std::string settled = object.settlingTime_s ? formatNumber(*object.settlingTime_s, 6) : "never";
        std::printf("%-16s %10.2f %10.2f %+9.2f %12s\n", object.name.c_str(),
                    celsiusFromKelvin(object.target_K), celsiusFromKelvin(object.final_K),
                    object.final_K - object.target_K, settled.c_str());
    }
    std::printf("%s after %.0f s of the run, %.2f s of wall time\n",
                outcome.fault     ? "fault"
                : outcome.settled ? "settled"
                                  : "not settled",
                outcome.simulated_s, wall_s);
    if (const Lateness& late = outcome.lateness; late.count() > 0)
        std::printf("control steps late by %.1f ms (median), %.1f ms (99.9 %%), %.1f ms (worst of %llu)\n",
                    1e3 * late.quantile_s(0.5), 1e3 * late.quantile_s(0.999), 1e3 * late.worst_s(),
                    static_cast<unsigned long long>(late.count()));
}

void warnOfTargets(const Experiment& experiment) {
    const JointVerdict verdict = jointVerdict(experiment);
    if (verdict.feasible)
        return;
    std::string nearest;
    for (const double target_K : verdict.nearest_K)
        nearest += (nearest.empty() ? "; nearest targets that can be held: " : ", ") +
                   formatNumber(celsiusFromKelvin(target_K), 4);
    std::fprintf(stderr, "bask run: the targets cannot be held: %s%s\n", describe(verdict.reason).c_str(),
                 nearest.empty() ? "" : (nearest + " degC").c_str());
}

std::string temperatureWords(const TraceSample& sample) {
    std::string text;
    for (const ObjectSample& object : sample.objects) {
        char number[16];
        std::snprintf(number, sizeof number, "%.2f ", celsiusFromKelvin(judgedTemperature_K(object)));
        text += number;
    }
    return text + "degC";
}

/// From the first sample on: what comes before a live run takes its own time.
class RunProgress {
public:
    RunProgress(const Experiment& experiment, const SimulatedRunOptions& options)
        : m_all_s(options.duration_s.value_or(experiment.simulation.durationLimit_s)),
          m_kind(options.duration_s ? Progress::Total::Exact : Progress::Total::AtMost) {}

    void tell(double time_s, const TraceSample& sample) {
        if (!m_line)
            m_line.emplace(m_all_s, "s of the run", m_kind);
        m_line->tell(time_s, [&] { return temperatureWords(sample); });
    }

private:
    double m_all_s;
    Progress::Total m_kind;
    std::optional<Progress> m_line;
};

Result<RunOutcome> runUntilSignal(const Experiment& experiment, const SimulatedRunOptions& options) {
    const SignalCount signalCount;
    std::stop_source stop;
    SimulatedRunOptions watched = options;
    watched.stop = stop.get_token();
    RunProgress progress(experiment, options);
    watched.progress = [&](double time_s, const TraceSample& sample) {
        if (signalCount.now() > 0)
            stop.request_stop();
        progress.tell(time_s, sample);
    };
    return runSimulated(experiment, watched);
}

/// Elsewhere than on a terminal a live run writes only what has to be known.
Result<RunOutcome> runLiveShown(const Experiment& experiment, SimulatedRunOptions options,
                                const LiveStart& start) {
    RunProgress progress(experiment, options);
    if (isatty(STDERR_FILENO) != 0)
        options.progress = [&](double time_s, const TraceSample& sample) { progress.tell(time_s, sample); };
    return runLive(experiment, options, start);
}

LivePlace livePlace(const QCommandLineParser& parser) {
    return parser.isSet("home")            ? LivePlace::Home
           : parser.isSet("confirm-place") ? LivePlace::Confirmed
                                           : LivePlace::AsFound;
}

Result<MonitorSettings> readMonitor(const QCommandLineParser& parser) {
    if (!parser.isSet("monitor"))
        return MonitorSettings();
    const std::string path = parser.value("monitor").toStdString();
    auto settings = readMonitorSettings(path);
    if (settings && !settings->isOn())
        return Error(MessageCode::FileUnreadable, path, {"nothing in it is switched on"});
    return settings;
}

int refuseWords(const QString& words) {
    std::fprintf(stderr, "bask run: %s\n", qPrintable(words));
    return kExitBadInput;
}

} // namespace

int runExperimentCommand(const QStringList& arguments) {
    QCommandLineParser parser;
    parser.setApplicationDescription(
        "Runs an experiment on the simulated rig, as fast as the machine goes, or with --live on its own\n"
        "rig: the robot then moves and the source heats. Ctrl+C stops it, a second one at once.\n"
        "Judged by the simulated objects' own temperatures, with --live by the estimates from the readings.\n"
        "Exit code: 0 settled, 1 fault, 2 bad input or unwritable output, 3 not settled.");
    parser.addOption({{"h", "help"}, "Displays this help."});
    parser.addPositionalArgument("EXPERIMENT.json", "The experiment.");
    parser.addOptions(
        {{"live", "On the devices of the experiment's \"rig\", in real time."},
         {"accept-limits", "With --live: also where the experiment allows the rig more than is usual."},
         {"confirm-place", "With --live: a person has seen that the robot is where its controller says."},
         {"allow-program", "With --live: starts the programs of the rig, also where nobody has confirmed "
                           "them on this computer."},
         {"monitor", "With --live: publishes the run as this file of settings says.", "MONITOR.json"},
         {"home", "With --live: homes the robot first; it moves."},
         {"targets", "Targets in degC, one an object: 50,40,40.", "LIST"},
         {"duration", "Seconds of the run; without it the run ends when all have been settled for 120 s.",
          "SECONDS"},
         {"seed", "Seed of noise, sensor offsets and wrong estimates.", "N"},
         {"o", "Record the run into this session file.", "SESSION.bask"},
         {"overwrite", "With -o: replaces an earlier recording of that name."},
         {"operator", "Recorded: who operates.", "NAME"},
         {"sample", "Recorded: what is heated.", "NAME"},
         {"batch", "Recorded: to which the sample belongs.", "NAME"},
         {"summary", "Write the outcome as JSON.", "SUMMARY.json"},
         {"recipe",
          "Instead of one experiment those of a recipe, one after another with its waits. Exit code: 0 only\n"
          "where every step got there, 1 a fault or an alarm.",
          "RECIPE.json"},
         {"out", "Folder for the recipe's sessions, one a run: 01-NAME.bask. None of them may be there yet.",
          "DIR"}});
    const bool isRecipe = std::ranges::any_of(arguments, [](const QString& argument) {
        return argument.startsWith(QLatin1String("--recipe")) ||
               argument.startsWith(QLatin1String("-recipe"));
    });
    if (const auto code = parseCommand(parser, "run", arguments, isRecipe ? 0 : 1))
        return *code;
    for (const char* option : {"targets", "duration", "seed", "o", "overwrite"})
        if (isRecipe && parser.isSet(option))
            return refuseWords(QStringLiteral("%1 is not for recipes")
                                   .arg((option[1] == '\0' ? "-" : "--") + QLatin1String(option)));
    for (const char* option : {"home", "confirm-place", "allow-program", "accept-limits", "monitor"})
        if (parser.isSet(option) && !parser.isSet("live"))
            return refuseWords(QStringLiteral("--%1 is for --live").arg(QLatin1String(option)));
    if (parser.isSet("seed") && parser.isSet("live"))
        return refuseWords(QStringLiteral("--seed is for the simulated rig, not for --live"));
    if (parser.isSet("overwrite") && !parser.isSet("o"))
        return refuseWords(QStringLiteral("--overwrite is for -o"));
    if (parser.isSet("home") && parser.isSet("confirm-place"))
        return refuseWords(QStringLiteral("--home and --confirm-place exclude each other"));
    if (isRecipe && parser.value("recipe").isEmpty())
        return refuseWords(QStringLiteral("--recipe: the name is empty"));
    for (const char* option : {"out", "summary"})
        if (isRecipe && parser.isSet(option) && parser.value(option).isEmpty())
            return refuseWords(QStringLiteral("--%1: the name is empty").arg(QLatin1String(option)));
    for (const char* option : {"operator", "sample", "batch"})
        if (parser.isSet(option) && parser.value(option).trimmed().isEmpty())
            return refuseWords(QStringLiteral("--%1: the name is empty").arg(QLatin1String(option)));
    const RunLabels labels{parser.value("operator").toStdString(), parser.value("sample").toStdString(),
                           parser.value("batch").toStdString()};
    for (const char* option : {"operator", "sample", "batch"})
        if (parser.isSet(option) && !parser.isSet(isRecipe ? "out" : "o") && !parser.isSet("monitor"))
            return refuseWords(QStringLiteral("--%1 is for a recording (%2), or for --monitor")
                                   .arg(QLatin1String(option), QLatin1String(isRecipe ? "--out" : "-o")));
    if (const auto valid = validate(labels); !valid)
        return refuse("run",
                      Error(valid.error().code(), "--" + valid.error().where, valid.error().message.args));
    const auto monitor = readMonitor(parser);
    if (!monitor)
        return refuse("run", monitor.error());
    if (isRecipe)
        return runRecipe({parser.value("recipe"), parser.value("out"), parser.value("summary"),
                          parser.isSet("live"), livePlace(parser), parser.isSet("accept-limits"),
                          parser.isSet("allow-program"), labels, *monitor});
    if (parser.isSet("out"))
        return refuseWords(QStringLiteral("--out is for recipes; -o is the session file of one run"));
    auto request = readRunArguments(parser);
    if (!request)
        return refuse("run", request.error());
    request->options.labels = labels;
    if (parser.isSet("live") && !parser.isSet("accept-limits"))
        if (const Message loosened = limitsLoosened(widenedFromUsual(request->experiment));
            loosened.code != MessageCode::None)
            return refuseWords(QString::fromStdString(describe(loosened)) +
                               QStringLiteral(": allow it with --accept-limits"));
    warnOfOverlaps("run", request->experiment);
    warnOfTargets(request->experiment);
    const bool isLive = parser.isSet("live");
    QElapsedTimer timer;
    timer.start();
    LiveStart start{livePlace(parser)};
    start.monitor = *monitor;
    const std::optional<RigSpec>& rig = request->experiment.rig;
    if (start.place == LivePlace::Confirmed && rig && rig->robot && rig->robot->mustHome.value_or(false))
        return refuseWords(
            QStringLiteral("--confirm-place is not enough: this rig's robot must be homed; use --home"));
    if (parser.isSet("allow-program")) {
        auto allowed = allowedPrograms(request->experiment);
        if (!allowed)
            return refuse("run", allowed.error());
        start.allowed = std::move(*allowed);
    }
    const auto outcome = isLive ? runLiveShown(request->experiment, request->options, start)
                                : runUntilSignal(request->experiment, request->options);
    if (!outcome)
        return refuse("run", outcome.error());
    const double wall_s = static_cast<double>(timer.nsecsElapsed()) * 1e-9;
    for (const TraceEvent& event : outcome->events)
        if (alarmPriority(event.message.code) > 0)
            std::fprintf(stderr, "bask run: at %.0f s: %s\n", event.time_s, describe(event.message).c_str());
    printOutcome(*outcome, wall_s);
    if (!request->summaryPath.empty())
        if (const auto written = writeTextFile(request->summaryPath, summaryJson(*outcome, wall_s)); !written)
            return refuse("run", written.error());
    return outcome->fault ? kExitFault : outcome->settled ? kExitDone : kExitNegative;
}

} // namespace bask
