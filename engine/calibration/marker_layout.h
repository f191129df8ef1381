#pragma once
// Which markers are on the source, the end-effector and the robot's base, and their poses there.

#include "engine/base/pose.h"
#include "engine/base/result.h"
#include "engine/shape/marker.h"

#include <array>
#include <span>
#include <string>
#include <vector>

namespace bask {

enum class Part { Source, EndEffector, Base };

/// Marker axes: x right, y up, z out of it, origin in its middle (MarkerPose).
struct PlacedMarker {
    Part part = Part::Source;
    int id = 0;
    double side_m = 0.0;          ///< with the black border, as measured on the print
    Pose X_PM = Pose::Identity(); ///< in the frame of its part: S, E or R

    /// Returns the corners in P, clockwise from the upper left, in the order of FoundMarker.
    std::array<Eigen::Vector3d, 4> corners() const;
};

/// Valid range of a marker's side.
inline constexpr double kMinMarkerSide_mm = 1.0, kMaxMarkerSide_mm = 2000.0;

/// Ids are unique: all parts use one dictionary.
struct MarkerLayout {
    MarkerDictionary dictionary;
    std::vector<PlacedMarker> markers;
};

/// Checks a layout. Errors, with `where` as "markers[1].id": MarkerListedTwice, ValueOutOfRange (id, side),
/// NumbersUnusable (pose).
Result<void> checkLayout(const MarkerLayout& layout);

/// Returns "1, 2, 5".
std::string idsText(std::span<const int> ids);

} // namespace bask
