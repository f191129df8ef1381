#include "engine/calibration/seen_markers.h"

#include "engine/base/message_code.h"

#include <algorithm>
#include <cmath>

namespace bask {
namespace {

using Coordinates = Eigen::Matrix<double, 8, 1>; // of the four corners in one picture

Coordinates coordinatesOf(const FoundMarker& found) {
    Coordinates c;
    for (int k = 0; k < 4; ++k)
        c.segment<2>(2 * k) = found.corners_px[static_cast<std::size_t>(k)];
    return c;
}

std::vector<Coordinates> sightings(std::span<const MarkerFrame> frames, int id) {
    std::vector<Coordinates> seen;
    for (const MarkerFrame& frame : frames) {
        const auto isIt = [&](const FoundMarker& found) { return found.id == id; };
        if (std::ranges::count_if(frame, isIt) != 1)
            continue;
        const Coordinates c = coordinatesOf(*std::ranges::find_if(frame, isIt));
        if (c.allFinite())
            seen.push_back(c);
    }
    return seen;
}

double median(std::vector<double> values) {
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::ranges::nth_element(values, middle);
    if (values.size() % 2 == 1)
        return *middle;
    return 0.5 * (*middle + *std::max_element(values.begin(), middle));
}

Coordinates medianOf(std::span<const Coordinates> seen) {
    Coordinates result;
    for (int i = 0; i < 8; ++i) {
        std::vector<double> values;
        for (const Coordinates& c : seen)
            values.push_back(c[i]);
        result[i] = median(values);
    }
    return result;
}

SeenMarker meanOf(const PlacedMarker& marker, const std::vector<Coordinates>& seen) {
    constexpr double kFarther = 5.0, kMin_px = 0.5;
    const Coordinates middle = medianOf(seen);
    std::vector<double> distances; // of the worst coordinate
    for (const Coordinates& c : seen)
        distances.push_back((c - middle).lpNorm<Eigen::Infinity>());
    const double max = std::max(kMin_px, kFarther * median(distances));
    std::vector<Coordinates> kept;
    for (std::size_t k = 0; k < seen.size(); ++k)
        if (distances[k] <= max)
            kept.push_back(seen[k]);
    Coordinates mean = Coordinates::Zero();
    for (const Coordinates& c : kept)
        mean += c / static_cast<double>(kept.size());
    SeenMarker result{marker, {}, static_cast<int>(kept.size()), static_cast<int>(seen.size() - kept.size())};
    for (std::size_t k = 0; k < 4; ++k)
        result.corners_px[k] = mean.segment<2>(static_cast<Eigen::Index>(2 * k));
    for (const Coordinates& c : kept)
        result.squares_px2 += (c - mean).squaredNorm();
    return result;
}

// How far it moved between the first third and the last, 0 when that may be noise. Differences from one
// frame to the next tell the noise whatever the motion; medians of thirds hold against wrong sightings.
double motionOf(const std::vector<Coordinates>& seen) {
    constexpr std::size_t kMinFrames = 6;
    constexpr double kMin_px = 0.5, kDeviations = 3.0, kMedianOfNormal = 0.6745;
    if (seen.size() < kMinFrames)
        return 0.0;
    std::vector<double> steps;
    for (std::size_t k = 1; k < seen.size(); ++k)
        for (int i = 0; i < 8; ++i)
            steps.push_back(std::abs(seen[k][i] - seen[k - 1][i]));
    const double deviation = median(steps) / kMedianOfNormal / std::sqrt(2.0);
    const std::span all(seen);
    const std::size_t third = seen.size() / 3;
    const Coordinates moved = medianOf(all.last(third)) - medianOf(all.first(third));
    const double distance = moved.norm() / 2.0; // root mean square of the four corners'
    return distance > std::max(kMin_px, kDeviations * deviation) ? distance : 0.0;
}

} // namespace

Result<std::vector<SeenMarker>> seenMarkers(std::span<const MarkerFrame> frames, const MarkerLayout& layout,
                                            Part part) {
    std::vector<SeenMarker> result;
    std::vector<int> ids;
    for (const PlacedMarker& marker : layout.markers) {
        if (marker.part != part)
            continue;
        ids.push_back(marker.id);
        const std::vector<Coordinates> seen = sightings(frames, marker.id);
        if (const double moved_px = motionOf(seen); moved_px > 0.0)
            return Error{
                MessageCode::MarkerMoved, "", {std::to_string(marker.id), formatNumber(moved_px, 2)}};
        if (!seen.empty())
            result.push_back(meanOf(marker, seen));
    }
    if (result.empty())
        return Error{MessageCode::MarkersNotSeen, "", {idsText(ids)}};
    return result;
}

std::optional<double> scatterOf(std::span<const SeenMarker> markers) {
    constexpr int kMinFreedom = 40; // tells the deviation to a tenth
    double squares_px2 = 0.0;
    int freedom = 0;
    for (const SeenMarker& seen : markers) {
        squares_px2 += seen.squares_px2;
        freedom += 8 * (seen.frames - 1);
    }
    return freedom < kMinFreedom ? std::nullopt : std::optional(std::sqrt(squares_px2 / freedom));
}

} // namespace bask
