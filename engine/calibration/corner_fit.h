#pragma once
// The pose of a part that shows its corners least far from where they were seen.

#include "engine/calibration/camera_model.h"
#include "engine/calibration/pose_covariance.h"

#include <optional>
#include <span>

namespace bask {

struct SeenCorner {
    Eigen::Vector3d p_PQ = Eigen::Vector3d::Zero();
    Eigen::Vector2d seen_px = Eigen::Vector2d::Zero();
    double weight = 1.0; ///< pictures that it is the mean of
};

struct CornerFit {
    Pose X_CP = Pose::Identity();
    double squares_px2 = 0.0; ///< weighted sum of the squared distances
    /// Weighted sum of J^T J by the displacement of X_CP (pose_covariance.h): its inverse times the variance
    /// of a corner's coordinate in one picture is the covariance.
    Matrix6d information = Matrix6d::Zero();
};

/// Distance between seen and shown, infinite behind the camera.
double missOf(const SeenCorner& corner, const CameraModel& camera, const Pose& X_CP);

/// From `start` by Ceres, exact derivatives. With `robust_px` distances beyond that count less and less
/// (Cauchy's loss); `squares_px2` and `information` are without it. Nothing when a corner starts behind the
/// camera or the corners determine no pose.
std::optional<CornerFit> fitCorners(std::span<const SeenCorner> corners, const CameraModel& camera,
                                    const Pose& start, std::optional<double> robust_px = std::nullopt);

/// The corners before the camera at this pose, as one step of least squares sees them.
struct CornerSums {
    Matrix6d information = Matrix6d::Zero(); ///< as CornerFit's
    Vector6d gradient = Vector6d::Zero();    ///< weighted sum of J^T times (seen - shown)
    double squares_px2 = 0.0;
};
CornerSums cornerSums(std::span<const SeenCorner> corners, const CameraModel& camera, const Pose& X_CP);

} // namespace bask
