#pragma once
// Where one part is in another by a camera that sees both: the end-effector in the source (X_SE), the source
// in the robot's base (X_RS).

#include "engine/calibration/part_pose.h"
#include "engine/calibration/verdict.h"

namespace bask {

/// Standard deviation of what frames of a still scene have in common in a corner's coordinate, and no average
/// removes: how the detector takes its edges, the lens.
inline constexpr double kLastingCorner_px = 0.1;

struct RelativePose {
    Pose X_AB = Pose::Identity();
    Matrix6d covariance = Matrix6d::Zero(); ///< of X_AB as pose_covariance.h has it
    PartPose a, b;
    /// By the covariance and kLastingCorner_px besides.
    PoseSpread spread;
    /// The same for all markers that the camera shows there, where they are said to be, in as many frames
    /// with corners uncertain by kUsualCorner_px.
    PoseSpread possible;
};

/// From frames of a still camera and still parts; arguments and errors as partPose.
Result<RelativePose> relativePose(std::span<const MarkerFrame> frames, const MarkerLayout& layout, Part a,
                                  Part b, const CameraModel& camera,
                                  std::optional<double> corner_px = std::nullopt);

/// Covariance of X_AB to expect of a configuration; nothing when the camera shows no marker of a part.
std::optional<Matrix6d> predictedCovariance(const MarkerLayout& layout, Part a, const Pose& X_CA, Part b,
                                            const Pose& X_CB, const CameraModel& camera, int frames,
                                            double corner_px = kUsualCorner_px);

/// Good: 1 mm and 0.3 degrees (2 sigma); Usable: 3 mm and 1 degree; Redo: worse.
Verdict verdictOn(const PoseSpread& spread);
/// By its spread; Redo, too, for one of two poses. Reasons: PoseGood; PoseAmbiguous; PoseLimited (markers and
/// camera allow no better); PoseUncertain (they do).
Judgement judged(const RelativePose& pose);

} // namespace bask
