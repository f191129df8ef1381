#include "engine/drivers/step_planner.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace bask {
namespace {

const std::vector<AxisSpec> kPlannedAxes{{'X', 0, false, 0.0}, {'Z', 2, false, 0.0}, {'A', 4, false, 0.0}};
const Vector6d kRight = (Vector6d() << 0.01, 0, 0, 0, 0, 0).finished();

StepPlanner anywhere() {
    return {AxisMap(kPlannedAxes, Vector6d::Zero()), [](const Vector6d&) { return true; }};
}

// Catches a guard that is asked for another place than the one that is sent, be it by a rounding.
TEST(StepPlanner, TheVeryTargetWasApproved) {
    const AxisMap map(kPlannedAxes, Vector6d::Constant(0.001));
    std::vector<Vector6d> approved;
    StepPlanner planner(map, [&](const Vector6d& target) {
        const bool isFine = target[0] < 0.02;
        if (isFine)
            approved.push_back(target);
        return isFine;
    });
    std::mt19937 random(3);
    std::uniform_real_distribution<double> any(-1.0, 1.0);
    const auto isApproved = [&](const Vector6d& q) {
        return std::ranges::find(approved, q) != approved.end();
    };
    int steps = 0;
    for (int i = 0; i < 1000; ++i) {
        planner.forget();
        planner.setTwist(0.05 * Vector6d::NullaryExpr([&] { return any(random); }), 0.5, i);
        const auto step = planner.next({20.0 * any(random), any(random), any(random)}, i);
        if (!step)
            continue;
        ++steps;
        ASSERT_FALSE(approved.empty());
        EXPECT_TRUE(isApproved(map.coordinates(step->to)));
        approved.clear();
    }
    EXPECT_GT(steps, 800);
}

// Catches steps longer than the velocity is valid, or than half a second.
TEST(StepPlanner, StepsAreBounded) {
    for (const auto& [valid_s, expected_mm] :
         {std::pair{0.15, 1.5}, std::pair{0.5, 5.0}, std::pair{60.0, 5.0}}) {
        StepPlanner planner = anywhere();
        planner.setTwist(kRight, valid_s, 0.0);
        const auto step = planner.next({0.0, 0.0, 0.0}, 0.0);
        ASSERT_TRUE(step);
        EXPECT_NEAR(step->to[0], expected_mm, 1e-9);
        EXPECT_NEAR(step->time_s, expected_mm / 10.0, 1e-9);
    }
}

// Catches a velocity that does not end, and a step that begins before the one before it is over.
TEST(StepPlanner, AVelocityExpires) {
    StepPlanner planner = anywhere();
    planner.setTwist(kRight, 0.2, 0.0);
    EXPECT_TRUE(planner.next({0.0, 0.0, 0.0}, 0.05));
    EXPECT_FALSE(planner.next({2.0, 0.0, 0.0}, 0.1));
    EXPECT_FALSE(planner.next({2.0, 0.0, 0.0}, 0.3));
    planner.setTwist(kRight, 0.2, 0.3);
    EXPECT_TRUE(planner.next({2.0, 0.0, 0.0}, 0.3));
    planner.setTwist(kRight, 0.2, 1.0);
    planner.forget();
    EXPECT_FALSE(planner.next({2.0, 0.0, 0.0}, 1.0));
}

// Catches a step that is sent late in a velocity's time and goes on beyond its end.
TEST(StepPlanner, AStepEndsWithItsVelocity) {
    StepPlanner planner = anywhere();
    planner.setTwist(kRight, 0.2, 0.0);
    const auto step = planner.next({0.0, 0.0, 0.0}, 0.15);
    ASSERT_TRUE(step);
    EXPECT_NEAR(step->time_s, 0.05, 1e-9);
    EXPECT_NEAR(step->to[0], 0.5, 1e-9);
    planner.setTwist(kRight, 0.2, 1.0);
    EXPECT_FALSE(planner.next({0.5, 0.0, 0.0}, 1.19));
}

// Catches a turn whose end is fine and whose way is not, and turns without bound.
TEST(StepPlanner, ATurnIsApprovedOnItsWay) {
    const Vector6d turn = (Vector6d() << 0, 0, 0, 0, 0.15, 0).finished();
    for (const double bad_rad : {0.25 * 0.075, 0.5 * 0.075, 0.75 * 0.075}) {
        StepPlanner planner(AxisMap(kPlannedAxes, Vector6d::Zero()),
                            [&](const Vector6d& target) { return std::abs(target[4] - bad_rad) > 0.001; });
        planner.setTwist(turn, 0.5, 0.0);
        const auto step = planner.next({0.0, 0.0, 0.0}, 0.0);
        if (step) {
            EXPECT_LT(step->to[2], bad_rad * 57.3);
        }
    }
    StepPlanner planner = anywhere();
    planner.setTwist(10.0 * turn, 0.5, 0.0);
    const auto step = planner.next({0.0, 0.0, 0.0}, 0.0);
    ASSERT_TRUE(step);
    EXPECT_NEAR(step->to[2], 0.1 * 57.29577951308232, 1e-3);
    EXPECT_NEAR(step->time_s, 0.1 / 1.5, 1e-9);
}

// Catches roundings that add up, and a goal that is kept where the robot is not: pushed, or stopped on its
// way.
TEST(StepPlanner, GoesOnFromItsGoalWhereItIsNear) {
    StepPlanner planner = anywhere();
    planner.setTwist(kRight, 0.5, 0.0);
    ASSERT_TRUE(planner.next({0.0, 0.0, 0.0}, 0.0));
    planner.setTwist(kRight, 0.5, 1.0);
    EXPECT_NEAR(planner.next({4.95, 0.0, 0.0}, 1.0)->to[0], 10.0, 1e-9);
    planner.setTwist(kRight, 0.5, 2.0);
    EXPECT_NEAR(planner.next({9.5, 0.0, 0.0}, 2.0)->to[0], 14.5, 1e-9);
}

// Catches a turn about the robot's axes that is sent as rates of the angles, which differ once it is turned.
TEST(StepPlanner, TurnsAreAboutTheAxesOfTheBase) {
    StepPlanner planner(
        {AxisMap({{'A', 3, false, 0.0}, {'B', 4, false, 0.0}, {'C', 5, false, 0.0}}, Vector6d::Zero())},
        [](const Vector6d&) { return true; });
    const Vector6d twist = (Vector6d() << 0, 0, 0, 0.1, 0, 0).finished();
    planner.setTwist(twist, 0.5, 0.0);
    const auto step = planner.next({0.0, 0.0, 90.0}, 0.0); // turned by a quarter about z
    ASSERT_TRUE(step);
    Vector6d expected = Vector6d::Zero();
    expected.tail<3>() =
        rotationAxes((Vector6d() << 0, 0, 0, 0, 0, 1.5707963267948966).finished()).inverse() *
        twist.tail<3>();
    EXPECT_NEAR(step->to[0], 0.5 * expected[3] * 57.29577951308232, 1e-3);
    EXPECT_NEAR(step->to[1], 0.5 * expected[4] * 57.29577951308232, 1e-3);
    EXPECT_NEAR(std::abs(step->to[1]), 2.865, 1e-3);
}

// Catches a refused robot that stays refused when it is asked to turn round.
TEST(StepPlanner, ARefusalEndsWithAnotherVelocity) {
    StepPlanner planner(AxisMap(kPlannedAxes, Vector6d::Zero()),
                        [](const Vector6d& target) { return target[0] <= 0.0; });
    planner.setTwist(kRight, 1.0, 0.0);
    EXPECT_FALSE(planner.next({0.0, 0.0, 0.0}, 0.0));
    EXPECT_TRUE(planner.isRefused());
    planner.setTwist(-kRight, 1.0, 0.01);
    EXPECT_TRUE(planner.next({0.0, 0.0, 0.0}, 0.01));
    EXPECT_FALSE(planner.isRefused());
}

} // namespace
} // namespace bask
