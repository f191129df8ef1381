#pragma once
// The pose of one part in another from a camera that sees both: the end-effector in the source (X_SE), the
// source in the robot's base (X_RS).

#include "engine/calibration/part_pose.h"
#include "engine/calibration/verdict.h"

namespace bask {

/// Standard deviation of the error in a corner's coordinate that all frames of a fixed scene have in common
/// and averaging does not remove: edge detection, the lens.
inline constexpr double kLastingCorner_px = 0.1;

struct RelativePose {
    Pose X_AB = Pose::Identity();
    Matrix6d covariance = Matrix6d::Zero(); ///< of X_AB, in the convention of pose_covariance.h
    PartPose a, b;
    /// From the covariance and kLastingCorner_px.
    PoseSpread spread;
    /// The spread that would be possible: with all markers that the camera shows there, at their listed
    /// positions, in as many frames with corners uncertain by kUsualCorner_px.
    PoseSpread possible;
};

/// Returns the pose from frames of a fixed camera and fixed parts; arguments and errors as in partPose.
Result<RelativePose> relativePose(std::span<const MarkerFrame> frames, const MarkerLayout& layout, Part a,
                                  Part b, const CameraModel& camera,
                                  std::optional<double> corner_px = std::nullopt);

/// Returns the expected covariance of X_AB in a configuration; empty if the camera shows no marker of one
/// part.
std::optional<Matrix6d> predictedCovariance(const MarkerLayout& layout, Part a, const Pose& X_CA, Part b,
                                            const Pose& X_CB, const CameraModel& camera, int frames,
                                            double corner_px = kUsualCorner_px);

/// Good: 1 mm and 0.3 degrees (2 sigma); Usable: 3 mm and 1 degree; Redo: worse.
Verdict verdictOn(const PoseSpread& spread);
/// Judges a pose by its spread; an ambiguous pose is Redo, too. Reasons: PoseGood; PoseAmbiguous; PoseLimited
/// (markers and camera allow no better result); PoseUncertain (they do).
Judgement judged(const RelativePose& pose);

} // namespace bask
