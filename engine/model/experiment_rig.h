#pragma once
// The geometry of an experiment: its source, its mounted objects and its robot, for view factors.

#include "engine/control/rig_geometry.h"
#include "engine/model/experiment.h"

#include <memory>

namespace bask {

/// Returns the geometry of an experiment that validates.
std::shared_ptr<const RigGeometry> rigGeometry(const Experiment& experiment);

} // namespace bask
