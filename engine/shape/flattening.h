#pragma once
// Arcs and splines as chains of straight edges.

#include <Eigen/Geometry>

#include <vector>

namespace bask {

/// How closely edges follow a curve. They always follow it to 1/4000 of its size too, so that area and length
/// of a small one hold within 0.1 %.
struct Flattening {
    double tolerance = 1e-5;           ///< largest distance between them, in the unit of the points
    std::size_t most_points = 500'000; ///< a spline of more ends early, with more points than that
};

/// centre + u cos t + v sin t for t from `begin` over `sweep` rad, which is negative where the arc runs back.
struct EllipseArc {
    Eigen::Vector2d centre, u, v;
    double begin = 0.0, sweep = 0.0;
};

/// The arc between two points whose quarter angle has the tangent `bulge` (positive: counter-clockwise, not
/// 0).
EllipseArc bulgeArc(const Eigen::Vector2d& from, const Eigen::Vector2d& to, double bulge);

/// A rational B-spline: knots do not fall and are control.size() + degree + 1, weights are positive; it runs
/// over knots[degree] to knots[control.size()].
struct Spline {
    int degree = 3;
    std::vector<double> knots, weights;
    std::vector<Eigen::Vector2d> control;
};

/// The cubic spline through at least 2 points, its parameter their distance; `closed` joins the last one to
/// the first in one curve; where it is open, it starts and ends along the directions given (zero: straight).
Spline splineThrough(std::vector<Eigen::Vector2d> points, bool closed, const Eigen::Vector2d& startDirection,
                     const Eigen::Vector2d& endDirection);

/// Appends the curve's points from its start to its end, both included. An arc gets at most 20 000.
void flatten(const EllipseArc& arc, const Flattening& how, std::vector<Eigen::Vector2d>& points);
void flatten(const Spline& spline, const Flattening& how, std::vector<Eigen::Vector2d>& points);

/// The curve seen through an affine map.
EllipseArc mapped(const EllipseArc& arc, const Eigen::Affine2d& map);
Spline mapped(const Spline& spline, const Eigen::Affine2d& map);

} // namespace bask
