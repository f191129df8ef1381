#pragma once
// The shapes the solver knows: disk, Fourier contour, polygon, and each of them with holes;
// counter-clockwise, the outline centred on its frame's origin.

#include "engine/shape/contour.h"
#include "engine/shape/fourier_contour.h"

#include <span>
#include <string>
#include <variant>
#include <vector>

namespace bask {

struct Disk {
    double radius_m = 0.0;
    bool operator==(const Disk&) const = default;
};

/// A face without holes.
using PlainShape = std::variant<Disk, FourierContour, Contour>;

/// A face with holes, at least one: checked contours in the outline's frame, inside the outline and clear of
/// it and of one another (checkHoles). Made by withHoles.
struct PiercedShape {
    PlainShape outline;
    std::vector<Contour> holes;
    bool operator==(const PiercedShape&) const = default;
};

using Shape = std::variant<Disk, FourierContour, Contour, PiercedShape>;

/// The outline with these holes instead of its own; the plain outline when there are none.
Shape withHoles(const Shape& outline, std::vector<Contour> holes);
/// The shape without its holes.
PlainShape outlineOf(const Shape& shape);
const std::vector<Contour>& holesOf(const Shape& shape);
/// The outline when it is a T (Disk, FourierContour, Contour), with holes in it or not; else null. Lives as
/// long as the shape.
template <class T> const T* outlineAs(const Shape& shape) {
    const auto* pierced = std::get_if<PiercedShape>(&shape);
    return pierced ? std::get_if<T>(&pierced->outline) : std::get_if<T>(&shape);
}

inline constexpr std::size_t kMaxHoles = 200; ///< in one shape

/// Whether the holes fit into the shape (a Fourier contour as it is truncated, to a millionth of its size):
/// simple contours, at most kMaxHoles, inside the outline, none touching it or another, none in another.
/// Errors: HolesTooMany, HoleOutside, HolesMeet, and makeContour's, with `where`[k] as place.
Result<void> checkHoles(const Shape& shape, const std::string& where = {});
/// The same of one more hole, in the polygon `outline` beside `others`.
Result<void> checkHole(const Contour& hole, const std::vector<Eigen::Vector2d>& outline,
                       std::span<const Contour> others, const std::string& where = {});

/// The fit with the holes of the outline that was fitted, in its coordinates: they move with the centroid.
Shape shapeOfFit(const FourierFit& fit, const std::vector<Contour>& holes);

double shapeArea(const Shape& shape);      ///< m2, holes counted off
double shapePerimeter(const Shape& shape); ///< m, of the outline alone
double shapeRadius(const Shape& shape); ///< m, of the smallest circle about the origin that holds the outline

/// `n` points (m) along the outline, counter-clockwise (a polygon gives its own vertices, whatever n is).
std::vector<Eigen::Vector2d> shapeOutline(const Shape& shape, int n);
/// The same, followed by the points of every hole (counter-clockwise, too).
std::vector<std::vector<Eigen::Vector2d>> shapeRings(const Shape& shape, int n);

} // namespace bask
