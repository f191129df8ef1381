#pragma once
// A run on the experiment's own rig in real time, without a window: `bask run --live`.

#include "app/commands/live_place.h"
#include "engine/runtime/simulated_run.h"

namespace bask {

/// Makes the robot's place sure as it is told to, resets what a start on a real rig is faulted with, arms,
/// starts; ends when all have been settled for kSettledFor_s or after the duration, by Stop and the retreat.
/// SIGINT and SIGTERM stop it, the second one is STOP. The objects' final temperatures are those measured.
/// Errors: a rig that is not ready within a minute, with its reasons; refused verbs.
Result<RunOutcome> runLive(const Experiment& experiment, const SimulatedRunOptions& options, LivePlace place);

} // namespace bask
