#pragma once
// The part of the radiation from an object to a source that blockers stop, with its derivatives.

#include "engine/radiation/view_factor.h"

#include <span>
#include <vector>

namespace bask {

/// A plate at its pose in S.
struct PlacedShape {
    const RadiatingContour& contour;
    Pose X_S = Pose::Identity();
    bool isHeld = true; ///< a blocker: whether it moves with the object; only for a rough flux
};

struct ShadowFluxGoal {
    double tolerance = 1e-7; ///< error of the flux, over the object's area
    int maxPoints = 1 << 15;
};

/// The flux that blockers stop, and its derivatives for a motion of one of the figures alone: by translation
/// (m) and rotation about the object's origin (m2), S axes. Their sum is zero.
struct ShadowFlux {
    double value_m2 = 0.0; ///< A2 F21 without blockers less A2 F21 with them
    Vector6d byObject = Vector6d::Zero();
    Vector6d bySource = Vector6d::Zero();
    std::vector<Vector6d> byBlocker;
    double error_m2 = 0.0; ///< estimated
};

/// The flux is homogeneous of degree two in all lengths, so by Euler's theorem it is half its derivative for
/// an even stretch of the scene. This derivative, like those for motions, is a sum of integrals along the
/// outlines of source, object and blockers: where a piece dl of an outline moves by u, the flux changes by u
/// . (dl x B), B being the vector of the stopped radiation through that piece (ShadowField). So a flux
/// between surfaces becomes integrals over lines, of a function in closed form, and value and gradient come
/// from the same points. Every blocker counts only between the two faces. `source` stands at the identity.
ShadowFlux shadowFlux(const PlacedShape& source, const PlacedShape& object,
                      std::span<const PlacedShape> blockers, const ShadowFluxGoal& goal);

/// As `ShadowFlux`; the gradient, for a motion of the source and of the blockers that are not held as one, is
/// not exactly the value's.
struct RoughShadowFlux {
    double value_m2 = 0.0;
    Vector6d byStanding = Vector6d::Zero();
};

/// By fixed rules over the object's face and, for the gradient, along the outlines of what stands: to about a
/// hundredth of the flux and in less than a tenth of the time; it changes evenly with the poses.
RoughShadowFlux roughShadowFlux(const PlacedShape& source, const PlacedShape& object,
                                std::span<const PlacedShape> blockers, bool withGradient);

} // namespace bask
