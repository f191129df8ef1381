#pragma once
// The markers of a part in pictures of a scene at rest: mean corners, and their scatter.

#include "engine/base/result.h"
#include "engine/calibration/marker_layout.h"

#include <optional>

namespace bask {

/// The markers of one picture.
using MarkerFrame = std::vector<FoundMarker>;

struct SeenMarker {
    PlacedMarker marker;
    std::array<Eigen::Vector2d, 4> corners_px; ///< mean over `frames`
    int frames = 0;
    int outliers = 0;         ///< number of frames that showed it elsewhere and were left out
    double squares_px2 = 0.0; ///< sum of squares of the eight coordinates' differences from their means
};

/// Corners far from the median of the same corner are left out frame by frame, and so is an id that a frame
/// has twice. Errors: MarkersNotSeen (none of the part's), MarkerMoved (with six frames or more: the first
/// third and the last differ by over 0.5 px and by more than their scatter).
Result<std::vector<SeenMarker>> seenMarkers(std::span<const MarkerFrame> frames, const MarkerLayout& layout,
                                            Part part);

/// Returns the standard deviation of a corner's coordinate in one frame, from the scatter over frames; empty
/// if there are too few frames.
std::optional<double> scatterOf(std::span<const SeenMarker> markers);

} // namespace bask
