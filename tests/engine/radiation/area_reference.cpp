#include "tests/engine/radiation/area_reference.h"

#include "tests/engine/radiation/face_pairs.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <functional>
#include <numbers>

namespace bask::test {
namespace {

using Complex = std::complex<double>;
using Height = std::function<double(Complex)>;

struct Rule {
    std::vector<double> x, w; // on [0, 1]
};

// Newton on the Legendre recurrence.
Rule legendre(int n) {
    Rule rule;
    for (int i = 0; i < n; ++i) {
        double x = std::cos(kPi * (i + 0.75) / (n + 0.5));
        double slope = 1.0;
        for (int step = 0; step < 20; ++step) {
            double p0 = 1.0, p1 = x;
            for (int k = 2; k <= n; ++k)
                p0 = std::exchange(p1, ((2 * k - 1) * x * p1 - (k - 1) * p0) / k);
            slope = n * (x * p1 - p0) / (x * x - 1.0);
            x -= p1 / slope;
        }
        rule.x.push_back(0.5 * (1.0 - x));
        rule.w.push_back(1.0 / ((1.0 - x * x) * slope * slope));
    }
    return rule;
}

struct Stretch {
    std::function<Complex(double)> point, slope;
    double from = 0.0, to = 1.0;
};

Stretch straight(Complex a, Complex b) {
    return {[a, b](double t) { return a + t * (b - a); }, [a, b](double) { return b - a; }};
}

std::vector<Stretch> stretchesOf(const Shape& shape) {
    std::vector<Stretch> result;
    if (const auto* polygon = std::get_if<Contour>(&shape)) {
        const auto& p = polygon->points_m;
        for (std::size_t i = 0; i < p.size(); ++i) {
            const auto& q = p[(i + 1) % p.size()];
            result.push_back(straight({p[i].x(), p[i].y()}, {q.x(), q.y()}));
        }
        return result;
    }
    const auto* disk = std::get_if<Disk>(&shape);
    const FourierContour curve =
        disk ? FourierContour({0.0, 0.0, disk->radius_m}) : std::get<FourierContour>(shape);
    const int parts = 4 * (curve.harmonics() + 1);
    for (int i = 0; i < parts; ++i)
        result.push_back({[curve](double t) { return curve.point(t - std::floor(t)); },
                          [curve](double t) { return curve.derivative(t - std::floor(t)); },
                          static_cast<double>(i) / parts, static_cast<double>(i + 1) / parts});
    return result;
}

void appendPartsInFront(const Stretch& stretch, const Height& height, std::vector<Stretch>& parts) {
    constexpr int kSamples = 64;
    const auto front = [&](double t) { return height(stretch.point(t)) > 0.0; };
    double start = stretch.from;
    for (int i = 0; i < kSamples; ++i) {
        const double width = (stretch.to - stretch.from) / kSamples;
        double a = stretch.from + i * width;
        double b = i + 1 == kSamples ? stretch.to : a + width;
        const bool before = front(a), after = front(b);
        for (int k = 0; before != after && k < 60; ++k) {
            const double middle = 0.5 * (a + b);
            (front(middle) == before ? a : b) = middle;
        }
        if (!before && after)
            start = b;
        if ((before && !after) || (after && i + 1 == kSamples))
            parts.push_back({stretch.point, stretch.slope, start, after ? stretch.to : a});
    }
}

// A closed loop: what is in front, with straight ways from where it leaves to where it comes back.
std::vector<Stretch> visibleLoop(const Shape& shape, const Height& height) {
    std::vector<Stretch> parts;
    for (const Stretch& stretch : stretchesOf(shape))
        appendPartsInFront(stretch, height, parts);
    std::vector<Stretch> loop;
    for (std::size_t i = 0; i < parts.size(); ++i) {
        const Stretch& next = parts[(i + 1) % parts.size()];
        const Complex a = parts[i].point(parts[i].to), b = next.point(next.from);
        loop.push_back(parts[i]);
        if (std::abs(b - a) > 1e-13 * shapeRadius(shape))
            loop.push_back(straight(a, b));
    }
    return loop;
}

struct Loops {
    std::vector<Stretch> source, object;
};

Loops visibleLoops(const Shape& source, const Shape& object, const Pose& X_SO) {
    const Eigen::Vector3d n = -X_SO.linear().col(2);
    return {visibleLoop(source,
                        [&](Complex s) {
                            return n.dot(Eigen::Vector3d(s.real(), s.imag(), 0.0) - X_SO.translation());
                        }),
            visibleLoop(object,
                        [&](Complex q) { return (X_SO * Eigen::Vector3d(q.real(), q.imag(), 0.0)).z(); })};
}

struct Node {
    Eigen::Vector3d p;
    double weight;
};

// A fan of (signed) sectors about a point of the loop.
std::vector<Node> areaNodes(const std::vector<Stretch>& loop, const Pose& X, const Rule& rule) {
    std::vector<Node> nodes;
    if (loop.empty())
        return nodes;
    const Complex apex = loop[0].point(loop[0].from);
    for (const Stretch& part : loop)
        for (std::size_t i = 0; i < rule.x.size(); ++i) {
            const double t = part.from + (part.to - part.from) * rule.x[i];
            const Complex arm = part.point(t) - apex, step = part.slope(t);
            const double cross = arm.real() * step.imag() - arm.imag() * step.real();
            for (std::size_t k = 0; k < rule.x.size(); ++k) {
                const Complex q = apex + rule.x[k] * arm;
                nodes.push_back({X * Eigen::Vector3d(q.real(), q.imag(), 0.0),
                                 (part.to - part.from) * rule.w[i] * rule.w[k] * rule.x[k] * cross});
            }
        }
    return nodes;
}

struct Step {
    double x, y, z, dx, dy; // the z of the step meets no other
};

std::vector<Step> outlineSteps(const std::vector<Stretch>& loop, const Pose& X, double panel_m) {
    const Rule rule = legendre(10);
    std::vector<Step> steps;
    for (const Stretch& part : loop) {
        double length = 0.0;
        for (int i = 0; i < 16; ++i)
            length += std::abs(part.slope(part.from + (part.to - part.from) * (i + 0.5) / 16)) / 16;
        const int panels = std::max(1, static_cast<int>(std::ceil(length * (part.to - part.from) / panel_m)));
        const double width = (part.to - part.from) / panels;
        for (int k = 0; k < panels; ++k)
            for (std::size_t i = 0; i < rule.x.size(); ++i) {
                const double t = part.from + (k + rule.x[i]) * width;
                const Complex q = part.point(t), d = width * rule.w[i] * part.slope(t);
                const Eigen::Vector3d p = X * Eigen::Vector3d(q.real(), q.imag(), 0.0);
                const Eigen::Vector3d step = X.linear() * Eigen::Vector3d(d.real(), d.imag(), 0.0);
                steps.push_back({p.x(), p.y(), p.z(), step.x(), step.y()});
            }
    }
    return steps;
}

} // namespace

double areaViewFactor(const Shape& source, const Shape& object, const Pose& X_SO, int nodes) {
    const Loops loops = visibleLoops(source, object, X_SO);
    const Rule rule = legendre(nodes);
    const std::vector<Node> from = areaNodes(loops.object, X_SO, rule);
    const std::vector<Node> to = areaNodes(loops.source, Pose::Identity(), rule);
    const Eigen::Vector3d n = -X_SO.linear().col(2);
    double sum = 0.0;
    for (const Node& p : from) {
        double inner = 0.0;
        for (const Node& s : to) {
            const double x = s.p.x() - p.p.x(), y = s.p.y() - p.p.y(), z = -p.p.z();
            const double square = x * x + y * y + z * z;
            inner += s.weight * (n.x() * x + n.y() * y + n.z() * z) / (square * square);
        }
        sum += p.weight * inner * p.p.z();
    }
    return sum / (kPi * shapeArea(object));
}

double contourViewFactor(const Shape& source, const Shape& object, const Pose& X_SO, double panel_m) {
    const Loops loops = visibleLoops(source, object, X_SO);
    const std::vector<Step> from = outlineSteps(loops.object, X_SO, panel_m);
    const std::vector<Step> to = outlineSteps(loops.source, Pose::Identity(), panel_m);
    double sum = 0.0;
    for (const Step& p : from) {
        double inner = 0.0;
        for (const Step& s : to) {
            const double x = s.x - p.x, y = s.y - p.y;
            inner += std::log(x * x + y * y + p.z * p.z) * (s.dx * p.dx + s.dy * p.dy);
        }
        sum += inner;
    }
    return -sum / (4.0 * kPi * shapeArea(object));
}

} // namespace bask::test
