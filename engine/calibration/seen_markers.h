#pragma once
// The markers of a part in pictures of things that keep still: mean corners, and how much they scatter.

#include "engine/base/result.h"
#include "engine/calibration/marker_layout.h"

#include <optional>

namespace bask {

/// What one picture showed.
using MarkerFrame = std::vector<FoundMarker>;

struct SeenMarker {
    PlacedMarker marker;
    std::array<Eigen::Vector2d, 4> corners_px; ///< mean over `frames`
    int frames = 0;
    int outliers = 0;         ///< frames that showed it elsewhere, left out
    double squares_px2 = 0.0; ///< of the eight coordinates' differences from their means
};

/// Corners far from the median of their kind are left out frame by frame; so is an id that one frame has
/// twice. Errors: MarkersNotSeen (none of the part's), MarkerMoved (with six frames or more: the first third
/// and the last differ by over 0.5 px and more than they scatter).
Result<std::vector<SeenMarker>> seenMarkers(std::span<const MarkerFrame> frames, const MarkerLayout& layout,
                                            Part part);

/// Standard deviation of a corner's coordinate in one frame by the scatter over frames; nothing when they
/// are too few to tell.
std::optional<double> scatterOf(std::span<const SeenMarker> markers);

} // namespace bask
