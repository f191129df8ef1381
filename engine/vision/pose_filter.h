#pragma once
// Filters a part's pose and velocity from the corners of its markers, frame by frame: an extended Kalman
// filter with constant velocity that leaves out wrong corners.

#include "engine/calibration/corner_fit.h"

#include <cstddef>
#include <vector>

namespace bask {

/// Displacements and rates in the convention of pose_covariance.h: C axes, rotation about the part's origin.
struct MotionState {
    double time_s = 0.0;
    Pose X_CP = Pose::Identity();
    Vector6d velocity = Vector6d::Zero();     ///< [v; w], m/s and rad/s
    Matrix12d covariance = Matrix12d::Zero(); ///< of [displacement of X_CP; error of the velocity]
};

/// The effect of one frame on the filter.
struct FilterStep {
    bool accepted = false;             ///< whether the frame was accepted; if not, the filter is unchanged
    std::vector<std::size_t> left_out; ///< indices of corners that do not fit the others and the prediction
    /// Of the accepted corners and the prediction; two degrees of freedom for each corner.
    double chiSquare = 0.0;
};

/// The measurement is the corners themselves, not a pose computed from them: the prediction then selects one
/// of the poses that one marker allows, and stabilises directions that the corners determine poorly.
///
/// The motion model is white acceleration: that of a steady hand (kCalm) or, if the corners contradict that
/// but agree with more, of a brisk one. The noise of the corners is kUsualCorner_px or, if two or more
/// markers have larger residuals (wrong marker positions, a blurred picture), the average of the residuals.
/// The covariance does not include errors that are constant from frame to frame, such as those of the
/// camera's calibration.
class PoseFilter {
public:
    /// Starts at rest. `covariance` is that of X_CP; `corner_px` is the standard deviation of a corner's
    /// coordinate.
    PoseFilter(double time_s, const Pose& X_CP, const Matrix6d& covariance, double corner_px);

    /// Takes the corners seen at `time_s`, which must not be before the last time: four for each marker, with
    /// p_PQ in the part's frame; weights are not used. The frame is accepted if more than half of the
    /// corners, and at least three, fit.
    FilterStep take(double time_s, std::span<const SeenCorner> corners, const CameraModel& camera);
    /// Returns the state extrapolated (forwards or backwards) to a time, with the motion of a steady hand.
    MotionState at(double time_s) const;
    double corner_px() const;

private:
    MotionState m_state;
    double m_variance_px2;
};

} // namespace bask
