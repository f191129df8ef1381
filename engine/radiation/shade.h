#pragma once
// View factors with shade: plates that stand between an object and the source.

#include "engine/radiation/view_factor.h"

#include <span>
#include <vector>

namespace bask {

/// A thin opaque plate, with holes or not. It shades with both sides, and only with the part that lies in
/// front of the object's face and of the source.
struct Blocker {
    RadiatingContour contour;
    Pose X_S = Pose::Identity();
    bool isHeld = true; ///< moves with the object on the end-effector; else it stands with the source
};

struct ShadedViewFactor {
    double value = 0.0;    ///< F21, in [0, unshaded]
    double unshaded = 0.0; ///< F21 without the blockers
    /// dF/d(position) 1/m and dF/d(rotation) 1/rad, S axes, about O's origin, for a motion of the object
    /// alone.
    Vector6d gradient = Vector6d::Zero();
    /// The same for a motion of the end-effector: the object and every blocker that is held move as one.
    Vector6d gradientRigid = Vector6d::Zero();
    Visibility visibility = Visibility::Hidden; ///< without the blockers
    double errorEstimate = 0.0;                 ///< absolute error of `value`, at most 1
};

struct ShadeOptions {
    ViewFactorOptions unshaded; ///< for the view factor without blockers
    double tolerance = 1e-7;    ///< absolute error of what the blockers take
    int maxPoints = 1 << 15;    ///< of all outlines; if it is reached, errorEstimate says which error remains
    /// Whether a blocker that passes through a face throws; else the value has no meaning then.
    bool refusesCrossing = true;
};

/// Returns whether a part of the plate at X_B lies in front of the face (along -z) of an object at X_O, both
/// in any common frame; else it never shades the object.
bool isInFront(const RadiatingContour& plate, const Pose& X_B, const Pose& X_O);

/// Returns F21 as viewFactor does, less what the blockers take. Three cases, the cheapest that applies: (1)
/// no blocker meets the convex hull of object and source: viewFactor's own result; (2) the shadow of a
/// blocker lies within a convex source for every point of the object, and meets no other shadow: the view
/// factor to the blocker is subtracted; (3) else the stopped radiation is integrated along the outlines
/// (shadow_flux.h). Thread-safe. Throws std::invalid_argument as viewFactor does, and if a blocker passes
/// through the object's face or through the source.
ShadedViewFactor shadedViewFactor(const RadiatingContour& source, const RadiatingContour& object,
                                  const Pose& X_SO, std::span<const Blocker> blockers,
                                  const ShadeOptions& options = {});

/// A view factor and its gradient for a motion of the end-effector, as in ShadedViewFactor.
struct RigidViewFactor {
    double value = 0.0;
    Vector6d gradient = Vector6d::Zero();
};

/// Returns F21, its shade by fixed rules: to about a hundredth of what the blockers take, in less than a
/// tenth of the time. For searches, which go on from there with shadedViewFactor. `tolerance`: of the view
/// factor without blockers.
RigidViewFactor roughShadedViewFactor(const RadiatingContour& source, const RadiatingContour& object,
                                      const Pose& X_SO, std::span<const Blocker> blockers, double tolerance);

/// Returns only what the blockers take, by the same rule.
double roughShade(const RadiatingContour& source, const RadiatingContour& object, const Pose& X_SO,
                  std::span<const Blocker> blockers);

} // namespace bask
