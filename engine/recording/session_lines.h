#pragma once
// A recorded run as lines in space: trajectories of objects and end-effector, and outlines at a time.

#include "engine/exchange/poly_file.h"
#include "engine/recording/session_file.h"

namespace bask {

/// See exportVtk for the contents.
PolyLines objectTrajectories(const SessionRecord& session);
PolyLines endEffectorTrajectory(const SessionRecord& session);
PolyLines outlinesAt(const SessionRecord& session, const TraceSample& sample);

} // namespace bask
