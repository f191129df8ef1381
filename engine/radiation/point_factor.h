#pragma once
// View factor of a small flat element to a planar source: the point factor of heat-transfer catalogues.

#include "engine/shape/shape.h"

namespace bask {

/// Returns the fraction of the radiation that a differential element at `p_SP` (S, m) emits into its half
/// space that reaches the source: dF(d2 -> 1), in [0, 1]. `normal_S` is the element's normal (S axes, any
/// length); the source, any counter-clockwise shape in the xy-plane of S, radiates along +z. The part of the
/// source behind the element's plane is ignored, and the result for an element with z <= 0 is 0. Uses closed
/// forms for a disk and a polygon (holes are polygons); a Fourier outline is integrated until the estimated
/// error is below 1e-12 (less accurate if the point is nearly on the outline). This is the limit of
/// viewFactor for a small object with the normal -z of O. Throws std::invalid_argument for numbers that are
/// not finite, a normal of length zero, and a point of the source itself, where the value is not unique.
double pointFactor(const Shape& source, const Eigen::Vector3d& p_SP, const Eigen::Vector3d& normal_S);

} // namespace bask
