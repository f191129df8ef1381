#pragma once
// A run on the experiment's own rig in real time, without a window: `bask run --live`.

#include "app/commands/live_place.h"
#include "engine/runtime/simulated_run.h"

namespace bask {

/// Makes the robot's position sure as told, resets the start-up fault of a real rig, arms and starts. Ends,
/// by Stop and the retreat, when all objects have been settled for kSettledFor_s, or after the duration.
/// SIGINT and SIGTERM stop the run, a second one is STOP. The final temperatures are the measured ones.
/// Errors: a rig that is not ready within a minute, with its reasons; refused verbs.
Result<RunOutcome> runLive(const Experiment& experiment, const SimulatedRunOptions& options,
                           const LiveStart& start);

} // namespace bask
