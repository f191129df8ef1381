#pragma once
// Poses (X_AB: B's frame in A), the six pose coordinates of the end-effector and their rates.

#include <Eigen/Geometry>

#include <array>

namespace bask {

using Pose = Eigen::Isometry3d;
using Vector6d = Eigen::Matrix<double, 6, 1>;

/// Order of the six pose coordinates: metres, then radians.
enum Coordinate { kX = 0, kY, kZ, kThetaX, kThetaY, kThetaZ };
inline constexpr std::array<const char*, 6> kCoordinateNames{"x", "y", "z", "theta_x", "theta_y", "theta_z"};

/// Pose from translation (m) and rotation vector (rad, axis times angle).
Pose poseFromRotationVector(const Eigen::Vector3d& translation_m, const Eigen::Vector3d& rotation_rad);

/// Interpolates between two poses: `share` is 0 at `from` and 1 at `to`. The turn is even and about one axis.
Pose poseBetween(const Pose& from, const Pose& to, double share);

/// Pose from coordinates (x, y, z, theta_x, theta_y, theta_z): R = Rz(theta_z) Ry(theta_y) Rx(theta_x).
Pose poseFromCoordinates(const Vector6d& q);

/// Coordinates of a pose, the inverse of poseFromCoordinates; theta_y in [-pi/2, pi/2].
Vector6d coordinatesFromPose(const Pose& X);

/// 3 x 3 matrix whose column k is the axis (parent frame) about which theta_k turns: w = axes * d(theta)/dt.
Eigen::Matrix3d rotationAxes(const Vector6d& q);

/// Converts a gradient by position and by rotation about the parent axes to one by the six coordinates.
Vector6d coordinateGradient(const Vector6d& q, const Vector6d& gradient);

} // namespace bask
