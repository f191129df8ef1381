#pragma once
// The valid ranges of the coordinates of a pose.

#include "engine/base/parameter.h"
#include "engine/base/pose.h"

namespace bask {

/// Of the robot's workspace, and of the source, plates in the room, cameras and markers.
inline constexpr double kMaxPlace_cm = 500.0;
/// Of what is held, in the end-effector's frame.
inline constexpr double kMaxMounting_cm = 100.0;

/// Returns the valid range of a coordinate in the unit of files, cm or degrees. With `isUnique` theta_y ends
/// at 90 degrees, where the three angles are no longer unique.
constexpr ValidRange coordinateRange(int coordinate, double maxPlace_cm, bool isUnique) {
    const double max = coordinate < kThetaX ? maxPlace_cm : isUnique && coordinate == kThetaY ? 90.0 : 180.0;
    return {-max, max};
}

} // namespace bask
