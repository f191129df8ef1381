#pragma once
// What the two laws of the paper share: from wanted rates of change to a velocity within the limits.

#include "engine/control/controller.h"

namespace bask {

/// Output of a law that wants rows * rates = wanted (rows: N x 6, by the six pose coordinates). The beliefs
/// are left to the caller.
ControlOutput followWanted(const RigGeometry& geometry, const ControllerSettings& settings,
                           const Observation& observation, double dt_s,
                           const Eigen::Matrix<double, Eigen::Dynamic, 6>& rows,
                           const Eigen::VectorXd& wanted);

} // namespace bask
