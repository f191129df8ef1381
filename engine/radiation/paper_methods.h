#pragma once
// The numerical methods of the paper, unchanged: references for measuring and testing Bask's solver.

#include "engine/base/pose.h"
#include "engine/shape/shape.h"

namespace bask {

/// F21 by the discrete surface integral of the paper's Appendix B: each face is cut into about `elements`
/// equal squares (those of a square grid whose centres lie inside), and Lambert's cosine law is summed over
/// all pairs that see each other. Work grows with elements^2; the error falls about as elements^(-3/4), since
/// an outline of squares is a staircase.
double discreteSurfaceIntegral(const Shape& source, const Shape& object, const Pose& X_SO, int elements);

/// Returns F21 by the double contour integral, composite Simpson with `points` (even) subintervals on each
/// contour. Supports disks and Fourier contours without holes, as in the paper, and the one visibility cut of
/// the paper: a disk source cut by the object's plane, with `points` subintervals on the arc and on the
/// chord. Throws std::invalid_argument for polygons and holes, an odd number, and any other source that is
/// cut. An object that is partly below the source plane is treated as if it were not, which is wrong.
double simpsonViewFactor(const Shape& source, const Shape& object, const Pose& X_SO, int points);

/// A value with its derivatives by the six pose coordinates of the object (1/m, 1/rad; see
/// poseFromCoordinates).
struct SimpsonGradient {
    double value = 0.0;
    Vector6d gradient = Vector6d::Zero();
};

/// Returns forward differences of simpsonViewFactor with `step_m` and `step_rad`: seven evaluations.
SimpsonGradient simpsonGradient(const Shape& source, const Shape& object, const Vector6d& coordinates,
                                int points, double step_m = 1e-5, double step_rad = 1e-4);

} // namespace bask
