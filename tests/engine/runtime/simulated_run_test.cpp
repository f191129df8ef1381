// The numbers on the shipped examples, by whole runs on the simulated clock.

#include "engine/base/units.h"
#include "engine/runtime/simulated_run.h"

#include <QTemporaryDir>

#include <gtest/gtest.h>

#include <algorithm>

namespace bask {
namespace {

Experiment example(const char* name) {
    auto experiment = readExperiment(std::string(BASK_EXAMPLES) + "/" + name);
    EXPECT_TRUE(experiment) << (experiment ? "" : describe(experiment.error()));
    return experiment ? *experiment : Experiment();
}

RunOutcome run(const Experiment& experiment, std::optional<double> duration_s = {}) {
    SimulatedRunOptions options;
    options.duration_s = duration_s;
    auto outcome = runSimulated(experiment, options);
    EXPECT_TRUE(outcome) << (outcome ? "" : describe(outcome.error()));
    return outcome ? *outcome : RunOutcome();
}

bool toldOfCompromise(const RunOutcome& outcome) {
    return std::ranges::any_of(outcome.events, [](const TraceEvent& event) {
        return event.message.code == MessageCode::EventCompromise;
    });
}

} // namespace

TEST(Example, SettlesAllThreeInUnder120SecondsFor20SeedsOfWrongBeliefs) {
    Experiment experiment = example("three-objects.json");
    ASSERT_GE(experiment.controller.believedRateErrorFactor, 4.0);
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
        experiment.simulation.seed = seed;
        const RunOutcome outcome = run(experiment);
        EXPECT_TRUE(outcome.settled) << "seed " << seed;
        for (const ObjectOutcome& object : outcome.objects) {
            ASSERT_TRUE(object.settlingTime_s) << object.name << ", seed " << seed;
            EXPECT_LT(*object.settlingTime_s, 120.0) << object.name << ", seed " << seed;
        }
        EXPECT_FALSE(toldOfCompromise(outcome)) << "seed " << seed;
    }
}

// Catches a controller that does not know what velocity the robot has: its commands would jump.
TEST(SimulatedRun, CommandsKeepTheAcceleration) {
    Experiment experiment = example("three-objects.json");
    experiment.controller.kind = ControllerKind::Adaptive;
    experiment.robot.maxAcceleration_m_s2 = 0.004;
    experiment.robot.maxAngularAcceleration_rad_s2 = 0.02;
    experiment.robot.maxRotation_rad_s = 0.05;
    Vector6d last = Vector6d::Zero();
    double most = 0.0, fastest_m_s = 0.0;
    SimulatedRunOptions options;
    options.duration_s = 60.0;
    options.progress = [&](double, const TraceSample& sample) {
        const Vector6d change = sample.twist - last;
        most = std::max({most, change.head<3>().norm() / experiment.robot.maxAcceleration_m_s2,
                         change.tail<3>().norm() / experiment.robot.maxAngularAcceleration_rad_s2});
        fastest_m_s = std::max(fastest_m_s, sample.twist.head<3>().norm());
        last = sample.twist;
    };
    ASSERT_TRUE(runSimulated(experiment, options));
    EXPECT_LT(most, 1.0 + 1e-6);    // in a period of 1 s
    EXPECT_GT(fastest_m_s, 0.0079); // it has gathered speed over several periods
}

TEST(Example, OtherReachableTargetsSettleToo) {
    const struct {
        std::vector<double> targets_degC;
        double within_s; ///< the physical bound of the slowest object, times 1.3
    } cases[] = {{{50, 40, 40}, 169},
                 {{50, 50, 35}, 169},
                 {{60, 60, 30}, 259},
                 {{40, 45, 50}, 94},
                 {{45, 45, 45}, 130}};
    for (const auto& [targets_degC, within_s] : cases) {
        Experiment experiment = example("three-objects.json");
        for (std::size_t i = 0; i < 3; ++i)
            experiment.objects[i].target_K = kelvinFromCelsius(targets_degC[i]);
        const RunOutcome outcome = run(experiment);
        EXPECT_TRUE(outcome.settled) << targets_degC[0] << " " << targets_degC[1] << " " << targets_degC[2];
        for (const ObjectOutcome& object : outcome.objects)
            EXPECT_LT(object.settlingTime_s.value_or(1e9), within_s) << object.name;
    }
}

// Catches a source that is no disk lost on the way to the controller or to the simulated rig.
TEST(Example, OverARectangularPlateBothSettleInUnder180Seconds) {
    Experiment experiment = example("rectangular-plate.json");
    ASSERT_TRUE(std::holds_alternative<Contour>(experiment.source.shape));
    for (std::uint64_t seed = 1; seed <= 5; ++seed) {
        experiment.simulation.seed = seed;
        const RunOutcome outcome = run(experiment);
        EXPECT_TRUE(outcome.settled) << "seed " << seed;
        for (const ObjectOutcome& object : outcome.objects)
            EXPECT_LT(object.settlingTime_s.value_or(1e9), 180.0) << object.name << ", seed " << seed;
    }
}

TEST(Example, InALineItEndsAtTheBestCompromiseAndSaysSo) {
    const RunOutcome outcome = run(example("three-objects-in-line.json"), 900.0);
    EXPECT_FALSE(outcome.settled);
    EXPECT_TRUE(toldOfCompromise(outcome));
    // Least squares over the workspace gives 39.41, 40.97, 39.40 degC (computed from 600 starts); sensor
    // offsets move it a little.
    const double best_degC[] = {39.41, 40.97, 39.40};
    for (std::size_t i = 0; i < 3; ++i)
        EXPECT_NEAR(celsiusFromKelvin(outcome.objects[i].final_K), best_degC[i], 0.4)
            << outcome.objects[i].name;
}

TEST(Example, ThePapersControllersRun) {
    for (const char* name : {"paper-adaptive.json", "paper-model-based.json"}) {
        const RunOutcome outcome = run(example(name), 600.0);
        EXPECT_FALSE(outcome.fault) << name;
        EXPECT_NEAR(outcome.simulated_s, 600.0, 1.0) << name;
    }
}

TEST(SimulatedRun, TheSameSeedGivesTheSameRun) {
    Experiment experiment = example("three-objects.json");
    const RunOutcome first = run(experiment, 60.0);
    const RunOutcome again = run(experiment, 60.0);
    experiment.simulation.seed += 1;
    const RunOutcome other = run(experiment, 60.0);
    for (std::size_t i = 0; i < 3; ++i)
        EXPECT_EQ(first.objects[i].final_K, again.objects[i].final_K);
    EXPECT_NE(first.objects[0].final_K, other.objects[0].final_K);
}

TEST(SimulatedRun, ConvectionIsTakenUpByTheServo) {
    Experiment experiment = example("three-objects.json");
    experiment.source.emittance = 0.9;
    experiment.simulation.convection_W_m2K = 7.0;
    EXPECT_TRUE(run(experiment).settled);
}

TEST(SimulatedRun, PassingThroughTheBandAtTheEndIsNotSettled) {
    Experiment experiment = example("three-objects.json");
    const RunOutcome outcome = run(experiment, 85.0); // all are within the band from about 78 s on
    EXPECT_TRUE(outcome.objects[0].settlingTime_s);
    EXPECT_FALSE(outcome.settled);
}

TEST(SimulatedRun, EndsWhenTheRunIsStoppedByALostSensor) {
    Experiment experiment = example("three-objects.json");
    experiment.source.temperature_K = 2200.0; // objects leave the range that a sensor can plausibly show
    experiment.source.emittance = 1.0;
    for (ObjectSpec& object : experiment.objects)
        object.target_K = kelvinFromCelsius(1300.0);
    const RunOutcome outcome = run(experiment);
    EXPECT_FALSE(outcome.settled);
    EXPECT_LT(outcome.simulated_s, experiment.simulation.durationLimit_s);
}

TEST(SimulatedRun, AnImpossibleStartLeavesAnOlderSessionAlone) {
    const QTemporaryDir folder;
    SimulatedRunOptions options;
    options.sessionPath = folder.filePath("keep.bask").toStdString();
    options.duration_s = 20.0;
    Experiment experiment = example("three-objects.json");
    ASSERT_TRUE(runSimulated(experiment, options));
    experiment.simulation.sensorNoise_K = 1.0; // cannot be zeroed
    const auto refused = runSimulated(experiment, options);
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().code(), MessageCode::ReasonSensorsDisagree);
    const auto kept = readSession(options.sessionPath);
    ASSERT_TRUE(kept);
    EXPECT_GT(kept->samples.size(), 10U);
}

} // namespace bask
