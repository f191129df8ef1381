#include "app/commands/recipe_command.h"

#include "app/commands/allowed_programs.h"
#include "app/commands/command_line.h"
#include "app/commands/engine_thread.h"
#include "app/commands/experiment_arguments.h"
#include "app/commands/output_file.h"
#include "app/commands/parse_command.h"
#include "app/commands/recipe_live.h"
#include "app/examples.h"
#include "engine/base/message_code.h"
#include "engine/base/unfinished.h"
#include "engine/base/units.h"
#include "engine/experiment/text_file.h"
#include "engine/model/limits_widened.h"
#include "engine/recipe/simulated_recipe.h"

#include <nlohmann/json.hpp>

#include <QDir>
#include <QElapsedTimer>
#include <QFileInfo>

#include <algorithm>
#include <cstdio>
#include <optional>
#include <set>
#include <vector>

namespace bask {
namespace {

using Until = RecipeStep::Until;
using State = RecipeProgress::State;

std::string nameOf(const RecipeStep& step) {
    return step.example.empty()
               ? QFileInfo(QString::fromStdString(step.experiment)).completeBaseName().toStdString()
               : step.example;
}

std::string seconds(double value_s) {
    return formatNumber(value_s, 6) + " s";
}

std::string conditionOf(const RecipeStep& step) {
    switch (step.until) {
    case Until::Settled:
        return "until settled for " + seconds(step.duration_s);
    case Until::Time:
        return "for " + seconds(step.duration_s);
    case Until::Above:
    case Until::Below:
        break;
    }
    return "until " + step.object + (step.until == Until::Above ? " has risen to " : " has fallen to ") +
           formatNumber(celsiusFromKelvin(step.temperature_K), 6) + " degC";
}

std::string wordsOf(const RecipeStep& step) {
    return (step.isRun() ? "run " + nameOf(step) : "wait") + ' ' + conditionOf(step);
}

const char* wordOf(State state) {
    switch (state) {
    case State::Waiting:
        return "not begun";
    case State::Underway:
        return "under way";
    case State::Done:
        return "done";
    case State::NotReached:
        return "not reached";
    case State::Failed:
        return "failed";
    case State::Stopped:
        return "stopped";
    case State::Paused:
        return "held";
    }
    return "";
}

const char* wordOf(RecipeEnd end) {
    switch (end) {
    case RecipeEnd::None:
        return "on";
    case RecipeEnd::Done:
        return "done";
    case RecipeEnd::StepFailed:
        return "not all steps done";
    case RecipeEnd::Stopped:
    case RecipeEnd::TakenOver:
        return "stopped";
    case RecipeEnd::Alarm:
        return "ended by an alarm";
    case RecipeEnd::Fault:
        return "ended by a fault";
    }
    return "";
}

/// What it is about to do.
void announce(const Recipe& recipe) {
    std::fprintf(stderr, "bask run: recipe \"%s\", %zu step%s, at most %s\n", recipe.name.c_str(),
                 recipe.steps.size(), recipe.steps.size() == 1 ? "" : "s",
                 seconds(maxDuration_s(recipe)).c_str());
    for (std::size_t i = 0; i < recipe.steps.size(); ++i) {
        const RecipeStep& step = recipe.steps[i];
        std::fprintf(stderr, "%4zu  %s%s%s\n", i + 1, wordsOf(step).c_str(),
                     step.until == Until::Time ? "" : (", at most " + seconds(step.maxDuration_s)).c_str(),
                     step.goesOn ? "; otherwise the next step" : "");
    }
}

/// Tells each step's end once.
class Teller {
public:
    void look(const RecipeRunner& runner) {
        const auto& all = runner.progress();
        for (;
             m_told < all.size() && isOver(all[m_told].state) && (m_told < runner.step() || runner.isOver());
             ++m_told) {
            const RecipeProgress& step = all[m_told];
            std::string reason;
            if (step.reason.code != MessageCode::None)
                reason = ": " + describe(step.reason);
            std::fprintf(stderr, "bask run: step %zu of %zu: %s after %s%s\n", m_told + 1, all.size(),
                         wordOf(step.state), seconds(step.elapsed_s).c_str(), reason.c_str());
        }
    }

private:
    static bool isOver(State state) { return state != State::Waiting && state != State::Underway; }
    std::size_t m_told = 0;
};

void printOutcome(const RecipeRunner& runner, double wall_s) {
    double all_s = 0.0;
    std::printf("%4s  %-12s %10s  %s\n", "step", "outcome", "s", "what");
    for (std::size_t i = 0; i < runner.progress().size(); ++i) {
        const RecipeProgress& step = runner.progress()[i];
        all_s += step.elapsed_s;
        std::printf("%4zu  %-12s %10.1f  %s%s%s\n", i + 1, wordOf(step.state), step.elapsed_s,
                    wordsOf(runner.recipe().steps[i]).c_str(), step.recording.empty() ? "" : ", ",
                    step.recording.c_str());
    }
    const std::string reason =
        runner.reason().code == MessageCode::None ? "" : " (" + describe(runner.reason()) + ")";
    std::printf("recipe: %s%s after %.0f s of its steps, %.2f s of wall time\n", wordOf(runner.end()),
                reason.c_str(), all_s, wall_s);
}

std::string summaryJson(const RecipeRunner& runner, double wall_s) {
    nlohmann::ordered_json summary;
    summary["steps"] = nlohmann::ordered_json::array();
    for (std::size_t i = 0; i < runner.progress().size(); ++i) {
        const RecipeProgress& step = runner.progress()[i];
        nlohmann::ordered_json row;
        row["what"] = wordsOf(runner.recipe().steps[i]);
        row["outcome"] = wordOf(step.state);
        row["elapsed_s"] = step.elapsed_s;
        row["reason"] = step.reason.code == MessageCode::None ? nlohmann::ordered_json()
                                                              : nlohmann::ordered_json(describe(step.reason));
        row["session"] =
            step.recording.empty() ? nlohmann::ordered_json() : nlohmann::ordered_json(step.recording);
        summary["steps"].push_back(std::move(row));
    }
    summary["outcome"] = wordOf(runner.end());
    summary["wall_s"] = wall_s;
    return summary.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) + '\n';
}

/// For the session of a step's run.
std::string recordingOf(const Recipe& recipe, std::size_t step, const QDir& folder) {
    return folder
        .filePath(QStringLiteral("%1-%2.bask")
                      .arg(step + 1, 2, 10, QLatin1Char('0'))
                      .arg(QString::fromStdString(nameOf(recipe.steps[step]))))
        .toStdString();
}

/// The first that is there already: each run would put its own in the place of an earlier one.
std::optional<std::string> earlierRecording(const Recipe& recipe, const QDir& folder) {
    for (std::size_t i = 0; i < recipe.steps.size(); ++i) {
        if (!recipe.steps[i].isRun())
            continue;
        std::string path = recordingOf(recipe, i, folder);
        const QFileInfo there(QString::fromStdString(path));
        if (there.exists() || there.isSymbolicLink())
            return path;
    }
    return std::nullopt;
}

/// The folder is there.
Result<void> checkOutputs(const RecipeRequest& request, const Recipe& recipe) {
    const std::vector<std::string> inputs{request.recipe.toStdString()};
    std::vector<OutputFile> summary;
    if (!request.summary.isEmpty())
        summary.push_back({request.summary.toStdString(), "steps", "a summary written by Bask"});
    auto fits = checkOutputs(inputs, summary);
    for (std::size_t i = 0; i < recipe.steps.size() && fits && !request.folder.isEmpty(); ++i) {
        if (!recipe.steps[i].isRun())
            continue;
        std::vector<OutputFile> outputs{{recordingOf(recipe, i, QDir(request.folder))}};
        outputs.insert(outputs.end(), summary.begin(), summary.end());
        fits = checkOutputs(inputs, outputs);
    }
    return fits;
}

/// All of one rig, which a person has looked at.
std::optional<std::string> otherRig(const RecipeExperiments& experiments) {
    for (std::size_t i = 0; i < experiments.size(); ++i) {
        const std::string place = "steps[" + std::to_string(i) + "]: ";
        if (!experiments[i]->rig)
            return place + describe(Message{MessageCode::RigMissing, {}});
        if (hasManualSource(experiments[i]->rig))
            return place + "its source is heated by hand; a recipe cannot switch it off between its steps";
        if (experiments[i]->rig != experiments.front()->rig)
            return place + "its rig is another than the first step's; a recipe runs on one rig";
    }
    return std::nullopt;
}

void runUntilSignal(RecipeRunner& runner, const RecipeWatch& watch, const RunLabels& labels) {
    const SignalCount signalCount;
    std::stop_source stop;
    const RecipeWatch look = [&](const RecipeRunner& on, const Snapshot& snapshot) {
        if (signalCount.now() > 0)
            stop.request_stop();
        watch(on, snapshot);
    };
    runSimulated(runner, look, stop.get_token(), labels);
}

} // namespace

int runRecipe(const RecipeRequest& request) {
    const std::string path = request.recipe.toStdString();
    auto recipe = readRecipe(path);
    if (!recipe)
        return refuse("run", recipe.error());
    auto experiments = readExperiments(
        *recipe, [](const std::string& name) { return readExample(QString::fromStdString(name)); });
    if (!experiments)
        return refuse("run", Error(experiments.error().code(), path + ": " + experiments.error().where,
                                   experiments.error().message.args));
    if (const auto trouble = request.isLive ? otherRig(*experiments) : std::nullopt) {
        std::fprintf(stderr, "bask run: %s: %s\n", path.c_str(), trouble->c_str());
        return kExitBadInput;
    }
    for (std::size_t i = 0; i < experiments->size() && request.isLive && !request.mayLoosenLimits; ++i)
        if (const Message loosened = limitsLoosened(widenedFromUsual(*(*experiments)[i]));
            loosened.code != MessageCode::None) {
            std::fprintf(stderr, "bask run: %s: steps[%zu]: %s: allow it with --accept-limits\n",
                         path.c_str(), i, describe(loosened).c_str());
            return kExitBadInput;
        }
    const QDir folder(request.folder);
    if (const auto there = request.folder.isEmpty() ? std::nullopt : earlierRecording(*recipe, folder)) {
        std::fprintf(
            stderr,
            "bask run: %s: it is there already and is not replaced; name another folder by --out, or "
            "move it away\n",
            there->c_str());
        return kExitBadInput;
    }
    std::vector<Unfinished> made; // a recipe without a recording leaves no empty folder
    if (!request.folder.isEmpty()) {
        std::error_code failed;
        made = makeFolders(request.folder.toStdString(), failed);
        if (failed)
            return refuse("run", Error(MessageCode::FileUnwritable, request.folder.toStdString(),
                                       {"the folder cannot be made: " + failed.message()}));
    }
    if (const auto fits = checkOutputs(request, *recipe); !fits)
        return refuse("run", fits.error());
    std::set<const Experiment*> told;
    for (const auto& experiment : *experiments)
        if (told.insert(experiment.get()).second)
            warnOfOverlaps("run", *experiment);
    announce(*recipe);
    LiveStart start{request.place};
    start.monitor = request.monitor;
    if (request.mayStartPrograms) {
        auto allowed = allowedPrograms(*experiments->front()); // all are of one rig
        if (!allowed)
            return refuse("run", allowed.error());
        start.allowed = std::move(*allowed);
    }
    RecipeRunner runner(*recipe, std::move(*experiments), [&](std::size_t step) {
        return request.folder.isEmpty() ? std::string() : recordingOf(*recipe, step, folder);
    });
    Teller teller;
    const RecipeWatch watch = [&](const RecipeRunner& on, const Snapshot& snapshot) {
        for (const TraceEvent& event : snapshot.newEvents)
            if (alarmPriority(event.message.code) > 0)
                std::fprintf(stderr, "bask run: step %zu, at %.0f s: %s\n", on.step() + 1, event.time_s,
                             describe(event.message).c_str());
        teller.look(on);
    };
    QElapsedTimer timer;
    timer.start();
    if (request.isLive)
        runLive(runner, watch, start, request.labels);
    else
        runUntilSignal(runner, watch, request.labels);
    teller.look(runner);
    const double wall_s = static_cast<double>(timer.nsecsElapsed()) * 1e-9;
    printOutcome(runner, wall_s);
    if (!request.summary.isEmpty())
        if (const auto written = writeTextFile(request.summary.toStdString(), summaryJson(runner, wall_s));
            !written)
            return refuse("run", written.error());
    if (std::ranges::any_of(runner.progress(), [](const RecipeProgress& step) {
            return step.state == State::Failed && step.reason.code == MessageCode::FileUnwritable;
        }))
        return kExitBadInput; // an output that cannot be written
    switch (runner.end()) {
    case RecipeEnd::Done:
        return kExitDone;
    case RecipeEnd::Alarm:
    case RecipeEnd::Fault:
        return kExitFault;
    default:
        return kExitNegative;
    }
}

} // namespace bask
