#pragma once
// The smallest distance between the objects' target surfaces in end-effector space.

#include "engine/control/steady_search.h"

#include <optional>
#include <vector>

namespace bask {

/// One point on each object's surface of the poses (E's origin in R, at fixed angles) at which its target is
/// its steady temperature.
struct SurfaceGap {
    double distance_m = 0.0;             ///< largest distance between two of the points
    std::vector<Eigen::Vector3d> points; ///< one for each object
};

/// Returns points of the surfaces within workspace and clearance, nearest to one another around the pose q,
/// found by going in turn from the common centre to each surface. Empty if a surface is not found from q, or
/// without a free translation.
std::optional<SurfaceGap> surfaceGap(const SteadySearch& search, const std::vector<double>& targets_K,
                                     const Vector6d& q);

} // namespace bask
