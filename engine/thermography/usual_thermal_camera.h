#pragma once
// The lens and the place of a thermal camera that nobody has calibrated.

#include "engine/base/pose.h"
#include "engine/calibration/camera_model.h"
#include "engine/thermography/camera_profile.h"

namespace bask {

/// Returns a lens of 57 degrees across the picture of a camera, without distortion.
CameraModel usualThermalLens(const ThermalProfile& profile);

/// Returns X_RC of a camera 1.1 m above a source at R's origin, which sees the backs of objects within 20 cm
/// of it and up to 30 cm high.
Pose usualThermalPose();

} // namespace bask
