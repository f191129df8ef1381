#pragma once
// How far two closed outlines are apart at most.

#include <Eigen/Core>

#include <vector>

namespace bask {

/// Hausdorff distance (m) of two closed polygons' edges, the larger of both ways, every point of every edge
/// counted: exact to `tolerance_m`. O(n log n) or so. Both need a point.
double hausdorffDistance(const std::vector<Eigen::Vector2d>& a, const std::vector<Eigen::Vector2d>& b,
                         double tolerance_m);

} // namespace bask
