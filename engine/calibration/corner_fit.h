#pragma once
// Fits the pose of a part for which the distances between shown and seen corners are smallest.

#include "engine/calibration/camera_model.h"
#include "engine/calibration/pose_covariance.h"

#include <optional>
#include <span>

namespace bask {

struct SeenCorner {
    Eigen::Vector3d p_PQ = Eigen::Vector3d::Zero();
    Eigen::Vector2d seen_px = Eigen::Vector2d::Zero();
    double weight = 1.0; ///< number of pictures of which it is the mean
};

struct CornerFit {
    Pose X_CP = Pose::Identity();
    double squares_px2 = 0.0; ///< weighted sum of the squared distances
    /// Weighted sum of J^T J by the displacement of X_CP (pose_covariance.h). Its inverse, times the variance
    /// of a corner's coordinate in one picture, is the covariance.
    Matrix6d information = Matrix6d::Zero();
};

/// Returns the distance between the seen and the shown corner; infinite behind the camera.
double missOf(const SeenCorner& corner, const CameraModel& camera, const Pose& X_CP);

/// Fits from `start` with Ceres and exact derivatives. With `robust_px`, larger distances get decreasing
/// weight (Cauchy's loss); `squares_px2` and `information` are computed without it. Empty if a corner starts
/// behind the camera or the corners do not determine a pose.
std::optional<CornerFit> fitCorners(std::span<const SeenCorner> corners, const CameraModel& camera,
                                    const Pose& start, std::optional<double> robust_px = std::nullopt);

/// The corners in front of the camera at this pose, linearised for one step of least squares.
struct CornerSums {
    Matrix6d information = Matrix6d::Zero(); ///< as in CornerFit
    Vector6d gradient = Vector6d::Zero();    ///< weighted sum of J^T times (seen - shown)
    double squares_px2 = 0.0;
};
CornerSums cornerSums(std::span<const SeenCorner> corners, const CameraModel& camera, const Pose& X_CP);

} // namespace bask
