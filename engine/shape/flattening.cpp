#include "engine/shape/flattening.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace bask {
namespace {

constexpr double kOfSize = 1.0 / 4000;
constexpr double kMinEdgesATurn = 96.0;
constexpr double kMaxEdges = 20'000.0;
constexpr int kDeepest = 10; // halvings of a spline's first pieces
constexpr std::size_t kHighestDegree = 15;
constexpr double kShortestOfSteps = 1e-9; // between fit points

Eigen::Vector2d leftOf(const Eigen::Vector2d& d) {
    return {-d.y(), d.x()};
}

// The longest of the radii of an ellipse with conjugate radii u and v.
double longestRadius(const Eigen::Vector2d& u, const Eigen::Vector2d& v) {
    const double sum = u.squaredNorm() + v.squaredNorm();
    const double cross = u.x() * v.y() - u.y() * v.x();
    return std::sqrt(0.5 * (sum + std::sqrt(std::max(0.0, sum * sum - 4.0 * cross * cross))));
}

// Edges along a spline, halved until three points between their ends lie close to them.
class SplineFlattener {
public:
    SplineFlattener(const Spline& spline, const Flattening& how, std::vector<Eigen::Vector2d>& points)
        : m_spline(spline), m_points(points), m_max_points(how.max_points) {
        Eigen::AlignedBox2d box;
        for (const Eigen::Vector2d& p : spline.control)
            box.extend(p);
        m_tolerance = std::min(how.tolerance, kOfSize * box.diagonal().norm());
    }

    void run() {
        const auto p = static_cast<std::size_t>(m_spline.degree);
        const int pieces = m_spline.degree + 1;
        m_points.push_back(at(p, m_spline.knots[p]));
        for (std::size_t span = p; span < m_spline.control.size(); ++span) {
            const double a = m_spline.knots[span], b = m_spline.knots[span + 1];
            for (int k = 0; a < b && k < pieces && m_points.size() <= m_max_points; ++k) {
                const double from = a + (b - a) * k / pieces;
                const double to = k + 1 == pieces ? b : a + (b - a) * (k + 1) / pieces;
                piece(span, from, to, at(span, to), kDeepest);
            }
        }
    }

private:
    // From the last point, which is the curve's at `from`.
    void piece(std::size_t span, double from, double to, const Eigen::Vector2d& end, int depth) {
        const Eigen::Vector2d start = m_points.back();
        const double middle = 0.5 * (from + to);
        const Eigen::Vector2d half = at(span, middle);
        const bool straight = isNear(half, start, end) &&
                              isNear(at(span, 0.5 * (from + middle)), start, end) &&
                              isNear(at(span, 0.5 * (middle + to)), start, end);
        if (straight || depth == 0 || m_points.size() > m_max_points) {
            m_points.push_back(end);
            return;
        }
        piece(span, from, middle, half, depth - 1);
        piece(span, middle, to, end, depth - 1);
    }

    bool isNear(const Eigen::Vector2d& p, const Eigen::Vector2d& a, const Eigen::Vector2d& b) const {
        const double along = (b - a).squaredNorm();
        const double t = along > 0.0 ? std::clamp((p - a).dot(b - a) / along, 0.0, 1.0) : 0.0;
        return (a + t * (b - a) - p).norm() <= m_tolerance;
    }

    // De Boor's triangle in homogeneous coordinates.
    Eigen::Vector2d at(std::size_t span, double t) const {
        const auto p = static_cast<std::size_t>(m_spline.degree);
        std::array<Eigen::Vector3d, kHighestDegree + 1> d;
        for (std::size_t k = 0; k <= p; ++k) {
            const double w = m_spline.weights[span - p + k];
            d[k] << w * m_spline.control[span - p + k], w;
        }
        for (std::size_t r = 1; r <= p; ++r)
            for (std::size_t k = p; k >= r; --k) {
                const double low = m_spline.knots[span - p + k];
                const double high = m_spline.knots[span + 1 + k - r];
                const double f = (t - low) / (high - low); // high > t's span > low
                d[k] = (1.0 - f) * d[k - 1] + f * d[k];
            }
        return d[p].head<2>() / d[p].z();
    }

    const Spline& m_spline;
    std::vector<Eigen::Vector2d>& m_points;
    std::size_t m_max_points;
    double m_tolerance = 0.0;
};

// Derivatives of the C2 cubic through points whose parameters are `steps` apart: Thomas's solution of the
// tridiagonal system.
std::vector<Eigen::Vector2d> derivatives(const std::vector<Eigen::Vector2d>& points,
                                         const std::vector<double>& steps, const Eigen::Vector2d& start,
                                         const Eigen::Vector2d& end) {
    const std::size_t n = points.size();
    const auto slope = [&](std::size_t k) { return Eigen::Vector2d((points[k + 1] - points[k]) / steps[k]); };
    std::vector<double> upper(n, 0.0);
    std::vector<Eigen::Vector2d> d(n);
    const bool clampedStart = start.norm() > 0.0, clampedEnd = end.norm() > 0.0;
    upper[0] = clampedStart ? 0.0 : 0.5;
    d[0] = clampedStart ? Eigen::Vector2d(start.normalized()) : Eigen::Vector2d(1.5 * slope(0));
    for (std::size_t k = 1; k + 1 < n; ++k) {
        const double before = steps[k - 1], after = steps[k];
        const double pivot = 2.0 * (before + after) - after * upper[k - 1];
        upper[k] = before / pivot;
        d[k] = (3.0 * (after * slope(k - 1) + before * slope(k)) - after * d[k - 1]) / pivot;
    }
    if (clampedEnd)
        d[n - 1] = end.normalized();
    else
        d[n - 1] = (1.5 * slope(n - 2) - 0.5 * d[n - 2]) / (1.0 - 0.5 * upper[n - 2]);
    for (std::size_t k = n - 1; k-- > 0;)
        d[k] -= upper[k] * d[k + 1];
    return d;
}

} // namespace

EllipseArc bulgeArc(const Eigen::Vector2d& from, const Eigen::Vector2d& to, double bulge) {
    EllipseArc arc;
    arc.centre = 0.5 * (from + to) + 0.25 * (1.0 / bulge - bulge) * leftOf(to - from);
    arc.u = from - arc.centre;
    arc.v = leftOf(arc.u);
    arc.sweep = 4.0 * std::atan(bulge);
    return arc;
}

Spline splineThrough(std::vector<Eigen::Vector2d> points, bool closed, const Eigen::Vector2d& startDirection,
                     const Eigen::Vector2d& endDirection) {
    points.erase(std::unique(points.begin(), points.end()), points.end());
    if (closed && points.size() > 1 && points.front() == points.back())
        points.pop_back();
    if (points.size() < 2)
        points.resize(2, points.front());

    // Closed: more of the same before and after, until its ends are felt no more (0.27 a point).
    const std::size_t count = points.size(), extra = closed ? 24 : 0;
    const std::size_t first = extra, last = closed ? extra + count : count - 1;
    std::vector<Eigen::Vector2d> run;
    for (std::size_t k = 0; k <= last + extra; ++k)
        run.push_back(points[(k + count * extra - extra) % count]);
    std::vector<double> steps;
    for (std::size_t k = 0; k + 1 < run.size(); ++k)
        steps.push_back((run[k + 1] - run[k]).norm());
    const double longest = *std::ranges::max_element(steps);
    for (double& step : steps) // none that a sum would swallow
        step = longest > 0.0 ? std::max(step, kShortestOfSteps * longest) : 1.0;

    const Eigen::Vector2d none = Eigen::Vector2d::Zero();
    const auto d = derivatives(run, steps, closed ? none : startDirection, closed ? none : endDirection);
    Spline spline;
    spline.control.push_back(run[first]);
    spline.knots.assign(4, 0.0);
    for (std::size_t k = first; k < last; ++k) {
        const double third = steps[k] / 3.0;
        spline.control.insert(spline.control.end(),
                              {run[k] + third * d[k], run[k + 1] - third * d[k + 1], run[k + 1]});
        spline.knots.insert(spline.knots.end(), 3, spline.knots.back() + steps[k]);
    }
    spline.knots.push_back(spline.knots.back());
    spline.weights.assign(spline.control.size(), 1.0);
    return spline;
}

void flatten(const EllipseArc& arc, const Flattening& how, std::vector<Eigen::Vector2d>& points) {
    const double radius = longestRadius(arc.u, arc.v);
    const double step =
        std::min(std::sqrt(8.0 * how.tolerance / radius), 2.0 * std::numbers::pi / kMinEdgesATurn);
    const double edges = std::clamp(std::ceil(std::abs(arc.sweep) / step), 1.0, kMaxEdges);
    for (int k = 0; k <= static_cast<int>(edges); ++k) {
        const double t = arc.begin + arc.sweep * k / edges;
        points.push_back(arc.centre + std::cos(t) * arc.u + std::sin(t) * arc.v);
    }
}

void flatten(const Spline& spline, const Flattening& how, std::vector<Eigen::Vector2d>& points) {
    SplineFlattener(spline, how, points).run();
}

EllipseArc mapped(const EllipseArc& arc, const Eigen::Affine2d& map) {
    return {map * arc.centre, map.linear() * arc.u, map.linear() * arc.v, arc.begin, arc.sweep};
}

Spline mapped(const Spline& spline, const Eigen::Affine2d& map) {
    Spline image = spline;
    for (Eigen::Vector2d& p : image.control)
        p = map * p;
    return image;
}

} // namespace bask
