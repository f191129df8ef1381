#include "engine/radiation/shade.h"

#include "engine/radiation/outline_table.h"
#include "engine/radiation/plate.h"
#include "engine/radiation/plate_crossing.h"
#include "engine/radiation/shadow_flux.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace bask {
namespace {

using Eigen::Vector3d;

constexpr double kRounding = 1e-12; // of the size of a plate: nearer to a plane, it lies in it

struct Scene {
    const RadiatingContour& source;
    const RadiatingContour& object;
    const Pose& X_SO;
    const Plate& sourcePlate = source.impl().plate();
    const Plate& objectPlate = object.impl().plate();
    Vector3d face = -X_SO.linear().col(2);

    double front(const Vector3d& v) const { return face.dot(v - X_SO.translation()); }
    /// Returns the way to v from the nearest point between the centres of source and object.
    Vector3d awayFromAxis(const Vector3d& v) const {
        const Vector3d axis = X_SO.translation();
        return v - std::clamp(v.dot(axis) / axis.squaredNorm(), 0.0, 1.0) * axis;
    }
};

// Whether the plate lies wholly on the other side of a plane through p, or in it.
bool isBehind(const Plate& plate, const Pose& X_S, const Vector3d& normal, const Vector3d& p) {
    return plate.reachAlong_m(X_S, normal) - normal.dot(p) <= kRounding * plate.reach_m();
}

void refuseCrossing(const Scene& scene, const Blocker& blocker) {
    if (platesCross(blocker.contour, blocker.X_S, scene.object, scene.X_SO))
        throw std::invalid_argument("a blocker passes through the object");
    if (platesCross(blocker.contour, blocker.X_S, scene.source, Pose::Identity()))
        throw std::invalid_argument("a blocker passes through the source");
}

// Case 1, the quick part: behind a face, or outside the spheres around object and source, along the line from
// their axis to the blocker.
bool isFarAside(const Scene& scene, const Plate& plate, const Pose& X_S) {
    if (isBehind(plate, X_S, scene.face, scene.X_SO.translation()) ||
        isBehind(plate, X_S, Vector3d::UnitZ(), Vector3d::Zero()))
        return true;
    const Vector3d d = scene.awayFromAxis(X_S.translation());
    const double length = d.norm(), object = scene.X_SO.translation().dot(d);
    return (X_S.translation().dot(d) - plate.reach_m() * length) >=
               std::max(scene.sourcePlate.reach_m() * length,
                        object + scene.objectPlate.reach_m() * length) &&
           length > 0.0;
}

// Case 1. Looks for a plane between the blocker and the hull of object and source (K. Chung, W. Wang, Quick
// collision detection of polytopes in virtual environments, VRST 1996).
bool isAside(const Scene& scene, const Plate& plate, const Pose& X_S) {
    Vector3d d = scene.awayFromAxis(X_S.translation());
    const double length = d.norm();
    if (length == 0.0)
        return false;
    d /= length;
    constexpr int kSteps = 8;
    for (int step = 0; step < kSteps; ++step) {
        const Vector3d a = scene.sourcePlate.farthest(Pose::Identity(), d),
                       b = scene.objectPlate.farthest(scene.X_SO, d);
        const Vector3d& hull = a.dot(d) > b.dot(d) ? a : b;
        const double margin = plate.margin_m(X_S, d) + scene.sourcePlate.margin_m(Pose::Identity(), d) +
                              scene.objectPlate.margin_m(scene.X_SO, d);
        const Vector3d gap = plate.farthest(X_S, -d) - hull;
        if (gap.dot(d) >= margin)
            return true;
        const double gap2 = gap.squaredNorm();
        if (gap2 == 0.0)
            return false;
        d -= 2.0 * gap.dot(d) / gap2 * gap;
    }
    return false;
}

// A circle of the source plane that contains the shadow for every point of the object; empty if there is
// none.
struct ShadowCircle {
    Eigen::Vector2d centre = Eigen::Vector2d::Zero();
    double radius = -1.0;

    bool isFinite() const { return radius >= 0.0; }
    bool meets(const ShadowCircle& other) const {
        return (centre - other.centre).norm() < radius + other.radius;
    }
};

ShadowCircle shadowCircle(const Scene& scene, const Plate& plate, const Pose& X_S) {
    // The blocker lies wholly between, below every point of the object.
    const Vector3d q0 = X_S.translation(), x0 = scene.X_SO.translation();
    const auto steep = [](const Pose& X) { return std::hypot(X.linear()(2, 0), X.linear()(2, 1)); };
    const double rq = plate.reach_m(), rx = scene.objectPlate.reach_m();
    const double riseQ = rq * steep(X_S), riseX = rx * steep(scene.X_SO);
    const double tiltToFace =
        std::hypot(scene.face.dot(X_S.linear().col(0)), scene.face.dot(X_S.linear().col(1)));
    if (q0.z() - riseQ <= 0.0 || x0.z() - riseX <= q0.z() + riseQ || scene.front(q0) - rq * tiltToFace <= 0.0)
        return {};
    // A point q shades s = q + k (q - x) for the point x.
    const double k0 = q0.z() / (x0.z() - q0.z());
    const double kMax = (q0.z() + riseQ) / (x0.z() - riseX - q0.z() - riseQ);
    const double kMin = (q0.z() - riseQ) / (x0.z() + riseX - q0.z() + riseQ);
    const Eigen::Vector2d q = q0.head<2>(), x = x0.head<2>();
    const double spread = std::max(kMax - k0, k0 - kMin) * (q - x).norm();
    return {q + k0 * (q - x), rq * (1.0 + kMax) + rx * kMax + spread};
}

bool isInside(const Plate& source, const RadiatingContour& contour, const ShadowCircle& shadow) {
    if (!source.isConvex() || !shadow.isFinite())
        return false;
    if (contour.impl().disk)
        return shadow.centre.norm() + shadow.radius <= contour.impl().disk->radius_m;
    return std::ranges::all_of(contour.impl().edges, [&](const kernels::Edge& edge) {
        const double inward =
            edge.t1 * (shadow.centre.y() - edge.a2) - edge.t2 * (shadow.centre.x() - edge.a1);
        return inward >= shadow.radius;
    });
}

// Case 2: what goes to the side of the blocker that faces the object.
void subtractWhole(const Scene& scene, const Blocker& blocker, const ShadeOptions& options,
                   ShadedViewFactor& result) {
    static const Pose kTurned(Eigen::AngleAxisd(std::acos(-1.0), Vector3d::UnitX()));
    const Vector3d normal = blocker.X_S.linear().col(2);
    const double height = normal.dot(scene.X_SO.translation() - blocker.X_S.translation());
    for (const bool isBack : {false, true}) {
        if ((isBack ? height : -height) >=
            scene.objectPlate.reach_m()) // no point of the object sees this side
            continue;
        const RadiatingContour* side = isBack ? &blocker.contour.impl().plate().back() : &blocker.contour;
        const Pose X_SB = isBack ? blocker.X_S * kTurned : blocker.X_S;
        const ViewFactor taken = viewFactor(*side, scene.object, X_SB.inverse(Eigen::Isometry) * scene.X_SO,
                                            {0.5 * options.tolerance, options.maxPoints});
        if (taken.visibility == Visibility::Hidden)
            continue;
        Vector6d gradient;
        gradient << X_SB.linear() * taken.gradient.head<3>(), X_SB.linear() * taken.gradient.tail<3>();
        result.value -= taken.value;
        result.errorEstimate += taken.errorEstimate;
        result.gradient -= gradient;
        if (!blocker.isHeld)
            result.gradientRigid -= gradient;
    }
}

// Case 3.
void subtractPart(const Scene& scene, std::span<const Blocker* const> blockers, const ShadeOptions& options,
                  ShadedViewFactor& result) {
    std::vector<PlacedShape> placed;
    for (const Blocker* blocker : blockers)
        placed.push_back({blocker->contour, blocker->X_S});
    const double area = scene.object.area_m2();
    const ShadowFlux flux = shadowFlux({scene.source, Pose::Identity()}, {scene.object, scene.X_SO}, placed,
                                       {options.tolerance, options.maxPoints});
    result.value -= flux.value_m2 / area;
    result.errorEstimate += flux.error_m2 / area;
    result.gradient -= flux.byObject / area;
    result.gradientRigid += flux.bySource / area;
    for (std::size_t i = 0; i < blockers.size(); ++i)
        if (!blockers[i]->isHeld)
            result.gradientRigid += flux.byBlocker[i] / area;
}

std::vector<PlacedShape> placedBetween(const Scene& scene, std::span<const Blocker> blockers) {
    std::vector<PlacedShape> between;
    for (const Blocker& blocker : blockers)
        if (const Plate& plate = blocker.contour.impl().plate();
            !isFarAside(scene, plate, blocker.X_S) && !isAside(scene, plate, blocker.X_S))
            between.push_back({blocker.contour, blocker.X_S, blocker.isHeld});
    return between;
}

} // namespace

bool isInFront(const RadiatingContour& plate, const Pose& X_B, const Pose& X_O) {
    return !isBehind(plate.impl().plate(), X_B, -X_O.linear().col(2), X_O.translation());
}

ShadedViewFactor shadedViewFactor(const RadiatingContour& source, const RadiatingContour& object,
                                  const Pose& X_SO, std::span<const Blocker> blockers,
                                  const ShadeOptions& options) {
    const ViewFactor unshaded = viewFactor(source, object, X_SO, options.unshaded);
    ShadedViewFactor result{unshaded.value,    unshaded.value,      unshaded.gradient,
                            unshaded.gradient, unshaded.visibility, unshaded.errorEstimate};
    if (blockers.empty() || unshaded.visibility == Visibility::Hidden)
        return result;
    const Scene scene{source, object, X_SO};
    struct Between {
        const Blocker* blocker;
        ShadowCircle shadow;
        bool isWithin; ///< the source
    };
    std::vector<Between> between;
    for (const Blocker& blocker : blockers) {
        const Plate& plate = blocker.contour.impl().plate();
        if (isFarAside(scene, plate, blocker.X_S))
            continue;
        const ShadowCircle shadow = shadowCircle(scene, plate, blocker.X_S);
        const bool isWithin = isInside(scene.sourcePlate, source, shadow);
        if (!isWithin && isAside(scene, plate, blocker.X_S))
            continue;
        if (options.refusesCrossing && !shadow.isFinite())
            refuseCrossing(scene, blocker);
        between.push_back({&blocker, shadow, isWithin});
    }
    std::vector<const Blocker*> rest;
    for (const Between& one : between) {
        const bool isWhole =
            one.isWithin && std::ranges::all_of(between, [&one](const Between& other) {
                return &one == &other || (other.shadow.isFinite() && !one.shadow.meets(other.shadow));
            });
        if (isWhole)
            subtractWhole(scene, *one.blocker, options, result);
        else
            rest.push_back(one.blocker);
    }
    if (!rest.empty())
        subtractPart(scene, rest, options, result);
    result.value = std::clamp(result.value, 0.0, result.unshaded);
    result.errorEstimate = std::min(result.errorEstimate, 1.0);
    return result;
}

RigidViewFactor roughShadedViewFactor(const RadiatingContour& source, const RadiatingContour& object,
                                      const Pose& X_SO, std::span<const Blocker> blockers, double tolerance) {
    const ViewFactor unshaded = viewFactor(source, object, X_SO, {.tolerance = tolerance});
    const std::vector<PlacedShape> between = placedBetween({source, object, X_SO}, blockers);
    if (between.empty() || unshaded.value == 0.0)
        return {unshaded.value, unshaded.gradient};
    const RoughShadowFlux flux = roughShadowFlux({source, Pose::Identity()}, {object, X_SO}, between, true);
    const double area = object.area_m2();
    return {std::clamp(unshaded.value - flux.value_m2 / area, 0.0, unshaded.value),
            unshaded.gradient + flux.byStanding / area};
}

double roughShade(const RadiatingContour& source, const RadiatingContour& object, const Pose& X_SO,
                  std::span<const Blocker> blockers) {
    const std::vector<PlacedShape> between = placedBetween({source, object, X_SO}, blockers);
    return between.empty()
               ? 0.0
               : roughShadowFlux({source, Pose::Identity()}, {object, X_SO}, between, false).value_m2 /
                     object.area_m2();
}

} // namespace bask
