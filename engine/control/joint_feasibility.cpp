#include "engine/control/joint_feasibility.h"

#include "engine/base/message_code.h"
#include "engine/base/units.h"
#include "engine/control/steady_search.h"
#include "engine/control/surface_gap.h"
#include "engine/control/velocity_solve.h"

#include <algorithm>
#include <cmath>
#include <future>
#include <stdexcept>
#include <utility>

namespace bask {
namespace {

constexpr int kStarts = 48;

/// Least squares of all targets, with those in `heavy` weighted first.
SteadyAim aimAt(const std::vector<double>& targets_K, const std::vector<bool>& heavy) {
    constexpr double kHeavy = 1e3;
    const auto N = static_cast<Eigen::Index>(targets_K.size());
    SteadyAim aim{Eigen::MatrixXd::Identity(N, N), Eigen::VectorXd(N)};
    for (Eigen::Index i = 0; i < N; ++i) {
        const auto object = static_cast<std::size_t>(i);
        aim.rows(i, i) = !heavy.empty() && heavy[object] ? kHeavy : 1.0;
        aim.wanted[i] = aim.rows(i, i) * targets_K[object];
    }
    return aim;
}

std::vector<double> toVector(const Eigen::VectorXd& v) {
    return {v.begin(), v.end()};
}

PoseMargin marginAt(const SteadySearch& search, const Vector6d& q) {
    const LimitDistance nearest = nearestLimit(search.geometry(), q);
    return {nearest.distance_m, nearest.limit, nearest.coordinate,
            singularRange(search.geometry(), search.at(q).dT, kRadianLength_m).smallest};
}

/// The nearest targets with the kept ones unchanged, if the best compromise does not keep them.
void findNearest(const SteadySearch& search, const FeasibilityRequest& request, JointVerdict& out) {
    const SteadyPose found = search.best(aimAt(request.targets_K, request.fixed), kStarts, 0.0);
    out.nearestPose = found.q;
    out.nearest_K = toVector(found.T_K);
    for (std::size_t i = 0; i < request.targets_K.size(); ++i) {
        if (!request.fixed[i])
            continue;
        if (std::abs(out.nearest_K[i] - request.targets_K[i]) <= kReachedWithin_K)
            out.nearest_K[i] = request.targets_K[i];
        else
            out.fixedKept = false;
    }
}

void answerJointly(const SteadySearch& search, const FeasibilityRequest& request, JointVerdict& out) {
    const auto N = static_cast<double>(request.targets_K.size());
    const double enough_K2 = N * kReachedWithin_K * kReachedWithin_K;
    // Ends early at a thousandth of the tolerance for held targets: if there is a solution, it is found to
    // the digits.
    const SteadyPose found = search.best(aimAt(request.targets_K, {}), kStarts, 1e-6 * enough_K2);
    if (search.stopped())
        return;
    out.feasible = found.cost_K2 <= enough_K2;
    out.pose = found.q;
    out.steady_K = toVector(found.T_K);
    for (std::size_t i = 0; i < request.targets_K.size(); ++i)
        out.residuals_K.push_back(out.steady_K[i] - request.targets_K[i]);
    out.margin = marginAt(search, out.pose);
    out.nearestPose = out.pose;
    out.nearest_K = out.feasible ? request.targets_K : out.steady_K;
    if (out.feasible)
        return;
    if (std::ranges::find(request.fixed, true) != request.fixed.end())
        findNearest(search, request, out);
    if (const auto gap = surfaceGap(search, request.targets_K, out.pose)) {
        out.surfaceGap_m = gap->distance_m;
        out.surfacePoints = gap->points;
    }
}

/// Why one object alone cannot be held; `name` as in the request.
Message objectReason(const std::string& name, const TargetVerdict& v) {
    if (v.verdict == FeasibilityVerdict::TooHot && v.target_K > v.highest_K)
        return {MessageCode::TargetAboveCeiling,
                {name, roundedTemperatureArg(v.target_K, 2), roundedTemperatureArg(v.highest_K, 2)}};
    if (v.verdict == FeasibilityVerdict::TooHot)
        return {MessageCode::TargetNeedsMore,
                {name, formatNumber(v.neededViewFactor, 3), formatNumber(v.reachableMax_F, 3)}};
    if (v.target_K < v.lowest_K)
        return {MessageCode::TargetBelowFloor,
                {name, roundedTemperatureArg(v.target_K, 2), roundedTemperatureArg(v.lowest_K, 2)}};
    return {MessageCode::TargetNeedsLess,
            {name, formatNumber(v.neededViewFactor, 3), formatNumber(v.reachableMin_F, 3)}};
}

/// Reported for the object with the higher target.
Message pairReason(const std::vector<std::string>& names, const PairVerdict& v) {
    const bool flipped = v.wanted_K < 0.0;
    const std::string& hotter = names[static_cast<std::size_t>(flipped ? v.second : v.first)];
    const std::string& colder = names[static_cast<std::size_t>(flipped ? v.first : v.second)];
    const double wanted_K = std::abs(v.wanted_K);
    const double largest_K = flipped ? -v.min_K : v.largest_K;
    const double min_K = flipped ? -v.largest_K : v.min_K;
    const bool tooMuch = wanted_K > largest_K;
    return {tooMuch ? MessageCode::TargetsTooFarApart : MessageCode::TargetsTooClose,
            {hotter, colder, differenceArg(wanted_K, 3), differenceArg(tooMuch ? largest_K : min_K, 3)}};
}

/// The condition with the largest violation; the joint one if both necessary ones are met.
Message reasonOf(const FeasibilityRequest& request, const JointVerdict& verdict) {
    if (!verdict.anyPose)
        return {MessageCode::TargetsNoPose, {}};
    if (verdict.feasible)
        return {};
    const auto missed_K = [](const TargetVerdict& v) {
        return std::max(v.target_K - v.reachableMax_K, v.reachableMin_K - v.target_K);
    };
    const auto object = std::ranges::max_element(verdict.conditions1, {}, missed_K);
    if (object->verdict != FeasibilityVerdict::Reachable) {
        const auto i = static_cast<std::size_t>(object - verdict.conditions1.begin());
        return objectReason(request.names[i], *object);
    }
    const auto apart_K = [](const PairVerdict& v) {
        return std::max(v.wanted_K - v.largest_K, v.min_K - v.wanted_K);
    };
    const auto pair = std::ranges::max_element(verdict.conditions2, {}, apart_K);
    if (pair != verdict.conditions2.end() && !pair->holds)
        return pairReason(request.names, *pair);
    const auto worst =
        std::ranges::max_element(verdict.residuals_K, {}, [](double r_K) { return std::abs(r_K); });
    const std::string& name = request.names[static_cast<std::size_t>(worst - verdict.residuals_K.begin())];
    const MessageArg error = differenceArg(std::abs(*worst), 2);
    if (!verdict.surfaceGap_m)
        return {MessageCode::TargetsNotTogether, {name, error}};
    return {MessageCode::TargetsSurfacesApart, {name, error, formatNumber(*verdict.surfaceGap_m * 100.0, 2)}};
}

void checkLengths(const FeasibilityRequest& request) {
    const auto N = static_cast<std::size_t>(request.geometry->objects());
    const bool fixed = request.fixed.empty() || request.fixed.size() == N;
    if (N == 0 || request.names.size() != N || request.rates.size() != N || request.targets_K.size() != N ||
        !fixed)
        throw std::invalid_argument("jointFeasibility: one name, rate and target an object");
}

} // namespace

std::optional<JointVerdict> jointFeasibility(const FeasibilityRequest& request, std::stop_token stop) {
    checkLengths(request);
    const auto lookup = request.lookup ? request.lookup : feasibilityLookup(request.geometry, request.rest);
    const SteadySearch search(request.geometry, lookup, request.rates, std::move(stop));
    JointVerdict out;
    out.anyPose = !search.empty();
    if (out.anyPose) {
        // Computes the conditions in parallel with the search: neither reads what the other writes.
        auto conditions = std::async(std::launch::async, [&] {
            return std::pair(targetVerdicts(search, request.targets_K),
                             pairVerdicts(search, request.targets_K));
        });
        answerJointly(search, request, out);
        std::tie(out.conditions1, out.conditions2) = conditions.get();
    } else {
        out.conditions1 = targetVerdicts(search, request.targets_K);
    }
    if (search.stopped())
        return std::nullopt;
    out.reason = reasonOf(request, out);
    if (!request.isAirKnown)
        out.caveat = {MessageCode::TargetsWithoutAir, {}};
    return out;
}

} // namespace bask
