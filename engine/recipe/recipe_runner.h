#pragma once
// A recipe on its way: what to ask of the engine next, by what the engine tells.

#include "engine/recipe/recipe.h"
#include "engine/runtime/command.h"
#include "engine/runtime/snapshot.h"

#include <functional>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace bask {

/// What has become of a step.
struct RecipeProgress {
    enum class State {
        Waiting,    ///< its turn has not come
        Underway,   ///< from the loading of its experiment to the end of its retreat
        Done,       ///< its condition holds
        NotReached, ///< not within at_most_s
        Failed,     ///< it could not be begun, or a fault or an alarm ended it: `reason`
        Stopped,    ///< by a person
        Held,       ///< by a person: its run is not ended, and not watched any more
    };
    State state = State::Waiting;
    double elapsed_s = 0.0; ///< since Start, or of the wait
    Message reason;
    std::string recording; ///< session file of a run; empty: none
};

/// What has become of the recipe.
enum class RecipeEnd {
    None, ///< it is on
    Done,
    StepFailed, ///< some step was not reached or failed, all others are done or not begun
    Stopped,    ///< as asked for by stopNow or stopAfterStep
    TakenOver,  ///< a person held or stopped the run, or loaded something else
    Alarm,      ///< that is no notice
    Fault,
};

/// Whether a fault's reason only says that a rig was connected just now: whoever looks at it may reset.
bool isNotThereYet(MessageCode code);

/// Pure: time is the rig's, by snapshots. Every run goes through Arm and Start as by hand and ends by Stop,
/// with the heat off; waits are at rest. A hold, stop, fault or alarm that it has not asked for ends the
/// recipe, and it never resets a fault. Commands go to the engine in their order.
class RecipeRunner {
public:
    /// The session file for a step's run; empty: it is not recorded. An error fails the step.
    using RecordingPath = std::function<Result<std::string>(std::size_t step)>;

    /// A recipe with at least one run, with its experiments (readExperiments).
    RecipeRunner(Recipe recipe, RecipeExperiments experiments, RecordingPath recordingPath);

    /// `now`: the engine's last snapshot.
    std::vector<Command> begin(const Snapshot& now);
    std::vector<Command> take(const Snapshot& snapshot);
    std::vector<Command> stopNow();
    /// A person stops or holds the rig in this moment: nothing is asked of the engine any more, also not by
    /// what it told before.
    void takeOver(bool isHold = false);
    void setStopAfterStep(bool isWanted) { m_isLast = isWanted; }
    bool stopsAfterStep() const { return m_isLast; }
    /// What is open must not be replaced: ends where another experiment would be loaded.
    void setKeepsExperiment(bool isKept) { m_keepsExperiment = isKept; }

    const Recipe& recipe() const { return m_recipe; }
    const std::vector<RecipeProgress>& progress() const { return m_progress; }
    std::size_t step() const { return m_step; } ///< under way, or the last that was
    bool isOver() const { return m_phase == Phase::Over; }
    RecipeEnd end() const { return m_phase == Phase::Over ? m_end : RecipeEnd::None; }
    const Message& reason() const { return m_reason; } ///< of the end; None: none

    /// `Load` until the rig is ready; `Stop`: heat off, retreat.
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
    bool m_isAnswered = false; ///< the load has been carried out
    double m_since_s = 0.0;    ///< by the rig's clock: of the phase
    double m_within_s = 0.0;   ///< all within the band since
    bool m_isWithin = false;
    std::set<std::pair<std::uint64_t, int>> m_knownAlarms;
    bool m_isLast = false, m_keepsExperiment = false;
};

} // namespace bask
