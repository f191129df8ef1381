// Limits of acceleration in the velocity solve: kept, and always leaving room to brake.

#include "engine/base/clock.h"
#include "engine/simulation/simulated_robot.h"
#include "tests/engine/control/two_disks.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace bask {
namespace {

RobotLimits accelerating() {
    RobotLimits limits;
    limits.maxAcceleration_m_s2 = 0.008;
    limits.maxAngularAcceleration_rad_s2 = 0.03;
    return limits;
}

double excess(const RigGeometry& geometry, const Vector6d& q, const Vector6d& rates, const Vector6d& last,
              double dt_s) {
    const RobotLimits& limits = geometry.limits();
    const Vector6d change = rates - last;
    const Eigen::Matrix3d axes = rotationAxes(q);
    return std::max({rates.head<3>().norm() / limits.maxSpeed_m_s,
                     (axes * rates.tail<3>()).norm() / limits.maxRotation_rad_s,
                     change.head<3>().norm() / (limits.maxAcceleration_m_s2 * dt_s),
                     (axes * change.tail<3>()).norm() / (limits.maxAngularAcceleration_rad_s2 * dt_s)}) -
           1.0;
}

Vector6d start(double z) {
    Vector6d q = Vector6d::Zero();
    q[kZ] = z;
    return q;
}

} // namespace

// A solve that looks one step ahead only, or clips afterwards, runs into a wall or over the acceleration.
TEST(VelocityLimits, ARobotThatAcceleratesStaysWithinEveryLimit) {
    const double dt_s = 0.5;
    const RigGeometry geometry = twoDisks(accelerating());
    std::mt19937 random(23);
    std::uniform_real_distribution<double> u(-1.0, 1.0);
    for (const bool ramps : {false, true}) { // takes up a velocity at once, or over the period
        Vector6d q = start(0.1);
        Vector6d last = Vector6d::Zero();
        Eigen::Vector2d wanted(0.0, 0.0);
        int braked = 0;
        for (int step = 0; step < 1500; ++step) {
            if (step % 25 == 0)
                wanted = Eigen::Vector2d(u(random), u(random));
            VelocityProblem problem = problemAt(geometry, q, wanted);
            problem.lastRates = last;
            problem.dt_s = dt_s;
            const VelocitySolution solution = solveVelocity(geometry, problem);
            ASSERT_LT(excess(geometry, q, solution.rates, last, dt_s), 1e-6) << step;
            EXPECT_FALSE(solution.limits.bits == 1U) << "no answer found at " << step;
            braked += solution.limits.has(Limit::Clearance) ? 1 : 0;
            q += dt_s * (ramps ? Vector6d(0.5 * (last + solution.rates)) : solution.rates);
            last = solution.rates;
            for (const int k : geometry.freeCoordinates()) {
                ASSERT_LE(q[k], geometry.limits().upper[k] + 1e-9) << step << " " << k;
                ASSERT_GE(q[k], geometry.limits().lower[k] - 1e-9) << step << " " << k;
            }
            ASSERT_GT(geometry.lowestPoint_m(q), geometry.limits().clearance_m - 1e-6) << step;
        }
        EXPECT_GT(braked, 20); // it has been there
    }
}

// Stops at once, by whatever cause, must be possible without leaving workspace or clearance.
TEST(VelocityLimits, AStopAtAnyMomentStaysInside) {
    const double dt_s = 0.5;
    const RobotLimits limits = accelerating();
    const RigGeometry geometry = twoDisks(limits);
    std::mt19937 random(5);
    std::uniform_real_distribution<double> u(-1.0, 1.0);
    Vector6d q = start(0.1);
    Vector6d last = Vector6d::Zero();
    Eigen::Vector2d wanted(1.0, 1.0);
    for (int step = 0; step < 400; ++step) {
        if (step % 20 == 0)
            wanted = Eigen::Vector2d(u(random), u(random));
        VelocityProblem problem = problemAt(geometry, q, wanted);
        problem.lastRates = last;
        problem.dt_s = dt_s;
        last = solveVelocity(geometry, problem).rates;
        q += dt_s * last;
        const double braking_s = std::max(last.head<3>().norm() / limits.maxAcceleration_m_s2,
                                          last.tail<3>().norm() / limits.maxAngularAcceleration_rad_s2);
        for (int k = 1; k <= 20; ++k) {
            const double t = braking_s * k / 20.0;
            const Vector6d there = q + (t - (braking_s > 0.0 ? 0.5 * t * t / braking_s : 0.0)) * last;
            ASSERT_GT(geometry.lowestPoint_m(there), limits.clearance_m - 1e-5) << step;
            for (const int c : geometry.freeCoordinates()) {
                ASSERT_LE(there[c], limits.upper[c] + 1e-9);
                ASSERT_GE(there[c], limits.lower[c] - 1e-9);
            }
        }
    }
}

// No velocity that keeps the limits of speed and acceleration is better: the norms are inside the solve.
TEST(VelocityLimits, NoAllowedVelocityIsBetter) {
    const RigGeometry geometry = twoDisks(accelerating());
    std::mt19937 random(3);
    std::uniform_real_distribution<double> u(-1.0, 1.0);
    for (int trial = 0; trial < 40; ++trial) {
        VelocityProblem problem;
        problem.coordinates = start(0.15);
        problem.coordinates[kThetaX] = 0.2 * u(random);
        problem.rows = geometry.viewFactors(problem.coordinates).dF;
        problem.wanted = Eigen::Vector2d(0.4 * u(random), 0.4 * u(random));
        problem.lastRates.head<3>() = 0.01 * Eigen::Vector3d(u(random), u(random), u(random));
        problem.lastRates[kThetaX] = 0.05 * u(random);
        problem.dt_s = 0.5;
        const VelocitySolution solution = solveVelocity(geometry, problem);
        EXPECT_LT(excess(geometry, problem.coordinates, solution.rates, problem.lastRates, 0.5), 1e-6);
        const double best = (problem.rows * solution.rates - problem.wanted).squaredNorm();
        for (int probe = 0; probe < 2000; ++probe) {
            Vector6d rates = problem.lastRates;
            rates.head<3>() += 0.004 * Eigen::Vector3d(u(random), u(random), u(random));
            rates[kThetaX] += 0.015 * u(random);
            if (excess(geometry, problem.coordinates, rates, problem.lastRates, 0.5) > 0.0)
                continue;
            EXPECT_GE((problem.rows * rates - problem.wanted).squaredNorm(),
                      best - 1e-4 * problem.wanted.squaredNorm());
        }
    }
}

TEST(VelocityLimits, SayWhichOneHoldsBack) {
    RobotLimits limits = accelerating();
    const auto limitsOf = [&](const Vector6d& q, const Vector6d& last, double rate) {
        const RigGeometry geometry = twoDisks(limits);
        VelocityProblem problem;
        problem.rows = geometry.viewFactors(q).dF;
        problem.wanted = Eigen::Vector2d(rate, rate);
        problem.coordinates = q;
        problem.lastRates = last;
        return describe(solveVelocity(geometry, problem).limits);
    };
    EXPECT_EQ(limitsOf(start(0.1), Vector6d::Zero(), 0.5), "acceleration");
    EXPECT_EQ(limitsOf(start(0.1), Vector6d::Zero(), 1e-3), "");
    Vector6d down = Vector6d::Zero();
    down[kZ] = -0.02;
    EXPECT_EQ(limitsOf(start(0.2), down, 0.5), "speed");
    limits = RobotLimits();
    limits.lower[kZ] = 0.05;
    EXPECT_EQ(limitsOf(start(0.06), Vector6d::Zero(), 0.5), "workspace z");
    limits.lower[kZ] = 0.0;
    EXPECT_EQ(limitsOf(start(0.015), Vector6d::Zero(), 0.5), "clearance");
    ActiveLimits all;
    all.add(Limit::AngularAcceleration);
    all.add(Limit::Workspace, kThetaX);
    EXPECT_EQ(describe(all), "angular acceleration, workspace theta_x");
}

// Arrives, without going past, with the acceleration kept all the way: through the simulated robot's ramps.
TEST(VelocityLimits, TowardsBrakesToArrive) {
    const double dt_s = 0.5;
    const RobotLimits limits = accelerating();
    const RigGeometry geometry = twoDisks(limits);
    SimulatedRobotConfig config;
    config.free = limits.free;
    config.lower = limits.lower;
    config.upper = limits.upper;
    config.maxAcceleration_m_s2 = limits.maxAcceleration_m_s2;
    config.maxAngularAcceleration_rad_s2 = limits.maxAngularAcceleration_rad_s2;
    config.start = start(0.25);
    ManualClock clock;
    SimulatedRobot robot(config, clock);
    Vector6d goal = start(0.1);
    goal[kX] = 0.08;
    goal[kThetaX] = 0.3;
    Vector6d last = Vector6d::Zero();
    const double path_m = (goal - config.start).head<3>().norm();
    double farthest_m = 0.0;
    int steps = 0;
    while ((goal - robot.coordinates()).norm() > 2e-4 && steps < 200) {
        const Vector6d rates = velocityTowards(geometry, robot.coordinates(), goal, dt_s, last).rates;
        ASSERT_LT(excess(geometry, robot.coordinates(), rates, last, dt_s), 1e-6) << steps;
        ASSERT_TRUE(robot.setTwist(rates, 1.5 * dt_s).ok()); // the only free angle turns about x itself
        robot.advance(dt_s);
        clock.advanceTo(clock.now_s() + dt_s);
        last = rates;
        farthest_m = std::max(farthest_m, (robot.coordinates() - config.start).head<3>().norm());
        ++steps;
    }
    const double min_s = path_m / limits.maxSpeed_m_s + limits.maxSpeed_m_s / limits.maxAcceleration_m_s2;
    EXPECT_LT(dt_s * steps, min_s + 8.0 * dt_s);
    EXPECT_LT(farthest_m, path_m + 1e-4);
}

TEST(VelocityLimits, SingularRangeIsThatOfTheScaledMatrix) {
    const RigGeometry geometry = twoDisks(RobotLimits());
    Eigen::Matrix<double, Eigen::Dynamic, 6> rows(2, 6);
    rows << 3.0, 0, 0, 0, 100.0, 0, 0, 0, 0, 0.2, 0, 100.0; // theta_y and theta_z are not free
    const SingularRange range = singularRange(geometry, rows, 0.1);
    EXPECT_NEAR(range.largest, 3.0, 1e-12);
    EXPECT_NEAR(range.smallest, 2.0, 1e-12);
}

} // namespace bask
