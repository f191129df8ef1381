#pragma once
// The geometry of an experiment: its source, its objects as mounted and its robot, ready for view factors.

#include "engine/control/rig_geometry.h"
#include "engine/model/experiment.h"

#include <memory>

namespace bask {

/// Of an experiment that validates.
std::shared_ptr<const RigGeometry> rigGeometry(const Experiment& experiment);

} // namespace bask
