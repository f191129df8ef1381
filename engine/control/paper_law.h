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

/// Leads out of the dark: where no object sees the source, no motion changes a view factor, and both laws
/// stand for ever. If one is colder than its target then, `out` goes towards the pose that faces the source
/// instead. (One that is dark beside another that is lit is left to the law.)
void leaveDark(const RigGeometry& geometry, const Observation& observation, const ViewFactors& seen,
               const std::vector<double>& targets_K, double dt_s, ControlOutput& out);

} // namespace bask
