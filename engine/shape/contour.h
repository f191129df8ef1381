#pragma once
// A planar outline as a checked polygon: closed, simple, counter-clockwise, in metres.

#include "engine/base/result.h"

#include <Eigen/Core>

#include <vector>

namespace bask {

/// A closed polygon; the first point is not repeated. Made by makeContour, which checks it.
struct Contour {
    std::vector<Eigen::Vector2d> points_m;

    bool operator==(const Contour&) const = default;
};

double contourArea(const Contour& contour);              ///< m2, positive
double contourPerimeter(const Contour& contour);         ///< m
Eigen::Vector2d contourCentroid(const Contour& contour); ///< m, area centroid

/// Checks points (m) and makes a contour of them. Removes a repeated last point and repeated neighbours, and
/// reverses clockwise input. Refuses too few points, non-finite numbers, zero area and crossing edges. About
/// O(n log n) for ordinary outlines. `where` is the place in the error.
Result<Contour> makeContour(std::vector<Eigen::Vector2d> points_m, const std::string& where = {});

/// Returns whether p lies inside a closed polygon (even-odd). On an edge the result may be either.
bool encloses(const std::vector<Eigen::Vector2d>& ring, const Eigen::Vector2d& p);

/// Returns the outline moved by `by_m`.
Contour shifted(const Contour& contour, const Eigen::Vector2d& by_m);

/// Returns the outline moved so that its area centroid is at the origin.
Contour centred(const Contour& contour);

/// Returns the outline without the points that are within `tolerance_m` of it (Douglas-Peucker on the closed
/// ring).
Contour simplified(const Contour& contour, double tolerance_m);

/// Returns the outline simplified to at most the given number (> 3) of points. The tolerance starts at a
/// millionth of the perimeter and is doubled until this is reached. An outline with no more points is
/// returned unchanged.
Contour simplifiedTo(const Contour& contour, std::size_t max);

/// Returns the outline's points, and more points along edges that are longer than `step_m` (> 0).
std::vector<Eigen::Vector2d> pointsAlong(const Contour& contour, double step_m);

} // namespace bask
