#pragma once
// Fits the pose of a fixed camera in the robot's base to contours of parts that the robot holds.

#include "engine/calibration/camera_model.h"
#include "engine/calibration/pose_covariance.h"

#include <optional>
#include <span>
#include <vector>

namespace bask {

/// A point of a contour on the end-effector, and the line in the picture that it should be shown on. Along
/// that line a contour tells nothing.
struct ContourPoint {
    Eigen::Vector3d p_E = Eigen::Vector3d::Zero();
    Eigen::Vector2d seen_px = Eigen::Vector2d::Zero(); ///< a point of the line
    Eigen::Vector2d normal = Eigen::Vector2d::UnitX(); ///< of the line; length 1
    double deviation_px = 1.0;                         ///< standard deviation of `seen_px` along the normal
};

/// What was seen at one pose of the robot.
struct ContourSight {
    Pose X_RE = Pose::Identity();
    std::vector<ContourPoint> points;
};

/// Returns the distance (px) along the normal from where the point is shown to where it is seen. NaN behind
/// the camera.
double contourMiss(const ContourPoint& point, const Pose& X_RE, const CameraModel& camera, const Pose& X_RC);

/// A point's miss linearised: how it changes with the displacement of X_CE.
struct ContourJacobian {
    double miss_px = 0.0;
    Vector6d byPart = Vector6d::Zero(); ///< how far the shown point moves along the normal
};
ContourJacobian contourJacobian(const ContourPoint& point, const CameraModel& camera, const Pose& X_CE);

/// Minimises the sum of Cauchy's loss of (miss / deviation), of scale `robust`, from `start`, with Ceres and
/// exact derivatives. With `prior` (an information matrix) displacements from `start` cost, too. Empty if a
/// point starts behind the camera or the result is not finite.
std::optional<Pose> fitContours(std::span<const ContourSight> sights, const CameraModel& camera,
                                const Pose& start, double robust,
                                const std::optional<Matrix6d>& prior = std::nullopt);

} // namespace bask
