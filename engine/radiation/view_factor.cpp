#include "engine/radiation/view_factor.h"

#include "engine/radiation/coplanar.h"
#include "engine/radiation/outline_integral.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>

namespace bask {

namespace {

constexpr double kEpsilon = std::numeric_limits<double>::epsilon();

// Within rounding of the source's plane: just above it the face sees a source of its own size, just below it
// nothing.
void refuseOverlapInPlane(const RadiatingContour::Impl& source, const RadiatingContour::Impl& object,
                          const Sight& sight) {
    const HeightPlane& height = sight.overSource;
    if (std::abs(height.z0) + object.reach * height.slope > 1e-13 * (source.reach + object.reach))
        return;
    if (overlapInPlane(source.shape, object.shape, sight.X_SO))
        throw std::invalid_argument("object and source overlap in one plane: there is no view factor");
}

// Rounding error, m2: a few relative epsilons times the size of the potential and the length of the path;
// larger than any observed error.
double roundingFloor(const RadiatingContour::Impl& source, const RadiatingContour::Impl& object,
                     const Sight& sight) {
    const Eigen::Vector3d p = sight.X_SO.translation();
    const double potential =
        std::min(0.5 * source.perimeter, 2.0 * source.area * (p.norm() + object.reach) / p.squaredNorm());
    return 64.0 * kEpsilon * object.perimeter * potential;
}

// Upper bound (m2) of the part of a face in front of a plane: a strip as wide as the face.
double visibleArea(const RadiatingContour::Impl& face, const HeightPlane& height, PlaneSide side) {
    if (side == PlaneSide::Front)
        return face.area;
    return 2.0 * face.reach * (height.z0 / height.slope + face.reach);
}

template <bool kMoments, class Source>
OutlineIntegral integrate(Source source, const RadiatingContour::Impl& object, const Sight& sight,
                          PlaneSide side, const IntegralGoal& goal) {
    OutlineIntegrator<kMoments, Source> integrator(source, object, sight, goal);
    if (side == PlaneSide::Front)
        return integrator.whole();
    return integrator.over(object.piecesInFront(sight.overSource));
}

struct Outcome {
    OutlineIntegral integral;
    Visibility visibility = Visibility::Hidden;
    double floor_m2 = 0.0;

    double error(double area) const {
        return std::min((integral.error_m2 + floor_m2) / (2.0 * std::numbers::pi * area), 1.0);
    }
};

// One outline over another, `allowed_m2` being the error of the circulation.
template <bool kMoments>
Outcome betweenOutlines(const RadiatingContour::Impl& source, const RadiatingContour::Impl& object,
                        const Sight& sight, double allowed_m2, int maxPoints) {
    const PlaneSide seen = source.side(sight.overObject);
    if (seen == PlaneSide::Behind)
        return {};
    const PlaneSide side = object.side(sight.overSource);
    if (side == PlaneSide::Behind)
        return {};
    Outcome outcome;
    outcome.floor_m2 = roundingFloor(source, object, sight);
    outcome.visibility =
        seen == PlaneSide::Front && side == PlaneSide::Front ? Visibility::Full : Visibility::Partial;
    // The visible part of each face bounds A2 F21: a sliver does not justify the many points that it would
    // need.
    const double seen_m2 =
        std::min(visibleArea(source, sight.overObject, seen), visibleArea(object, sight.overSource, side));
    if (2.0 * std::numbers::pi * seen_m2 <= allowed_m2) {
        outcome.integral.error_m2 = 2.0 * std::numbers::pi * seen_m2;
        return outcome;
    }
    const IntegralGoal goal{std::max(kRuleShare * allowed_m2, outcome.floor_m2), source.perimeter, maxPoints};
    if (!source.disk)
        outcome.integral = integrate<kMoments>(LoopSource(source, sight, seen == PlaneSide::Across), object,
                                               sight, side, goal);
    else if (seen == PlaneSide::Front)
        outcome.integral =
            integrate<kMoments>(WholeDiskSource(source.disk->radius_m, sight), object, sight, side, goal);
    else
        outcome.integral =
            integrate<kMoments>(DiskSegmentSource(source.disk->radius_m, sight), object, sight, side, goal);
    return outcome;
}

// A2 F21 is linear in each face, so the circulations of all pairs of outlines add up, those of a hole with
// the opposite sign. Each pair gets an equal part of the error.
template <bool kMoments>
Outcome withHoles(const RadiatingContour::Impl& source, const RadiatingContour::Impl& object,
                  const Sight& sight, double allowed_m2, int maxPoints) {
    const auto pairs = static_cast<double>((1 + source.holes.size()) * (1 + object.holes.size()));
    Outcome sum = betweenOutlines<kMoments>(source, object, sight, allowed_m2 / pairs, maxPoints);
    if (sum.visibility == Visibility::Hidden)
        return sum;
    const auto add = [&](const RadiatingContour::Impl& from, const RadiatingContour::Impl& to, double sign) {
        const Outcome pair = betweenOutlines<kMoments>(from, to, sight, allowed_m2 / pairs, maxPoints);
        sum.integral.circulation_m2 += sign * pair.integral.circulation_m2;
        sum.integral.moments += sign * pair.integral.moments;
        sum.integral.error_m2 += pair.integral.error_m2;
        sum.floor_m2 += pair.floor_m2;
    };
    for (const RadiatingContour::Impl& hole : object.holes)
        add(source, hole, -1.0);
    for (const RadiatingContour::Impl& hole : source.holes) {
        add(hole, object, -1.0);
        for (const RadiatingContour::Impl& other : object.holes)
            add(hole, other, 1.0);
    }
    return sum;
}

template <bool kMoments>
Outcome evaluate(const RadiatingContour::Impl& source, const RadiatingContour::Impl& object, const Pose& X_SO,
                 double tolerance, int maxPoints) {
    constexpr double kFarthest2 = 1e100; // m2; beyond, squares of squares overflow
    if (!(X_SO.translation().squaredNorm() < kFarthest2) || !std::isfinite(X_SO.linear().sum()))
        throw std::invalid_argument("viewFactor: the pose is not finite");
    if (!(tolerance >= 0.0) || maxPoints < 1)
        throw std::invalid_argument("viewFactor: the tolerance is negative or there are no points");
    const Sight sight(X_SO);
    refuseOverlapInPlane(source, object, sight);
    const double allowed_m2 = 2.0 * std::numbers::pi * object.netArea * tolerance;
    if (source.holes.empty() && object.holes.empty())
        return betweenOutlines<kMoments>(source, object, sight, allowed_m2, maxPoints);
    return withHoles<kMoments>(source, object, sight, allowed_m2, maxPoints);
}

// The value of one disk over another that are wholly seen, so far apart that a quick rule is enough: nearly
// all calls. The sum does not wait for the distances, which the processor looks at meanwhile. NaN: not so.
double quickValue(const RadiatingContour::Impl& source, const RadiatingContour::Impl& object,
                  const Pose& X_SO, double tolerance) {
    constexpr double kNotSo = std::numeric_limits<double>::quiet_NaN();
    const double perimeters = source.perimeter * object.perimeter;
    const double allowed_m2 = kRuleShare * 2.0 * std::numbers::pi * object.area * tolerance;
    if (!(allowed_m2 >= 32.0 * kEpsilon * perimeters)) // roundingFloor() is never more
        return kNotSo;
    const int exponent = static_cast<int>(logAbove(kRuleSafety * perimeters / allowed_m2) + kHalfError) + 1;
    if (exponent < 0 || exponent > RadiatingContour::Impl::kMaxQuickExponent)
        return kNotSo;
    const Sight sight(X_SO);
    const Eigen::Vector3d o = X_SO.translation();
    const WholeDiskSource disk(source.disk->radius_m, sight);
    const double least = kInFront * (source.reach + object.reach);
    const double away = disk.distance_m(o);
    const kernels::Outline points = object.quick(exponent, away);
    if (!(sight.overObject.z0 - source.reach * sight.overObject.slope > least &&
          sight.overSource.z0 - object.reach * sight.overSource.slope > least && points.count > 0 &&
          away < 1e50))
        return kNotSo;
    return disk.circulation(disk.value(points));
}

double asFraction(double circulation, double area) {
    return std::clamp(-circulation / (2.0 * std::numbers::pi * area), 0.0, 1.0) + 0.0; // avoids minus zero
}

} // namespace

const char* visibilityName(Visibility visibility) {
    switch (visibility) {
    case Visibility::Full:
        return "full";
    case Visibility::Partial:
        return "partial";
    case Visibility::Hidden:
        break;
    }
    return "hidden";
}

RadiatingContour::RadiatingContour(const Shape& shape) : m_impl(std::make_shared<const Impl>(shape)) {}
RadiatingContour::~RadiatingContour() = default;
RadiatingContour::RadiatingContour(const RadiatingContour&) = default;
RadiatingContour& RadiatingContour::operator=(const RadiatingContour&) = default;

double RadiatingContour::area_m2() const {
    return m_impl->netArea;
}

const Shape& RadiatingContour::shape() const {
    return m_impl->shape;
}

ViewFactor viewFactor(const RadiatingContour& source, const RadiatingContour& object, const Pose& X_SO,
                      const ViewFactorOptions& options) {
    const double area = object.area_m2();
    const Outcome outcome =
        evaluate<true>(source.impl(), object.impl(), X_SO, options.tolerance, options.maxPoints);
    const double perCirculation = 1.0 / (2.0 * std::numbers::pi * area);
    ViewFactor factor;
    factor.value = asFraction(outcome.integral.circulation_m2, area);
    factor.gradient = -perCirculation * outcome.integral.moments;
    factor.visibility = outcome.visibility;
    factor.errorEstimate = outcome.error(area);
    return factor;
}

double viewFactorValue(const RadiatingContour& source, const RadiatingContour& object, const Pose& X_SO,
                       double tolerance, double* errorEstimate) {
    const double area = object.area_m2();
    if (errorEstimate == nullptr && source.impl().isPlainDisk() && object.impl().isPlainDisk())
        if (const double value = quickValue(source.impl(), object.impl(), X_SO, tolerance);
            !std::isnan(value))
            return asFraction(value, area);
    const Outcome outcome =
        evaluate<false>(source.impl(), object.impl(), X_SO, tolerance, ViewFactorOptions{}.maxPoints);
    if (errorEstimate)
        *errorEstimate = outcome.error(area);
    return asFraction(outcome.integral.circulation_m2, area);
}

Vector6d gradientAbout(const Vector6d& gradient, const Eigen::Vector3d& p_SO, const Eigen::Vector3d& p_SE) {
    Vector6d result = gradient;
    result.tail<3>() += (p_SO - p_SE).cross(gradient.head<3>());
    return result;
}

} // namespace bask
