#pragma once
// Flattens arcs and splines into chains of straight edges.

#include <Eigen/Geometry>

#include <vector>

namespace bask {

/// How closely edges follow a curve. They always follow it to 1/4000 of its size too, so that the area and
/// length of a small curve are correct within 0.1 %.
struct Flattening {
    /// Largest distance of the edges from the curve, in the unit of the points.
    double tolerance = 1e-5;
    std::size_t max_points = 500'000; ///< a spline with more points ends early, with more points than this
};

/// The curve centre + u cos t + v sin t for t from `begin` over `sweep` rad; `sweep` is negative if the arc
/// runs backwards.
struct EllipseArc {
    Eigen::Vector2d centre, u, v;
    double begin = 0.0, sweep = 0.0;
};

/// Returns the arc between two points, where `bulge` is the tangent of a quarter of its angle (positive:
/// counter-clockwise; not 0).
EllipseArc bulgeArc(const Eigen::Vector2d& from, const Eigen::Vector2d& to, double bulge);

/// A rational B-spline from knots[degree] to knots[control.size()]. There are control.size() + degree + 1
/// knots in non-decreasing order; weights are positive.
struct Spline {
    int degree = 3;
    std::vector<double> knots, weights;
    std::vector<Eigen::Vector2d> control;
};

/// Returns the cubic spline through at least 2 points, with their distance as parameter. `closed` joins the
/// last point to the first smoothly; an open spline starts and ends along the given directions (zero:
/// straight).
Spline splineThrough(std::vector<Eigen::Vector2d> points, bool closed, const Eigen::Vector2d& startDirection,
                     const Eigen::Vector2d& endDirection);

/// Appends the curve's points from its start to its end, both included. An arc gets at most 20 000 points.
void flatten(const EllipseArc& arc, const Flattening& how, std::vector<Eigen::Vector2d>& points);
void flatten(const Spline& spline, const Flattening& how, std::vector<Eigen::Vector2d>& points);

/// Returns the curve transformed by an affine map.
EllipseArc mapped(const EllipseArc& arc, const Eigen::Affine2d& map);
Spline mapped(const Spline& spline, const Eigen::Affine2d& map);

} // namespace bask
