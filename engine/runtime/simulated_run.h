#pragma once
// A whole run on the simulated rig, as fast as the computer can; used by `bask run` and by the whole-engine
// tests.

#include "engine/model/predicted_run.h"
#include "engine/runtime/lateness.h"
#include "engine/runtime/servo_loop.h"
#include "engine/simulation/simulated_rig.h"

#include <functional>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

namespace bask {

struct SimulatedRunOptions {
    std::optional<double>
        duration_s; ///< empty: until all have been settled for kSettledFor_s, at most the experiment's limit
    std::string sessionPath; ///< empty: the run is not recorded
    /// called for every sample; may be empty
    std::function<void(double time_s, const TraceSample&)> progress;
    /// ends the run at once; before Start the outcome is empty, and nothing is recorded
    std::stop_token stop = {};
    bool mayReplace = false; ///< an earlier recording of that name
    RunLabels labels = {};
    /// where the simulated rig begins; empty: at its start, as cold as the room
    std::optional<RigCondition> from{};
};

/// Outcome for one object, judged by the plant's true temperature.
struct ObjectOutcome {
    std::string name;
    double target_K = 0.0;
    double final_K = 0.0;
    std::optional<double> settlingTime_s;
};

struct RunOutcome {
    std::vector<ObjectOutcome> objects;
    /// all objects are in the band for at least the last kInBandFor_s (or the whole of a shorter run)
    bool settled = false;
    double simulated_s = 0.0;
    std::vector<TraceEvent> events;
    bool fault = false;     ///< the loop ended in a fault; the reasons are in the events
    bool isStopped = false; ///< an alarm ended the run
    /// lateness of the control steps, from Start to Stop; without steps on a simulated rig
    Lateness lateness;
};

/// longest time that a recorded fault is followed until the objects are cold
inline constexpr double kFaultRecord_s = 3600.0;
inline constexpr double kSettledFor_s = 120.0; ///< a run without a duration ends after this time in the band
/// so that only passing through the band at the end is not settled
inline constexpr double kInBandFor_s = 30.0;

/// Zeroes the sensors, fills the estimators, starts and runs to the end. Errors: an experiment that does not
/// validate, a session that cannot be written.
Result<RunOutcome> runSimulated(const Experiment& experiment, const SimulatedRunOptions& options);

/// Predicts a run of the experiment's controller by a whole run on the simulated rig, without its faults and
/// with materials, air, source and thermal camera as the experiment assumes them. `from` is where the rig is
/// now; empty: at its start, as cold as the room. Objects that are warm cool for the seconds in which the
/// estimators fill. Ends as runSimulated does; if it was stopped, the samples end there (none before Start).
/// Takes a few seconds for a thousand simulated seconds; `progress` is told how many of them have passed.
/// Errors: those of runSimulated.
Result<PredictedRun> predictedRun(const Experiment& experiment, const std::optional<RigCondition>& from,
                                  std::stop_token stop = {},
                                  const std::function<void(double time_s)>& progress = {});

/// Adds to a prediction of predictedRun how far apart its temperatures lie in `draws` runs that differ from
/// it by what the seed draws, that is noise and offsets of the sensors: a controller that learns, or whose
/// law is rough, may go another way. A run that ends sooner keeps its last temperatures; one that ends in a
/// fault does not count. Adds nothing if it is stopped.
Result<void> addSpread(PredictedRun& run, const Experiment& experiment,
                       const std::optional<RigCondition>& from, int draws, std::stop_token stop = {},
                       const std::function<void(double time_s)>& progress = {});

/// Returns the time, s, after which the experiment's controller keeps all objects within kSettledBand_K of
/// their targets, by predictedRun from the start. Empty if that does not happen within the experiment's
/// duration limit, or if stopped. Errors: those of runSimulated.
Result<std::optional<double>> predictedSettling_s(const Experiment& experiment, std::stop_token stop = {},
                                                  const std::function<void(double time_s)>& progress = {});

} // namespace bask
