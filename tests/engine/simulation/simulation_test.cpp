#include "engine/simulation/simulated_rig.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

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

SimulatedRigConfig oneDisk() {
    SimulatedRigConfig config;
    config.source = Disk{0.1};
    config.objects.push_back({Disk{0.015}, Vector6d::Zero(), kPainted});
    config.robot = robotConfig();
    config.thermometer.channels = 1;
    return config;
}

} // namespace

TEST(ThermalPlant, ReachesTheSteadyTemperatureOfTheHeatBalance) {
    const Surroundings surroundings = surroundingsOf(SourceModel::Gray, 473.15, 0.25, kRoom_K);
    ThermalPlant plant({{kPainted, kRoom_K}}, SourceModel::Gray, kRoom_K, {});
    for (int i = 0; i < 50000; ++i)
        plant.advance(0.5, {0.4}, surroundings.netSourcePower_W_m2);
    EXPECT_NEAR(plant.temperature_K(0), heatRates(kPainted, surroundings).steadyTemperature_K(0.4), 1e-6);
}

// Catches a plant that takes the room's radiation by the absorptance for the source's.
TEST(ThermalPlant, AnObjectFarFromTheSourceComesToTheRoomsTemperature) {
    Material shiny = kPainted;
    shiny.emittance = 0.7;
    ThermalPlant plant({{shiny, kRoom_K + 20.0}}, SourceModel::Gray, kRoom_K, {});
    for (int i = 0; i < 50000; ++i)
        plant.advance(0.5, {0.0}, 1000.0);
    EXPECT_NEAR(plant.temperature_K(0), kRoom_K, 1e-6);
}

TEST(ThermalPlant, ConvectionTakesAwayWhatItShould) {
    const double h = 7.0;
    ThermalPlant plant({{kPainted, kRoom_K}}, SourceModel::Gray, kRoom_K, {h});
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
    ThermalPlant plant({{foil, kRoom_K}}, SourceModel::Gray, kRoom_K, {1000.0});
    for (int i = 0; i < 100; ++i)
        plant.advance(0.1, {1.0}, 2000.0);
    const double T = plant.temperature_K(0);
    const double balance = 0.9 * 2000.0 - 0.9 * 5.670374419e-8 * (std::pow(T, 4) - std::pow(kRoom_K, 4)) -
                           1000.0 * (T - kRoom_K);
    EXPECT_NEAR(balance, 0.0, 1e-6);
}

// Two plates face each other, 2 cm apart at 80 and 30 degC: what one gives the other gets.
TEST(ThermalPlant, NeighboursExchangeRadiation) {
    const double hot_K = 353.15, cold_K = 303.15;
    const Pose turned(Eigen::AngleAxisd(std::numbers::pi, Eigen::Vector3d::UnitX()));
    const MountedObjects plates({{RadiatingContour(Disk{0.1}), turned},
                                 {RadiatingContour(Disk{0.1}), Pose(Eigen::Translation3d(0, 0, 0.02))}});
    const auto rates_W_m2 = [&](const Neighbours& neighbours) -> Eigen::Vector2d {
        ThermalPlant plant({{kPainted, hot_K}, {kPainted, cold_K}}, SourceModel::Gray, kRoom_K, {},
                           neighbours);
        plant.advance(0.01, {0.0, 0.0}, 0.0);
        return Eigen::Vector2d(plant.temperature_K(0) - hot_K, plant.temperature_K(1) - cold_K) / 0.01 *
               kPainted.arealHeatCapacity_J_m2K();
    };
    const Neighbours facing(plates, {{0.9, 0.9}, {0.9, 0.9}});
    const Eigen::Vector2d gained = rates_W_m2(facing) - rates_W_m2({});
    constexpr double kSigma = 5.670374419e-8;
    const double f = 0.8190; // closed form of equal coaxial disks, a fifth of the radius apart
    const double hot = kSigma * (std::pow(hot_K, 4) - std::pow(kRoom_K, 4)),
                 cold = kSigma * (std::pow(cold_K, 4) - std::pow(kRoom_K, 4));
    const double all = 1.0 - std::pow(f * 0.1, 2);
    EXPECT_NEAR(gained[1], 0.9 * f * 0.9 * (hot + 0.1 * f * cold) / all, 0.5);
    EXPECT_NEAR(gained[0], 0.9 * f * 0.9 * (cold + 0.1 * f * hot) / all, 0.5);
    EXPECT_GT(gained[1], 250.0);
}

// Catches a shield that goes along with a source that moves.
TEST(SimulatedRig, ShieldsStayWhereTheyAreWhenTheSourceMoves) {
    const auto warmed_K = [](double from_m, bool moves, bool isShielded) {
        SimulatedRigConfig config = oneDisk();
        config.sourcePose[kX] = from_m;
        Vector6d there = Vector6d::Zero();
        there[kX] = 0.04;
        if (moves)
            config.sourceMotion = {{0.0, config.sourcePose}, {0.05, there}};
        if (isShielded)
            config.screens.shields.push_back(
                {RadiatingContour(Disk{0.05}), Pose(Eigen::Translation3d(0.05, 0.0, 0.05))});
        SimulatedRig rig(config);
        EXPECT_TRUE(rig.heatSource().keepHeating(config.sourceTemperature_K, 1e3));
        rig.advance(60.0);
        return rig.trueTemperatures_K()[0];
    };
    const double there_K = warmed_K(0.04, false, true);
    EXPECT_NEAR(warmed_K(-0.1, true, true), there_K, 0.02);
    EXPECT_GT(warmed_K(0.04, false, false), there_K + 0.5) << "it shades";
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

// Catches a lag that depends on how often the plant is stepped, or that is none.
TEST(SimulatedThermometer, LagsBehindAStepByItsTimeConstant) {
    for (const double step_s : {0.1, 2.5}) {
        ManualClock clock;
        SimulatedThermometerConfig config{1, 0.0, 0.0, 0.0, 0.0, 1};
        config.lag_s = 5.0;
        SimulatedThermometer thermometer(config, clock);
        thermometer.observe({300.0});
        for (double t_s = 0.0; t_s < 5.0 - 1e-9; t_s += step_s) {
            clock.advance(step_s);
            thermometer.observe({400.0});
        }
        EXPECT_NEAR((*thermometer.read())[0].value_K, 400.0 - 100.0 * std::exp(-1.0), 1e-9) << step_s;
    }
}

// Catches dropouts that come as numbers, that all channels share, or at another rate than asked.
TEST(SimulatedThermometer, LosesReadingsAtItsRateAndNeverGivesThemANumber) {
    ManualClock clock;
    SimulatedThermometerConfig config{2, 0.0, 0.0, 0.0, 0.0, 7};
    config.dropout = 0.2;
    SimulatedThermometer thermometer(config, clock);
    thermometer.observe({310.0, 320.0});
    int lost = 0, both = 0;
    constexpr int kReads = 20000;
    for (int i = 0; i < kReads; ++i) {
        const auto readings = *thermometer.read();
        for (std::size_t k = 0; k < 2; ++k) {
            EXPECT_EQ(std::isnan(readings[k].value_K), !readings[k].valid);
            lost += readings[k].valid ? 0 : 1;
        }
        both += !readings[0].valid && !readings[1].valid ? 1 : 0;
    }
    EXPECT_NEAR(lost / (2.0 * kReads), 0.2, 0.01);
    EXPECT_NEAR(both / (1.0 * kReads), 0.04, 0.006);
}

// Catches a command that takes effect at once, a halt that overtakes it, an expiry that comes early.
TEST(SimulatedRobot, ObeysLateAndThenForAsLongAsItWasTold) {
    ManualClock clock;
    SimulatedRobotConfig config = robotConfig();
    config.latency_s = 0.25;
    SimulatedRobot robot(config, clock);
    Vector6d twist = Vector6d::Zero();
    twist[kX] = 0.01;
    const auto pass = [&](int tenths) {
        for (int i = 0; i < tenths; ++i) {
            robot.advance(0.1);
            clock.advance(0.1);
        }
    };
    ASSERT_TRUE(robot.setTwist(twist, 1.0));
    pass(2);
    EXPECT_EQ(robot.coordinates()[kX], 0.0);
    pass(1);
    EXPECT_NEAR(robot.coordinates()[kX], 0.0005, 1e-12);
    pass(30);
    EXPECT_NEAR(robot.coordinates()[kX], 0.01, 1e-12);
    ASSERT_TRUE(robot.setTwist(twist, 10.0));
    pass(10);
    ASSERT_TRUE(robot.halt());
    pass(30);
    EXPECT_NEAR(robot.coordinates()[kX], 0.02, 1e-12); // 0.75 s before the halt was given, 0.25 s after
}

// Catches a pose that is stamped with the time of the reading, noise in the wrong unit, and a lost source
// that still has a pose.
TEST(SimulatedSourceTracker, GivesThePoseOfItsTimeWithItsNoise) {
    ManualClock clock;
    SimulatedTrackerConfig config;
    config.delay_s = 0.5;
    SimulatedSourceTracker exact(config, clock);
    config.noise_m = 0.002;
    config.noise_rad = 0.01;
    SimulatedSourceTracker noisy(config, clock);
    for (int i = 0; i <= 20; ++i) {
        const Pose X_RS(Eigen::Translation3d(0.1 * clock.now_s(), 0.0, 0.0));
        exact.observe(X_RS);
        noisy.observe(X_RS);
        clock.advance(i < 20 ? 0.1 : 0.0);
    }
    const PoseReading reading = *exact.read();
    EXPECT_TRUE(reading.valid);
    EXPECT_NEAR(reading.time_s, 1.5, 1e-9);
    EXPECT_NEAR(reading.X_RS.translation().x(), 0.15, 1e-9);
    double squares_m2 = 0.0, squares_rad2 = 0.0;
    constexpr int kReads = 5000;
    for (int i = 0; i < kReads; ++i) {
        const Pose error = reading.X_RS.inverse() * noisy.read()->X_RS;
        squares_m2 += error.translation().squaredNorm() / kReads;
        squares_rad2 += std::pow(Eigen::AngleAxisd(error.linear()).angle(), 2) / kReads;
    }
    EXPECT_NEAR(std::sqrt(squares_m2 / 3.0), 0.002, 1e-4);
    EXPECT_NEAR(std::sqrt(squares_rad2 / 3.0), 0.01, 5e-4);
    noisy.setLost(true);
    EXPECT_FALSE(noisy.read()->valid);
}

// Catches a time until the source is warm that is not the one that it takes, and one that is told of a source
// that will not get there.
TEST(SimulatedHeatSource, TellsHowLongItTakesToBeWarm) {
    ManualClock clock;
    SimulatedHeatSource source(473.15, kRoom_K, clock);
    EXPECT_EQ(source.heatingTime_s(473.15, 5.0), 0.0);
    source.setHeatedTo(kRoom_K);
    const double told_s = source.heatingTime_s(473.15, 5.0).value();
    double took_s = 0.0;
    for (; source.temperature_K() < 473.15 - 5.0 && took_s < 1000.0; took_s += 0.1) {
        ASSERT_TRUE(source.keepHeating(473.15, 1.0));
        source.advance(0.1);
        clock.advanceTo(clock.now_s() + 0.1);
    }
    EXPECT_NEAR(took_s, told_s, 0.2);
    EXPECT_GT(told_s, 100.0);
    EXPECT_EQ(source.heatingTime_s(473.15, 5.0), 0.0);
    source.setTrouble(SourceTrouble::NotHeating);
    EXPECT_FALSE(source.heatingTime_s(473.15, 5.0).has_value());
}

// Catches a plate that stays as hot as a fault has made it once the fault is gone.
TEST(SimulatedHeatSource, CoolsAfterItHasHeatedUnasked) {
    for (const SourceTrouble trouble : {SourceTrouble::HeatsAlone, SourceTrouble::Overheats}) {
        ManualClock clock;
        SimulatedHeatSource source(473.15, kRoom_K, clock);
        source.advance(10.0);
        EXPECT_EQ(source.temperature_K(), 473.15) << "it waits behind its shutter";
        source.setTrouble(trouble);
        source.advance(10.0);
        const double hot_K = source.temperature_K();
        EXPECT_GT(hot_K, 482.0);
        source.setTrouble(SourceTrouble::None);
        source.advance(SimulatedHeatSource::kCooling_s);
        EXPECT_NEAR(source.temperature_K(), kRoom_K + (hot_K - kRoom_K) * std::exp(-1.0), 1e-9);
    }
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

// Catches a plant that does not see where its source is: a source 4 cm to the right is a robot 4 cm to the
// left.
TEST(SimulatedRig, ASourceMovedIsARobotMovedTheOtherWay) {
    SimulatedRigConfig moved = oneDisk();
    moved.sourcePose[kX] = 0.04;
    SimulatedRigConfig robot = oneDisk();
    robot.robot.start[kX] = -0.04;
    SimulatedRig a(moved), b(robot), c(oneDisk());
    for (SimulatedRig* rig : {&a, &b, &c}) {
        ASSERT_TRUE(rig->heatSource().keepHeating(473.15, 100.0));
        rig->advance(50.0);
    }
    EXPECT_NEAR(a.trueTemperatures_K()[0], b.trueTemperatures_K()[0], 1e-5);
    EXPECT_LT(a.trueTemperatures_K()[0], c.trueTemperatures_K()[0] - 0.2);
}

// Catches a motion that begins with the rig instead of the run, stops in it, or is not begun anew by the
// next.
TEST(SimulatedRig, TheSourceMovesFromWhenTheHeatComesOnAndAnewTheNextTime) {
    SimulatedRigConfig config = oneDisk();
    Vector6d there = Vector6d::Zero();
    there[kY] = 0.1;
    config.sourceMotion = {{0.0, Vector6d::Zero()}, {10.0, Vector6d::Zero()}, {20.0, there}};
    SimulatedRig rig(config);
    const auto place_m = [&rig] { return rig.X_RS().translation().y(); };
    const auto heatFor = [&rig](int seconds) {
        for (int i = 0; i < seconds; ++i) {
            ASSERT_TRUE(rig.heatSource().keepHeating(473.15, 3.0));
            rig.advance(1.0);
        }
    };
    rig.advance(30.0);
    EXPECT_EQ(place_m(), 0.0);
    heatFor(10);
    EXPECT_NEAR(place_m(), 0.0, 1e-12);
    heatFor(5);
    EXPECT_NEAR(place_m(), 0.05, 1e-12);
    EXPECT_NEAR(rig.sourceTracker().read()->X_RS.translation().y(), 0.05, 1e-12);
    ASSERT_TRUE(rig.heatSource().heatOff());
    rig.advance(60.0);
    EXPECT_NEAR(place_m(), 0.05, 1e-12);
    heatFor(15);
    EXPECT_NEAR(place_m(), 0.05, 1e-12);
    heatFor(20);
    EXPECT_NEAR(place_m(), 0.1, 1e-12);
}

TEST(SimulatedRig, WarmsObjectsOnlyWhileTheHeatIsOn) {
    SimulatedRig rig(oneDisk());
    rig.advance(100.0);
    EXPECT_NEAR(rig.trueTemperatures_K()[0], kRoom_K, 1e-6);
    ASSERT_TRUE(rig.heatSource().keepHeating(473.15, 50.0));
    rig.advance(50.0);
    EXPECT_GT(rig.trueTemperatures_K()[0], kRoom_K + 2.0);
}

} // namespace bask
