#pragma once
// A part's pose and velocity by the corners of its markers, frame after frame: extended Kalman filter with
// constant velocity, wrong corners left out.

#include "engine/calibration/corner_fit.h"

#include <cstddef>
#include <vector>

namespace bask {

/// Displacements and rates as in pose_covariance.h: C axes, rotation about the part's origin.
struct MotionState {
    double time_s = 0.0;
    Pose X_CP = Pose::Identity();
    Vector6d velocity = Vector6d::Zero();     ///< [v; w], m/s and rad/s
    Matrix12d covariance = Matrix12d::Zero(); ///< of [displacement of X_CP; error of the velocity]
};

/// What one frame did to the filter.
struct FilterStep {
    bool believed = false;             ///< otherwise the filter is as it was
    std::vector<std::size_t> left_out; ///< indices of corners that do not fit the others and the prediction
    double chiSquare = 0.0;            ///< of the kept corners and the prediction; two degrees a kept corner
};

/// The corners themselves are the measurement, not a pose that they give: the prediction then chooses among
/// the poses that one marker allows, and directions that the corners tell badly are held by it.
///
/// Motion is by white acceleration: what a steady hand does (kCalm) or, where the corners do not agree with
/// that and do with more, a brisk one. Corners' noise is kUsualCorner_px or, where two markers or more leave
/// more than that (badly placed markers, a blurred picture), the average of what they leave. Errors that stay
/// the same from frame to frame, as those of the camera's calibration, are not in the covariance.
class PoseFilter {
public:
    /// At rest for all that is known. `covariance` of X_CP; `corner_px`: a corner coordinate's deviation.
    PoseFilter(double time_s, const Pose& X_CP, const Matrix6d& covariance, double corner_px);

    /// Corners seen at `time_s`, which is not before the last, four of each marker; p_PQ in the part's frame,
    /// weights not used. Believed when more than half of them, and three at least, fit.
    FilterStep take(double time_s, std::span<const SeenCorner> corners, const CameraModel& camera);
    /// Carried on (or back) to a moment, by a steady hand.
    MotionState at(double time_s) const;
    double corner_px() const;

private:
    MotionState m_state;
    double m_variance_px2;
};

} // namespace bask
