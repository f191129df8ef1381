#include "engine/thermography/region_statistics.h"

#include "engine/base/message_code.h"
#include "engine/shape/contour.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <stdexcept>

namespace bask {
namespace {

constexpr double kSdPerDeviation = 1.482602218505602; ///< of a normal distribution
constexpr double kHuber = 1.345;                      ///< 95 % efficiency for a normal distribution
constexpr int kMinTile_px = 3;

double medianOf(std::vector<double>& values) {
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::ranges::nth_element(values, middle);
    if (values.size() % 2 == 1)
        return *middle;
    return 0.5 * (*middle + *std::max_element(values.begin(), middle));
}

struct RobustMean {
    double mean = 0.0, spread = 0.0, standardError = 0.0;
};

/// Huber's M-estimate of location with the median deviation as scale, by reweighting.
RobustMean huberMean(const std::vector<double>& values) {
    std::vector<double> sorted = values;
    RobustMean out;
    out.mean = medianOf(sorted);
    for (std::size_t i = 0; i < values.size(); ++i)
        sorted[i] = std::abs(values[i] - out.mean);
    out.spread = kSdPerDeviation * medianOf(sorted);
    if (out.spread == 0.0) // more than half are alike, as coarse steps make them
        for (const double value : values)
            out.spread += std::abs(value - out.mean) * 1.2533141373155 / static_cast<double>(values.size());
    if (out.spread == 0.0)
        return out;
    const double limit = kHuber * out.spread;
    for (int i = 0; i < 100; ++i) {
        double sum = 0.0, weights = 0.0;
        for (const double value : values) {
            const double off = std::abs(value - out.mean);
            const double weight = off <= limit ? 1.0 : limit / off;
            sum += weight * value;
            weights += weight;
        }
        const double step = sum / weights - out.mean;
        out.mean += step;
        if (std::abs(step) < 1e-9)
            break;
    }
    double squares = 0.0, inside = 0.0;
    for (const double value : values) {
        const double off = std::min(std::abs(value - out.mean), limit);
        squares += off * off;
        inside += off < limit ? 1.0 : 0.0;
    }
    const auto n = static_cast<double>(values.size());
    out.standardError = std::sqrt(squares * n / std::max(n - 1.0, 1.0)) / std::max(inside, 1.0);
    return out;
}

/// Noise of a pixel, from pairs of neighbours in a row.
double noiseOf(const ThermalPicture& picture, std::span<const int> pixels, double spread) {
    std::vector<double> differences;
    for (std::size_t k = 0; k + 1 < pixels.size(); ++k)
        if (pixels[k + 1] == pixels[k] + 1 && pixels[k + 1] % picture.width != 0)
            differences.push_back(std::abs(picture.T_K[static_cast<std::size_t>(pixels[k + 1])] -
                                           picture.T_K[static_cast<std::size_t>(pixels[k])]));
    if (differences.empty())
        return spread;
    const double noise = kSdPerDeviation * medianOf(differences) / std::sqrt(2.0);
    // Steps of the camera can be coarser than its noise: then most neighbours are alike.
    return noise > 0.0 ? noise : spread;
}

/// Expected range of `count` normal values of standard deviation 1: 2 E(max), by Blom's approximation.
double expectedRange(std::size_t count) {
    if (count < 2)
        return 0.0;
    const double p = (static_cast<double>(count) - 0.375) / (static_cast<double>(count) + 0.25);
    // Quantile of the normal distribution (Abramowitz and Stegun 26.2.23, 4.5e-4).
    const double t = std::sqrt(-2.0 * std::log(1.0 - p));
    return 2.0 * (t - (2.515517 + t * (0.802853 + t * 0.010328)) /
                          (1.0 + t * (1.432788 + t * (0.189269 + t * 0.001308))));
}

std::optional<RegionDifference> differenceOf(const ThermalPicture& picture, std::span<const int> pixels,
                                             double noise_K) {
    const int side =
        std::clamp(static_cast<int>(std::sqrt(static_cast<double>(pixels.size())) / 6.0), kMinTile_px, 16);
    std::map<std::pair<int, int>, std::vector<double>> tiles;
    for (const int pixel : pixels)
        tiles[{pixel / picture.width / side, pixel % picture.width / side}].push_back(
            picture.T_K[static_cast<std::size_t>(pixel)]);
    struct Tile {
        double mean = 0.0, uncertainty = 0.0;
    };
    std::vector<Tile> means;
    double variances = 0.0;
    for (const auto& [place, values] : tiles) {
        if (3 * static_cast<int>(values.size()) < 2 * side * side)
            continue;
        const double variance = noise_K * noise_K / (0.95 * static_cast<double>(values.size()));
        means.push_back({huberMean(values).mean, std::sqrt(variance)});
        variances += variance;
    }
    if (means.size() < 2)
        return std::nullopt;
    const auto [low, high] = std::ranges::minmax_element(means, {}, &Tile::mean);
    return RegionDifference{high->mean - low->mean, std::hypot(high->uncertainty, low->uncertainty),
                            expectedRange(means.size()) *
                                std::sqrt(variances / static_cast<double>(means.size()))};
}

} // namespace

Result<RegionStatistics> regionStatistics(const ThermalPicture& picture, std::span<const int> pixels,
                                          int minPixels) {
    std::vector<double> values;
    std::size_t unknown = 0, saturated = 0;
    values.reserve(pixels.size());
    for (const int pixel : pixels) {
        if (pixel < 0)
            throw std::out_of_range("regionStatistics: a pixel outside of the picture");
        values.push_back(picture.T_K.at(static_cast<std::size_t>(pixel)));
        unknown += std::isnan(values.back()) ? 1 : 0;
        saturated += std::isinf(values.back()) ? 1 : 0;
    }
    const std::string count = std::to_string(pixels.size());
    if (pixels.empty() || static_cast<int>(pixels.size()) < minPixels)
        return Error{MessageCode::ThermalFaceSmall, {}, {count, std::to_string(minPixels)}};
    if (unknown > 0)
        return Error{MessageCode::ThermalPixelsUnknown, {}, {std::to_string(unknown), count}};
    if (saturated > 0)
        return Error{MessageCode::ThermalPixelsSaturated, {}, {std::to_string(saturated), count}};
    if (isConstant(picture))
        return Error{MessageCode::ThermalPictureConstant, {}};
    const RobustMean mean = huberMean(values);
    RegionStatistics out;
    out.pixels = static_cast<int>(pixels.size());
    out.mean_K = mean.mean;
    out.standardError_K = mean.standardError;
    out.spread_K = mean.spread;
    out.noise_K = noiseOf(picture, pixels, mean.spread);
    out.min_K = std::ranges::min(values);
    out.max_K = std::ranges::max(values);
    out.difference = differenceOf(picture, pixels, out.noise_K);
    return out;
}

std::vector<int> pixelsIn(const std::vector<Eigen::Vector2d>& polygon_px, int width, int height) {
    std::vector<int> out;
    for (int row = 0; row < height; ++row)
        for (int column = 0; column < width; ++column)
            if (encloses(polygon_px, Eigen::Vector2d(column, row)))
                out.push_back(row * width + column);
    return out;
}

} // namespace bask
