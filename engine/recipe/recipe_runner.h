#pragma once
// Runs a recipe: decides the next command to the engine from the engine's snapshots.

#include "engine/recipe/recipe.h"
#include "engine/runtime/command.h"
#include "engine/runtime/snapshot.h"

#include <functional>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace bask {

/// The state of a step.
struct RecipeProgress {
    enum class State {
        Waiting,    ///< not started yet
        Underway,   ///< from loading its experiment to the end of its retreat
        Done,       ///< its condition was reached
        NotReached, ///< not reached within at_most_s
        Failed,     ///< it could not be started, or a fault or an alarm ended it: see `reason`
        Stopped,    ///< by a person
        Paused,     ///< paused by a person: its run has not ended, and is not monitored any more
    };
    State state = State::Waiting;
    double elapsed_s = 0.0; ///< since Start, or since the beginning of the wait
    Message reason;
    std::string recording; ///< session file of a run; empty: none
};

/// How the recipe ended.
enum class RecipeEnd {
    None, ///< it has not ended
    Done,
    StepFailed, ///< a step was not reached or failed; all others are done or not started
    Stopped,    ///< as requested by stopNow or stopAfterStep
    TakenOver,  ///< a person paused or stopped the run, or loaded something else
    Alarm,      ///< an alarm that is not a notice
    Fault,
};

/// Returns whether a fault's reason only says that a rig was just connected: a person may reset it.
bool isNotThereYet(MessageCode code);

/// Does no input or output; time comes from the rig, with the snapshots. Every run uses Arm and Start, as a
/// person would, and ends by Stop, with the heat off; waits are at rest. A hold, stop, fault or alarm that
/// the recipe has not requested ends it, and it never resets a fault. Commands must be sent to the engine in
/// their order.
class RecipeRunner {
public:
    /// Returns the session file for a step's run; empty: it is not recorded. An error fails the step.
    using RecordingPath = std::function<Result<std::string>(std::size_t step)>;

    /// Takes a recipe with at least one run, with its experiments (readExperiments).
    RecipeRunner(Recipe recipe, RecipeExperiments experiments, RecordingPath recordingPath);

    /// Starts the recipe; `now` is the engine's last snapshot.
    std::vector<Command> begin(const Snapshot& now);
    std::vector<Command> take(const Snapshot& snapshot);
    std::vector<Command> stopNow();
    /// Call when a person stops or pauses the rig: no further command is sent, not even for snapshots from
    /// before.
    void takeOver(bool isHold = false);
    void setStopAfterStep(bool isWanted) { m_isLast = isWanted; }
    bool stopsAfterStep() const { return m_isLast; }
    /// If set, the open experiment must not be replaced: the recipe ends where another one would be loaded.
    void setKeepsExperiment(bool isKept) { m_keepsExperiment = isKept; }

    const Recipe& recipe() const { return m_recipe; }
    const std::vector<RecipeProgress>& progress() const { return m_progress; }
    std::size_t step() const { return m_step; } ///< in progress, or the last one that was
    bool isOver() const { return m_phase == Phase::Over; }
    RecipeEnd end() const { return m_phase == Phase::Over ? m_end : RecipeEnd::None; }
    const Message& reason() const { return m_reason; } ///< reason of the end; None: there is none

    /// `Load` lasts until the rig is ready; `Stop` means heat off and retreat.
    enum class Phase { Load, Arm, Start, Run, Stop, Wait, Over };
    Phase phase() const { return m_phase; }

private:
    using State = RecipeProgress::State;

    const RecipeStep& now() const { return m_recipe.steps[m_step]; }
    void enter(std::size_t step);
    void loading(const Snapshot& snapshot);
    void ready(const Snapshot& snapshot);
    void arming(const Snapshot& snapshot);
    void starting(const Snapshot& snapshot);
    bool isEndedBefore(const Snapshot& snapshot);
    void running(const Snapshot& snapshot);
    void stopping(const Snapshot& snapshot);
    void waiting(const Snapshot& snapshot);
    bool isReached(const TraceSample& sample, double time_s);
    const Alarm* newAlarm(const Snapshot& snapshot) const;
    void remember(const std::vector<Alarm>& alarms);
    void failed(const Message& reason);
    void stopRun(State state, Message reason = {});
    void endBy(const Snapshot& snapshot, RecipeEnd end, const Message& reason);
    void finish(State state, const Message& reason = {});
    void goOn();
    void finishAll(State state, RecipeEnd end, const Message& reason = {});

    Recipe m_recipe;
    RecipeExperiments m_experiments;
    RecordingPath m_recordingPath;
    std::vector<RecipeProgress> m_progress;
    std::vector<Command> m_orders;
    Phase m_phase = Phase::Over;
    RecipeEnd m_end = RecipeEnd::None;
    Message m_reason;
    std::size_t m_step = 0;
    std::shared_ptr<const Experiment> m_loaded;
    std::uint64_t m_loadId = 0;
    bool m_isAnswered = false; ///< whether the experiment has been loaded
    double m_since_s = 0.0;    ///< start of the phase by the rig's clock
    double m_within_s = 0.0;   ///< since when all objects are within the band
    bool m_isWithin = false;
    std::set<std::pair<std::uint64_t, int>> m_knownAlarms;
    bool m_isLast = false, m_keepsExperiment = false;
};

} // namespace bask
