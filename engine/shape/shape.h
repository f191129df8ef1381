#pragma once
// The shapes that the solver supports: disk, Fourier contour, polygon, and each of them with holes. They are
// counter-clockwise, and the outline is centred on the origin of its frame.

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

/// A face with at least one hole. The holes are checked contours in the outline's frame, inside the outline,
/// and do not touch it or one another (checkHoles). Made by withHoles.
struct PiercedShape {
    PlainShape outline;
    std::vector<Contour> holes;
    bool operator==(const PiercedShape&) const = default;
};

using Shape = std::variant<Disk, FourierContour, Contour, PiercedShape>;

/// Returns the outline with these holes instead of its own; the plain outline if there are none.
Shape withHoles(const Shape& outline, std::vector<Contour> holes);
/// Returns the shape without its holes.
PlainShape outlineOf(const Shape& shape);
const std::vector<Contour>& holesOf(const Shape& shape);
/// Returns the outline if it is a T (Disk, FourierContour, Contour), with or without holes; else null. Valid
/// as long as the shape exists.
template <class T> const T* outlineAs(const Shape& shape) {
    const auto* pierced = std::get_if<PiercedShape>(&shape);
    return pierced ? std::get_if<T>(&pierced->outline) : std::get_if<T>(&shape);
}

inline constexpr std::size_t kMaxHoles = 200; ///< in one shape

/// Checks that the holes fit into the shape (a Fourier contour as truncated, to a millionth of its size): at
/// most kMaxHoles simple contours inside the outline, none touching it, touching another hole, or inside
/// another hole. Errors: HolesTooMany, HoleOutside, HolesMeet, and those of makeContour, with `where`[k] as
/// place.
Result<void> checkHoles(const Shape& shape, const std::string& where = {});
/// Checks one more hole, in the polygon `outline` beside `others`.
Result<void> checkHole(const Contour& hole, const std::vector<Eigen::Vector2d>& outline,
                       std::span<const Contour> others, const std::string& where = {});

/// Returns the fit with the holes of the fitted outline, in the coordinates of the fit: they move with the
/// centroid.
Shape shapeOfFit(const FourierFit& fit, const std::vector<Contour>& holes);

/// Returns the shape as seen from its other side: y becomes -y, and it is counter-clockwise again.
Shape mirrored(const Shape& shape);

double shapeArea(const Shape& shape);      ///< m2, without the holes
double shapePerimeter(const Shape& shape); ///< m, of the outline without holes
/// Returns area over perimeter, m: the characteristic length of a plate in natural convection.
double shapeCharacteristicLength(const Shape& shape);
/// M, of the smallest circle about the origin that contains the outline.
double shapeRadius(const Shape& shape);

/// Returns `n` points (m) along the outline, counter-clockwise (of a polygon its own vertices, for any n).
std::vector<Eigen::Vector2d> shapeOutline(const Shape& shape, int n);
/// Returns the outline as shapeOutline does, followed by the points of every hole (counter-clockwise, too).
std::vector<std::vector<Eigen::Vector2d>> shapeRings(const Shape& shape, int n);

} // namespace bask
