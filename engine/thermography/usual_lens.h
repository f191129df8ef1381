#pragma once
// The lens of a thermal camera that nobody has calibrated.

#include "engine/calibration/camera_model.h"
#include "engine/thermography/camera_profile.h"

namespace bask {

/// Returns a lens of 57 degrees across the picture of a camera, without distortion.
CameraModel usualThermalLens(const ThermalProfile& profile);

} // namespace bask
