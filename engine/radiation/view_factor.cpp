#include "engine/radiation/view_factor.h"

#include "engine/radiation/coplanar.h"
#include "engine/radiation/disk_strip.h"
#include "engine/radiation/outline_integral.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
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
                     const Pose& X_SO) {
    const Eigen::Vector3d p = X_SO.translation();
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
    outcome.floor_m2 = roundingFloor(source, object, sight.X_SO);
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
        outcome.integral = integrate<kMoments>(WholeDiskSource(source.disk->radius_m, sight.X_SO), object,
                                               sight, side, goal);
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

// Not inlined: its frame would be the quick way's, too.
template <bool kMoments>
[[gnu::noinline]] Outcome evaluate(const RadiatingContour::Impl& source, const RadiatingContour::Impl& object,
                                   const Pose& X_SO, double tolerance, int maxPoints) {
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

/// Sums in O axes, in units of `factor`.
struct QuickSum {
    double factor = 0.0; ///< m2
    double error_m2 = 0.0;
    kernels::Sums sums;
};

// One disk over another that are wholly seen, so far apart that a quick rule is enough: nearly all calls. The
// processor sums while it looks at the conditions, which no pose meets that is not finite. Empty if they are
// not met.
template <bool kMoments>
std::optional<QuickSum> quick(const RadiatingContour::Impl& source, const RadiatingContour::Impl& object,
                              const Pose& X_SO, double tolerance, int maxPoints) {
    if (!source.isPlainDisk() || !object.isPlainDisk())
        return std::nullopt;
    const double R = source.disk->radius_m, r = object.disk->radius_m;
    const double perimeters = source.perimeter * object.perimeter;
    const double allowed_m2 = kRuleShare * 2.0 * std::numbers::pi * object.area * tolerance;
    if (!(allowed_m2 >= 32.0 * kEpsilon * perimeters)) // roundingFloor() is never more
        return std::nullopt;
    const kernels::WholeDisk disk = WholeDiskSource::seen(R, X_SO);
    const auto& [R2, o, k] = disk;
    const double z = X_SO.translation().z();
    const double overObject = o[2] - kInFront * (R + r), overSource = z - kInFront * (R + r);
    const DiskRule<8> rule(wideStripExp(stripCosh(R, r, o[0], o[1], o[2], k[0], k[1], z)),
                           kRuleSafety * perimeters, allowed_m2, RadiatingContour::Impl::kMaxQuickPoints);
    if (!(rule.points <= std::min(RadiatingContour::Impl::kMaxQuickPoints, maxPoints) && overObject > 0.0 &&
          overSource > 0.0 && overObject * overObject > R2 * X_SO.linear().col(2).head<2>().squaredNorm() &&
          overSource * overSource > r * r * (k[0] * k[0] + k[1] * k[1]) &&
          o[0] * o[0] + o[1] * o[1] + o[2] * o[2] < kFarthestStrip_m * kFarthestStrip_m))
        return std::nullopt;
    const kernels::Outline& points = object.quick(rule.points);
    QuickSum sum{-2.0 * std::numbers::pi * R2, kRuleSafety * perimeters / rule.gain, {}};
    if constexpr (kMoments)
        sum.sums = kernels::kernels().diskSums(disk, points);
    else
        sum.sums.value = kernels::kernels().diskValue(disk, points);
    return sum;
}

double perCirculation(double area) {
    return -1.0 / (2.0 * std::numbers::pi * area);
}

double asFraction(double factor) {
    return std::clamp(factor, 0.0, 1.0) + 0.0; // avoids minus zero
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
    const double area = object.impl().netArea;
    const double scale = perCirculation(area);
    ViewFactor factor;
    if (const auto sum =
            quick<true>(source.impl(), object.impl(), X_SO, options.tolerance, options.maxPoints)) {
        const double scaled = scale * sum->factor;
        const auto R = X_SO.linear();
        factor.value = asFraction(scaled * sum->sums.value);
        factor.gradient.head<3>() = scaled * (R * Eigen::Map<const Eigen::Vector3d>(sum->sums.moments));
        factor.gradient.tail<3>() = scaled * (R * Eigen::Map<const Eigen::Vector3d>(sum->sums.moments + 3));
        factor.visibility = Visibility::Full;
        factor.errorEstimate =
            std::min(-scale * (sum->error_m2 + roundingFloor(source.impl(), object.impl(), X_SO)), 1.0);
        return factor;
    }
    const Outcome outcome =
        evaluate<true>(source.impl(), object.impl(), X_SO, options.tolerance, options.maxPoints);
    factor.value = asFraction(scale * outcome.integral.circulation_m2);
    factor.gradient = scale * outcome.integral.moments;
    factor.visibility = outcome.visibility;
    factor.errorEstimate = outcome.error(area);
    return factor;
}

double viewFactorValue(const RadiatingContour& source, const RadiatingContour& object, const Pose& X_SO,
                       double tolerance, double* errorEstimate) {
    constexpr int kMaxPoints = ViewFactorOptions{}.maxPoints;
    const double scale = perCirculation(object.impl().netArea); // before the sum, which does not wait for it
    if (errorEstimate == nullptr)
        if (const auto sum = quick<false>(source.impl(), object.impl(), X_SO, tolerance, kMaxPoints))
            return asFraction(scale * sum->factor * sum->sums.value);
    const Outcome outcome = evaluate<false>(source.impl(), object.impl(), X_SO, tolerance, kMaxPoints);
    if (errorEstimate)
        *errorEstimate = outcome.error(object.impl().netArea);
    return asFraction(scale * outcome.integral.circulation_m2);
}

Vector6d gradientAbout(const Vector6d& gradient, const Eigen::Vector3d& p_SO, const Eigen::Vector3d& p_SE) {
    Vector6d result = gradient;
    result.tail<3>() += (p_SO - p_SE).cross(gradient.head<3>());
    return result;
}

} // namespace bask
