#pragma once
// What an experiment says of its rig: the geometry for view factors, the surroundings for heat rates.

#include "engine/control/rig_geometry.h"
#include "engine/model/experiment.h"

#include <memory>

namespace bask {

/// Returns the geometry of an experiment that validates.
std::shared_ptr<const RigGeometry> rigGeometry(const Experiment& experiment);

/// Returns what the objects exchange radiation with, at the source's set temperature and an environment, K.
Surroundings surroundingsOf(const Experiment& experiment, double environment_K);
/// Same in the environment that the experiment states.
Surroundings surroundingsOf(const Experiment& experiment);

} // namespace bask
