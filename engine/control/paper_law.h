#pragma once
// Shared by the two laws of the paper: from demanded rates of change to a velocity within the limits.

#include "engine/control/controller.h"

namespace bask {

/// Returns the rates at which what the neighbours add to the room's T^4 changes, K4/s (N).
Eigen::VectorXd neighbourGainRates_K4_s(const RigGeometry& geometry, const Observation& observation);

/// Returns the output of a law that demands rows * rates = wanted (rows: N x 6, by the six pose coordinates).
/// The caller fills in the estimates.
ControlOutput followWanted(const RigGeometry& geometry, const ControllerSettings& settings,
                           const Observation& observation, double dt_s,
                           const Eigen::Matrix<double, Eigen::Dynamic, 6>& rows,
                           const Eigen::VectorXd& wanted);

} // namespace bask
