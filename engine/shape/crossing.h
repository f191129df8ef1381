#pragma once
// Finds where a closed polygon meets itself (sweep of Shamos and Hoey, O(n log n)) or another one. Used by
// the other files of this folder.

#include <Eigen/Core>

#include <optional>
#include <vector>

namespace bask {

/// Two edges (edge k goes from point k to point k + 1, counted from 0, first < second) and a point that both
/// contain.
struct Crossing {
    std::size_t first = 0;
    std::size_t second = 0;
    Eigen::Vector2d point = Eigen::Vector2d::Zero();
};

/// Returns a pair of edges that cross, touch or overlap, including neighbours that fold back; empty if the
/// polygon is simple. The points must be finite and at least three, and no two neighbours may be equal.
std::optional<Crossing> findCrossing(const std::vector<Eigen::Vector2d>& points);

/// Returns a point at which the edges of two closed polygons cross or touch; empty if there is none.
std::optional<Eigen::Vector2d> findMeeting(const std::vector<Eigen::Vector2d>& a,
                                           const std::vector<Eigen::Vector2d>& b);

} // namespace bask
