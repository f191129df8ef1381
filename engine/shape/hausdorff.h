#pragma once
// How far closed outlines are apart: at most, and point by point.

#include <Eigen/Core>

#include <vector>

namespace bask {

/// Hausdorff distance (m) of two closed polygons' edges, the larger of both ways, every point of every edge
/// counted: exact to `tolerance_m`. O(n log n) or so. Both need a point.
double hausdorffDistance(const std::vector<Eigen::Vector2d>& a, const std::vector<Eigen::Vector2d>& b,
                         double tolerance_m);

/// Distance (m) of each point to the nearest point of a closed polygon's edges. O(log n) each or so where
/// neighbours in the list are neighbours in the plane. The polygon needs a point.
std::vector<double> distancesTo(const std::vector<Eigen::Vector2d>& ring,
                                const std::vector<Eigen::Vector2d>& points);

} // namespace bask
