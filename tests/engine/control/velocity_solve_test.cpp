#include "tests/engine/control/two_disks.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace bask {
namespace {

Vector6d somewhere(double x, double y, double z, double theta_x) {
    Vector6d q = Vector6d::Zero();
    q[kX] = x;
    q[kY] = y;
    q[kZ] = z;
    q[kThetaX] = theta_x;
    return q;
}

} // namespace

TEST(VelocitySolve, GivesTheWantedRatesWhenNothingLimits) {
    const RigGeometry geometry = twoDisks(RobotLimits());
    auto problem = problemAt(geometry, somewhere(0.02, 0.01, 0.12, 0.1), {0.003, -0.002});
    problem.damping = 1e-6;
    const VelocitySolution solution = solveVelocity(geometry, problem);
    EXPECT_FALSE(solution.limits.any());
    EXPECT_GT(solution.smallestSingularValue, 0.0);
    EXPECT_LT((problem.rows * solution.rates - problem.wanted).norm(), 1e-6);
    EXPECT_EQ(solution.rates[kThetaY], 0.0);
    EXPECT_EQ(solution.rates[kThetaZ], 0.0);
}

TEST(VelocitySolve, SpeedLimitsHoldAndNoFeasibleVelocityIsBetter) {
    const RobotLimits limits;
    const RigGeometry geometry = twoDisks(limits);
    std::mt19937 random(3);
    std::uniform_real_distribution<double> u(-1.0, 1.0);
    for (int trial = 0; trial < 60; ++trial) {
        const Vector6d q =
            somewhere(0.15 * u(random), 0.15 * u(random), 0.12 + 0.05 * u(random), 0.3 * u(random));
        const auto problem = problemAt(geometry, q, {0.4 * u(random), 0.4 * u(random)});
        const VelocitySolution solution = solveVelocity(geometry, problem);
        EXPECT_LE(solution.rates.head<3>().norm(), limits.maxSpeed_m_s * (1.0 + 1e-6));
        EXPECT_LE(solution.rates.tail<3>().norm(), limits.maxRotation_rad_s * (1.0 + 1e-6));
        EXPECT_TRUE(geometry.allowed(q + problem.dt_s * solution.rates));
        const double best = (problem.rows * solution.rates - problem.wanted).squaredNorm();
        for (int probe = 0; probe < 400; ++probe) {
            Vector6d rates = Vector6d::Zero();
            rates.head<3>() = Eigen::Vector3d(u(random), u(random), u(random)).normalized() *
                              limits.maxSpeed_m_s * std::abs(u(random));
            rates[kThetaX] = limits.maxRotation_rad_s * u(random);
            if (!geometry.allowed(q + problem.dt_s * rates))
                continue;
            EXPECT_GE((problem.rows * rates - problem.wanted).squaredNorm(),
                      best - 1e-4 * problem.wanted.squaredNorm());
        }
    }
}

// Catches a robot that is stuck over a hot source: with a face parallel to the floor at its clearance each
// tilt lowers some side, so that the row of one lowest point believes in a tilt that no step, however short,
// allows.
TEST(VelocitySolve, SlidesWhereEachTiltIsTooLow) {
    std::mt19937 random(5);
    std::uniform_real_distribution<double> u(-1.0, 1.0);
    for (const double acceleration_m_s2 : {0.0, 0.3}) {
        RobotLimits limits;
        limits.maxAcceleration_m_s2 = acceleration_m_s2;
        const RigGeometry geometry = twoDisks(limits);
        for (int trial = 0; trial < 200; ++trial) {
            const Vector6d q = somewhere(0.08 * u(random), 0.08 * u(random), limits.clearance_m, 0.0);
            const auto problem = problemAt(geometry, q, {0.4 * u(random), 0.4 * u(random)});
            const VelocitySolution solution = solveVelocity(geometry, problem);
            EXPECT_TRUE(geometry.allowed(q + problem.dt_s * solution.rates)) << trial;
            const double left = (problem.rows * solution.rates - problem.wanted).squaredNorm();
            double best = problem.wanted.squaredNorm();
            for (int probe = 0; probe < 400; ++probe) {
                Vector6d rates = Vector6d::Zero();
                rates.head<3>() =
                    Eigen::Vector3d(u(random), u(random), std::max(0.0, u(random))).normalized() *
                    limits.maxSpeed_m_s * std::abs(u(random));
                rates[kThetaX] = probe % 2 == 0 ? 0.0 : limits.maxRotation_rad_s * u(random);
                if (geometry.allowed(q + 2.0 * problem.dt_s * rates)) // and room to brake
                    best = std::min(best, (problem.rows * rates - problem.wanted).squaredNorm());
            }
            EXPECT_LE(left, best + 0.1 * problem.wanted.squaredNorm()) << trial;
        }
    }
}

TEST(VelocitySolve, StopsAtTheWorkspaceAndTheClearance) {
    const RigGeometry geometry = twoDisks(RobotLimits());
    // Both disks are asked to see more of the source, which lies below the least height.
    Vector6d q = somewhere(0.0, 0.0, 0.0105, 0.0);
    const VelocitySolution down = solveVelocity(geometry, problemAt(geometry, q, {0.5, 0.5}));
    EXPECT_TRUE(down.limits.any());
    EXPECT_GE(geometry.lowestPoint_m(q + down.rates), 0.01 - 1e-8);
    q = somewhere(0.2, 0.0, 0.1, 0.0);
    const VelocitySolution out = solveVelocity(geometry, problemAt(geometry, q, {-0.5, -0.5}));
    EXPECT_LE(q[kX] + out.rates[kX], 0.2 + 1e-9);
}

TEST(VelocitySolve, TowardsArrivesAndDoesNotPass) {
    const RigGeometry geometry = twoDisks(RobotLimits());
    Vector6d q = somewhere(0.0, 0.0, 0.2, 0.0);
    const Vector6d goal = somewhere(0.05, -0.03, 0.1, 0.2);
    const double time_s = travelTime_s(geometry.limits(), q, goal);
    int steps = 0;
    while ((goal - q).norm() > 1e-9 && steps < 100) {
        q += velocityTowards(geometry, q, goal, 1.0).rates;
        ++steps;
    }
    EXPECT_EQ(steps, static_cast<int>(std::ceil(time_s)));
}

TEST(RigGeometry, InteractionMatrixIsTheDerivativeOfTheViewFactors) {
    const RigGeometry geometry = twoDisks(RobotLimits());
    Vector6d q = somewhere(0.03, -0.02, 0.08, 0.2);
    q[kThetaY] = -0.15;
    q[kThetaZ] = 0.4;
    const ViewFactors fields = geometry.viewFactors(q);
    for (int k = 0; k < 6; ++k) {
        const double h = 1e-5;
        Vector6d up = q;
        Vector6d down = q;
        up[k] += h;
        down[k] -= h;
        const Eigen::VectorXd slope = (geometry.viewFactors(up).F - geometry.viewFactors(down).F) / (2.0 * h);
        EXPECT_LT((slope - fields.dF.col(k)).norm(), 1e-5 * fields.dF.norm())
            << kCoordinateNames[static_cast<std::size_t>(k)];
    }
}

TEST(RigGeometry, ClearanceIsThatOfTheLowestPoint) {
    const RigGeometry geometry = twoDisks(RobotLimits());
    // A disk 4 cm out, 1.5 cm in radius, tilted by theta: its lowest point is 5.5 cm sin(theta) below the
    // centre.
    EXPECT_NEAR(geometry.lowestPoint_m(somewhere(0.0, 0.0, 0.1, 0.3)), 0.1 - 0.055 * std::sin(0.3), 1e-5);
    EXPECT_FALSE(geometry.allowed(somewhere(0.0, 0.0, 0.02, 0.3)));
    EXPECT_TRUE(geometry.allowed(somewhere(0.0, 0.0, 0.02, 0.0)));
}

// Catches a robot that jumps off the source at full speed where its straight way is nanometres too low: a
// tilt lowers one of the disks, and the sine bends the way.
TEST(VelocityTowards, TiltsAlongTheClearanceWithoutJumpingOff) {
    for (const double acceleration_m_s2 : {0.0, 0.3}) {
        RobotLimits limits;
        limits.maxAcceleration_m_s2 = acceleration_m_s2;
        const RigGeometry geometry = twoDisks(limits);
        Vector6d q = Vector6d::Zero();
        q[kZ] = limits.clearance_m;
        Vector6d goal = q;
        goal[kY] = 0.02;
        goal[kThetaX] = 0.06;
        goal[kZ] += limits.clearance_m - geometry.lowestPoint_m(goal);
        ASSERT_TRUE(geometry.allowed(q));
        ASSERT_TRUE(geometry.allowed(goal));
        Vector6d rates = Vector6d::Zero();
        for (int k = 0; k < 20; ++k) {
            rates = velocityTowards(geometry, q, goal, 0.25, rates).rates;
            EXPECT_LT(rates[kZ], 0.3 * limits.maxSpeed_m_s) << k;
            q += 0.25 * rates;
            EXPECT_TRUE(geometry.allowed(q)) << k;
        }
        EXPECT_NEAR((q - goal).norm(), 0.0, 1e-5) << acceleration_m_s2;
    }
}

} // namespace bask
