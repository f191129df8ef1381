#pragma once
// A recorded run as lines in space: trajectories of objects and end-effector, outlines at a moment.

#include "engine/exchange/poly_file.h"
#include "engine/recording/session_file.h"

namespace bask {

/// See exportVtk for what they hold.
PolyLines objectTrajectories(const SessionRecord& session);
PolyLines endEffectorTrajectory(const SessionRecord& session);
PolyLines outlinesAt(const SessionRecord& session, const TraceSample& sample);

} // namespace bask
