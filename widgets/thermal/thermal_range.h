#pragma once
// The range of temperatures that a thermal picture's colours show, and how its pixels are distributed.

#include "engine/thermography/thermal_view.h"

#include <optional>
#include <vector>

namespace bask {

struct ThermalRange {
    double min_K = 293.15;
    double max_K = 303.15;
    bool operator==(const ThermalRange&) const = default;
};

/// Returns whether the view has a picture, of at least one pixel and with as many as its size says.
bool hasPicture(const ThermalView& view);

/// Returns the temperatures of all pixels that tell one.
std::vector<double> pixelsOf(const ThermalPicture& picture);
/// Returns the same of one object's pixels.
std::vector<double> pixelsOf(const ThermalPicture& picture, const ThermalObjectView& object);

/// Returns the range between the 0.5th and the 99.5th percentile, so that a few odd pixels do not count; at
/// least 2 K. Empty if there are none.
std::optional<ThermalRange> rangeOfPicture(const ThermalPicture& picture);
/// Returns the range of the objects' pixels and a tenth more on either side, at least 2 K: a hot plate beside
/// them does not count. Empty if there are none.
std::optional<ThermalRange> rangeOfObjects(const ThermalView& view);

/// Returns `shown`, if it differs from `wanted` by little: colours then do not flicker with the noise.
ThermalRange steadied(const ThermalRange& wanted, const std::optional<ThermalRange>& shown);

/// How often each temperature occurs.
struct ThermalHistogram {
    double from_K = 0.0; ///< lower edge of the first bin
    double bin_K = 1.0;
    std::vector<int> counts; ///< of each bin; the first and the last are not both empty
    int pixels = 0;
    double mean_K = 0.0;
    double deviation_K = 0.0; ///< standard deviation
};

/// Returns bins of a round width, about 40. Empty if there are no temperatures.
std::optional<ThermalHistogram> thermalHistogram(const std::vector<double>& pixels_K);

} // namespace bask
