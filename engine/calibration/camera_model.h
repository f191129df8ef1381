#pragma once
// A calibrated camera: pinhole with Brown's distortion, how sure its numbers are and where they came from.

#include "engine/base/result.h"

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace bask {

/// How far a picture's corners lie from where the camera shows them, root mean square.
struct ViewResidual {
    std::string name;
    double rms_px = 0.0;

    bool operator==(const ViewResidual&) const = default;
};

/// u = fx x'' + cx, v = fy y'' + cy in pixels (pixel centres at whole numbers), where (x, y) = (X/Z, Y/Z) of
/// a point in camera axes (x right, y down, z forward) goes to (x'', y'') by Brown's model as OpenCV has it:
/// with r2 = x2 + y2 and g = (1 + k1 r2 + k2 r4 + k3 r6) / (1 + k4 r2 + k5 r4 + k6 r6),
/// x'' = g x + 2 p1 x y + p2 (r2 + 2 x2), y'' = g y + p1 (r2 + 2 y2) + 2 p2 x y.
struct CameraModel {
    int width = 0, height = 0; ///< of its pictures in pixels; 0 when the file did not say
    double fx = 0.0, fy = 0.0, cx = 0.0, cy = 0.0;
    std::vector<double> distortion; ///< 5 or 8: k1 k2 p1 p2 k3 [k4 k5 k6]

    std::optional<double> rms_px;   ///< over all corners of the calibration
    std::vector<double> deviations; ///< standard deviations of fx fy cx cy and the distortion; empty: unknown
    std::vector<ViewResidual> views;
    std::string board; ///< setting of the calibration's board, as parseBoard reads it; may be empty

    bool operator==(const CameraModel&) const = default;
};

/// "1280 x 720".
std::string pixelsText(int width, int height);

/// CameraSizeOther where the camera was calibrated for pictures of another size.
Result<void> checkSize(const CameraModel& camera, int width, int height);

} // namespace bask
