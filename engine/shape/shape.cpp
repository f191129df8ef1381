#include "engine/shape/shape.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

namespace bask {
namespace {

template <class... F> struct Overloaded : F... { using F::operator()...; };
template <class... F> Overloaded(F...) -> Overloaded<F...>;

// Largest |z| between `low` and `high`, which enclose one maximum.
double largestBetween(const FourierContour& contour, double low, double high) {
    for (int k = 0; k < 60; ++k) {
        const double a = low + (high - low) / 3.0, b = high - (high - low) / 3.0;
        if (std::abs(contour.point(a)) < std::abs(contour.point(b)))
            low = a;
        else
            high = b;
    }
    return std::abs(contour.point(0.5 * (low + high)));
}

double radiusOf(const FourierContour& contour) {
    const int n = std::max(256, 32 * contour.harmonics());
    std::vector<double> r(static_cast<std::size_t>(n));
    for (int k = 0; k < n; ++k)
        r[static_cast<std::size_t>(k)] = std::abs(contour.point(static_cast<double>(k) / n));
    const double coarse = *std::ranges::max_element(r);
    double most = coarse;
    for (int k = 0; k < n; ++k)
        if (r[static_cast<std::size_t>(k)] >= 0.99 * coarse &&
            r[static_cast<std::size_t>(k)] >= r[static_cast<std::size_t>((k + 1) % n)] &&
            r[static_cast<std::size_t>(k)] >= r[static_cast<std::size_t>((k + n - 1) % n)])
            most = std::max(most, largestBetween(contour, (k - 1.0) / n, (k + 1.0) / n));
    return most;
}

} // namespace

double shapeArea(const Shape& shape) {
    return std::visit(Overloaded{[](const Disk& d) { return std::numbers::pi * d.radius_m * d.radius_m; },
                                 [](const FourierContour& c) { return c.area(); },
                                 [](const Contour& c) { return contourArea(c); }},
                      shape);
}

double shapePerimeter(const Shape& shape) {
    return std::visit(Overloaded{[](const Disk& d) { return 2.0 * std::numbers::pi * d.radius_m; },
                                 [](const FourierContour& c) { return c.perimeter(); },
                                 [](const Contour& c) { return contourPerimeter(c); }},
                      shape);
}

double shapeRadius(const Shape& shape) {
    return std::visit(Overloaded{[](const Disk& d) { return d.radius_m; },
                                 [](const FourierContour& c) { return radiusOf(c); },
                                 [](const Contour& c) {
                                     double most = 0.0;
                                     for (const Eigen::Vector2d& p : c.points_m)
                                         most = std::max(most, p.norm());
                                     return most;
                                 }},
                      shape);
}

std::vector<Eigen::Vector2d> shapeOutline(const Shape& shape, int n) {
    if (const auto* polygon = std::get_if<Contour>(&shape))
        return polygon->points_m;
    if (n < 3)
        throw std::invalid_argument("shapeOutline: at least 3 points");
    std::vector<Eigen::Vector2d> points;
    points.reserve(static_cast<std::size_t>(n));
    for (int k = 0; k < n; ++k) {
        const double phi = static_cast<double>(k) / n;
        const std::complex<double> z =
            std::holds_alternative<Disk>(shape)
                ? std::polar(std::get<Disk>(shape).radius_m, 2.0 * std::numbers::pi * phi)
                : std::get<FourierContour>(shape).point(phi);
        points.emplace_back(z.real(), z.imag());
    }
    return points;
}

} // namespace bask
