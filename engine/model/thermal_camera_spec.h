#pragma once
// The thermal camera of a real rig, as values.

#include "engine/base/pose.h"
#include "engine/calibration/camera_model.h"
#include "engine/thermography/camera_profile.h"

#include <optional>
#include <string>

namespace bask {

struct ThermalCameraSpec {
    std::string device; ///< as in openThermalFrames
    ThermalProfile profile;
    std::optional<CameraModel> lens; ///< calibrated; if empty, the one that such cameras usually have
    std::optional<Vector6d> pose;    ///< coordinates of X_RC; without it the camera only shows pictures
    bool operator==(const ThermalCameraSpec&) const = default;
};

} // namespace bask
