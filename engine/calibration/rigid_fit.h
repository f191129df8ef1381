#pragma once
// Unknowns from many rigid things that are each seen with corners' noise and sit each a little elsewhere than
// they are said to: markers on a part, a robot at its poses.

#include "engine/calibration/pose_covariance.h"

#include <vector>

namespace bask {

struct RigidSight {
    Vector6d moved = Vector6d::Zero();                   ///< displacement that its corners ask for
    Matrix6d noise = Matrix6d::Zero();                   ///< covariance of that by the corners' noise
    Eigen::Matrix<double, 6, Eigen::Dynamic> byUnknowns; ///< displacement by the unknowns
};

struct RigidFit {
    Eigen::VectorXd unknowns;
    Eigen::MatrixXd covariance;
    double position_m = 0.0,
           angle_rad = 0.0; ///< standard deviations of each thing's own displacement, an axis
};

/// 99.9 % of sums of so many squared normal deviates are below (Wilson and Hilferty 1931).
double chiSquareBound(double freedom);

/// Generalised least squares with the two deviations by restricted maximum likelihood (expectation
/// maximisation, Laird and Ware 1982), and what few things do not tell of those in the covariance. At least
/// one thing more than determine the unknowns.
RigidFit fitRigid(const std::vector<RigidSight>& sights);

} // namespace bask
