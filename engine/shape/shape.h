#pragma once
// The shapes the solver knows: disk, Fourier contour, polygon; each centred on its frame's origin,
// counter-clockwise.

#include "engine/shape/contour.h"
#include "engine/shape/fourier_contour.h"

#include <variant>
#include <vector>

namespace bask {

struct Disk {
    double radius_m = 0.0;
    bool operator==(const Disk&) const = default;
};

using Shape = std::variant<Disk, FourierContour, Contour>;

double shapeArea(const Shape& shape);      ///< m2
double shapePerimeter(const Shape& shape); ///< m
double shapeRadius(const Shape& shape); ///< m, of the smallest circle about the origin that holds the outline

/// `n` points (m) along the outline, counter-clockwise (a polygon gives its own vertices, whatever n is).
std::vector<Eigen::Vector2d> shapeOutline(const Shape& shape, int n);

} // namespace bask
