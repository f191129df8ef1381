#pragma once
// The pose of a square marker from one picture: both poses that a square allows, and whether they can be
// distinguished.

#include "engine/base/pose.h"
#include "engine/calibration/camera_model.h"
#include "engine/shape/marker.h"

#include <array>
#include <optional>

namespace bask {

/// Marker axes: x right, y up, z out of it, origin in its middle. Camera axes: x right, y down, z forward.
struct MarkerPose {
    std::array<double, 3> rotation_rad{}; ///< rotation vector of the marker's axes in the camera frame
    std::array<double, 3> translation_m{};
    double rms_px = 0.0; ///< over the four corners, distances between seen and shown

    Pose X_CM() const;
};

struct MarkerPoses {
    MarkerPose best;
    std::optional<MarkerPose> second; ///< the mirrored pose, if there is one in front of the camera
    /// Whether the second pose is possible too, for corners with an error of 0.2 px (or the residual of
    /// `best`): the sums of squares differ by less than nine variances.
    bool isAmbiguous = false;
};

/// Returns both poses by IPPE (Collins and Bartoli 2014), each refined to the smallest distances. Empty if
/// the corners are not those of a square.
std::optional<MarkerPoses> markerPoses(const std::array<Eigen::Vector2d, 4>& corners_px, double side_m,
                                       const CameraModel& camera);

} // namespace bask
