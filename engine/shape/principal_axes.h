#pragma once
// Second moments of area of an outline: its extent and main direction.

#include <Eigen/Core>

#include <vector>

namespace bask {

/// Principal axes of an area. A radius of gyration is the root mean square distance of the area from the
/// centroid, measured along its axis; a disk's is half its radius.
struct PrincipalAxes {
    Eigen::Vector2d centroid_m = Eigen::Vector2d::Zero();
    Eigen::Vector2d major =
        Eigen::Vector2d::UnitX(); ///< of length 1, x not negative; the minor axis is perpendicular to it
    double major_m = 0.0;         ///< radius of gyration along `major`
    double minor_m = 0.0;         ///< radius of gyration along the minor axis; at most major_m
};

/// Returns the axes of the area within closed rings: outlines counter-clockwise, holes clockwise. `major` is
/// along x if the two radii agree to 1e-6. The area must not be zero.
PrincipalAxes principalAxes(const std::vector<std::vector<Eigen::Vector2d>>& rings);

} // namespace bask
