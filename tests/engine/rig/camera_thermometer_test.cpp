// The thermal camera as the simulated rig's thermometer.

#include "engine/rig/camera_thermometer.h"

#include "engine/base/message_code.h"
#include "engine/base/units.h"
#include "engine/experiment/experiment_file.h"
#include "engine/model/experiment_rig.h"
#include "engine/rig/rig_setup.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

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
                ASSERT_TRUE(readings[i].valid) << describe(readings[i].reason);
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
            ASSERT_TRUE(readings[i].valid) << describe(readings[i].reason);
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
        ASSERT_TRUE(readings[i].valid) << describe(readings[i].reason);
        EXPECT_GT(F[static_cast<Eigen::Index>(i)], 0.08);
        EXPECT_LT(readings[i].standardUncertainty_K, 1.5);
        EXPECT_NEAR(readings[i].value_K, bench.rig.trueTemperatures_K()[i],
                    3.0 * readings[i].standardUncertainty_K);
    }
}

/// Three disks that see one another and take one another's light, over a source that is colder towards its
/// rim, seen from beside and below.
Experiment unevenExperiment() {
    Experiment experiment = cameraExperiment();
    experiment.source.uneven.profile = {{0.0, 1.0, 0.0}, {0.05, 0.9, 0.0}, {0.1, 0.6, 0.0}};
    const std::vector<std::pair<double, Vector6d>> disks{
        {0.02, Vector6d{{0.0, 0.0, 0.02, 0.0, 0.0, 0.0}}},
        {0.02, Vector6d{{0.04, 0.0, 0.0, 0.0, radFromDeg(-20.0), 0.0}}},
        {0.02, Vector6d{{-0.04, 0.0, 0.0, 0.0, radFromDeg(20.0), 0.0}}}};
    for (std::size_t i = 0; i < disks.size(); ++i) {
        ObjectSpec& object = experiment.objects[i];
        object.shape = Disk{disks[i].first};
        object.mounting = disks[i].second;
        object.material.emittance = object.material.absorptance = 0.6;
    }
    experiment.start = Vector6d{{0.0, 0.0, 0.07, 0.0, 0.0, 0.0}};
    experiment.simulation.thermalCamera->pose =
        coordinatesFromPose(lookingAt({0.0, -0.25, 0.015}, {0.0, 0.0, 0.08}));
    return experiment;
}

// Catches an uneven source that is refused, or taken as even (that is wrong by kelvins), and what neighbours
// radiate and reflect left out.
TEST(CameraThermometer, ReadsFacesOverAnUnevenSourceBesideNeighbours) {
    int within = 0, count = 0;
    double evenWorst = 0.0;
    for (std::uint64_t seed = 1; seed <= 4; ++seed) {
        Experiment experiment = unevenExperiment();
        experiment.simulation.seed = seed;
        Experiment even = experiment;
        even.source.uneven = {};
        SimulatedRigConfig config = simulatedRigConfig(experiment);
        config.viewFactorTolerance = 1e-5;
        Bench bench(experiment, config);
        const auto naive = cameraThermometer(even, bench.rig);
        for (const Reading& reading : bench.read())
            ASSERT_TRUE(reading.valid) << describe(reading.reason);
        (void)naive->read();
        bench.heat(60.0);
        (void)bench.read();
        bench.heat(1.0);
        const std::vector<Reading> readings = bench.read(), wrong = naive->read().value();
        const std::vector<double> true_K = bench.rig.trueTemperatures_K();
        for (std::size_t i = 0; i < readings.size(); ++i) {
            ASSERT_TRUE(readings[i].valid && wrong[i].valid) << describe(readings[i].reason);
            const double stated_K = readings[i].standardUncertainty_K;
            EXPECT_LT(stated_K, 2.5);
            EXPECT_LT(std::abs(readings[i].value_K - true_K[i]), 3.5 * stated_K + 0.1) << i;
            within += std::abs(readings[i].value_K - true_K[i]) < 2.0 * stated_K ? 1 : 0;
            ++count;
            evenWorst = std::max(evenWorst, std::abs(wrong[i].value_K - true_K[i]) / stated_K);
        }
    }
    EXPECT_GE(within, 0.85 * count);
    EXPECT_GT(evenWorst, 3.0);
}

// Catches the reflection of a source that is not where the experiment says, computed as if it were.
TEST(CameraThermometer, GoesByWhereATrackedSourceIs) {
    Experiment experiment = unevenExperiment();
    experiment.source.uneven = {};
    experiment.source.tracked = true;
    SimulatedRigConfig config = simulatedRigConfig(experiment);
    config.sourcePose[0] += 0.06;
    Bench bench(experiment, config);
    for (const Reading& reading : bench.read())
        EXPECT_EQ(reading.reason.code, MessageCode::ThermalSourceUneven) << "nobody has seen it";
    bench.thermometer->setSource(poseFromCoordinates(config.sourcePose));
    bench.rig.advance(1.0);
    for (const Reading& reading : bench.read())
        ASSERT_TRUE(reading.valid) << describe(reading.reason);
    bench.heat(90.0);
    const std::vector<Reading> readings = bench.read();
    for (std::size_t i = 0; i < readings.size(); ++i) {
        ASSERT_TRUE(readings[i].valid) << describe(readings[i].reason);
        EXPECT_NEAR(readings[i].value_K, bench.rig.trueTemperatures_K()[i],
                    3.5 * readings[i].standardUncertainty_K);
    }
    bench.thermometer->setSource({});
    bench.heat(2.0);
    for (const Reading& reading : bench.read())
        EXPECT_FALSE(reading.valid);
}

// Catches a camera of another band or accuracy read as any other.
TEST(CameraThermometer, GoesByTheCamerasOwnBandAndUncertainty) {
    const Experiment experiment = unevenExperiment();
    SimulatedRigConfig config = simulatedRigConfig(experiment);
    config.viewFactorTolerance = 1e-5;
    const auto stated_K = [&] {
        Bench bench(experiment, config);
        (void)bench.read();
        bench.heat(60.0);
        const std::vector<Reading> readings = bench.read();
        for (std::size_t i = 0; i < readings.size(); ++i) {
            EXPECT_TRUE(readings[i].valid) << describe(readings[i].reason);
            EXPECT_NEAR(readings[i].value_K, bench.rig.trueTemperatures_K()[i],
                        3.5 * readings[i].standardUncertainty_K);
        }
        return readings[0].standardUncertainty_K;
    };
    const double usual_K = stated_K();
    config.thermalCamera->profile.uncertainty.gain = 0.05;
    EXPECT_GT(stated_K(), 1.3 * usual_K);
    config.thermalCamera->profile.uncertainty = {};
    config.thermalCamera->profile.response = {{6e-6, 0.3}, {8e-6, 1.0}, {10e-6, 0.2}};
    (void)stated_K();
}

// Catches a drift that is counted from half a period, however long ago the shutter closed.
TEST(CameraThermometer, CountsTheDriftFromTheLastShutterEvent) {
    const Experiment experiment = cameraExperiment();
    SimulatedRigConfig config = simulatedRigConfig(experiment);
    config.thermalCamera->profile.uncertainty.drift_K_min = 1.0;
    const auto stated_K = [&](double until_s) {
        Bench bench(experiment, config);
        (void)bench.read();
        bench.heat(until_s);
        return bench.read().front().standardUncertainty_K;
    };
    EXPECT_NEAR(stated_K(181.5), 0.0, 1.0);
    EXPECT_GT(stated_K(178.0), 2.5); // three minutes
    config.thermalCamera->errors.shutterPeriod_s = 0.0;
    EXPECT_GT(stated_K(60.0), 2.9) << "nobody knows when";
}

// Catches a simulated camera that drifts otherwise than its profile says.
TEST(CameraThermometer, ItsSimulatedCameraErrsAsItsProfileStates) {
    Experiment experiment = cameraExperiment();
    experiment.simulation.thermalCamera->gain.reset();
    const auto config = *simulatedRigConfig(experiment).thermalCamera;
    EXPECT_EQ(config.errors.gain, config.profile.uncertainty.gain);
    EXPECT_EQ(config.errors.drift_K_min, config.profile.uncertainty.drift_K_min);
    EXPECT_NEAR(std::hypot(config.errors.shutterOffset_K, config.errors.shutterOffset_K),
                config.profile.uncertainty.offset_K, 1e-12)
        << "of a reading and of its zero";
    experiment.simulation.thermalCamera->gain = 0.03;
    EXPECT_EQ(simulatedRigConfig(experiment).thermalCamera->errors.gain, 0.03);
}

TEST(CameraThermometer, ShowsHowLongAgoItsShutterWasAndWhatItDriftsBy) {
    Bench bench(cameraExperiment());
    bench.heat(230.5);
    (void)bench.read();
    const auto view = bench.thermometer->view();
    ASSERT_TRUE(view->sinceShutter_s);
    EXPECT_NEAR(*view->sinceShutter_s, 50.0, 1.0);
    EXPECT_NEAR(view->drift_K, 0.05 * *view->sinceShutter_s / 60.0, 1e-9);
    EXPECT_NEAR(*bench.thermometer->shutter_s(), 180.5, 1e-6);
}

/// A camera whose bytes are damaged before they are decoded; where that fails the last frame stays, as of a
/// live camera.
class DamagedCamera final : public ThermalCamera {
public:
    explicit DamagedCamera(ThermalCamera& camera) : m_camera(camera) {}
    Result<std::shared_ptr<const ThermalCameraFrame>> newest() override {
        const auto frame = m_camera.newest();
        if (!frame || (*frame)->number == m_number)
            return m_frame;
        m_number = (*frame)->number;
        std::string bytes = bytesOfFrame((*frame)->frame.picture, profile());
        if (damage)
            damage(bytes);
        auto decoded = frameOfBytes(bytes, profile(), "damaged");
        if (decoded)
            m_frame = std::make_shared<ThermalCameraFrame>(
                ThermalCameraFrame{(*frame)->time_s, m_number, std::move(*decoded), {}});
        else
            refusal = decoded.error().code();
        return m_frame;
    }
    const ThermalProfile& profile() const override { return m_camera.profile(); }

    std::function<void(std::string&)> damage;
    MessageCode refusal = MessageCode::None;

private:
    ThermalCamera& m_camera;
    std::uint64_t m_number = 0;
    std::shared_ptr<const ThermalCameraFrame> m_frame;
};

// Catches a number told of pixels that tell nothing, and one of an earlier frame told as if it were of now.
TEST(CameraThermometer, GivesReasonsAndNoNumbersOfDamagedFrames) {
    const Experiment experiment = cameraExperiment();
    Bench bench(experiment);
    DamagedCamera camera(*bench.rig.thermalCamera());
    CameraThermometerSetup setup;
    const PlacedThermalCamera placed = believedThermalCamera(experiment, true).value();
    setup.camera = placed.lens;
    setup.X_RC = placed.X_RC;
    setup.hasShutter = true;
    setup.objects = experiment.objects;
    setup.source = experiment.source.shape;
    setup.geometry = rigGeometry(experiment);
    setup.reflecting = reflectingRig(experiment);
    CameraThermometer thermometer(setup, camera, bench.rig.robot(), bench.rig.heatSource(),
                                  bench.rig.clock());
    bench.rig.advance(1.0);
    ASSERT_TRUE(thermometer.read().value()[0].valid);
    const std::vector<int> pixels = thermometer.view()->objects[0].pixels;
    ASSERT_GT(pixels.size(), 10U);
    const std::size_t skipped = 2 * static_cast<std::size_t>(camera.profile().width) *
                                static_cast<std::size_t>(camera.profile().skipTop);
    const auto put = [&](std::string& bytes, std::size_t pixel, unsigned number) {
        bytes.at(skipped + 2 * pixel) = static_cast<char>(number & 0xffU);
        bytes.at(skipped + 2 * pixel + 1) = static_cast<char>(number >> 8U);
    };
    const auto readAfter_s = [&](double time_s) {
        std::vector<Reading> readings;
        for (double t_s = 0.0; t_s < time_s - 1e-9; t_s += 0.5) {
            bench.heat(0.5);
            readings = thermometer.read().value();
        }
        return readings;
    };
    const std::size_t one = static_cast<std::size_t>(pixels[pixels.size() / 2]);
    for (const unsigned number : {0xffffU, 0U}) { // saturated, and colder than it can tell
        camera.damage = [&](std::string& bytes) { put(bytes, one, number); };
        const auto readings = readAfter_s(1.0);
        EXPECT_FALSE(readings[0].valid);
        EXPECT_EQ(readings[0].reason.code, MessageCode::ThermalPixelsSaturated);
        EXPECT_TRUE(readings[1].valid) << "the pixel is of another one";
    }
    const std::function<void(std::string&)> refused[]{
        [](std::string& bytes) { bytes.pop_back(); }, [](std::string& bytes) { bytes += bytes; },
        [](std::string& bytes) { bytes.assign(bytes.size(), 'u'); }}; // of a closed shutter
    for (const auto& damage : refused) {
        camera.damage = nullptr;
        ASSERT_TRUE(readAfter_s(1.0)[0].valid);
        camera.damage = damage;
        camera.refusal = MessageCode::None;
        for (const Reading& reading : readAfter_s(3.0)) {
            EXPECT_FALSE(reading.valid);
            EXPECT_EQ(reading.reason.code, MessageCode::ThermalFrameOld);
        }
        EXPECT_NE(camera.refusal, MessageCode::None);
    }
    camera.damage = nullptr;
    for (const Reading& reading : readAfter_s(1.0))
        EXPECT_TRUE(reading.valid) << describe(reading.reason);
}

// Catches an emittance's own uncertainty that the reading's does not have.
TEST(CameraThermometer, StatesWhatTheMaterialsEmittanceIsKnownTo) {
    Experiment experiment = cameraExperiment();
    const auto stated_K = [&experiment] {
        Bench bench(experiment);
        (void)bench.read();
        bench.heat(120.0);
        return bench.read().front().standardUncertainty_K;
    };
    const double usual_K = stated_K();
    experiment.objects[0].material.uncertainties["emittance"] = 0.01;
    EXPECT_DOUBLE_EQ(stated_K(), usual_K);
    experiment.objects[0].material.uncertainties["emittance"] = 0.1;
    EXPECT_GT(stated_K(), 1.1 * usual_K);
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
    EXPECT_EQ(readings[0].reason.code, MessageCode::ThermalFaceHidden);
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
        const std::vector<Reading> readings = bench.read();
        for (std::size_t i = 0; i < readings.size(); ++i)
            EXPECT_TRUE(readings[i].valid)
                << "corner " << corner << ", object " << i << ": " << describe(readings[i].reason);
    }
}

TEST(CameraThermometer, GivesNoNumberOfAnObjectThatItDoesNotSee) {
    Experiment experiment = cameraExperiment();
    // Looks past the rig.
    experiment.simulation.thermalCamera->pose = Vector6d{{0.0, 0.0, 1.0, 0.0, 0.0, 0.0}};
    Bench bench(experiment);
    for (const Reading& reading : bench.read()) {
        EXPECT_FALSE(reading.valid);
        EXPECT_EQ(reading.reason.code, MessageCode::ThermalFaceOutside);
    }
}

// Catches a zero that takes a warm board for the cold objects behind it: all later readings were too low.
TEST(CameraThermometer, ReadsNothingBehindACalibrationBoard) {
    Bench bench(cameraExperiment());
    for (const Reading& reading : bench.read())
        ASSERT_TRUE(reading.valid);
    SimulatedThermalCamera& camera = *bench.rig.simulatedThermalCamera();
    camera.setBoard(parseBoard("chessboard:9x6:0.025").value());
    bench.thermometer->setBoardShown(true);
    const auto advance = [&](double time_s) {
        for (double t_s = 0.0; t_s < time_s; t_s += 0.5) {
            bench.rig.advance(0.5);
            (void)bench.read();
        }
    };
    advance(30.0);
    for (const Reading& reading : bench.read()) {
        EXPECT_FALSE(reading.valid);
        EXPECT_EQ(reading.reason.code, MessageCode::ThermalFaceHidden);
    }
    bench.thermometer->setBoardShown(false); // the person is slower
    advance(5.0);
    camera.setBoard({});
    advance(10.0);
    for (const Reading& reading : bench.read()) {
        ASSERT_TRUE(reading.valid) << describe(reading.reason);
        EXPECT_NEAR(reading.value_K, 298.15, 0.3);
    }
}

TEST(CameraThermometer, GoesByWhatIsBelievedOfItsPlace) {
    Experiment experiment = cameraExperiment();
    ThermalCalibration believed;
    believed.pose = Vector6d{{0.0, 0.0, 1.0, 0.0, 0.0, 0.0}}; // looks past the rig
    calibrateThermalCamera(experiment, believed);
    Bench bench(experiment);
    for (const Reading& reading : bench.read())
        EXPECT_EQ(reading.reason.code, MessageCode::ThermalFaceOutside);
}

// Catches a measured place that is believed as if it were exact: pixels at the rim may show the source.
TEST(CameraThermometer, ReadsFewerPixelsTheLessItsPlaceIsKnown) {
    Experiment experiment = cameraExperiment();
    Bench exact(experiment);
    ASSERT_TRUE(exact.read()[0].valid);
    ThermalCalibration believed;
    believed.pose = coordinatesFromPose(trueThermalPose(experiment));
    believed.poseUncertainty_m = 0.001;
    calibrateThermalCamera(experiment, believed);
    Bench measured(experiment);
    ASSERT_TRUE(measured.read()[0].valid);
    EXPECT_EQ(exact.thermometer->sample(0).pixels, 16.0);   // of a circle of 3.72 px, less a rim of 1.5 px
    EXPECT_EQ(measured.thermometer->sample(0).pixels, 8.0); // and of twice 0.25 px more
    believed.poseUncertainty_m = 0.02;
    calibrateThermalCamera(experiment, believed);
    Bench unsure(experiment);
    for (const Reading& reading : unsure.read()) {
        EXPECT_FALSE(reading.valid);
        EXPECT_EQ(reading.reason.code, MessageCode::ThermalPlaceVague);
    }
}

// Catches a place that somebody typed, believed as if it were measured; objects that are large enough are
// read.
TEST(CameraThermometer, ReadsOnlyLargeObjectsFromAPlaceThatWasTyped) {
    Experiment experiment = cameraExperiment();
    experiment.objects[0].shape = Disk{0.05};
    ThermalCalibration believed;
    believed.pose = coordinatesFromPose(trueThermalPose(experiment));
    calibrateThermalCamera(experiment, believed);
    const SightUncertainty sight = believedThermalCamera(experiment, true)->sight;
    EXPECT_NEAR(sight.across_m, 0.005, 1e-12);
    EXPECT_NEAR(sight.angle_rad, 0.01745, 1e-5);
    Bench bench(experiment);
    const std::vector<Reading> readings = bench.read();
    EXPECT_TRUE(readings[0].valid) << describe(readings[0].reason);
    EXPECT_EQ(readings[1].reason.code, MessageCode::ThermalPlaceVague);
    EXPECT_EQ(readings[2].reason.code, MessageCode::ThermalPlaceVague);
    experiment.simulation.thermalCamera->calibration = {};
    EXPECT_EQ(believedThermalCamera(experiment, true)->sight.across_m, 0.0) << "known as it is";
}

TEST(CameraThermometer, GivesNoNumberBeforeItIsZeroed) {
    Bench bench(cameraExperiment());
    for (int k = 0; k < 40; ++k) { // heated before the first picture was looked at
        ASSERT_TRUE(bench.rig.heatSource().keepHeating(473.15, 10.0));
        bench.rig.advance(0.5);
    }
    for (const Reading& reading : bench.read()) {
        EXPECT_FALSE(reading.valid);
        EXPECT_EQ(reading.reason.code, MessageCode::ThermalNotZeroed);
    }
}

// Catches a camera that is zeroed on an object that is warm although nothing was heated yet: all later
// readings of it were too low.
TEST(CameraThermometer, IsNotZeroedOnAWarmObjectAmongColdOnes) {
    const Experiment experiment = cameraExperiment();
    Bench bench(experiment);
    bench.rig.setHot(1, true);
    bench.rig.advance(3.0);
    bench.rig.setHot(1, false);
    const std::vector<Reading> readings = bench.read();
    EXPECT_TRUE(readings[0].valid);
    EXPECT_FALSE(readings[1].valid);
    EXPECT_EQ(readings[1].reason.code, MessageCode::ThermalNotZeroed);
    EXPECT_TRUE(readings[2].valid);
}

TEST(CameraThermometer, ShowsWhatItReads) {
    const Experiment experiment = cameraExperiment();
    Bench bench(experiment);
    const std::vector<Reading> readings = bench.read();
    const auto view = bench.thermometer->view();
    ASSERT_TRUE(view->picture);
    EXPECT_EQ(view->picture->width, 256);
    EXPECT_NEAR(view->age_s, 0.1, 0.15);
    EXPECT_EQ(view->problem.code, MessageCode::None);
    ASSERT_EQ(view->objects.size(), 3U);
    for (std::size_t i = 0; i < 3; ++i) {
        const ThermalObjectView& object = view->objects[i];
        EXPECT_EQ(object.T_K, readings[i].value_K);
        EXPECT_EQ(object.uncertainty_K, readings[i].standardUncertainty_K);
        EXPECT_EQ(static_cast<double>(object.pixels.size()), bench.thermometer->sample(i).pixels);
        Eigen::AlignedBox2d outline;
        for (const Eigen::Vector2d& point : object.outline_px)
            outline.extend(point);
        for (const int pixel : object.pixels)
            EXPECT_TRUE(outline.contains(Eigen::Vector2d(pixel % 256, pixel / 256)));
    }
    bench.rig.simulatedThermalCamera()->setUnplugged(true);
    bench.rig.advance(3.0);
    const auto lost = bench.thermometer->view();
    EXPECT_NE(lost->problem.code, MessageCode::None);
    EXPECT_EQ(lost->picture, view->picture); // with its age
    EXPECT_GT(lost->age_s, 2.0);
}

// Catches half an object that is read as if it were a whole one.
TEST(CameraThermometer, TellsThatAnObjectIsPartlyOutside) {
    Experiment experiment = cameraExperiment();
    experiment.objects[0].shape = Disk{0.05};
    experiment.objects[0].mounting[0] = 0.51; // the picture ends at 0.516 m
    Bench bench(experiment);
    ASSERT_TRUE(bench.read()[0].valid) << describe(bench.thermometer->reason(0));
    const auto view = bench.thermometer->view();
    for (std::size_t i = 0; i < 3; ++i) {
        EXPECT_EQ(bench.thermometer->sample(i).isPartlyOutside, i == 0) << i;
        EXPECT_EQ(view->objects[i].isPartlyOutside, i == 0) << i;
    }
}

// Catches frames that are left out without a word.
TEST(CameraThermometer, ShowsWhatItsCameraLeftOut) {
    struct Left final : ThermalCamera {
        explicit Left(ThermalCamera& camera) : m_camera(camera) {}
        Result<std::shared_ptr<const ThermalCameraFrame>> newest() override { return m_camera.newest(); }
        const ThermalProfile& profile() const override { return m_camera.profile(); }
        LeftOutPictures leftOut() const override {
            return {2, Error{MessageCode::ThermalPictureConstant, "b.raw"}};
        }
        ThermalCamera& m_camera;
    };
    const Experiment experiment = cameraExperiment();
    Bench bench(experiment);
    EXPECT_EQ(bench.thermometer->view()->leftOut.count, 0U);
    Left camera(*bench.rig.thermalCamera());
    CameraThermometerSetup setup;
    setup.camera = believedThermalCamera(experiment, true)->lens;
    setup.objects = experiment.objects;
    setup.geometry = rigGeometry(experiment);
    setup.reflecting = reflectingRig(experiment);
    CameraThermometer thermometer(setup, camera, bench.rig.robot(), bench.rig.heatSource(),
                                  bench.rig.clock());
    const auto view = thermometer.view();
    EXPECT_EQ(view->leftOut.count, 2U);
    EXPECT_EQ(view->leftOut.last->where, "b.raw");
}

// Catches the channel of one object taken for another's where a sensor is left out, and a camera asked for
// what it does not read.
TEST(ObjectThermometer, TakesEachObjectFromWhatItIsReadBy) {
    struct Contact final : Thermometer {
        int channels() const override { return 2; }
        Result<std::vector<Reading>> read() override {
            return std::vector<Reading>{{1.0, 301.0, true}, {1.0, 302.0, true}};
        }
    } contact;
    Experiment experiment = cameraExperiment();
    Bench bench(experiment);
    ObjectThermometer thermometer({ReadBy::Both, ReadBy::Camera, ReadBy::Contact}, 298.15, contact,
                                  cameraThermometer(experiment, bench.rig));
    const std::vector<Reading> readings = thermometer.read().value();
    EXPECT_EQ(readings[0].value_K, 301.0);
    EXPECT_NEAR(readings[1].value_K, experiment.environment_K, 0.1);
    EXPECT_GT(readings[1].standardUncertainty_K, 0.0);
    EXPECT_EQ(readings[2].value_K, 302.0);
    EXPECT_NEAR(thermometer.camera().sample(0).T_K, experiment.environment_K, 0.1);

    bench.rig.simulatedThermalCamera()->setUnplugged(true);
    bench.rig.advance(3.0);
    const std::vector<Reading> without = thermometer.read().value();
    EXPECT_EQ(without[0].value_K, 301.0); // the sensors go on telling
    EXPECT_FALSE(without[1].valid);
    EXPECT_EQ(without[1].reason.code, thermometer.cameraProblem().code);
    EXPECT_NE(thermometer.cameraProblem().code, MessageCode::None);
    EXPECT_TRUE(std::isnan(thermometer.camera().sample(0).T_K)); // not the last that it saw
}

// Catches a room that is not the experiment's: sensors and camera differed by it for ever.
TEST(ObjectThermometer, ZeroesTheCameraToTheRoomThatTheSensorsTell) {
    struct Contact final : Thermometer {
        int channels() const override { return 3; }
        Result<std::vector<Reading>> read() override {
            return std::vector<Reading>{{1.0, 295.0, true}, {1.0, 296.0, true}, {1.0, 297.0, true}};
        }
    } contact;
    const Experiment experiment = cameraExperiment();
    Bench bench(experiment);
    ObjectThermometer thermometer(std::vector(3, ReadBy::Both), 298.15, contact,
                                  cameraThermometer(experiment, bench.rig));
    for (int k = 0; k < 10; ++k) {
        ASSERT_TRUE(thermometer.read());
        bench.rig.advance(0.5);
    }
    for (std::size_t i = 0; i < 3; ++i)
        EXPECT_NEAR(thermometer.camera().sample(i).T_K, 296.0, 0.1);
}

TEST(CameraThermometer, TellsNothingOfAFrameThatIsOld) {
    const Experiment experiment = cameraExperiment();
    Bench bench(experiment);
    ASSERT_TRUE(bench.read()[0].valid);
    bench.rig.simulatedThermalCamera()->setUnplugged(true);
    bench.rig.advance(0.5);
    bench.rig.advance(3.0);
    EXPECT_FALSE(bench.thermometer->read());
    EXPECT_TRUE(std::isnan(bench.thermometer->sample(0).T_K));
    EXPECT_NE(bench.thermometer->reason(0).code, MessageCode::None);
}

// Catches zeros that are lost by an edit, and a warm object taken for cold after it.
TEST(CameraThermometer, RemembersItsZerosAndTheHeat) {
    const Experiment experiment = cameraExperiment();
    Bench bench(experiment);
    (void)bench.read();
    bench.heat(30.0);
    (void)bench.read();
    auto other = cameraThermometer(experiment, bench.rig);
    other->use(bench.thermometer->memory());
    EXPECT_FALSE(other->isCold());
    const std::vector<Reading> readings = other->read().value();
    for (std::size_t i = 0; i < 3; ++i) {
        ASSERT_TRUE(readings[i].valid) << describe(readings[i].reason);
        EXPECT_NEAR(readings[i].value_K, bench.rig.trueTemperatures_K()[i],
                    4.0 * readings[i].standardUncertainty_K + 0.1);
    }
}

} // namespace
} // namespace bask
