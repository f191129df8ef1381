#pragma once
// A planar outline as a checked polygon: closed, simple, counter-clockwise, in metres.

#include "engine/base/result.h"

#include <Eigen/Core>

#include <vector>

namespace bask {

/// Closed polygon; the first point is not repeated. Made by makeContour, which checks it.
struct Contour {
    std::vector<Eigen::Vector2d> points_m;

    bool operator==(const Contour&) const = default;
};

double contourArea(const Contour& contour);              ///< m2, positive
double contourPerimeter(const Contour& contour);         ///< m
Eigen::Vector2d contourCentroid(const Contour& contour); ///< m, area centroid

/// Checks points (m) and makes a contour of them: drops a repeated last point and repeated neighbours,
/// reverses clockwise input, refuses too few points, non-finite numbers, zero area and crossing edges. O(n
/// log n) or so in ordinary outlines. `where` goes into the error.
Result<Contour> makeContour(std::vector<Eigen::Vector2d> points_m, const std::string& where = {});

/// Whether p lies inside a closed polygon (even-odd); either on its edges.
bool encloses(const std::vector<Eigen::Vector2d>& ring, const Eigen::Vector2d& p);

/// The same outline elsewhere.
Contour shifted(const Contour& contour, const Eigen::Vector2d& by_m);

/// The same outline with its area centroid at the origin.
Contour centred(const Contour& contour);

/// The outline with points left out that lie within `tolerance_m` of it (Douglas-Peucker on the closed ring).
Contour simplified(const Contour& contour, double tolerance_m);

/// The outline simplified to at most `most` (> 3) points: by a millionth of its perimeter, and by twice as
/// much until they suffice. As it is when it has no more.
Contour simplifiedTo(const Contour& contour, std::size_t most);

/// The outline's points, and more along its edges where these are longer than `step_m` (> 0).
std::vector<Eigen::Vector2d> pointsAlong(const Contour& contour, double step_m);

} // namespace bask
