#pragma once
// How near the objects' target surfaces come to one another in end-effector space.

#include "engine/control/steady_search.h"

#include <optional>
#include <vector>

namespace bask {

/// One point on each object's surface of poses (E's origin in R, at fixed angles) with its target as steady
/// temperature.
struct SurfaceGap {
    double distance_m = 0.0;             ///< largest between two of the points
    std::vector<Eigen::Vector3d> points; ///< one an object
};

/// Points of the surfaces within workspace and clearance nearest to one another around the pose q, found by
/// going in turn from the common centre to each surface. Empty when a surface is not met from q, and without
/// a free translation.
std::optional<SurfaceGap> surfaceGap(const SteadySearch& search, const std::vector<double>& targets_K,
                                     const Vector6d& q);

} // namespace bask
