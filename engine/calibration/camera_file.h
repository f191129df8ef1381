#pragma once
// Cameras as files: OpenCV's YAML and the camera_info YAML of ROS.

#include "engine/base/result.h"
#include "engine/calibration/camera_model.h"

#include <string>

namespace bask {

/// A camera from either kind of YAML, also of other tools: `camera_matrix` and `distortion_coefficients`
/// (4, 5 or 8) are needed, the rest is taken if it is there. At most 1 MiB.
/// Errors: those of a file; JsonMissingKey, NumbersUnusable, ValueOutOfRange; CameraMatrixUnusable,
/// DistortionUnusable, ValueUnknown (a distortion model that is not Brown's, such as a fish-eye's).
Result<CameraModel> readCamera(const std::string& path);
/// The same from a file's text; `where` names it in errors.
Result<CameraModel> cameraFromYaml(const std::string& text, const std::string& where);

/// The first key of openCvYaml.
inline constexpr const char* kCameraFirstKey = "camera_matrix";
/// As cv::FileStorage reads it: camera_matrix, distortion_coefficients, rms, image_width, image_height,
/// standard_deviations, per_view_reprojection_errors, views, board.
std::string openCvYaml(const CameraModel& camera);
/// As camera_info_manager reads it; the size must be known. `name` is plain: letters, digits, - and _.
std::string rosYaml(const CameraModel& camera, const std::string& name);

} // namespace bask
