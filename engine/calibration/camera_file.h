#pragma once
// Reads and writes cameras as files: OpenCV's YAML and the camera_info YAML of ROS.

#include "engine/base/result.h"
#include "engine/calibration/camera_model.h"

#include <string>

namespace bask {

/// Reads a camera from either kind of YAML, also from other tools: `camera_matrix` and
/// `distortion_coefficients` (4, 5 or 8) are required, the other keys are optional. At most 1 MiB. Errors:
/// those of a file; JsonMissingKey, NumbersUnusable, ValueOutOfRange; CameraMatrixUnusable,
/// DistortionUnusable, ValueUnknown (a distortion model other than Brown's, such as a fish-eye's).
Result<CameraModel> readCamera(const std::string& path);
/// Like readCamera, from the text of a file; `where` names it in errors.
Result<CameraModel> cameraFromYaml(const std::string& text, const std::string& where);

/// The first key of openCvYaml.
inline constexpr const char* kCameraFirstKey = "camera_matrix";
/// Returns the camera as cv::FileStorage reads it: camera_matrix, distortion_coefficients, rms, image_width,
/// image_height, standard_deviations, per_view_reprojection_errors, views, board. A lens without distortion
/// gets five coefficients of 0, here and below.
std::string openCvYaml(const CameraModel& camera);
/// Returns the camera as camera_info_manager reads it; the size must be known. `name` may have letters,
/// digits, - and _.
std::string rosYaml(const CameraModel& camera, const std::string& name);

} // namespace bask
