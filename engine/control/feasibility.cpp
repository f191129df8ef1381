#include "engine/control/feasibility.h"

#include "engine/control/pose_lookup.h"

#include <algorithm>
#include <stdexcept>

namespace bask {
namespace {

/// Extreme view factor of one object: the look-up's best pose, refined towards `aim` (0 or 1).
double extremeViewFactor(const RigGeometry& geometry, const PoseLookup& lookup, int object, double aim) {
    const auto F = lookup.table().col(object);
    Eigen::Index k = 0;
    const double sampled = aim > 0.5 ? F.maxCoeff(&k) : F.minCoeff(&k);
    PoseQuery query;
    query.wanted = Eigen::VectorXd::Constant(geometry.objects(), aim);
    query.weights = Eigen::VectorXd::Unit(geometry.objects(), object);
    query.from = lookup.pose(static_cast<std::size_t>(k));
    const double refined = geometry.viewFactors(refinePose(geometry, query, query.from, 20)).F[object];
    return aim > 0.5 ? std::max(sampled, refined) : std::min(sampled, refined);
}

} // namespace

std::vector<TargetVerdict> targetVerdicts(const std::shared_ptr<const RigGeometry>& geometry,
                                          const Vector6d& rest, const std::vector<HeatRates>& rates,
                                          const std::vector<double>& targets_K) {
    const auto N = static_cast<std::size_t>(geometry->objects());
    if (rates.size() != N || targets_K.size() != N)
        throw std::invalid_argument("targetVerdicts: one rate and one target an object");
    constexpr int kSamples = 12000;
    const PoseLookup lookup(geometry, rest, kSamples);
    std::vector<TargetVerdict> out(N);
    for (std::size_t i = 0; i < N; ++i) {
        TargetVerdict& verdict = out[i];
        verdict.target_K = targets_K[i];
        verdict.lowest_K = rates[i].steadyTemperature_K(0.0);
        verdict.highest_K = rates[i].steadyTemperature_K(1.0);
        verdict.neededViewFactor = rates[i].steadyViewFactor(targets_K[i]);
        if (lookup.size() == 0) {
            verdict.verdict = FeasibilityVerdict::TooHot; // no pose of the workspace keeps the clearance
            continue;
        }
        verdict.reachableMin_F = extremeViewFactor(*geometry, lookup, static_cast<int>(i), 0.0);
        verdict.reachableMax_F = extremeViewFactor(*geometry, lookup, static_cast<int>(i), 1.0);
        verdict.reachableMin_K = rates[i].steadyTemperature_K(verdict.reachableMin_F);
        verdict.reachableMax_K = rates[i].steadyTemperature_K(verdict.reachableMax_F);
        if (verdict.neededViewFactor > verdict.reachableMax_F)
            verdict.verdict = FeasibilityVerdict::TooHot;
        else if (verdict.neededViewFactor < verdict.reachableMin_F)
            verdict.verdict = FeasibilityVerdict::TooCold;
    }
    return out;
}

} // namespace bask
