#include "engine/radiation/point_factor.h"

#include "engine/radiation/gauss_rule.h"
#include "engine/radiation/lambert_field.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <utility>
#include <vector>

namespace bask {
namespace {

constexpr int kMaxPanels = 20000; // for a Fourier outline: a limit for points that almost lie on it

/// The element. With r = s - p, F = -1/(2 pi) loop of n . (r x dr)/|r|^2 over the outline of the part with
/// n . r > 0 (Lambert): each straight edge gives the angle it subtends times the cosine to its plane's
/// normal.
struct Element {
    Eigen::Vector3d p, n;

    Eigen::Vector3d to(double x, double y) const { return {x - p.x(), y - p.y(), -p.z()}; }
    double height(double x, double y) const { return n.dot(to(x, y)); }

    /// Contribution of the straight line from r = a to r = b to the loop, without the factor.
    double edge(const Eigen::Vector3d& a, const Eigen::Vector3d& b) const {
        return n.dot(straightField(a, b));
    }
    /// The same on the line where the element's plane meets the source plane. The pieces of a non-convex
    /// source are joined there in the order of the outline: parts that are passed twice cancel.
    double edgeOnHorizon(const Eigen::Vector3d& a, const Eigen::Vector3d& b) const {
        return std::atan2(n.dot(a.cross(b)), a.dot(b));
    }
};

double circulation(const Disk& disk, const Element& element) {
    const ArcField arc(disk.radius_m, element.p);
    const double tilt = disk.radius_m * std::hypot(element.n.x(), element.n.y());
    const double middle = element.height(0.0, 0.0);
    if (middle <= -tilt)
        return 0.0;
    if (middle >= tilt)
        return element.n.dot(arc.whole());
    // Visible is the arc of +-half about the direction of the normal.
    const double direction = std::atan2(element.n.y(), element.n.x());
    const double half = std::acos(-middle / tilt);
    const Eigen::Vector2d from(std::cos(direction - half), std::sin(direction - half)),
        to(std::cos(direction + half), std::sin(direction + half));
    const auto rim = [&](const Eigen::Vector2d& u) {
        return element.to(disk.radius_m * u.x(), disk.radius_m * u.y());
    };
    return element.n.dot(arc.between(from, to, half > 0.5 * std::numbers::pi)) +
           element.edgeOnHorizon(rim(to), rim(from));
}

double circulation(const Contour& polygon, const Element& element) {
    // The pieces are joined along the horizon through its point nearest to the element.
    const Eigen::Vector3d nearest = element.n.z() * element.n - Eigen::Vector3d::UnitZ();
    double sum = 0.0;
    const auto& points = polygon.points_m;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const Eigen::Vector2d& next = points[(i + 1) % points.size()];
        const Eigen::Vector3d a = element.to(points[i].x(), points[i].y()),
                              b = element.to(next.x(), next.y());
        const double ha = element.n.dot(a), hb = element.n.dot(b);
        if (ha > 0.0 && hb > 0.0) {
            sum += element.edge(a, b);
        } else if (ha > 0.0 || hb > 0.0) {
            const Eigen::Vector3d cut = a + ha / (ha - hb) * (b - a);
            sum += ha > 0.0 ? element.edge(a, cut) + element.edgeOnHorizon(cut, nearest)
                            : element.edgeOnHorizon(nearest, cut) + element.edge(cut, b);
        }
    }
    return sum;
}

/// Roots of f in [0, 1] among `samples` steps, with the sign after each; f(0) = f(1).
template <class F> std::vector<std::pair<double, bool>> signChanges(const F& f, int samples) {
    std::vector<std::pair<double, bool>> found;
    bool last = f(0.0) > 0.0;
    for (int i = 1; i <= samples; ++i) {
        double low = (i - 1.0) / samples, high = static_cast<double>(i) / samples;
        const bool now = i == samples ? f(0.0) > 0.0 : f(high) > 0.0;
        if (now != last) {
            for (int k = 0; k < 60; ++k) {
                const double middle = 0.5 * (low + high);
                ((f(middle) > 0.0) == last ? low : high) = middle;
            }
            found.emplace_back(0.5 * (low + high), now);
        }
        last = now;
    }
    return found;
}

/// Enough samples that a dip of the outline below the horizon between two of them contributes less than
/// 1e-12: its effect is of fifth order in the step.
int samplesOf(const FourierContour& contour) {
    return 512 + 64 * contour.harmonics();
}

/// Gauss sums over halves until they agree with the whole to `allowed` and the integrand's own noise at the
/// middle, or `budget` panels are spent.
template <class F, class Noise> class Halving {
public:
    Halving(const F& f, const Noise& noise, double allowed, int budget)
        : m_f(f), m_noise(noise), m_allowed(allowed), m_budget(budget) {}

    double operator()(double from, double to) { return refine(from, to, panel(from, to)); }

private:
    double panel(double from, double to) {
        static const GaussRule rule = gaussRule(12);
        --m_budget;
        double sum = 0.0;
        for (std::size_t i = 0; i < rule.nodes.size(); ++i)
            sum += rule.weights[i] * m_f(from + (to - from) * rule.nodes[i]);
        return (to - from) * sum;
    }
    double refine(double from, double to, double whole) {
        const double middle = 0.5 * (from + to);
        const double left = panel(from, middle), right = panel(middle, to);
        if (std::abs(left + right - whole) <= m_allowed + m_noise(middle) || m_budget <= 0)
            return left + right;
        return refine(from, middle, left) + refine(middle, to, right);
    }

    const F& m_f;
    const Noise& m_noise;
    double m_allowed;
    int m_budget;
};

double circulation(const FourierContour& contour, const Element& element) {
    const auto at = [&](double phi) {
        const std::complex<double> s = contour.point(phi);
        return element.to(s.real(), s.imag());
    };
    const auto integrand = [&](double phi) {
        const std::complex<double> slope = contour.derivative(phi);
        const Eigen::Vector3d r = at(phi);
        return element.n.dot(r.cross(Eigen::Vector3d(slope.real(), slope.imag(), 0.0))) / r.squaredNorm();
    };
    // Close to the outline, rounding of its points appears under a wide angle.
    const double size = contour.perimeter();
    const auto noise = [&](double phi) { return 1e-15 * size / std::max(at(phi).norm(), 1e-15 * size); };
    Halving integral(integrand, noise, 1e-13, kMaxPanels);
    // Starts with panels of a quarter wave, so that whole and halves do not agree by chance.
    const auto stretch = [&](double from, double to) {
        const int panels =
            std::max(1, static_cast<int>(std::ceil((to - from) * 4 * (contour.harmonics() + 1))));
        double sum = 0.0;
        for (int i = 0; i < panels; ++i)
            sum += integral(from + (to - from) * i / panels, from + (to - from) * (i + 1) / panels);
        return sum;
    };
    const auto cuts = signChanges([&](double phi) { return element.n.dot(at(phi)); }, samplesOf(contour));
    if (cuts.empty())
        return element.n.dot(at(0.0)) > 0.0 ? stretch(0.0, 1.0) : 0.0;
    double sum = 0.0;
    for (std::size_t i = 0; i < cuts.size(); ++i) {
        const double here = cuts[i].first;
        const double next = i + 1 < cuts.size() ? cuts[i + 1].first : cuts[0].first + 1.0;
        sum += cuts[i].second ? stretch(here, next) : element.edgeOnHorizon(at(here), at(next));
    }
    return sum;
}

double circulation(const PiercedShape& pierced, const Element& element) {
    double sum =
        std::visit([&](const auto& outline) { return circulation(outline, element); }, pierced.outline);
    for (const Contour& hole : pierced.holes)
        sum -= circulation(hole, element);
    return sum;
}

bool isOnEdge(const Contour& polygon, const Eigen::Vector2d& p) {
    const auto& points = polygon.points_m;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const Eigen::Vector2d a = points[i] - p, b = points[(i + 1) % points.size()] - p;
        if (a.x() * b.y() - a.y() * b.x() == 0.0 && a.dot(b) <= 0.0)
            return true;
    }
    return false;
}

// The edges belong to the face.
bool isInside(const Disk& disk, const Eigen::Vector2d& p) {
    return p.norm() <= disk.radius_m;
}

bool isInside(const Contour& polygon, const Eigen::Vector2d& p) {
    return isOnEdge(polygon, p) || encloses(polygon.points_m, p);
}

bool isInside(const FourierContour& contour, const Eigen::Vector2d& p) {
    bool inside = false;
    for (const auto& cut :
         signChanges([&](double phi) { return contour.point(phi).imag() - p.y(); }, samplesOf(contour)))
        if (contour.point(cut.first).real() >= p.x())
            inside = !inside;
    return inside;
}

bool isInside(const PiercedShape& pierced, const Eigen::Vector2d& p) {
    const auto isOff = [&](const Contour& hole) { return isOnEdge(hole, p) || !encloses(hole.points_m, p); };
    return std::visit([&](const auto& outline) { return isInside(outline, p); }, pierced.outline) &&
           std::ranges::all_of(pierced.holes, isOff);
}

} // namespace

double pointFactor(const Shape& source, const Eigen::Vector3d& p_SP, const Eigen::Vector3d& normal_S) {
    const double length = normal_S.norm();
    if (!p_SP.allFinite() || !std::isfinite(length) || length == 0.0)
        throw std::invalid_argument(
            "pointFactor: position and normal must be finite and the normal not zero");
    if (!(shapeArea(source) > 0.0))
        throw std::invalid_argument("pointFactor: the source's area must be positive");
    if (p_SP.z() == 0.0 && std::visit([&](const auto& s) { return isInside(s, p_SP.head<2>()); }, source))
        throw std::invalid_argument("pointFactor: the point lies in the source");
    if (p_SP.z() <= 0.0)
        return 0.0;
    const Element element{p_SP, normal_S / length};
    const double loop = std::visit([&](const auto& s) { return circulation(s, element); }, source);
    return std::clamp(-loop / (2.0 * std::numbers::pi), 0.0, 1.0);
}

} // namespace bask
