#pragma once
// The lens and the place of a thermal camera that nobody has calibrated.

#include "engine/base/pose.h"
#include "engine/base/units.h"
#include "engine/calibration/camera_model.h"
#include "engine/thermography/camera_profile.h"
#include "engine/thermography/face_pixels.h"

namespace bask {

/// Returns a lens of 57 degrees across the picture of a camera, without distortion.
CameraModel usualThermalLens(const ThermalProfile& profile);

/// Returns X_RC of a camera 1.1 m above a source at R's origin, which sees the backs of objects within 20 cm
/// of it and up to 30 cm high.
Pose usualThermalPose();

/// Of a camera whose pose was typed: found with a tape and by the eye.
inline constexpr SightUncertainty kTypedSight{.across_m = 0.005, .angle_rad = radFromDeg(1.0)};

} // namespace bask
