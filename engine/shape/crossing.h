#pragma once
// Where a closed polygon meets itself (Shamos and Hoey's sweep, O(n log n)) or another. Used by the other
// files of this folder.

#include <Eigen/Core>

#include <optional>
#include <vector>

namespace bask {

/// Two edges (edge k runs from point k to point k + 1, counted from 0, first < second) and a point of both.
struct Crossing {
    std::size_t first = 0;
    std::size_t second = 0;
    Eigen::Vector2d point = Eigen::Vector2d::Zero();
};

/// A pair of edges that cross, touch or lie on each other, neighbours that fold back included; none when the
/// polygon is simple. Points are finite, three at least, and no two neighbours are equal.
std::optional<Crossing> findCrossing(const std::vector<Eigen::Vector2d>& points);

/// A point at which the edges of two closed polygons cross or touch.
std::optional<Eigen::Vector2d> findMeeting(const std::vector<Eigen::Vector2d>& a,
                                           const std::vector<Eigen::Vector2d>& b);

} // namespace bask
