#pragma once
// View factor of a small flat element to a planar source: the point factor of heat-transfer catalogues.

#include "engine/shape/shape.h"

namespace bask {

/// Fraction of what a differential element at `p_SP` (S, m) sends into its half space that arrives at the
/// source: dF(d2 -> 1), in [0, 1]. `normal_S` is the element's normal (S axes, any length); the source, any
/// counter-clockwise shape in the xy-plane of S, radiates along +z. The part of the source behind the
/// element's plane counts for nothing, and an element with z <= 0 sees nothing. Closed forms for a disk and a
/// polygon (holes are polygons); a Fourier outline is integrated until an estimate of the error is below
/// 1e-12 (less sharp where the point all but lies on the outline). The limit of viewFactor for a small object
/// with the normal -z of O. Throws std::invalid_argument on numbers that are not finite, a normal of no
/// length, and a point of the source itself, where there is no one answer.
double pointFactor(const Shape& source, const Eigen::Vector3d& p_SP, const Eigen::Vector3d& normal_S);

} // namespace bask
