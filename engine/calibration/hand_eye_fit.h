#pragma once
// Minimises the distances of the end-effector's corners over many poses of the robot.

#include "engine/calibration/corner_fit.h"

#include <vector>

namespace bask {

struct HandEyePoses {
    Pose X_RC = Pose::Identity(), X_EP = Pose::Identity();

    Pose X_CP(const Pose& X_RE) const { return X_RC.inverse() * X_RE * X_EP; }
};

/// Returns the displacement of X_CP by those of X_RC, then X_EP.
Eigen::Matrix<double, 6, 12> byHandEye(const HandEyePoses& poses, const Pose& X_RE);

struct HandEyeSight {
    std::size_t view = 0; ///< index in the caller's list
    Pose X_RE = Pose::Identity();
    Pose X_CP = Pose::Identity(); ///< from this view alone
    std::vector<SeenCorner> corners;
};

struct HandEyeFit {
    HandEyePoses poses;
    Matrix12d covariance = Matrix12d::Zero(); ///< of X_RC, then X_EP; zero if the mounting is known
    double rms_px = 0.0;
    double robot_m = 0.0, robot_rad = 0.0; ///< standard deviations of the robot's errors, for each axis
};

/// Fits from `start` with Ceres, exact derivatives and the robust loss of fitCorners. Empty if a corner
/// starts behind the camera or the views do not determine the poses. The covariance includes only the noise
/// of the corners.
std::optional<HandEyeFit> fitHandEye(std::span<const HandEyeSight> sights, const CameraModel& camera,
                                     const HandEyePoses& start, bool isMountingSought,
                                     std::optional<double> robust_px = std::nullopt);

/// Allows for errors of the robot's reported poses: all corners of a view then have a common error. Leaves a
/// fit unchanged if its residuals are explained by the noise of the corners.
void allowForRobot(HandEyeFit& fit, std::span<const HandEyeSight> sights, const CameraModel& camera,
                   bool isMountingSought);

} // namespace bask
