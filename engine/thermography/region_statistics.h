#pragma once
// Robust statistics of the pixels of one object, or of a polygon in a picture.

#include "engine/base/result.h"
#include "engine/thermography/thermal_picture.h"

#include <Eigen/Core>

#include <optional>
#include <span>
#include <vector>

namespace bask {

/// The largest difference of temperature across a region: between the means of square tiles of it, so that
/// noise of single pixels does not count.
struct RegionDifference {
    double value_K = 0.0;
    double standardUncertainty_K = 0.0; ///< of the difference of these two tiles, from the noise
    /// What the same many tiles of an even region would differ by on average, for the noise alone. A region
    /// is uneven where value_K is clearly above that.
    double byNoise_K = 0.0;
};

/// Of the apparent temperatures of a region.
struct RegionStatistics {
    int pixels = 0;
    double mean_K = 0.0;          ///< Huber's, with 95 % efficiency: a few foreign pixels do not move it
    double standardError_K = 0.0; ///< of the mean: type A
    double spread_K = 0.0; ///< standard deviation of the pixels, robust: 1.4826 times the median deviation
    double noise_K = 0.0;  ///< of one pixel, from differences of neighbours: without what varies slowly
    double min_K = 0.0, max_K = 0.0;
    std::optional<RegionDifference> difference; ///< none if the region has no two tiles of 3 x 3 pixels
};

/// Returns the statistics of these pixels (indices row by row). Errors: ThermalFaceSmall with fewer than
/// `minPixels`; ThermalPixelsUnknown (NaN), ThermalPixelsSaturated (infinite); ThermalPictureConstant if the
/// whole picture has one value. Throws std::out_of_range for a pixel that is not in the picture.
Result<RegionStatistics> regionStatistics(const ThermalPicture& picture, std::span<const int> pixels,
                                          int minPixels = 9);

/// Returns the pixels whose centres lie in a closed polygon (px, even-odd), ascending; those outside of the
/// picture are left out.
std::vector<int> pixelsIn(const std::vector<Eigen::Vector2d>& polygon_px, int width, int height);

} // namespace bask
