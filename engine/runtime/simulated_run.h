#pragma once
// A whole run on the simulated rig, as fast as the machine goes: what `bask run` and the whole-engine tests
// do.

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
    std::string sessionPath;                                         ///< empty: not recorded
    std::function<void(double time_s, const TraceSample&)> progress; ///< called every sample; may be empty
    std::stop_token stop = {};                                       ///< ends the run where it is
};

/// Outcome for one object, judged on the plant's true temperature.
struct ObjectOutcome {
    std::string name;
    double target_K = 0.0;
    double final_K = 0.0;
    std::optional<double> settlingTime_s;
};

struct RunOutcome {
    std::vector<ObjectOutcome> objects;
    bool settled = false; ///< all objects, for the last kInBandFor_s at least (or the whole of a shorter run)
    double simulated_s = 0.0;
    std::vector<TraceEvent> events;
    bool fault = false; ///< the loop ended in a fault; the reasons are in the events
    Lateness lateness;  ///< of the control steps, from Start to Stop; none on a simulated rig
};

inline constexpr double kFaultRecord_s = 3600.0; ///< a recorded fault is followed until all is cold, at most
inline constexpr double kSettledFor_s = 120.0;   ///< ends a run without a duration
inline constexpr double kInBandFor_s = 30.0;     ///< passing through the band at the end is not settled

/// Zeroes the sensors, fills the estimators, starts and runs to the end. Errors: an experiment that does not
/// validate, a session that cannot be written.
Result<RunOutcome> runSimulated(const Experiment& experiment, const SimulatedRunOptions& options);

/// When the experiment's controller has all objects within kSettledBand_K of their targets for good, by a
/// whole run on the simulated rig, s; empty: not within the experiment's duration limit, or stopped. A
/// second or a few of work for a thousand simulated seconds. Errors: those of runSimulated.
Result<std::optional<double>> predictedSettling_s(const Experiment& experiment, std::stop_token stop = {});

} // namespace bask
