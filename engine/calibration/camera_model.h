#pragma once
// A calibrated camera: pinhole with Brown's distortion, the accuracy of its numbers and their origin.

#include "engine/base/result.h"

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace bask {

/// The root mean square distance of a picture's corners from where the camera model shows them.
struct ViewResidual {
    std::string name;
    double rms_px = 0.0;

    bool operator==(const ViewResidual&) const = default;
};

/// u = fx x'' + cx, v = fy y'' + cy in pixels (pixel centres at whole numbers). A point in camera axes (x
/// right, y down, z forward) has (x, y) = (X/Z, Y/Z), which Brown's model maps to (x'', y'') as in OpenCV:
/// with r2 = x2 + y2 and g = (1 + k1 r2 + k2 r4 + k3 r6) / (1 + k4 r2 + k5 r4 + k6 r6), x'' = g x + 2 p1 x y
/// + p2 (r2 + 2 x2), y'' = g y + p1 (r2 + 2 y2) + 2 p2 x y.
struct CameraModel {
    int width = 0, height = 0; ///< size of its pictures in pixels; 0 if the file does not contain it
    double fx = 0.0, fy = 0.0, cx = 0.0, cy = 0.0;
    std::vector<double> distortion; ///< 5 or 8: k1 k2 p1 p2 k3 [k4 k5 k6]

    std::optional<double> rms_px;   ///< over all corners of the calibration
    std::vector<double> deviations; ///< standard deviations of fx fy cx cy and the distortion; empty: unknown
    std::vector<ViewResidual> views;
    std::string board; ///< board of the calibration, in the format of parseBoard; may be empty

    bool operator==(const CameraModel&) const = default;
};

/// Returns "1280 x 720".
std::string pixelsText(int width, int height);

/// Checks the size of pictures. Error: CameraSizeOther if the camera was calibrated for another size.
Result<void> checkSize(const CameraModel& camera, int width, int height);

} // namespace bask
