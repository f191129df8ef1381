// Joint feasibility of the example experiments: cases of known outcome, and targets that can and that cannot
// be held, against brute force that knows no gradient: a hundred of each in CI, a thousand by hand (`ctest -L
// soak -R feasibility`).

#include "engine/base/message_code.h"
#include "engine/base/units.h"
#include "engine/control/steady_search.h"
#include "engine/experiment/experiment_file.h"
#include "engine/rig/rig_setup.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace bask {
namespace {

Experiment example(const std::string& name, SourceModel model) {
    Experiment experiment = readExperiment(BASK_EXAMPLES "/" + name).value();
    experiment.source.model = model;
    return experiment;
}

JointVerdict verdictOf(Experiment experiment, std::vector<double> targets_degC) {
    for (double& target : targets_degC)
        target = kelvinFromCelsius(target);
    EXPECT_TRUE(setTargets(experiment, targets_degC).ok());
    return jointFeasibility(feasibilityRequest(experiment)).value();
}

double largest_K(const std::vector<double>& residuals_K) {
    double largest = 0.0;
    for (const double residual : residuals_K)
        largest = std::max(largest, std::abs(residual));
    return largest;
}

// The three objects on a triangle: what the paper's experiments ask for.
TEST(JointFeasibilityStudy, TriangleAsKnown) {
    const Experiment paper = example("three-objects.json", SourceModel::Paper);
    const Experiment gray = example("three-objects.json", SourceModel::Gray);
    for (const std::vector<double>& targets_degC : {std::vector{80.0, 80.0, 80.0}, {70.0, 35.0, 35.0}}) {
        const JointVerdict verdict = verdictOf(paper, targets_degC);
        EXPECT_FALSE(verdict.feasible);
        ASSERT_EQ(verdict.reason.code, MessageCode::TargetAboveCeiling);
        EXPECT_EQ(verdict.reason.args[2], "61.42");
        EXPECT_TRUE(verdictOf(gray, targets_degC).feasible); // the ceiling is 95.4 degC there
    }
    for (const Experiment& experiment : {paper, gray})
        for (const std::vector<double>& targets_degC : {std::vector{60.0, 60.0, 30.0},
                                                        {40.0, 40.0, 40.0},
                                                        {50.0, 40.0, 40.0},
                                                        {50.0, 50.0, 35.0},
                                                        {50.0, 45.0, 35.0},
                                                        {40.0, 45.0, 50.0},
                                                        {45.0, 45.0, 45.0}})
            EXPECT_TRUE(verdictOf(experiment, targets_degC).feasible);
}

// The same in a line: three points in a line do not lie on one convex level surface.
TEST(JointFeasibilityStudy, LineAsKnown) {
    const Experiment gray = example("three-objects-in-line.json", SourceModel::Gray);
    const Experiment paper = example("three-objects-in-line.json", SourceModel::Paper);
    for (const Experiment& experiment : {paper, gray}) {
        for (const std::vector<double>& targets_degC :
             {std::vector{40.0, 40.0, 40.0}, {50.0, 40.0, 40.0}, {45.0, 45.0, 45.0}, {40.0, 45.0, 50.0}}) {
            const JointVerdict verdict = verdictOf(experiment, targets_degC);
            EXPECT_FALSE(verdict.feasible);
            EXPECT_GT(largest_K(verdict.residuals_K), 0.8);
            EXPECT_LT(largest_K(verdict.residuals_K), 3.9);
            for (const TargetVerdict& each : verdict.conditions1)
                EXPECT_EQ(each.verdict, FeasibilityVerdict::Reachable);
            for (const PairVerdict& pair : verdict.conditions2)
                EXPECT_TRUE(pair.holds); // both necessary conditions are blind to it
        }
        EXPECT_TRUE(verdictOf(experiment, {50.0, 50.0, 35.0}).feasible);
    }
    EXPECT_TRUE(verdictOf(gray, {60.0, 60.0, 30.0}).feasible);
    // With the paper's source it takes contour points nearer to the source than its clearance of 1 cm.
    EXPECT_FALSE(verdictOf(paper, {60.0, 60.0, 30.0}).feasible);
    Experiment nearer = paper;
    nearer.robot.clearance_m = nearer.robot.lower[kZ] = 0.005;
    EXPECT_TRUE(verdictOf(nearer, {60.0, 60.0, 30.0}).feasible);
}

Vector6d randomPose(const RigGeometry& geometry, const Vector6d& rest, std::mt19937& random) {
    std::uniform_real_distribution<double> unit(0.0, 1.0);
    Vector6d q = rest;
    do {
        for (const int c : geometry.freeCoordinates())
            q[c] = geometry.limits().lower[c] +
                   unit(random) * (geometry.limits().upper[c] - geometry.limits().lower[c]);
    } while (!geometry.allowed(q));
    return q;
}

// Wanted: 99.9 % of what random poses hold is found feasible.
void judgeFixedTargets(int count) {
    for (const char* name : {"three-objects.json", "three-objects-in-line.json"}) {
        FeasibilityRequest request = feasibilityRequest(example(name, SourceModel::Gray));
        request.lookup = feasibilityLookup(request.geometry, request.rest);
        const SteadySearch search(request.geometry, request.lookup, request.rates);
        std::mt19937 random(1);
        int feasible = 0;
        for (int i = 0; i < count; ++i) {
            const Eigen::VectorXd T_K = search.at(randomPose(*request.geometry, request.rest, random)).T_K;
            request.targets_K.assign(T_K.begin(), T_K.end());
            feasible += jointFeasibility(request).value().feasible ? 1 : 0;
        }
        ::testing::Test::RecordProperty(name, feasible);
        EXPECT_GE(feasible, count - count / 1000) << name;
    }
}

TEST(WhatRandomPosesHoldIsFeasible, hundred) {
    judgeFixedTargets(100);
}
TEST(WhatRandomPosesHoldIsFeasible, thousand) {
    judgeFixedTargets(1000);
}

/// Root of the sum of squared errors of the best pose that a fine grid and a compass search from its best
/// dozen find: no gradients, no linearised limits.
class BruteForce {
public:
    explicit BruteForce(const FeasibilityRequest& request)
        : m_request(request), m_grid(std::make_shared<PoseLookup>(request.geometry, request.rest, 200000)),
          m_search(request.geometry, m_grid, request.rates) {}

    double best_K(const std::vector<double>& targets_K) const {
        const Eigen::Map<const Eigen::ArrayXd> wanted(targets_K.data(), 3);
        Eigen::ArrayXd cost = Eigen::ArrayXd::Zero(m_search.table_K().rows());
        for (Eigen::Index i = 0; i < 3; ++i)
            cost += (m_search.table_K().col(i) - wanted[i]).square();
        std::vector<Eigen::Index> order(static_cast<std::size_t>(cost.size()));
        for (std::size_t k = 0; k < order.size(); ++k)
            order[k] = static_cast<Eigen::Index>(k);
        constexpr int kTried = 12;
        std::ranges::partial_sort(order, order.begin() + kTried, {}, [&](Eigen::Index k) { return cost[k]; });
        double best = cost[order[0]];
        for (int k = 0; k < kTried; ++k)
            best = std::min(best, descended(wanted, m_grid->pose(static_cast<std::size_t>(order[k]))));
        return std::sqrt(best);
    }

private:
    double costAt(const Eigen::ArrayXd& wanted, const Vector6d& q) const {
        const Eigen::VectorXd F = m_request.geometry->viewFactorsFast(q);
        double cost = 0.0;
        for (Eigen::Index i = 0; i < 3; ++i)
            cost += std::pow(
                m_request.rates[static_cast<std::size_t>(i)].steadyTemperature_K(F[i]) - wanted[i], 2);
        return cost;
    }

    double descended(const Eigen::ArrayXd& wanted, Vector6d q) const {
        double best = costAt(wanted, q);
        for (double step = 1.0; step > 1e-2;) {
            bool better = false;
            for (const int c : m_request.geometry->freeCoordinates())
                for (const double sign : {-1.0, 1.0}) {
                    Vector6d next = q;
                    next[c] += sign * step * m_grid->cell()[c];
                    if (!m_request.geometry->allowed(next))
                        continue;
                    if (const double cost = costAt(wanted, next); cost < best) {
                        best = cost;
                        q = next;
                        better = true;
                    }
                }
            if (!better)
                step *= 0.5;
        }
        return best;
    }

    FeasibilityRequest m_request;
    std::shared_ptr<const PoseLookup> m_grid;
    SteadySearch m_search;
};

// Wanted: 99 % of the targets that brute force finds to lie 1 K or more outside are found not feasible. And
// the search's best compromise is not worse than brute force's, which a search that stays in local minima
// would fail.
void judgeTargetsOutside(int count) {
    FeasibilityRequest request = feasibilityRequest(example("three-objects.json", SourceModel::Paper));
    request.lookup = feasibilityLookup(request.geometry, request.rest);
    const SteadySearch search(request.geometry, request.lookup, request.rates);
    const BruteForce brute(request);
    std::mt19937 random(2);
    std::uniform_real_distribution<double> pushed_K(-20.0, 20.0);
    int outside = 0, notFeasible = 0, worse = 0, wrongInside = 0, inside = 0;
    while (outside < count) {
        const Eigen::VectorXd T_K = search.at(randomPose(*request.geometry, request.rest, random)).T_K;
        for (std::size_t i = 0; i < 3; ++i)
            request.targets_K[i] = T_K[static_cast<Eigen::Index>(i)] + pushed_K(random);
        const double brute_K = brute.best_K(request.targets_K);
        const JointVerdict verdict = jointFeasibility(request).value();
        double square_K2 = 0.0;
        for (const double residual_K : verdict.residuals_K)
            square_K2 += residual_K * residual_K;
        worse += std::sqrt(square_K2) > brute_K + kReachedWithin_K ? 1 : 0;
        if (brute_K >= 1.0) {
            ++outside;
            notFeasible += verdict.feasible ? 0 : 1;
        } else if (brute_K < kReachedWithin_K) {
            ++inside;
            wrongInside += verdict.feasible ? 0 : 1;
        }
    }
    ::testing::Test::RecordProperty("notFeasible", notFeasible);
    ::testing::Test::RecordProperty("inside", inside);
    ::testing::Test::RecordProperty("worseThanBruteForce", worse);
    EXPECT_GE(notFeasible, count - count / 100);
    EXPECT_EQ(wrongInside, 0);
    EXPECT_EQ(worse, 0);
}

TEST(TargetsOutsideAreNotFeasible, hundred) {
    judgeTargetsOutside(100);
}
TEST(TargetsOutsideAreNotFeasible, thousand) {
    judgeTargetsOutside(1000);
}

} // namespace
} // namespace bask
