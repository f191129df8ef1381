// When the run that would be started now is predicted, and from where.

#include "app/document.h"
#include "app/run_forecast.h"
#include "engine/base/units.h"
#include "engine/model/trace.h"
#include "tests/support/wait_for.h"

#include <gtest/gtest.h>

#include <cmath>

namespace bask::test {
namespace {

struct RunForecastTest : testing::Test {
    RunForecast forecast;
    Experiment experiment = Document::blank();
    int changes = 0;

    RunForecastTest() {
        QObject::connect(&forecast, &RunForecast::changed, [this] { ++changes; });
        forecast.setLongest_ms(100'000);
        aimAt(45.0);
    }
    void aimAt(double target_degC) {
        EXPECT_TRUE(bask::setTargets(experiment, {kelvinFromCelsius(target_degC)}));
        forecast.setExperiment(experiment);
    }
    /// The rig at the start, as cold as the room.
    Snapshot ready() const {
        Snapshot snapshot;
        snapshot.state = RunState::Ready;
        snapshot.place = PlaceState::Sure;
        snapshot.latest.coordinates = experiment.start;
        snapshot.source_K = experiment.source.temperature_K;
        for (const ObjectSpec& object : experiment.objects) {
            snapshot.objects.push_back(object.name);
            snapshot.toldReadings_K.push_back(experiment.environment_K + 0.1);
        }
        return snapshot;
    }
    bool isPredicted() const { return !forecast.predicted().samples.empty(); }
    /// Tells the rig again and again, as the engine does, until it has been answered.
    bool predictsFor(const Snapshot& snapshot) {
        return waitFor([&] {
            forecast.apply(snapshot, true);
            return isPredicted();
        });
    }
    /// Whether another prediction is waited for. What is being computed may be the spread of this one.
    bool isAsked() const { return forecast.isPending() && !forecast.isComputing(); }
    bool isSpread() const { return isPredicted() && !forecast.predicted().samples.front().lowest_K.empty(); }
    /// Whether the rig, told so, makes it drop a prediction or compute one.
    bool isMovedBy(const Snapshot& snapshot, bool isWatched = true) {
        const int before = changes;
        forecast.apply(snapshot, isWatched);
        return changes > before || isAsked();
    }
};

// Catches a prediction from elsewhere, to elsewhere, or one that is computed again and again.
TEST_F(RunForecastTest, IsMadeOnceForWhatWouldBeStarted) {
    ASSERT_TRUE(predictsFor(ready()));
    const PredictedRun run = forecast.predicted();
    EXPECT_LT((run.samples.front().coordinates - experiment.start).norm(), 2e-3);
    EXPECT_NEAR(run.samples.front().temperatures_K.at(0), experiment.environment_K, 0.5);
    EXPECT_NEAR(run.samples.back().temperatures_K.at(0), kelvinFromCelsius(45.0), kSettledBand_K);
    EXPECT_TRUE(run.settling_s);
    Snapshot noisy = ready();
    noisy.toldReadings_K[0] += 0.5;
    noisy.latest.coordinates[kX] += 2e-4;
    EXPECT_FALSE(isMovedBy(noisy));
    EXPECT_EQ(changes, 1);
}

// Catches a prediction that knows what only the simulated rig does: the run would not deviate from it.
TEST_F(RunForecastTest, KnowsNoMoreThanTheExperimentAssumes) {
    ASSERT_TRUE(predictsFor(ready()));
    const double assumed_s = forecast.predicted().settling_s.value();
    experiment.objects[0].simulatedMaterial = experiment.objects[0].material;
    experiment.objects[0].simulatedMaterial->absorptance *= 0.5;
    experiment.simulation.sourceEmittance = 0.5 * experiment.source.emittance;
    forecast.setExperiment(experiment);
    ASSERT_TRUE(predictsFor(ready()));
    EXPECT_EQ(forecast.predicted().settling_s, assumed_s);
}

// Catches work that nobody sees, in a run, or for a rig that is not known.
TEST_F(RunForecastTest, IsNotMadeUnlessItIsOfUse) {
    EXPECT_FALSE(isMovedBy(ready(), false));
    Snapshot other = ready();
    other.state = RunState::Running;
    EXPECT_FALSE(isMovedBy(other));
    other = ready();
    other.place = PlaceState::Unknown;
    EXPECT_FALSE(isMovedBy(other));
    other = ready();
    other.objects.emplace_back("one more");
    EXPECT_FALSE(isMovedBy(other)) << "the engine has another experiment yet";
    other = ready();
    other.place = PlaceState::Unsure;
    EXPECT_FALSE(isMovedBy(other));
    other = ready();
    other.toldReadings_K[0] = std::nan("");
    EXPECT_FALSE(isMovedBy(other));
    other = ready();
    other.latest.coordinates[kX] = experiment.robot.upper[kX] + 0.05;
    EXPECT_FALSE(isMovedBy(other)) << "no run begins there";
    EXPECT_TRUE(isMovedBy(ready()));
    EXPECT_FALSE(isMovedBy(ready(), false)) << "nobody looks any more";
}

// Catches a run without a prediction that cannot say why.
TEST_F(RunForecastTest, SaysWhyThereIsNone) {
    using enum RunForecast::Missing;
    forecast.apply(ready(), false);
    EXPECT_EQ(forecast.missing(), NotSeen);
    forecast.apply(ready(), true);
    EXPECT_EQ(forecast.missing(), NotFinished);
    forecast.apply(ready(), false); // the page was left
    EXPECT_EQ(forecast.missing(), NotSeen);
    Snapshot unknown = ready();
    unknown.place = PlaceState::Unknown;
    forecast.apply(unknown, true);
    EXPECT_EQ(forecast.missing(), NotKnown);
    ASSERT_TRUE(predictsFor(ready()));
    EXPECT_EQ(forecast.missing(), Nothing);
}

// Catches a prediction that goes, or is made anew, while its run is on or looked at; and one that stays when
// the next run would begin elsewhere.
TEST_F(RunForecastTest, StaysFromStartUntilTheNextRun) {
    ASSERT_TRUE(predictsFor(ready()));
    Snapshot run = ready();
    run.state = RunState::Running;
    EXPECT_FALSE(isMovedBy(run));
    run.runTime_s = 90.0;
    run.latest.coordinates[kZ] -= 0.03;
    run.toldReadings_K[0] = kelvinFromCelsius(44.0);
    EXPECT_FALSE(isMovedBy(run));
    run.state = RunState::Stopped;
    EXPECT_FALSE(isMovedBy(run));
    run.state = RunState::Armed;
    run.runTime_s = 0.0;
    forecast.apply(run, true);
    EXPECT_FALSE(isPredicted()) << "it was of the run before";
    ASSERT_TRUE(predictsFor(run));
    EXPECT_LT((forecast.predicted().samples.front().coordinates - run.latest.coordinates).norm(), 2e-3);
    EXPECT_GT(forecast.predicted().samples.front().temperatures_K.at(0), experiment.environment_K + 5.0);
}

// Catches a prediction that stays behind a run that began elsewhere, since nobody looked at the page then.
TEST_F(RunForecastTest, ARunFromElsewhereHasNone) {
    for (const bool isArmedSeen : {true, false}) {
        ASSERT_TRUE(predictsFor(ready()));
        Snapshot run = ready();
        run.runId = isArmedSeen ? 1 : 2;
        run.latest.coordinates[kX] += 0.02; // moved on the page of the rig
        run.state = isArmedSeen ? RunState::Armed : RunState::Running;
        forecast.apply(run, false);
        EXPECT_FALSE(isPredicted()) << isArmedSeen;
        EXPECT_FALSE(isAsked()) << "nobody looks";
        run.state = RunState::Running;
        EXPECT_FALSE(isMovedBy(run)) << "a run is on";
        forecast.setExperiment(experiment);
    }
}

// Catches a prediction that goes though its run begins where it does, unseen.
TEST_F(RunForecastTest, ItsRunKeepsItUnseen) {
    ASSERT_TRUE(predictsFor(ready()));
    Snapshot run = ready();
    run.runId = 1;
    for (const RunState state : {RunState::Armed, RunState::Running}) {
        run.state = state;
        EXPECT_FALSE(isMovedBy(run, false));
    }
    run.runTime_s = 30.0;
    run.latest.coordinates[kZ] -= 0.03;
    EXPECT_FALSE(isMovedBy(run));
    EXPECT_TRUE(isPredicted());
}

// Catches a next run that is predicted unasked behind the traces of the last one, and one that is not though
// it was edited.
TEST_F(RunForecastTest, AfterARunAnEditAsksForTheNext) {
    ASSERT_TRUE(predictsFor(ready()));
    Snapshot run = ready();
    run.runTime_s = 90.0;
    run.state = RunState::Running;
    forecast.apply(run, true);
    aimAt(44.0);
    EXPECT_FALSE(isMovedBy(run)) << "a run is on";
    run.state = RunState::Stopped;
    EXPECT_FALSE(isMovedBy(run)) << "its traces stand there";
    aimAt(43.0);
    ASSERT_TRUE(predictsFor(run));
    EXPECT_NEAR(forecast.predicted().samples.back().temperatures_K.at(0), kelvinFromCelsius(43.0),
                kSettledBand_K);
}

// Catches a source that cools and so keeps a prediction from ever being there.
TEST_F(RunForecastTest, ASourceThatCoolsDoesNotBeginItAgain) {
    Snapshot cooling = ready();
    *cooling.source_K -= 40.0;
    forecast.apply(cooling, true);
    ASSERT_TRUE(waitFor([&] { return forecast.isComputing(); }));
    *cooling.source_K -= 8.0;
    forecast.apply(cooling, true);
    EXPECT_TRUE(forecast.isComputing());
    ASSERT_TRUE(waitFor([&] { return isPredicted(); })) << "it was begun again";
    EXPECT_FALSE(isMovedBy(cooling));
    ASSERT_TRUE(forecast.isComputing()) << "its spread";
    *cooling.source_K -= 8.0;
    EXPECT_FALSE(isMovedBy(cooling));
    ASSERT_TRUE(waitFor([&] { return isSpread(); }));
    EXPECT_FALSE(isMovedBy(cooling)) << "the spread is there, as late as that";
    *cooling.source_K -= 8.0;
    EXPECT_TRUE(isMovedBy(cooling)) << "it is another one by now";
}

// Catches a spread that never comes, since the page was left while it was computed.
TEST_F(RunForecastTest, ASpreadThatWasLeftIsMadeLater) {
    ASSERT_TRUE(predictsFor(ready()));
    forecast.apply(ready(), false);
    ASSERT_TRUE(waitFor([&] { return !forecast.isComputing(); }));
    EXPECT_FALSE(isSpread()) << "nobody looks";
    EXPECT_TRUE(waitFor([&] {
        forecast.apply(ready(), true);
        return isSpread();
    }));
    EXPECT_EQ(changes, 2);
    EXPECT_FALSE(isMovedBy(ready()));
}

// Catches a prediction that is cut by the time and looks as if it had ended so.
TEST_F(RunForecastTest, OneThatTakesTooLongSaysSo) {
    forecast.setLongest_ms(0);
    ASSERT_TRUE(predictsFor(ready()));
    EXPECT_EQ(forecast.predicted().end, PredictedEnd::Cut);
    EXPECT_FALSE(forecast.predicted().settling_s);
}

// Catches a prediction that outlives an edit, or the target of before.
TEST_F(RunForecastTest, FollowsEdits) {
    ASSERT_TRUE(predictsFor(ready()));
    aimAt(42.0);
    EXPECT_FALSE(isPredicted());
    EXPECT_EQ(changes, 2) << "it was told";
    ASSERT_TRUE(predictsFor(ready()));
    EXPECT_NEAR(forecast.predicted().samples.back().temperatures_K.at(0), kelvinFromCelsius(42.0),
                kSettledBand_K);
    aimAt(43.0);
    aimAt(44.0);
    EXPECT_EQ(changes, 4);
}

// Catches a prediction for each step of a robot that is moved by hand.
TEST_F(RunForecastTest, WaitsUntilTheRobotStands) {
    Snapshot moved = ready();
    for (int k = 0; k < 50; ++k) {
        moved.latest.coordinates[kX] += 2e-3;
        forecast.apply(moved, true);
        QCoreApplication::processEvents();
    }
    ASSERT_TRUE(predictsFor(moved));
    EXPECT_EQ(changes, 1);
    EXPECT_LT((forecast.predicted().samples.front().coordinates - moved.latest.coordinates).norm(), 2e-3);
}

} // namespace
} // namespace bask::test
