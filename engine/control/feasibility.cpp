#include "engine/control/feasibility.h"

#include "engine/base/parallel.h"
#include "engine/control/steady_search.h"
#include "engine/control/steady_states.h"

#include <algorithm>
#include <stdexcept>

namespace bask {
namespace {

/// Where `row` times the steady temperatures is smallest or largest within the workspace; `bound_K` is a
/// limit that it cannot exceed.
SteadyPose extreme(const SteadySearch& search, const Eigen::RowVectorXd& row, double bound_K) {
    const int starts =
        row.cwiseAbs().sum() > 1.0 ? 8 : 2; // differences have more minima at the workspace's edge
    const SteadyAim aim{row, Eigen::VectorXd::Constant(1, bound_K)};
    return search.best(aim, starts, 0.0);
}

double extreme_K(const SteadySearch& search, const Eigen::RowVectorXd& row, double bound_K) {
    return (row * extreme(search, row, bound_K).T_K)[0];
}

/// The view factor that holds object i at its temperature beside the others at theirs.
double neededViewFactor(const SteadySearch& search, const Eigen::VectorXd& T_K, std::size_t i) {
    return ratesAmong(search.rates(), search.geometry().neighbours(), T_K)[i].steadyViewFactor(
        T_K[static_cast<Eigen::Index>(i)]);
}

void checkCounts(const SteadySearch& search, const std::vector<double>& targets_K) {
    if (targets_K.size() != search.rates().size())
        throw std::invalid_argument("feasibility: one target an object");
}

} // namespace

std::shared_ptr<const PoseLookup> feasibilityLookup(const std::shared_ptr<const RigGeometry>& geometry,
                                                    const Vector6d& rest) {
    constexpr int kSamples = 12000;
    return std::make_shared<const PoseLookup>(geometry, rest, kSamples);
}

std::vector<TargetVerdict> targetVerdicts(const std::shared_ptr<const RigGeometry>& geometry,
                                          const Vector6d& rest, const std::vector<HeatRates>& rates,
                                          const std::vector<double>& targets_K) {
    return targetVerdicts(SteadySearch(geometry, feasibilityLookup(geometry, rest), rates), targets_K);
}

std::vector<TargetVerdict> targetVerdicts(const SteadySearch& search, const std::vector<double>& targets_K) {
    checkCounts(search, targets_K);
    const std::size_t N = targets_K.size();
    std::vector<TargetVerdict> out(N);
    const Eigen::VectorXd all_K =
        Eigen::Map<const Eigen::VectorXd>(targets_K.data(), static_cast<Eigen::Index>(N));
    const auto judge = [&](int object) {
        const auto i = static_cast<std::size_t>(object);
        TargetVerdict& verdict = out[i];
        const HeatRates& rates = search.rates()[i];
        verdict.target_K = targets_K[i];
        verdict.lowest_K = rates.steadyTemperature_K(0.0);
        verdict.highest_K = rates.steadyTemperature_K(search.geometry().maxViewFactor());
        verdict.neededViewFactor = neededViewFactor(search, all_K, i);
        if (search.empty()) {
            verdict.verdict = FeasibilityVerdict::TooHot; // no pose of the workspace keeps the clearance
            return;
        }
        const Eigen::RowVectorXd row =
            Eigen::RowVectorXd::Unit(static_cast<Eigen::Index>(N), static_cast<Eigen::Index>(i));
        const SteadyPose coldest = extreme(search, row, verdict.lowest_K),
                         hottest = extreme(search, row, verdict.highest_K);
        verdict.reachableMin_K = coldest.T_K[static_cast<Eigen::Index>(i)];
        verdict.reachableMax_K = hottest.T_K[static_cast<Eigen::Index>(i)];
        verdict.reachableMin_F = std::max(0.0, neededViewFactor(search, coldest.T_K, i));
        verdict.reachableMax_F = neededViewFactor(search, hottest.T_K, i);
        if (verdict.target_K > verdict.reachableMax_K + kReachedWithin_K)
            verdict.verdict = FeasibilityVerdict::TooHot;
        else if (verdict.target_K < verdict.reachableMin_K - kReachedWithin_K)
            verdict.verdict = FeasibilityVerdict::TooCold;
    };
    runInParallel(static_cast<int>(N), 0, judge, {});
    return out;
}

std::vector<PairVerdict> pairVerdicts(const SteadySearch& search, const std::vector<double>& targets_K) {
    checkCounts(search, targets_K);
    const int N = static_cast<int>(targets_K.size());
    std::vector<PairVerdict> out;
    for (int i = 0; i < N; ++i)
        for (int j = i + 1; j < N; ++j)
            out.push_back(
                {i, j, targets_K[static_cast<std::size_t>(i)] - targets_K[static_cast<std::size_t>(j)]});
    const double max = search.geometry().maxViewFactor();
    const auto judge = [&](int pair) {
        PairVerdict& verdict = out[static_cast<std::size_t>(pair)];
        const HeatRates& a = search.rates()[static_cast<std::size_t>(verdict.first)];
        const HeatRates& b = search.rates()[static_cast<std::size_t>(verdict.second)];
        const Eigen::RowVectorXd row =
            Eigen::RowVectorXd::Unit(N, verdict.first) - Eigen::RowVectorXd::Unit(N, verdict.second);
        verdict.min_K = extreme_K(search, row, a.steadyTemperature_K(0.0) - b.steadyTemperature_K(max));
        verdict.largest_K = extreme_K(search, row, a.steadyTemperature_K(max) - b.steadyTemperature_K(0.0));
        verdict.holds = verdict.wanted_K <= verdict.largest_K + 2.0 * kReachedWithin_K &&
                        verdict.wanted_K >= verdict.min_K - 2.0 * kReachedWithin_K;
    };
    runInParallel(static_cast<int>(out.size()), 0, judge, {});
    return out;
}

} // namespace bask
