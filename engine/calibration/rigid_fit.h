#pragma once
// Estimates common unknowns from many rigid bodies. Each is seen with corner noise, and is slightly displaced
// from its nominal pose: markers on a part, a robot at its poses.

#include "engine/calibration/pose_covariance.h"

#include <vector>

namespace bask {

struct RigidSight {
    Vector6d moved = Vector6d::Zero();                   ///< displacement that fits its corners
    Matrix6d noise = Matrix6d::Zero();                   ///< its covariance by the noise of the corners
    Eigen::Matrix<double, 6, Eigen::Dynamic> byUnknowns; ///< derivative of the displacement by the unknowns
};

struct RigidFit {
    Eigen::VectorXd unknowns;
    Eigen::MatrixXd covariance;
    double position_m = 0.0,
           angle_rad = 0.0; ///< standard deviation of each body's own displacement, for each axis
};

/// Returns the bound below which 99.9 % of sums of this many squared normal deviates are (Wilson and Hilferty
/// 1931).
double chiSquareBound(double freedom);

/// Generalised least squares, with the two deviations by restricted maximum likelihood (expectation
/// maximisation, Laird and Ware 1982). The covariance includes the uncertainty of the deviations if there are
/// few bodies. Needs at least one body more than the number that determines the unknowns.
RigidFit fitRigid(const std::vector<RigidSight>& sights);

} // namespace bask
