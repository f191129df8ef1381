#include "widgets/thermal/thermal_range.h"

#include "widgets/common/colour_map.h"

#include <algorithm>
#include <cmath>

namespace bask {
namespace {

constexpr double kTail = 0.005;
constexpr double kMargin = 0.1;
constexpr double kMinSpan_K = 2.0;

ThermalRange atLeastMinSpan(const ThermalRange& range) {
    const double missing_K = std::max(0.0, kMinSpan_K - (range.max_K - range.min_K));
    return {range.min_K - 0.5 * missing_K, range.max_K + 0.5 * missing_K};
}

} // namespace

bool hasPicture(const ThermalView& view) {
    return view.picture && view.picture->width > 0 && view.picture->height > 0 &&
           view.picture->T_K.size() ==
               static_cast<std::size_t>(view.picture->width) * static_cast<std::size_t>(view.picture->height);
}

std::vector<double> pixelsOf(const ThermalPicture& picture) {
    std::vector<double> out;
    out.reserve(picture.T_K.size());
    for (const double T_K : picture.T_K)
        if (std::isfinite(T_K))
            out.push_back(T_K);
    return out;
}

std::vector<double> pixelsOf(const ThermalPicture& picture, const ThermalObjectView& object) {
    std::vector<double> out;
    out.reserve(object.pixels.size());
    for (const int pixel : object.pixels) {
        const auto i = static_cast<std::size_t>(pixel);
        if (pixel >= 0 && i < picture.T_K.size() && std::isfinite(picture.T_K[i]))
            out.push_back(picture.T_K[i]);
    }
    return out;
}

std::optional<ThermalRange> rangeOfPicture(const ThermalPicture& picture) {
    constexpr std::size_t kEnough = 100000;
    const std::size_t step = picture.T_K.size() / kEnough * 2 + 1; // odd, so that no column is left out
    std::vector<double> all;
    for (std::size_t i = 0; i < picture.T_K.size(); i += step)
        if (std::isfinite(picture.T_K[i]))
            all.push_back(picture.T_K[i]);
    if (all.empty())
        return std::nullopt;
    const auto tail = static_cast<std::ptrdiff_t>(kTail * static_cast<double>(all.size() - 1));
    const auto low = all.begin() + tail, high = all.end() - 1 - tail;
    std::nth_element(all.begin(), low, all.end());
    const double min_K = *low;
    std::nth_element(low, high, all.end());
    return atLeastMinSpan({min_K, *high});
}

std::optional<ThermalRange> rangeOfObjects(const ThermalView& view) {
    std::optional<ThermalRange> out;
    for (const ThermalObjectView& object : view.objects)
        for (const double T_K : pixelsOf(*view.picture, object)) {
            out = out ? ThermalRange{std::min(out->min_K, T_K), std::max(out->max_K, T_K)}
                      : ThermalRange{T_K, T_K};
        }
    if (!out)
        return std::nullopt;
    const double margin_K = kMargin * (out->max_K - out->min_K);
    return atLeastMinSpan({out->min_K - margin_K, out->max_K + margin_K});
}

ThermalRange steadied(const ThermalRange& wanted, const std::optional<ThermalRange>& shown) {
    constexpr double kLittle = 0.04;
    const double little_K = kLittle * (wanted.max_K - wanted.min_K);
    return shown && std::abs(shown->min_K - wanted.min_K) <= little_K &&
                   std::abs(shown->max_K - wanted.max_K) <= little_K
               ? *shown
               : wanted;
}

std::optional<ThermalHistogram> thermalHistogram(const std::vector<double>& pixels_K) {
    constexpr int kBins = 40;
    if (pixels_K.empty())
        return std::nullopt;
    const auto [min, max] = std::ranges::minmax_element(pixels_K);
    const NiceRange range = niceRange(*min, *max, kBins);
    ThermalHistogram out;
    out.from_K = range.min;
    out.bin_K = range.step;
    out.counts.resize(static_cast<std::size_t>(std::lround((range.max - range.min) / range.step)));
    double sum = 0.0, squares = 0.0; // about the first, so that no digits are lost
    for (const double T_K : pixels_K) {
        const auto bin = static_cast<std::size_t>(std::max(0.0, (T_K - range.min) / range.step));
        ++out.counts[std::min(bin, out.counts.size() - 1)];
        sum += T_K - pixels_K.front();
        squares += (T_K - pixels_K.front()) * (T_K - pixels_K.front());
    }
    const auto count = static_cast<double>(pixels_K.size());
    out.pixels = static_cast<int>(pixels_K.size());
    out.mean_K = pixels_K.front() + sum / count;
    out.deviation_K = std::sqrt(std::max(0.0, squares / count - sum / count * (sum / count)));
    return out;
}

} // namespace bask
