#include "tests/engine/radiation/lambert_reference.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

namespace bask::test {
namespace {

struct Rule {
    std::vector<double> x, w; // on [0, 1]
};

// Golub and Welsch would do; Newton on the Legendre recurrence is shorter.
Rule legendre(int n) {
    Rule rule;
    for (int i = 0; i < n; ++i) {
        double x = std::cos(std::numbers::pi * (i + 0.75) / (n + 0.5));
        double slope = 0.0;
        for (int step = 0; step < 20; ++step) {
            double p0 = 1.0;
            double p1 = x;
            for (int k = 2; k <= n; ++k) {
                const double p2 = ((2 * k - 1) * x * p1 - (k - 1) * p0) / k;
                p0 = p1;
                p1 = p2;
            }
            slope = n * (x * p1 - p0) / (x * x - 1.0);
            x -= p1 / slope;
        }
        rule.x.push_back(0.5 * (1.0 - x));
        rule.w.push_back(1.0 / ((1.0 - x * x) * slope * slope));
    }
    return rule;
}

/// Point factor of an element at p with the unit normal n, over the disk's points s with n.(s - p) > 0.
class PointFactor {
public:
    PointFactor(double radius, const Eigen::Vector3d& n, const Eigen::Vector3d& p0, const Rule& rule)
        : m_radius(radius), m_n(n), m_rule(rule) {
        const double tilt = std::hypot(n.x(), n.y());
        m_azimuth = std::atan2(n.y(), n.x());
        const double c = -n.dot(p0);
        m_half =
            tilt * radius <= c ? std::numbers::pi : std::acos(std::clamp(-c / (radius * tilt), -1.0, 1.0));
    }

    double operator()(const Eigen::Vector3d& p) const {
        double sum = 0.0;
        for (std::size_t i = 0; i < m_rule.x.size(); ++i) {
            // Strips parallel to the cut, x1 = cos(theta); across each, x2 = sin(theta) t.
            const double theta = m_half * m_rule.x[i];
            for (std::size_t k = 0; k < m_rule.x.size(); ++k) {
                const double x1 = m_radius * std::cos(theta);
                const double x2 = m_radius * std::sin(theta) * (2.0 * m_rule.x[k] - 1.0);
                const Eigen::Vector3d s(x1 * std::cos(m_azimuth) - x2 * std::sin(m_azimuth),
                                        x1 * std::sin(m_azimuth) + x2 * std::cos(m_azimuth), 0.0);
                const Eigen::Vector3d d = s - p;
                const double d2 = d.squaredNorm();
                const double area = m_half * m_rule.w[i] * m_radius * std::sin(theta) * 2.0 * m_radius *
                                    std::sin(theta) * m_rule.w[k];
                sum += area * m_n.dot(d) * -d.z() / (std::numbers::pi * d2 * d2);
            }
        }
        return sum;
    }

private:
    double m_radius;
    Eigen::Vector3d m_n;
    const Rule& m_rule;
    double m_azimuth = 0.0;
    double m_half = 0.0;
};

using Curve = std::function<std::complex<double>(double)>;

struct Stretch {
    Curve point;
    double from, to;
};

// The outline as smooth stretches over [0, 1].
std::vector<Stretch> stretchesOf(const Shape& shape) {
    if (const auto* disk = std::get_if<Disk>(&shape)) {
        const double r = disk->radius_m;
        return {{[r](double t) { return std::polar(r, 2.0 * std::numbers::pi * t); }, 0.0, 1.0}};
    }
    if (const auto* fourier = std::get_if<FourierContour>(&shape)) {
        const FourierContour f = *fourier;
        return {{[f](double t) { return f.point(t - std::floor(t)); }, 0.0, 1.0}};
    }
    std::vector<Stretch> result;
    const auto& points = std::get<Contour>(shape).points_m;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const std::complex<double> a(points[i].x(), points[i].y());
        const auto& q = points[(i + 1) % points.size()];
        const std::complex<double> b(q.x(), q.y());
        result.push_back({[a, b](double t) { return a + t * (b - a); }, 0.0, 1.0});
    }
    return result;
}

// Parts of a stretch with positive height, in short pieces, by dumb sampling and bisection.
std::vector<Stretch> partsAbove(const Stretch& stretch,
                                const std::function<double(std::complex<double>)>& height) {
    constexpr int kSamples = 2048;
    constexpr int kLongest = kSamples / 8;
    std::vector<Stretch> result;
    const auto z = [&](double t) { return height(stretch.point(t)); };
    const auto root = [&](double a, double b) {
        for (int i = 0; i < 60; ++i) {
            const double middle = 0.5 * (a + b);
            ((z(middle) > 0.0) == (z(a) > 0.0) ? a : b) = middle;
        }
        return 0.5 * (a + b);
    };
    double start = 0.0;
    int first = 0;
    for (int i = 0; i < kSamples; ++i) {
        const double a = static_cast<double>(i) / kSamples;
        const double b = static_cast<double>(i + 1) / kSamples;
        const bool here = z(a) > 0.0;
        const bool there = z(b) > 0.0;
        if (!here && there) {
            start = root(a, b);
            first = i;
        }
        if (here && !there)
            result.push_back({stretch.point, start, root(a, b)});
        else if (there && (i + 1 - first >= kLongest || i + 1 == kSamples)) {
            result.push_back({stretch.point, start, b});
            start = b;
            first = i + 1;
        }
    }
    return result;
}

} // namespace

// The object's visible area as a fan of (signed) sectors about one of its own points in front of the source
// plane; the straight closing edges on the cut line belong to the same fan.
double lambertViewFactor(const Disk& source, const Shape& object, const Pose& X_SO, int nodes) {
    const Rule rule = legendre(nodes);
    const Eigen::Vector3d n = -X_SO.linear().col(2);
    const PointFactor factor(source.radius_m, n, X_SO.translation(), rule);
    const auto inS = [&](std::complex<double> q) {
        return Eigen::Vector3d(X_SO * Eigen::Vector3d(q.real(), q.imag(), 0.0));
    };
    const auto height = [&](std::complex<double> q) { return inS(q).z(); };
    std::vector<Stretch> fan;
    for (const Stretch& stretch : stretchesOf(object))
        for (const Stretch& part : partsAbove(stretch, height))
            fan.push_back(part);
    if (fan.empty())
        return 0.0;
    for (std::size_t i = 0, count = fan.size(); i < count; ++i) {
        const Stretch& here = fan[i];
        const Stretch& next = fan[(i + 1) % count];
        const std::complex<double> a = here.point(here.to);
        const std::complex<double> b = next.point(next.from);
        if (std::abs(b - a) > 1e-12 * source.radius_m)
            fan.push_back({[a, b](double t) { return a + t * (b - a); }, 0.0, 1.0});
    }
    const std::complex<double> apex = fan[0].point(0.5 * (fan[0].from + fan[0].to));
    double sum = 0.0;
    for (const Stretch& part : fan) {
        const double width = part.to - part.from;
        for (std::size_t i = 0; i < rule.x.size(); ++i) {
            const double t = part.from + width * rule.x[i];
            const double h = 1e-4 * width;
            const auto slope = (8.0 * (part.point(t + h) - part.point(t - h)) -
                                (part.point(t + 2.0 * h) - part.point(t - 2.0 * h))) /
                               (12.0 * h);
            const std::complex<double> arm = part.point(t) - apex;
            const double cross = arm.real() * slope.imag() - arm.imag() * slope.real();
            for (std::size_t k = 0; k < rule.x.size(); ++k)
                sum +=
                    width * rule.w[i] * rule.w[k] * rule.x[k] * cross * factor(inS(apex + rule.x[k] * arm));
        }
    }
    return sum / shapeArea(object);
}

} // namespace bask::test
