#pragma once
// Where a still camera is in the robot's base, by the end-effector's markers at several poses of the robot.

#include "engine/calibration/part_pose.h"

namespace bask {

/// One pose of the robot, and what the camera saw while it stood still there.
struct HandEyeView {
    Pose X_RE = Pose::Identity();
    std::vector<MarkerFrame> frames;
};

/// Whether the layout's poses are in the robot's own end-effector frame (Known), or whether the frame P that
/// they are in is at an unknown X_EP (Sought).
enum class Mounting { Known, Sought };

struct PoseDifference {
    double distance_m = 0.0;
    double angle_rad = 0.0;
};

/// How far b lies from a and is turned against it.
PoseDifference differenceBetween(const Pose& a, const Pose& b);

struct HandEyeResidual {
    bool isUsed = false;
    double rms_px = 0.0;       ///< corners seen from shown
    PoseDifference difference; ///< the markers' pose by this view alone from where the robot has them
};

struct HandEye {
    Pose X_RC = Pose::Identity();
    Pose X_EP = Pose::Identity();
    /// Of the displacements of X_RC, then X_EP (pose_covariance.h), whose part is zero when the mounting is
    /// known. The robot's own errors are in it where views can tell them; by one view kLastingCorner_px
    /// (relative_pose.h) is instead. The camera's are not.
    Matrix12d covariance = Matrix12d::Zero();
    double rms_px = 0.0;
    /// Standard deviations of the robot's own errors, an axis, at the markers.
    double robot_m = 0.0, robot_rad = 0.0;
    std::vector<HandEyeResidual> views; ///< as given
    std::vector<Message> remarks;       ///< HandEyeViewLeftOut
};

/// Start by OpenCV's methods, then least distances of all corners by Ceres; views that do not fit (the robot
/// was elsewhere, or not still) are left out. With a sought mounting the robot must turn about two axes; what
/// turns about one only, or not at all, needs a known mounting. Errors: partPose's when no view has a pose;
/// HandEyeViewsFew (3 with the markers
/// seen; 1 when the mounting is known), HandEyeNoTurn, HandEyeOneAxis, HandEyeContradicts.
Result<HandEye> calibrateHandEye(std::span<const HandEyeView> views, const MarkerLayout& layout,
                                 const CameraModel& camera, Mounting mounting);

/// How far a thing at `p_R` is displaced by what X_RC may be off: two standard deviations, with what every
/// picture of the end-effector's markers at X_RE has in common.
PoseSpread spreadAt(const HandEye& place, const Eigen::Vector3d& p_R, const MarkerLayout& layout,
                    const CameraModel& camera, const Pose& X_RE);

/// At another known pose: the markers where the camera sees them from where the robot has them, and how far
/// that may be by the covariances (2 sigma). Errors as partPose.
struct HandEyeCheck {
    PoseDifference difference;
    PoseSpread expected;
};
Result<HandEyeCheck> checkHandEye(const HandEye& handEye, const HandEyeView& view, const MarkerLayout& layout,
                                  const CameraModel& camera);

} // namespace bask
