#pragma once
// The uncertainty of poses, in one convention.

#include "engine/base/pose.h"

namespace bask {

using Matrix6d = Eigen::Matrix<double, 6, 6>;
using Matrix12d = Eigen::Matrix<double, 12, 12>;

/// Returns X_AB displaced by [v; w] (m, rad; in A's axes, rotation about B's origin): p + v and exp(w x) R. A
/// covariance of X_AB is that of the [v; w] from the estimate to the true pose.
Pose displaced(const Pose& X_AB, const Vector6d& displacement);
/// Returns the [v; w] from one pose to another.
Vector6d displacementBetween(const Pose& from, const Pose& to);

/// Returns the matrix from the displacement of a body to that of a frame on it at `offset` from its origin
/// (same axes).
Matrix6d carriedBy(const Eigen::Vector3d& offset);

/// Two standard deviations in the worst direction, and about the worst axis.
struct PoseSpread {
    double position_m = 0.0;
    double angle_rad = 0.0;
};
PoseSpread spreadOf(const Matrix6d& covariance);

/// The displacement of X_AB = X_CA^-1 X_CB is `byA` times the displacement of X_CA plus `byB` times that of
/// X_CB.
struct BetweenJacobian {
    Matrix6d byA, byB;
};
BetweenJacobian betweenJacobian(const Pose& X_CA, const Pose& X_CB);

/// Returns the covariance of X_AB from those of two independent poses.
Matrix6d covarianceBetween(const Pose& X_CA, const Matrix6d& ofA, const Pose& X_CB, const Matrix6d& ofB);

} // namespace bask
