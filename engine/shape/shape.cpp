#include "engine/shape/shape.h"

#include "engine/base/message_code.h"
#include "engine/shape/crossing.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string>
#include <utility>

namespace bask {
namespace {

constexpr int kFittingPoints = 4096; // of a curve, when holes are fitted into it

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
    double max = coarse;
    for (int k = 0; k < n; ++k)
        if (r[static_cast<std::size_t>(k)] >= 0.99 * coarse &&
            r[static_cast<std::size_t>(k)] >= r[static_cast<std::size_t>((k + 1) % n)] &&
            r[static_cast<std::size_t>(k)] >= r[static_cast<std::size_t>((k + n - 1) % n)])
            max = std::max(max, largestBetween(contour, (k - 1.0) / n, (k + 1.0) / n));
    return max;
}

} // namespace

Shape withHoles(const Shape& outline, std::vector<Contour> holes) {
    PlainShape plain = outlineOf(outline);
    if (!holes.empty())
        return PiercedShape{std::move(plain), std::move(holes)};
    return std::visit([](auto& kind) { return Shape(std::move(kind)); }, plain);
}

PlainShape outlineOf(const Shape& shape) {
    return std::visit(Overloaded{[](const PiercedShape& pierced) { return pierced.outline; },
                                 [](const auto& plain) { return PlainShape(plain); }},
                      shape);
}

const std::vector<Contour>& holesOf(const Shape& shape) {
    static const std::vector<Contour> kNone;
    const auto* pierced = std::get_if<PiercedShape>(&shape);
    return pierced ? pierced->holes : kNone;
}

Result<void> checkHole(const Contour& hole, const std::vector<Eigen::Vector2d>& outline,
                       std::span<const Contour> others, const std::string& where) {
    const std::vector<Eigen::Vector2d>& ring = hole.points_m;
    if (const auto simple = makeContour(ring, where); !simple)
        return simple.error();
    if (findMeeting(ring, outline) || !encloses(outline, ring.front()))
        return Error{MessageCode::HoleOutside, where};
    for (std::size_t i = 0; i < others.size(); ++i) {
        const std::vector<Eigen::Vector2d>& other = others[i].points_m;
        if (findMeeting(ring, other) || encloses(other, ring.front()) || encloses(ring, other.front()))
            return Error{MessageCode::HolesMeet, where, {std::to_string(i)}};
    }
    return {};
}

Result<void> checkHoles(const Shape& shape, const std::string& where) {
    const std::vector<Contour>& holes = holesOf(shape);
    if (holes.size() > kMaxHoles)
        return Error{
            MessageCode::HolesTooMany, where, {std::to_string(holes.size()), std::to_string(kMaxHoles)}};
    if (holes.empty())
        return {};
    const std::vector<Eigen::Vector2d> outline = shapeOutline(shape, kFittingPoints);
    for (std::size_t k = 0; k < holes.size(); ++k)
        if (auto fits = checkHole(holes[k], outline, std::span(holes).first(k),
                                  where + '[' + std::to_string(k) + ']');
            !fits)
            return fits;
    return {};
}

Shape shapeOfFit(const FourierFit& fit, const std::vector<Contour>& holes) {
    std::vector<Contour> moved;
    for (const Contour& hole : holes)
        moved.push_back(shifted(hole, -fit.centre_m));
    return withHoles(fit.contour, std::move(moved));
}

namespace {

Contour mirroredContour(Contour contour) {
    for (Eigen::Vector2d& p : contour.points_m)
        p.y() = -p.y();
    std::ranges::reverse(contour.points_m);
    return contour;
}

} // namespace

Shape mirrored(const Shape& shape) {
    return std::visit(Overloaded{[](const Disk& disk) -> Shape { return disk; },
                                 [](const FourierContour& series) -> Shape { // conj z(-phi)
                                     std::vector<std::complex<double>> coefficients = series.coefficients();
                                     for (std::complex<double>& c : coefficients)
                                         c = std::conj(c);
                                     return FourierContour(std::move(coefficients));
                                 },
                                 [](const Contour& polygon) -> Shape { return mirroredContour(polygon); },
                                 [](const PiercedShape& pierced) {
                                     std::vector<Contour> holes;
                                     for (const Contour& hole : pierced.holes)
                                         holes.push_back(mirroredContour(hole));
                                     return withHoles(mirrored(withHoles(pierced, {})), std::move(holes));
                                 }},
                      shape);
}

double shapeArea(const Shape& shape) {
    return std::visit(Overloaded{[](const Disk& d) { return std::numbers::pi * d.radius_m * d.radius_m; },
                                 [](const FourierContour& c) { return c.area(); },
                                 [](const Contour& c) { return contourArea(c); },
                                 [](const PiercedShape& p) {
                                     double area = shapeArea(withHoles(p, {}));
                                     for (const Contour& hole : p.holes)
                                         area -= contourArea(hole);
                                     return area;
                                 }},
                      shape);
}

double shapePerimeter(const Shape& shape) {
    return std::visit(Overloaded{[](const Disk& d) { return 2.0 * std::numbers::pi * d.radius_m; },
                                 [](const FourierContour& c) { return c.perimeter(); },
                                 [](const Contour& c) { return contourPerimeter(c); },
                                 [](const PiercedShape& p) { return shapePerimeter(withHoles(p, {})); }},
                      shape);
}

double shapeCharacteristicLength(const Shape& shape) {
    return shapeArea(shape) / shapePerimeter(shape);
}

double shapeRadius(const Shape& shape) {
    return std::visit(Overloaded{[](const Disk& d) { return d.radius_m; },
                                 [](const FourierContour& c) { return radiusOf(c); },
                                 [](const Contour& c) {
                                     double max = 0.0;
                                     for (const Eigen::Vector2d& p : c.points_m)
                                         max = std::max(max, p.norm());
                                     return max;
                                 },
                                 [](const PiercedShape& p) { return shapeRadius(withHoles(p, {})); }},
                      shape);
}

std::vector<Eigen::Vector2d> shapeOutline(const Shape& shape, int n) {
    if (const auto* polygon = outlineAs<Contour>(shape))
        return polygon->points_m;
    if (n < 3)
        throw std::invalid_argument("shapeOutline: at least 3 points");
    const auto* disk = outlineAs<Disk>(shape);
    const auto* series = outlineAs<FourierContour>(shape);
    std::vector<Eigen::Vector2d> points;
    points.reserve(static_cast<std::size_t>(n));
    for (int k = 0; k < n; ++k) {
        const double phi = static_cast<double>(k) / n;
        const std::complex<double> z =
            disk ? std::polar(disk->radius_m, 2.0 * std::numbers::pi * phi) : series->point(phi);
        points.emplace_back(z.real(), z.imag());
    }
    return points;
}

std::vector<std::vector<Eigen::Vector2d>> shapeRings(const Shape& shape, int n) {
    std::vector<std::vector<Eigen::Vector2d>> rings{shapeOutline(shape, n)};
    for (const Contour& hole : holesOf(shape))
        rings.push_back(hole.points_m);
    return rings;
}

} // namespace bask
