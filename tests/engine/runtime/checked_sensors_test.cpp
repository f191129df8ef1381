// Runs on the simulated rig whose sensors are checked by a thermal camera: what is told of sensors that are
// wrong, and that nothing is told of good ones.

#include "engine/base/message_code.h"
#include "engine/experiment/experiment_file.h"
#include "engine/model/experiment_rig.h"
#include "engine/rig/rig_setup.h"
#include "engine/runtime/fault_script.h"
#include "engine/runtime/servo_loop.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <random>

namespace bask {
namespace {

/// Three objects with sensors that lag by up to 5 s and are off by up to 1 K, and with emittances that the
/// camera knows within +-0.02.
Experiment checkedExperiment(unsigned seed) {
    Experiment experiment = readExperiment(BASK_EXAMPLES "/thermal-camera.json").value();
    std::mt19937_64 random(seed);
    std::normal_distribution<double> normal;
    std::uniform_real_distribution<double> share;
    experiment.simulation.seed = seed;
    experiment.simulation.sensorLag_s = 5.0 * share(random);
    experiment.simulation.sensorOffset_K = 1.0;
    for (ObjectSpec& object : experiment.objects) {
        object.readBy = ReadBy::Both;
        object.target_K += 15.0 * (share(random) - 0.3);
        Material& truth = object.simulatedMaterial.emplace(object.material);
        truth.emittance += std::clamp(0.01 * normal(random), -0.02, 0.02);
    }
    return experiment;
}

struct CheckedRun {
    explicit CheckedRun(const Experiment& experiment)
        : period_s(experiment.sampling.period_s), rig(simulatedRigConfig(experiment)),
          thermometer(objectThermometer(experiment, rig)), loop(experiment,
                                                                {rig.robot(),
                                                                 *thermometer,
                                                                 rig.heatSource(),
                                                                 {},
                                                                 &rig.sourceTracker(),
                                                                 false,
                                                                 thermometer.get()},
                                                                rig.clock()) {
        for (int k = 0; k < 60 && loop.state() != RunState::Ready; ++k)
            period();
        begun = loop.arm();
        if (begun)
            begun = loop.start(true);
    }
    void period() {
        rig.advance(period_s);
        loop.tick();
        for (const TraceEvent& event : loop.takeRecord().events)
            events.push_back(event.message);
    }
    void run(double for_s) {
        for (double t_s = 0.0; t_s < for_s; t_s += period_s)
            period();
    }
    /// Returns after how long one of these alarms is there, s.
    double until(MessageCode code, double max_s) { return until({code}, max_s); }
    double until(std::initializer_list<MessageCode> codes, double max_s) {
        for (double t_s = 0.0; t_s < max_s; t_s += period_s) {
            period();
            if (std::ranges::any_of(loop.alarmConditions(), [&](const AlarmCondition& condition) {
                    return std::ranges::find(codes, condition.message.code) != codes.end();
                }))
                return t_s + period_s;
        }
        return 1e9;
    }

    double period_s;
    SimulatedRig rig;
    std::unique_ptr<ObjectThermometer> thermometer;
    ServoLoop loop;
    Result<void> begun;
    std::vector<Message> events;
};

} // namespace

// A part of the 200 healthy runs; all of them are in no test, for they take ten minutes.
TEST(CheckedSensors, NothingIsSaidOfGoodOnes) {
    for (unsigned seed = 1; seed <= 3; ++seed) {
        CheckedRun run(checkedExperiment(seed));
        ASSERT_TRUE(run.begun) << describe(run.begun.error());
        run.run(200.0);
        EXPECT_TRUE(run.loop.alarmConditions().empty())
            << seed << ": " << describe(run.loop.alarmConditions().front().message);
        EXPECT_TRUE(run.loop.state() == RunState::Running || run.loop.state() == RunState::Settled) << seed;
    }
}

TEST(CheckedSensors, OneThatComesOffEndsTheHeatWithinTenSeconds) {
    CheckedRun run(checkedExperiment(2));
    ASSERT_TRUE(run.begun);
    run.run(80.0);
    run.rig.simulatedThermometer().setOffLag(20.0);
    setFault(run.rig, SimulatedFault::SensorOff, 0, true);
    EXPECT_LE(run.until(MessageCode::SafetySensorNotOnObject, 60.0), 10.0);
    EXPECT_FALSE(run.loop.heat().isOn());
    EXPECT_EQ(run.loop.sensorTrust(0), SensorTrust::Distrusted);
    EXPECT_EQ(run.loop.sensorTrust(1), SensorTrust::Trusted);
}

TEST(CheckedSensors, TwoThatAreSwappedAreBothDoubted) {
    CheckedRun run(checkedExperiment(2));
    ASSERT_TRUE(run.begun);
    run.run(90.0);
    setFault(run.rig, SimulatedFault::SensorsSwapped, 0, true);
    EXPECT_LE(run.until({MessageCode::SafetySensorsSwapped, MessageCode::SafetySensorsSeenSwapped}, 60.0),
              10.0);
    EXPECT_FALSE(run.loop.heat().isOn());
    EXPECT_EQ(run.loop.sensorTrust(0), SensorTrust::Distrusted);
    EXPECT_EQ(run.loop.sensorTrust(1), SensorTrust::Distrusted);
    EXPECT_EQ(run.loop.sensorTrust(2), SensorTrust::Trusted);
}

// Catches: sensors of objects so near one another that only their changes tell them apart, which took 11 s.
TEST(CheckedSensors, TwoThatAreSwappedAreToldSoonWhereTheirObjectsAreNearlyAsWarm) {
    CheckedRun run(checkedExperiment(2));
    ASSERT_TRUE(run.begun);
    run.run(80.0);
    setFault(run.rig, SimulatedFault::SensorsSwapped, 0, true);
    EXPECT_LE(run.until(MessageCode::SafetySensorsSeenSwapped, 60.0), 6.0);
    EXPECT_FALSE(run.loop.heat().isOn());
    EXPECT_EQ(run.loop.sensorTrust(0), SensorTrust::Distrusted);
    EXPECT_EQ(run.loop.sensorTrust(1), SensorTrust::Distrusted);
    EXPECT_EQ(run.loop.sensorTrust(2), SensorTrust::Trusted);
}

// Catches: a record that does not say when the camera's drift began anew.
TEST(CheckedSensors, EachLookOfTheCameraAtItsShutterIsAnEvent) {
    CheckedRun run(checkedExperiment(1));
    ASSERT_TRUE(run.begun);
    run.run(400.0);
    EXPECT_EQ(std::ranges::count(run.events, MessageCode::EventShutter, &Message::code), 2);
}

// The run goes on: its sensors are right.
TEST(CheckedSensors, AWrongEmittanceIsToldWithTheRightOne) {
    Experiment experiment = checkedExperiment(1);
    experiment.objects[1].simulatedMaterial->emittance = 0.65;
    CheckedRun run(experiment);
    ASSERT_TRUE(run.begun);
    EXPECT_LT(run.until(MessageCode::SafetyEmittanceOther, 120.0), 120.0);
    const auto conditions = run.loop.alarmConditions();
    const auto told = std::ranges::find(conditions, MessageCode::SafetyEmittanceOther,
                                        [](const AlarmCondition& c) { return c.message.code; });
    ASSERT_NE(told, conditions.end());
    EXPECT_EQ(told->message.args[0].text(), "bunny");
    EXPECT_NEAR(std::stod(told->message.args[4].text()), 0.65, 0.1);
    EXPECT_TRUE(run.loop.heat().isOn());
}

// A second opinion that is lost is told and ends nothing; a camera that alone reads an object does.
TEST(CheckedSensors, ALostCameraIsTold) {
    CheckedRun run(checkedExperiment(3));
    ASSERT_TRUE(run.begun);
    run.run(10.0);
    setFault(run.rig, SimulatedFault::CameraLost, 0, true);
    EXPECT_LE(run.until(MessageCode::CameraLost, 30.0), 15.0);
    run.run(80.0); // while the objects warm up: what the camera saw last is no opinion
    EXPECT_TRUE(run.loop.state() == RunState::Running || run.loop.state() == RunState::Settled);
    EXPECT_TRUE(run.loop.heat().isOn());

    Experiment alone = checkedExperiment(3);
    alone.objects[2].readBy = ReadBy::Camera;
    CheckedRun byCamera(alone);
    ASSERT_TRUE(byCamera.begun);
    byCamera.run(10.0);
    setFault(byCamera.rig, SimulatedFault::CameraLost, 0, true);
    byCamera.run(6.0);
    EXPECT_EQ(byCamera.loop.state(), RunState::Holding);
}

} // namespace bask
