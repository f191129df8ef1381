#pragma once
// The thermal camera of a rig, as values.

#include "engine/base/pose.h"
#include "engine/calibration/camera_model.h"
#include "engine/thermography/camera_profile.h"

#include <optional>
#include <string>

namespace bask {

/// Dates are as in VisionSpec.
struct ThermalCalibration {
    std::optional<CameraModel> lens; ///< if empty, the one that such cameras usually have
    std::string lensDate;
    std::optional<Vector6d> pose; ///< coordinates of X_RC
    std::string poseDate;
    /// Standard uncertainty of the objects' places by that of the pose, across the line of sight; empty
    /// for a pose that was typed, or measured by a version that did not keep it.
    std::optional<double> poseUncertainty_m;
    bool operator==(const ThermalCalibration&) const = default;
};

/// Without a pose it only shows pictures.
struct ThermalCameraSpec {
    std::string device; ///< as in openThermalFrames
    ThermalProfile profile;
    ThermalCalibration calibration;
    bool operator==(const ThermalCameraSpec&) const = default;
};

/// The true thermal camera of a simulated rig. What its calibration does not say is known as it is.
struct SimulatedThermalCameraSpec {
    std::string profile = "p2-pro"; ///< name of a shipped profile
    std::optional<Vector6d> pose;   ///< coordinates of X_RC; if empty, the default pose
    double noise_K = 0.05;          ///< standard deviation of a pixel for a black body at 300 K
    std::optional<double> gain{};   ///< standard deviation of its error, relative; empty: the profile's
    double offset_K = 1.0;          ///< standard deviation, before it is zeroed
    ThermalCalibration calibration; ///< what is believed
    bool operator==(const SimulatedThermalCameraSpec&) const = default;
};

} // namespace bask
