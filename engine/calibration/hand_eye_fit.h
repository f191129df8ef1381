#pragma once
// Least distances of the end-effector's corners over many poses of the robot.

#include "engine/calibration/corner_fit.h"

#include <vector>

namespace bask {

struct HandEyePoses {
    Pose X_RC = Pose::Identity(), X_EP = Pose::Identity();

    Pose X_CP(const Pose& X_RE) const { return X_RC.inverse() * X_RE * X_EP; }
};

/// Displacement of X_CP by those of X_RC, then X_EP.
Eigen::Matrix<double, 6, 12> byHandEye(const HandEyePoses& poses, const Pose& X_RE);

struct HandEyeSight {
    std::size_t view = 0; ///< index in the caller's list
    Pose X_RE = Pose::Identity();
    Pose X_CP = Pose::Identity(); ///< by this view alone
    std::vector<SeenCorner> corners;
};

struct HandEyeFit {
    HandEyePoses poses;
    Matrix12d covariance = Matrix12d::Zero(); ///< of X_RC, then X_EP; zero where the mounting is known
    double rms_px = 0.0;
    double robot_m = 0.0, robot_rad = 0.0; ///< standard deviations of the robot's errors, an axis
};

/// From `start` by Ceres, exact derivatives, robust as fitCorners. Nothing when a corner starts behind the
/// camera or the views determine no poses. The covariance holds for corners' noise alone.
std::optional<HandEyeFit> fitHandEye(std::span<const HandEyeSight> sights, const CameraModel& camera,
                                     const HandEyePoses& start, bool isMountingSought,
                                     std::optional<double> robust_px = std::nullopt);

/// The same where the robot is not quite where it says: all corners of a view are wrong together then. Leaves
/// a fit alone that misses by no more than corners' noise does.
void allowForRobot(HandEyeFit& fit, std::span<const HandEyeSight> sights, const CameraModel& camera,
                   bool isMountingSought);

} // namespace bask
