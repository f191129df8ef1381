// The thermal camera as the simulated rig's thermometer.

#include "engine/rig/camera_thermometer.h"

#include "engine/base/message_code.h"
#include "engine/base/units.h"
#include "engine/experiment/experiment_file.h"
#include "engine/model/experiment_rig.h"
#include "engine/rig/rig_setup.h"

#include <gtest/gtest.h>

#include <cmath>

namespace bask {
namespace {

Experiment cameraExperiment() {
    return readExperiment(BASK_EXAMPLES "/thermal-camera.json").value();
}

/// A rig with its heat on, at a pose.
struct Bench {
    explicit Bench(const Experiment& experiment) : Bench(experiment, simulatedRigConfig(experiment)) {}
    Bench(const Experiment& experiment, const SimulatedRigConfig& config)
        : rig(config), thermometer(cameraThermometer(experiment, rig)) {}

    std::vector<Reading> read() { return thermometer->read().value(); }
    void heat(double time_s) {
        for (double t_s = 0.0; t_s < time_s; t_s += 0.5) {
            ASSERT_TRUE(rig.heatSource().keepHeating(473.15, 10.0));
            rig.advance(0.5);
        }
    }

    SimulatedRig rig;
    std::unique_ptr<CameraThermometer> thermometer;
};

TEST(CameraThermometer, OnlyStandsWhereTheExperimentHasAThermalCamera) {
    const Experiment experiment = readExperiment(BASK_EXAMPLES "/three-objects.json").value();
    SimulatedRig rig(simulatedRigConfig(experiment));
    EXPECT_EQ(cameraThermometer(experiment, rig), nullptr);
}

TEST(CameraThermometer, ReadsTheRoomFirstAndThenWarmObjectsWithinWhatItStates) {
    int within = 0, count = 0;
    for (std::uint64_t seed = 1; seed <= 12; ++seed) {
        Experiment experiment = cameraExperiment();
        experiment.simulation.seed = seed;
        Bench bench(experiment);
        for (const Reading& reading : bench.read()) {
            ASSERT_TRUE(reading.valid);
            EXPECT_NEAR(reading.value_K, experiment.environment_K, 0.05);
        }
        for (int part = 0; part < 3; ++part) {
            bench.heat(60.0);
            const std::vector<Reading> readings = bench.read();
            const std::vector<double> true_K = bench.rig.trueTemperatures_K();
            for (std::size_t i = 0; i < readings.size(); ++i) {
                ASSERT_TRUE(readings[i].valid) << describe(bench.thermometer->reason(i));
                EXPECT_GT(readings[i].standardUncertainty_K, 0.0);
                EXPECT_LT(std::abs(readings[i].value_K - true_K[i]),
                          4.0 * readings[i].standardUncertainty_K + 0.1);
                within += std::abs(readings[i].value_K - true_K[i]) < 2.0 * readings[i].standardUncertainty_K
                              ? 1
                              : 0;
                ++count;
            }
        }
        EXPECT_GT(bench.rig.trueTemperatures_K()[0], experiment.environment_K + 8.0);
    }
    EXPECT_GE(within, 0.9 * count);
}

// Catches objects looked for where the robot is now instead of where it was when the frame was taken: they
// are warm, and 3 cm are more than a small one.
TEST(CameraThermometer, KnowsWhereTheObjectsWereWhenTheFrameWasTaken) {
    const Experiment experiment = cameraExperiment();
    SimulatedRigConfig config = simulatedRigConfig(experiment);
    config.thermalCamera->delay_s = 1.5;
    Bench bench(experiment, config);
    (void)bench.read();
    for (std::size_t i = 0; i < 3; ++i)
        bench.rig.setHot(i, true);
    bench.rig.advance(8.0);
    for (std::size_t i = 0; i < 3; ++i)
        bench.rig.setHot(i, false);
    bench.rig.advance(2.0);
    (void)bench.read();
    Vector6d twist = Vector6d::Zero();
    twist[0] = 0.02;
    for (int k = 0; k < 7; ++k) {
        ASSERT_TRUE(bench.rig.robot().setTwist(twist, 2.0));
        bench.rig.advance(1.0);
        const std::vector<Reading> readings = bench.read();
        for (std::size_t i = 0; i < readings.size(); ++i) {
            ASSERT_TRUE(readings[i].valid) << describe(bench.thermometer->reason(i));
            EXPECT_GT(readings[i].value_K, experiment.environment_K + 10.0);
            EXPECT_NEAR(readings[i].value_K, bench.rig.trueTemperatures_K()[i], 1.0); // they cool meanwhile
        }
    }
}

// Catches a reflection left out or computed for another temperature, emittance or view factor: at emittance
// 0.6 it is ten kelvin and more.
TEST(CameraThermometer, TakesTheReflectionOffAFaceThatIsSeenFromBelow) {
    Experiment experiment = cameraExperiment();
    for (ObjectSpec& object : experiment.objects)
        object.material.emittance = object.material.absorptance = 0.6;
    experiment.start[2] = 0.2;
    experiment.simulation.thermalCamera->pose =
        coordinatesFromPose(lookingAt({0.45, 0.0, 0.02}, {0.0, 0.0, 0.2}));
    Bench bench(experiment);
    for (const Reading& reading : bench.read())
        ASSERT_TRUE(reading.valid);
    bench.heat(60.0);
    const std::vector<Reading> readings = bench.read();
    const Eigen::VectorXd F = rigGeometry(experiment)->viewFactors(experiment.start).F;
    for (std::size_t i = 0; i < readings.size(); ++i) {
        ASSERT_TRUE(readings[i].valid) << describe(bench.thermometer->reason(i));
        EXPECT_GT(F[static_cast<Eigen::Index>(i)], 0.08);
        EXPECT_LT(readings[i].standardUncertainty_K, 1.5);
        EXPECT_NEAR(readings[i].value_K, bench.rig.trueTemperatures_K()[i],
                    3.0 * readings[i].standardUncertainty_K);
    }
}

TEST(CameraThermometer, DoesNotReadWhatStandsBeforeAnObject) {
    Experiment experiment = cameraExperiment();
    PlateSpec plate;
    plate.name = "plate";
    plate.shape = Disk{0.02};
    plate.pose[1] = 0.05; // over the circle
    plate.pose[2] = 0.05;
    experiment.fixtures.push_back(plate);
    Bench bench(experiment);
    const std::vector<Reading> readings = bench.read();
    EXPECT_FALSE(readings[0].valid);
    EXPECT_EQ(bench.thermometer->reason(0).code, MessageCode::ThermalFaceHidden);
    EXPECT_TRUE(readings[1].valid); // one that is not seen takes nothing from the others
    EXPECT_TRUE(readings[2].valid);
}

TEST(CameraThermometer, NeedsFramesOftenEnough) {
    Experiment experiment = cameraExperiment();
    experiment.sampling.period_s = 0.1;
    const auto valid = validate(experiment);
    ASSERT_FALSE(valid);
    EXPECT_EQ(valid.error().where, "sampling.period_s");
    experiment.sampling.period_s = 1.0;
    experiment.simulation.thermalCamera->profile = "nobody's";
    ASSERT_FALSE(validate(experiment));
    EXPECT_EQ(validate(experiment).error().where, "simulation.thermal_camera.profile");
}

TEST(CameraThermometer, SeesAllObjectsFromEveryCornerOfTheWorkspace) {
    Experiment experiment = cameraExperiment();
    for (int corner = 0; corner < 16; ++corner) {
        int bit = 1;
        for (const int c : {0, 1, 2, 3}) {
            experiment.start[c] = (corner & bit) != 0 ? experiment.robot.upper[c] : experiment.robot.lower[c];
            bit *= 2;
        }
        experiment.start[2] = std::max(experiment.start[2], 0.08); // with the tilt above the clearance
        Bench bench(experiment);
        for (std::size_t i = 0; i < bench.read().size(); ++i)
            EXPECT_TRUE(bench.read()[i].valid)
                << "corner " << corner << ", object " << i << ": " << describe(bench.thermometer->reason(i));
    }
}

TEST(CameraThermometer, GivesNoNumberOfAnObjectThatItDoesNotSee) {
    Experiment experiment = cameraExperiment();
    // Looks past the rig.
    experiment.simulation.thermalCamera->pose = Vector6d{{0.0, 0.0, 1.0, 0.0, 0.0, 0.0}};
    Bench bench(experiment);
    for (const Reading& reading : bench.read())
        EXPECT_FALSE(reading.valid);
    EXPECT_EQ(bench.thermometer->reason(0).code, MessageCode::ThermalFaceOutside);
}

TEST(CameraThermometer, GivesNoNumberBeforeItIsZeroed) {
    Bench bench(cameraExperiment());
    for (int k = 0; k < 40; ++k) { // heated before the first picture was looked at
        ASSERT_TRUE(bench.rig.heatSource().keepHeating(473.15, 10.0));
        bench.rig.advance(0.5);
    }
    for (const Reading& reading : bench.read())
        EXPECT_FALSE(reading.valid);
}

} // namespace
} // namespace bask
