// The controllers against the analytic plant, without noise, sampling delays or limits in the way.

#include "engine/base/units.h"
#include "engine/control/controller.h"
#include "engine/control/lagged_identification.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <stdexcept>

namespace bask {
namespace {

constexpr double kT3_K = 298.15;

RobotLimits wideLimits() {
    RobotLimits limits;
    limits.maxSpeed_m_s = 10.0;
    limits.maxRotation_rad_s = 10.0;
    return limits;
}

/// One painted disk 10 cm over the source, at its steady state there.
struct Bench {
    std::shared_ptr<const RigGeometry> geometry;
    HeatRates rates;
    Vector6d q = Vector6d::Zero();
    double T_K = 0.0;
    double now_s = 0.0; ///< of all runs together: a controller's time only grows

    Bench() {
        RobotLimits limits = wideLimits();
        limits.free = {false, false, true, false, false, false};
        geometry = std::make_shared<RigGeometry>(Disk{0.1}, std::vector<Shape>{Disk{0.015}},
                                                 std::vector<Vector6d>{Vector6d::Zero()}, limits);
        const Material painted{"painted", 0.9, 0.9, 904.0, 2700.0, 0.001, 1.0};
        rates = heatRates(painted, surroundingsOf(SourceModel::Gray, 473.15, 0.25, kT3_K));
        q[kZ] = 0.10;
        T_K = rates.steadyTemperature_K(F());
    }
    double F() const { return geometry->viewFactors(q).F[0]; }
    double v() const { return rates.rate_K_s(F(), T_K); }

    /// Runs `controller` for a time with a small step; calls see(time, T) at each.
    template <class See> void run(Controller& controller, double duration_s, double dt_s, See see) {
        for (double t = 0.0; t < duration_s; t += dt_s, now_s += dt_s) {
            see(t, T_K);
            const ControlOutput output = controller.step({now_s, q, 1.0, {{T_K, v()}}}, dt_s);
            for (int i = 0; i < 10; ++i) {
                T_K += 0.1 * dt_s * v();
                q += 0.1 * dt_s * output.rates;
            }
        }
    }
};

ControllerSettings settingsOf(ControllerKind kind) {
    ControllerSettings settings;
    settings.kind = kind;
    settings.damping = 1e-6;
    return settings;
}

HeatRates badlyKnown(HeatRates rates) {
    rates.lambda1 *= 3.5;
    rates.lambda2 *= 0.3;
    rates.lambda3 *= 0.3;
    return rates;
}

} // namespace

TEST(LevelServo, SettlesFromBeliefsThatAreFourTimesWrong) {
    for (const double wrong1 : {0.25, 1.0, 4.0})
        for (const double wrong2 : {0.25, 1.0, 4.0}) {
            Bench bench;
            HeatRates estimated = bench.rates;
            estimated.lambda1 *= wrong1;
            estimated.lambda2 *= wrong2;
            estimated.lambda3 *= wrong2;
            const double target_K = bench.T_K + 8.0;
            const auto controller = makeController(settingsOf(ControllerKind::LevelServo),
                                                   {bench.geometry, {estimated}, {target_K}});
            double lastOutside_s = 0.0;
            bench.run(*controller, 400.0, 1.0, [&](double t, double T_K) {
                if (std::abs(T_K - target_K) > 0.3)
                    lastOutside_s = t;
            });
            EXPECT_NEAR(bench.T_K, target_K, 0.3) << wrong1 << " " << wrong2;
            EXPECT_LT(lastOutside_s, 200.0) << wrong1 << " " << wrong2;
        }
}

TEST(LevelServo, ChangeOfTargetAndStrengthAreFollowed) {
    Bench bench;
    const auto controller = makeController(settingsOf(ControllerKind::LevelServo),
                                           {bench.geometry, {bench.rates}, {bench.T_K + 3.0}});
    bench.run(*controller, 100.0, 1.0, [](double, double) {});
    const double target_K = bench.T_K - 5.0;
    controller->setTargets({target_K});
    bench.run(*controller, 400.0, 1.0, [](double, double) {});
    EXPECT_NEAR(bench.T_K, target_K, 0.1);
}

// Catches noise that moves the robot although the object is at its target and the pose holds it.
TEST(LevelServo, StandsStillAtAPoseThatHoldsTheTargetThoughReadingsScatter) {
    Bench bench;
    const double target_K = bench.T_K + 8.0;
    const auto controller =
        makeController(settingsOf(ControllerKind::LevelServo), {bench.geometry, {bench.rates}, {target_K}});
    bench.run(*controller, 300.0, 1.0, [](double, double) {});
    Observation observation;
    observation.coordinates = bench.q;
    double way_m = 0.0;
    for (int k = 1; k <= 60; ++k) {
        observation.time_s = 300.0 + k;
        const double scatter_K = k % 2 == 0 ? 0.22 : -0.22;
        observation.objects = {{target_K + scatter_K, 0.0}};
        const Vector6d rates = controller->step(observation, 1.0).rates;
        way_m += rates.head<3>().norm();
        observation.lastRates = rates;
        observation.coordinates += rates;
    }
    EXPECT_LT(way_m, 0.01);
}

TEST(Controllers, RefuseAWrongNumberOfObjects) {
    const Bench bench;
    for (const auto kind :
         {ControllerKind::LevelServo, ControllerKind::ModelBased, ControllerKind::Adaptive}) {
        const auto controller = makeController(settingsOf(kind), {bench.geometry, {bench.rates}, {310.0}});
        EXPECT_THROW(controller->step({0.0, bench.q, 1.0, {}}, 1.0), std::invalid_argument);
    }
}

TEST(RateIdentification, FindsBothRatesFromNoisyReadings) {
    const Bench bench;
    std::mt19937 random(5);
    std::normal_distribution<double> noise(0.0, 0.03);
    RateIdentification identification(badlyKnown(bench.rates));
    double T_K = kT3_K;
    for (int t = 0; t < 400; ++t) {
        const double F = t < 120 ? 0.8 : 0.2 + 0.1 * std::sin(0.05 * t);
        identification.add(t, T_K + noise(random), F, 1.0);
        for (int i = 0; i < 10; ++i)
            T_K += 0.1 * bench.rates.rate_K_s(F, T_K);
    }
    EXPECT_NEAR(identification.rates().lambda1 / bench.rates.lambda1, 1.0, 0.05);
    EXPECT_NEAR(identification.rates().lambda2 / bench.rates.lambda2, 1.0, 0.10);
}

// Catches a filter that leads the sensor's by half a period: every lag was taken for half a second more.
TEST(LaggedIdentification, FindsTheLagThatASensorHas) {
    const Bench bench;
    for (const double lag_s : {0.0, 0.7, 1.5, 2.5, 4.0, 6.0}) {
        std::mt19937 random(5);
        std::normal_distribution<double> noise(0.0, 0.03);
        LaggedIdentification identification(badlyKnown(bench.rates));
        double T_K = kT3_K, read_K = T_K;
        const auto heating = [](double t) {
            return 0.4 + 0.3 * std::sin(0.1 * t) + 0.2 * std::sin(0.31 * t);
        };
        for (int t = 0; t < 300; ++t) {
            identification.add(t, read_K + noise(random), heating(t), 1.0, 0.0);
            for (int i = 0; i < 100; ++i) {
                T_K += 0.01 * bench.rates.rate_K_s(heating(t + 0.01 * i), T_K);
                read_K = lag_s > 0.0 ? read_K + 0.01 / lag_s * (T_K - read_K) : T_K;
            }
        }
        EXPECT_EQ(identification.lag_s(), lag_s);
        EXPECT_NEAR(identification.rates().lambda1 / bench.rates.lambda1, 1.0, 0.05) << lag_s;
    }
}

} // namespace bask
