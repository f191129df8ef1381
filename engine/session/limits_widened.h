#pragma once
// Whether an edit allows more than before.

#include "engine/session/experiment.h"

namespace bask {

/// True if any limit of the robot, an object (of the same name) or the source is wider, or any watch slower
/// or blunter: what asks a person first on a real rig. Limits that are automatic count as what they amount
/// to.
bool widensLimits(const Experiment& before, const Experiment& after);

} // namespace bask
