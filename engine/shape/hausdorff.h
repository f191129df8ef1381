#pragma once
// Distances between closed outlines: the largest one, and the distance of each point.

#include <Eigen/Core>

#include <vector>

namespace bask {

/// Returns the Hausdorff distance (m) of the edges of two closed polygons: the larger of both directions,
/// over every point of every edge, exact to `tolerance_m`. About O(n log n). Each polygon needs at least one
/// point.
double hausdorffDistance(const std::vector<Eigen::Vector2d>& a, const std::vector<Eigen::Vector2d>& b,
                         double tolerance_m);

/// Returns the distance (m) of each point to the nearest point of a closed polygon's edges. About O(log n)
/// for each if neighbours in the list are close to each other. The polygon needs at least one point.
std::vector<double> distancesTo(const std::vector<Eigen::Vector2d>& ring,
                                const std::vector<Eigen::Vector2d>& points);

} // namespace bask
