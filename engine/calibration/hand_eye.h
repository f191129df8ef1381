#pragma once
// Finds the pose of a fixed camera in the robot's base, from the end-effector's markers at several poses of
// the robot.

#include "engine/calibration/part_pose.h"

namespace bask {

/// One pose of the robot, and what the camera saw while the robot stood still.
struct HandEyeView {
    Pose X_RE = Pose::Identity();
    std::vector<MarkerFrame> frames;
};

/// Whether the layout's poses are in the robot's own end-effector frame (Known), or in a frame P at an
/// unknown X_EP (Sought).
enum class Mounting { Known, Sought };

struct PoseDifference {
    double distance_m = 0.0;
    double angle_rad = 0.0;
};

/// Returns the distance and the angle between a and b.
PoseDifference differenceBetween(const Pose& a, const Pose& b);

struct HandEyeResidual {
    bool isUsed = false;
    double rms_px = 0.0;       ///< distances between seen and shown corners
    PoseDifference difference; ///< from the markers' pose that the robot reports to that of this view alone
};

struct HandEye {
    Pose X_RC = Pose::Identity();
    Pose X_EP = Pose::Identity();
    /// Covariance of the displacements of X_RC, then X_EP (pose_covariance.h); the part of X_EP is zero if
    /// the mounting is known. It includes the robot's own errors if there are enough views to estimate them;
    /// with one view, kLastingCorner_px (relative_pose.h) is included instead. It does not include the
    /// camera's errors.
    Matrix12d covariance = Matrix12d::Zero();
    double rms_px = 0.0;
    /// Standard deviations of the robot's own errors for each axis, at the markers.
    double robot_m = 0.0, robot_rad = 0.0;
    std::vector<HandEyeResidual> views; ///< in the given order
    std::vector<Message> remarks;       ///< HandEyeViewLeftOut
};

/// Starts with OpenCV's methods, then minimises the distances of all corners with Ceres. Views that do not
/// fit (the robot was elsewhere, or not still) are left out. With a sought mounting the robot must turn about
/// two axes; if it turns about only one, or not at all, the mounting must be known. Errors: those of partPose
/// if no view has a pose; HandEyeViewsFew (3 views with visible markers are needed; 1 if the mounting is
/// known), HandEyeNoTurn, HandEyeOneAxis, HandEyeContradicts.
Result<HandEye> calibrateHandEye(std::span<const HandEyeView> views, const MarkerLayout& layout,
                                 const CameraModel& camera, Mounting mounting);

/// Returns the error of a position `p_R` caused by the uncertainty of X_RC: two standard deviations,
/// including the error that all pictures of the end-effector's markers at X_RE have in common.
PoseSpread spreadAt(const HandEye& place, const Eigen::Vector3d& p_R, const MarkerLayout& layout,
                    const CameraModel& camera, const Pose& X_RE);

/// Checks the result at another known pose: compares the markers that the camera sees with their position
/// from the robot, and with the difference that the covariances allow (2 sigma). Errors: those of partPose.
struct HandEyeCheck {
    PoseDifference difference;
    PoseSpread expected;
};
Result<HandEyeCheck> checkHandEye(const HandEye& handEye, const HandEyeView& view, const MarkerLayout& layout,
                                  const CameraModel& camera);

} // namespace bask
