#pragma once
// One picture of a thermal camera, as apparent temperatures.

#include "engine/base/result.h"

#include <cstddef>
#include <vector>

namespace bask {

/// Row by row from the upper left, pixel centres at whole numbers. A pixel is the temperature (K) of the
/// black body that would look the same; infinity where that lies above what the camera can tell (saturated),
/// minus infinity where it lies below, NaN where the pixel tells nothing.
struct ThermalPicture {
    int width = 0, height = 0;
    std::vector<double> T_K;

    double at(int column, int row) const {
        return T_K[static_cast<std::size_t>(row) * static_cast<std::size_t>(width) +
                   static_cast<std::size_t>(column)];
    }
    bool operator==(const ThermalPicture&) const = default;
};

/// Returns whether all pixels have one value: a closed shutter, a dead camera. Noise alone makes a true
/// picture differ.
bool isConstant(const ThermalPicture& picture);

/// Least, largest and mean temperature of a whole picture.
struct PictureRange {
    double min_K = 0.0, max_K = 0.0, mean_K = 0.0;
};

/// Returns the range of a picture. Error: ThermalPixelsOut if a pixel is not finite, since the true minimum
/// or maximum is then unknown.
Result<PictureRange> pictureRange(const ThermalPicture& picture);

} // namespace bask
