#include "engine/simulation/simulated_rig.h"

#include <gtest/gtest.h>

#include <cmath>

namespace bask {
namespace {

constexpr double kRoom_K = 298.15;
const Material kPainted{"painted", 0.9, 0.9, 904.0, 2700.0, 0.001, 1.0};

SimulatedRobotConfig robotConfig() {
    SimulatedRobotConfig config;
    config.free = {true, true, true, true, false, false};
    config.lower = Vector6d(-0.2, -0.2, 0.01, -0.6, 0.0, 0.0);
    config.upper = Vector6d(0.2, 0.2, 0.3, 0.6, 0.0, 0.0);
    config.start = Vector6d(0.0, 0.0, 0.15, 0.0, 0.0, 0.0);
    return config;
}

} // namespace

TEST(ThermalPlant, ReachesTheSteadyTemperatureOfTheHeatBalance) {
    const double J = netSourcePower_W_m2(SourceModel::Gray, 473.15, 0.25, kRoom_K);
    ThermalPlant plant({{kPainted, kRoom_K}}, kRoom_K, 0.0);
    for (int i = 0; i < 50000; ++i)
        plant.advance(0.5, {0.4}, J);
    EXPECT_NEAR(plant.temperature_K(0), heatRates(kPainted, J, kRoom_K).steadyTemperature_K(0.4), 1e-6);
}

TEST(ThermalPlant, ConvectionTakesAwayWhatItShould) {
    const double h = 7.0;
    ThermalPlant plant({{kPainted, kRoom_K}}, kRoom_K, h);
    for (int i = 0; i < 50000; ++i)
        plant.advance(0.5, {1.0}, 1000.0);
    const double T = plant.temperature_K(0);
    const double balance =
        0.9 * 1000.0 - 0.9 * 5.670374419e-8 * (std::pow(T, 4) - std::pow(kRoom_K, 4)) - h * (T - kRoom_K);
    EXPECT_NEAR(balance, 0.0, 1e-6);
}

TEST(ThermalPlant, AFoilIsStiffButNotUnstable) {
    Material foil = kPainted;
    foil.thickness_m = 5e-6;
    ThermalPlant plant({{foil, kRoom_K}}, kRoom_K, 1000.0);
    for (int i = 0; i < 100; ++i)
        plant.advance(0.1, {1.0}, 2000.0);
    const double T = plant.temperature_K(0);
    const double balance = 0.9 * 2000.0 - 0.9 * 5.670374419e-8 * (std::pow(T, 4) - std::pow(kRoom_K, 4)) -
                           1000.0 * (T - kRoom_K);
    EXPECT_NEAR(balance, 0.0, 1e-6);
}

TEST(SimulatedRobot, MovesAtTheAskedVelocityUntilItExpires) {
    ManualClock clock;
    SimulatedRobot robot(robotConfig(), clock);
    Vector6d twist = Vector6d::Zero();
    twist[kX] = 0.01;
    ASSERT_TRUE(robot.setTwist(twist, 2.0));
    for (int i = 0; i < 50; ++i) {
        robot.advance(0.1);
        clock.advance(0.1);
    }
    EXPECT_NEAR(robot.coordinates()[kX], 0.02, 1e-9);
}

TEST(SimulatedRobot, KeepsSpeedWorkspaceAndFixedAxesWhateverItIsAsked) {
    ManualClock clock;
    SimulatedRobot robot(robotConfig(), clock);
    const Vector6d wild = Vector6d::Constant(50.0);
    for (int i = 0; i < 200; ++i) {
        ASSERT_TRUE(robot.setTwist(wild, 1.0));
        const Vector6d before = robot.coordinates();
        robot.advance(0.1);
        clock.advance(0.1);
        EXPECT_LE((robot.coordinates() - before).head<3>().norm(), 0.1 * 0.02 + 1e-12);
    }
    EXPECT_LE(robot.coordinates()[kX], 0.2);
    EXPECT_LE(robot.coordinates()[kThetaX], 0.6);
    EXPECT_EQ(robot.coordinates()[kThetaZ], 0.0);
}

TEST(SimulatedRobot, StepsInItsResolution) {
    ManualClock clock;
    SimulatedRobotConfig config = robotConfig();
    config.step_m = 0.001;
    SimulatedRobot robot(config, clock);
    Vector6d twist = Vector6d::Zero();
    twist[kY] = 0.0033;
    ASSERT_TRUE(robot.setTwist(twist, 5.0));
    robot.advance(1.0);
    EXPECT_NEAR(robot.coordinates()[kY], 0.003, 1e-12);
}

// A robot with mass neither jumps to a velocity nor stands at once, whatever its host asks.
TEST(SimulatedRobot, RampsWithItsAcceleration) {
    ManualClock clock;
    SimulatedRobotConfig config = robotConfig();
    config.step_m = 0.0;
    config.maxAcceleration_m_s2 = 0.004;
    SimulatedRobot robot(config, clock);
    const double from_m = robot.coordinates()[kX];
    const auto advance = [&](double dt_s) {
        robot.advance(dt_s);
        clock.advance(dt_s);
        return robot.coordinates()[kX] - from_m;
    };
    Vector6d twist = Vector6d::Zero();
    twist[kX] = 0.01;
    ASSERT_TRUE(robot.setTwist(twist, 100.0));
    EXPECT_NEAR(advance(1.0), 0.002, 1e-12);          // a t^2 / 2
    EXPECT_NEAR(advance(2.0), 0.0125 + 0.005, 1e-12); // at full speed after 2.5 s
    ASSERT_TRUE(robot.halt());
    ASSERT_TRUE(robot.state());
    EXPECT_TRUE(robot.state()->moving);
    EXPECT_NEAR(advance(10.0), 0.0175 + 0.0125, 1e-12); // v^2 / 2a more
    EXPECT_FALSE(robot.state()->moving);
}

TEST(SimulatedThermometer, RoundsDelaysOffsetsAndRepeatsItsSeed) {
    ManualClock clock;
    SimulatedThermometerConfig config{2, 0.0, 0.1, 0.3, 2.0, 42};
    SimulatedThermometer first(config, clock);
    SimulatedThermometer second(config, clock);
    first.observe({300.0, 300.0});
    second.observe({300.0, 300.0});
    const auto a = first.read();
    const auto b = second.read();
    ASSERT_TRUE(a && b);
    for (std::size_t i = 0; i < 2; ++i) {
        EXPECT_EQ((*a)[i].value_K, (*b)[i].value_K);
        EXPECT_NEAR((*a)[i].value_K, 300.0, 0.35);
        EXPECT_NEAR(std::remainder((*a)[i].value_K, 0.1), 0.0, 1e-9);
    }
    clock.advance(1.0);
    first.observe({350.0, 350.0});
    EXPECT_EQ((*first.read())[0].value_K, (*a)[0].value_K); // 2 s late
    clock.advance(2.0);
    first.observe({350.0, 350.0});
    EXPECT_NEAR((*first.read())[0].value_K, 350.0, 0.35);
}

TEST(SimulatedHeatSource, HeatGoesOffByItselfWhenNobodySaysOn) {
    ManualClock clock;
    SimulatedHeatSource source(473.15, kRoom_K, clock);
    EXPECT_FALSE(source.heating());
    ASSERT_TRUE(source.keepHeating(473.15, 3.0));
    clock.advance(2.9);
    EXPECT_TRUE(source.heating());
    clock.advance(0.2);
    EXPECT_FALSE(source.heating());
}

TEST(SimulatedRig, WarmsObjectsOnlyWhileTheHeatIsOn) {
    SimulatedRigConfig config;
    config.source = Disk{0.1};
    config.objects.push_back({Disk{0.015}, Vector6d::Zero(), kPainted});
    config.robot = robotConfig();
    config.thermometer.channels = 1;
    SimulatedRig rig(config);
    rig.advance(100.0);
    EXPECT_NEAR(rig.trueTemperatures_K()[0], kRoom_K, 1e-6);
    ASSERT_TRUE(rig.heatSource().keepHeating(473.15, 50.0));
    rig.advance(50.0);
    EXPECT_GT(rig.trueTemperatures_K()[0], kRoom_K + 2.0);
}

} // namespace bask
