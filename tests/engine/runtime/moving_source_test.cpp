// A source that moves, is heated by a profile, or is truly something else than believed: whole runs on the
// simulated rig.

#include "engine/base/message_code.h"
#include "engine/runtime/simulated_run.h"
#include "tests/engine/runtime/loop_on_rig.h"

#include <cmath>

namespace bask {
namespace {

/// Under a law that knows the two disks, so that what goes wrong is the geometry.
Experiment modelBased() {
    Experiment experiment = twoDisks(40.0);
    experiment.controller.kind = ControllerKind::ModelBased;
    experiment.controller.modelBased = {0.2, 0.01};
    return experiment;
}

/// From 300 s on the source is moved 6 cm and turned a little within a minute.
Experiment movedSource(bool tracked) {
    Experiment experiment = modelBased();
    experiment.source.tracked = tracked;
    Vector6d there = Vector6d::Zero();
    there[kX] = 0.06;
    there[kZ] = 0.01;
    there[kThetaX] = 0.1;
    experiment.simulation.sourceMotion = {{300.0, Vector6d::Zero()}, {360.0, there}};
    experiment.simulation.durationLimit_s = 800.0;
    return experiment;
}

double largestError_K(const RunOutcome& outcome) {
    double worst_K = 0.0;
    for (const ObjectOutcome& object : outcome.objects)
        worst_K = std::max(worst_K, std::abs(object.final_K - object.target_K));
    return worst_K;
}

bool has(const RunOutcome& outcome, MessageCode code) {
    return std::ranges::any_of(outcome.events, [&](const TraceEvent& e) { return e.message.code == code; });
}

} // namespace

// Catches a tracked pose that does not reach the controller or the record, and one that reaches it untracked.
TEST(MovingSource, IsFollowedWhereItIsTrackedAndIsNotWhereItIsNot) {
    for (const bool tracked : {true, false}) {
        LoopOnRig run(movedSource(tracked));
        run.startRun(true);
        run.periods(290);
        ASSERT_EQ(run.loop.state(), RunState::Settled);
        run.periods(500);
        const TraceSample& last = run.loop.latest();
        const Vector6d truth = coordinatesFromPose(run.rig.X_RS());
        EXPECT_NEAR(truth[kX], 0.06, 1e-9);
        const double offPlace = (last.source - truth).cwiseAbs().maxCoeff();
        double worst_K = 0.0;
        for (const ObjectSample& object : last.objects)
            worst_K = std::max(worst_K, std::abs(object.true_K - object.target_K));
        if (tracked) {
            EXPECT_LT(offPlace, 2e-3);
            EXPECT_LT(worst_K, 0.5);
            EXPECT_EQ(run.loop.state(), RunState::Settled);
        } else {
            EXPECT_EQ(last.source, Vector6d::Zero());
            EXPECT_GT(offPlace, 0.05);
        }
        // What the loop takes for the view factors, against the truth.
        const auto F = rigGeometry(movedSource(tracked))
                           ->withSourceAt(run.rig.X_RS())
                           ->viewFactors(run.rig.simulatedRobot().coordinates())
                           .F;
        double farthest = 0.0;
        for (std::size_t i = 0; i < last.objects.size(); ++i)
            farthest =
                std::max(farthest, std::abs(last.objects[i].viewFactor - F[static_cast<Eigen::Index>(i)]));
        EXPECT_EQ(farthest < 0.005, tracked) << farthest;
    }
}

// Catches noise that shakes the run apart and a delay that is taken for a loss.
TEST(MovingSource, IsFollowedThroughNoiseAndDelay) {
    Experiment experiment = movedSource(true);
    experiment.simulation.trackingNoise_m = 0.0005;
    experiment.simulation.trackingNoise_rad = 0.005;
    experiment.simulation.trackingDelay_s = 1.0;
    const auto outcome = runSimulated(experiment, {800.0, {}, {}});
    ASSERT_TRUE(outcome) << describe(outcome.error());
    EXPECT_FALSE(has(*outcome, MessageCode::ReasonSourcePoseLost));
    EXPECT_LT(largestError_K(*outcome), 0.5);
}

// Catches a source that moves by another clock than the run's.
TEST(MovingSource, ItsTimeIsTheRunsWheneverThatIsStarted) {
    LoopOnRig run(movedSource(true));
    run.periods(200);
    run.startRun(true);
    run.periods(300);
    EXPECT_EQ(run.rig.X_RS().translation().x(), 0.0);
    run.periods(30);
    EXPECT_NEAR(run.rig.X_RS().translation().x(), 0.03, 1e-9);
}

// Catches a run that goes on with a pose from long ago, resumes by itself, or holds for ever.
TEST(MovingSource, LostFromViewHoldsAndThenEndsTheRun) {
    LoopOnRig run(movedSource(true));
    run.startRun(true);
    run.periods(20);
    run.rig.simulatedSourceTracker().setLost(true);
    run.periods(3);
    EXPECT_EQ(run.loop.state(), RunState::Running);
    run.periods(1);
    EXPECT_EQ(run.loop.state(), RunState::Holding);
    EXPECT_TRUE(run.reasonGiven(MessageCode::ReasonSourcePoseLost));
    EXPECT_TRUE(run.eventSeen(MessageCode::ReasonSourcePoseLost));
    const auto refused = run.loop.resume();
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().code(), MessageCode::ReasonSourcePoseLost);

    run.rig.simulatedSourceTracker().setLost(false);
    run.periods(2);
    EXPECT_TRUE(run.eventSeen(MessageCode::EventSourcePoseBack));
    EXPECT_EQ(run.loop.state(), RunState::Holding);
    EXPECT_TRUE(run.loop.resume());

    run.rig.simulatedSourceTracker().setLost(true);
    run.periods(21);
    EXPECT_EQ(run.loop.state(), RunState::Stopping);
    EXPECT_FALSE(run.loop.heat().isOn());
    run.periods(60);
    EXPECT_EQ(run.loop.outcome(), "fault") << "no operator has stopped it";
    EXPECT_EQ(run.loop.reasons().front().code, MessageCode::ReasonSourcePoseLost);
}

// Catches a prediction that keeps a run going for ever: poses of now, of a source that is hidden.
TEST(MovingSource, APredictionIsNoSight) {
    struct Predicting final : SourceTracker {
        PoseReading reading{0.0, Pose::Identity(), true};
        bool hidden = false;
        Result<PoseReading> read() override {
            reading.time_s += 1.0;
            reading.predicted = hidden;
            if (!hidden)
                reading.seen_s = reading.time_s;
            return reading;
        }
    } tracker;
    LoopOnRig run(movedSource(true), &tracker);
    ASSERT_EQ(run.experiment.sampling.period_s, 1.0);
    run.startRun(true);
    run.periods(10);
    EXPECT_EQ(run.loop.state(), RunState::Running);
    tracker.hidden = true;
    run.periods(3);
    EXPECT_EQ(run.loop.state(), RunState::Running);
    run.periods(1);
    EXPECT_EQ(run.loop.state(), RunState::Holding);
    EXPECT_TRUE(run.reasonGiven(MessageCode::ReasonSourcePoseLost));
}

// Catches an Arm on a pose that nobody has measured.
TEST(MovingSource, IsNotReadyWhileATrackedSourceIsNotSeen) {
    LoopOnRig run(movedSource(true));
    run.rig.simulatedSourceTracker().setLost(true);
    run.periods(12);
    EXPECT_EQ(run.loop.state(), RunState::NotReady);
    EXPECT_TRUE(run.reasonGiven(MessageCode::ReasonSourcePoseLost));
    run.rig.simulatedSourceTracker().setLost(false);
    run.periods(1);
    EXPECT_EQ(run.loop.state(), RunState::Ready);
}

// Catches a retreat that goes up along the robot's z, which brings objects nearer to a source that leans
// over.
TEST(MovingSource, TheRetreatLeadsOffTheSourcesPlane) {
    Experiment experiment = modelBased();
    experiment.source.pose[kY] = 0.12;
    experiment.source.pose[kZ] = 0.1;
    experiment.source.pose[kThetaX] = 1.4;
    experiment.start[kY] = -0.1;
    ASSERT_TRUE(validate(experiment));
    LoopOnRig run(experiment);
    run.startRun(true);
    run.periods(30);
    ASSERT_TRUE(run.loop.stop());
    const auto geometry = rigGeometry(experiment);
    double height_m = geometry->lowestPoint_m(run.rig.simulatedRobot().coordinates());
    EXPECT_LT(height_m, 0.2);
    for (int i = 0; i < 60 && run.loop.state() == RunState::Stopping; ++i) {
        run.periods(1);
        const double next_m = geometry->lowestPoint_m(run.rig.simulatedRobot().coordinates());
        if (i < 5) {
            EXPECT_GT(next_m, height_m) << i;
        }
        EXPECT_GE(next_m, 0.009) << i;
        height_m = next_m;
    }
    EXPECT_EQ(run.loop.state(), RunState::Stopped);
    EXPECT_NEAR(run.rig.simulatedRobot().coordinates()[kY], experiment.robot.lower[kY], 2e-3);
}

// Catches an exception that leaves a run: plates in one plane have no view factor.
TEST(MovingSource, MovedIntoTheObjectsIsAFault) {
    Experiment experiment = modelBased();
    experiment.robot.maxSpeed_m_s = 1e-6;
    experiment.robot.maxRotation_rad_s = 1e-6;
    Vector6d there = Vector6d::Zero();
    there[kZ] = experiment.start[kZ];
    experiment.simulation.sourceMotion = {{0.0, Vector6d::Zero()}, {20.0, there}};
    const auto outcome = runSimulated(experiment, {60.0, {}, {}});
    ASSERT_TRUE(outcome) << describe(outcome.error());
    EXPECT_TRUE(outcome->fault);
    EXPECT_TRUE(has(*outcome, MessageCode::ReasonInternalFault));
}

// Catches a robot that waits at its least distance for a source that comes nearer.
TEST(MovingSource, ThatComesNearerIsBackedOffFrom) {
    Experiment experiment = modelBased();
    experiment.source.tracked = true;
    experiment.robot.lower[kZ] = -0.1;
    for (ObjectSpec& object : experiment.objects)
        object.target_K = kelvinFromCelsius(120.0); // as near as it may
    Vector6d there = Vector6d::Zero();
    there[kZ] = 0.1;
    experiment.simulation.sourceMotion = {{60.0, Vector6d::Zero()}, {160.0, there}};
    LoopOnRig run(experiment);
    run.startRun(true);
    const auto geometry = rigGeometry(experiment);
    double min_m = 1.0;
    for (int i = 0; i < 300; ++i) {
        run.periods(1);
        min_m = std::min(
            min_m,
            geometry->withSourceAt(run.rig.X_RS())->lowestPoint_m(run.rig.simulatedRobot().coordinates()));
    }
    EXPECT_EQ(run.loop.state(), RunState::Running);
    EXPECT_LT(min_m, 0.0101);
    EXPECT_GT(min_m, 0.006);
}

// Catches a verdict over the robot's origin instead of over the source.
TEST(MovingSource, VerdictsAreForWhereItLies) {
    Experiment experiment = modelBased();
    EXPECT_EQ(jointVerdict(experiment).conditions1[0].verdict, FeasibilityVerdict::Reachable);
    experiment.source.pose[kX] = 1.0;
    EXPECT_EQ(jointVerdict(experiment).conditions1[0].verdict, FeasibilityVerdict::TooHot);
}

// The paper's ramp. Catches a profile that is not asked for, or by another clock: the simulated plate follows
// a ramp of 0.1 K/s with its lag of 60 s, 6 K behind.
TEST(TemperatureProfile, TheMeasuredSourceFollowsTheRamp) {
    Experiment experiment = modelBased();
    experiment.source.temperatureProfile = {{0.0, kelvinFromCelsius(200.0)},
                                            {1000.0, kelvinFromCelsius(300.0)}};
    LoopOnRig run(experiment);
    run.periods(50);
    run.startRun(true);
    EXPECT_NEAR(run.loop.latest().source_K, kelvinFromCelsius(200.0), 1e-9);
    for (const int time_s : {300, 600, 900}) {
        run.periods(time_s - static_cast<int>(std::lround(run.loop.runTime_s())));
        EXPECT_NEAR(run.loop.latest().source_K, kelvinFromCelsius(200.0 + 0.1 * time_s - 6.0), 0.3) << time_s;
    }
    run.periods(500);
    EXPECT_NEAR(run.loop.latest().source_K, kelvinFromCelsius(300.0), 0.1);
    for (const ObjectSample& object : run.loop.latest().objects)
        EXPECT_NEAR(object.true_K, object.target_K, 0.5);
}

// Catches a plant that is what the controllers believe, and verdicts that know what they cannot.
TEST(TrueMaterials, AreThePlantsAndNobodyElses) {
    const Experiment assumed = modelBased();
    Experiment truly = assumed;
    truly.objects[0].simulatedMaterial = assumed.objects[0].material;
    truly.objects[0].simulatedMaterial->absorptance = 0.3;
    truly.objects[0].simulatedMaterial->emittance = 0.3;
    truly.simulation.sourceEmittance = 0.5;
    const auto a = jointVerdict(assumed).conditions1, b = jointVerdict(truly).conditions1;
    for (std::size_t i = 0; i < a.size(); ++i) {
        EXPECT_EQ(a[i].neededViewFactor, b[i].neededViewFactor);
        EXPECT_EQ(a[i].reachableMax_K, b[i].reachableMax_K);
        EXPECT_EQ(estimatedRates(assumed, 298.15)[i].lambda1, estimatedRates(truly, 298.15)[i].lambda1);
    }
    // Half of the emittance again, a third of the absorptance: lambda1 by the heat balance.
    EXPECT_NEAR(trueRates(truly)[0].lambda1 / trueRates(assumed)[0].lambda1, 2.0 / 3.0, 1e-12);
    EXPECT_NEAR(trueRates(truly)[1].lambda1 / trueRates(assumed)[1].lambda1, 2.0, 1e-12);
    EXPECT_EQ(trueRates(assumed)[0].lambda1, nominalRates(assumed, assumed.environment_K)[0].lambda1);
    LoopOnRig first(assumed), second(truly);
    for (LoopOnRig* run : {&first, &second}) {
        run->startRun();
        ASSERT_TRUE(run->loop.hold());
        run->periods(10);
    }
    const double rise_K = first.rig.trueTemperatures_K()[1] - assumed.environment_K;
    EXPECT_NEAR((second.rig.trueTemperatures_K()[1] - assumed.environment_K) / rise_K, 2.0, 0.05);
    EXPECT_NEAR((second.rig.trueTemperatures_K()[0] - assumed.environment_K) / rise_K, 2.0 / 3.0, 0.02);
}

// Catches a single missing reading that holds, ends or shakes a run; a run that cannot begin for them.
TEST(Dropouts, DoNotEndARun) {
    for (std::uint64_t seed = 1; seed <= 5; ++seed) {
        Experiment experiment = modelBased();
        experiment.simulation.sensorDropout = 0.08;
        experiment.simulation.seed = seed;
        const auto outcome = runSimulated(experiment, {400.0, {}, {}});
        ASSERT_TRUE(outcome) << describe(outcome.error());
        EXPECT_TRUE(outcome->settled) << seed;
        EXPECT_FALSE(has(*outcome, MessageCode::EventHeldFor)) << seed;
        EXPECT_NEAR(outcome->simulated_s, 400.0, 1.5);
    }
}

// Catches an estimate that stands still while readings drop out, and a missing reading that is shown as a
// number.
TEST(Dropouts, CarryTheEstimateOn) {
    LoopOnRig run(modelBased());
    run.startRun(true);
    run.periods(15);
    const ObjectSample before = run.loop.latest().objects[0];
    run.rig.simulatedThermometer().setLost(0, true);
    run.periods(2);
    const ObjectSample& after = run.loop.latest().objects[0];
    EXPECT_FALSE(after.valid);
    EXPECT_TRUE(std::isnan(after.measured_K));
    EXPECT_NEAR(after.estimated_K, before.estimated_K + 2.0 * before.rate_K_s, 1e-9);
    EXPECT_GT(std::abs(before.rate_K_s), 0.01);
}

// Catches a retreat that takes a robot which has not obeyed yet for one that has arrived.
TEST(LateRobot, RetreatsAllTheSame) {
    for (const double latency_s : {0.0, 2.0, 4.0, 10.0}) {
        Experiment experiment = modelBased();
        experiment.simulation.robotLatency_s = latency_s;
        experiment.start[kZ] = 0.05;
        experiment.start[kThetaX] = 0.3;
        LoopOnRig run(experiment);
        run.startRun(true);
        ASSERT_TRUE(run.loop.hold());
        run.periods(20);
        ASSERT_TRUE(run.loop.stop());
        for (int i = 0; i < 200 && run.loop.state() == RunState::Stopping; ++i)
            run.periods(1);
        EXPECT_EQ(run.loop.state(), RunState::Stopped) << latency_s;
        const Vector6d q = run.rig.simulatedRobot().coordinates();
        EXPECT_NEAR(q[kZ], experiment.robot.upper[kZ], 2e-3) << latency_s;
        EXPECT_NEAR(q[kThetaX], 0.0, 2e-3) << latency_s;
    }
}

// The same for one that starts so slowly that its first steps take several periods.
TEST(LateRobot, RetreatsAllTheSameWhenItStartsSlowly) {
    Experiment experiment = modelBased();
    experiment.sampling.period_s = 0.05;
    experiment.robot.maxAcceleration_m_s2 = 0.002;
    experiment.start[kZ] = 0.05;
    LoopOnRig run(experiment);
    run.startRun(true);
    ASSERT_TRUE(run.loop.hold());
    run.periods(100);
    ASSERT_TRUE(run.loop.stop());
    for (int i = 0; i < 2000 && run.loop.state() == RunState::Stopping; ++i)
        run.periods(1);
    EXPECT_EQ(run.loop.state(), RunState::Stopped);
    EXPECT_NEAR(run.rig.simulatedRobot().coordinates()[kZ], experiment.robot.upper[kZ], 2e-3);
}

// Catches a loose contact that starts the time of a loss anew each time, so that a held object is heated for
// ever.
TEST(Dropouts, ALooseContactEndsTheRunToo) {
    LoopOnRig run(modelBased());
    run.startRun(true);
    run.periods(15);
    for (int i = 0; i < 100 && run.loop.running() && run.loop.state() != RunState::Stopping; ++i) {
        run.rig.simulatedThermometer().setLost(0, i % 12 != 0);
        run.periods(1);
    }
    EXPECT_FALSE(run.loop.heat().isOn());
}

// Catches a limit in seconds that a slow loop never reaches.
TEST(Dropouts, ALossEndsASlowRunToo) {
    Experiment experiment = modelBased();
    experiment.sampling.period_s = 20.0;
    LoopOnRig run(experiment);
    run.startRun(true);
    run.rig.simulatedThermometer().setLost(0, true);
    run.periods(6);
    EXPECT_FALSE(run.loop.heat().isOn());
}

// Catches another kind of controller that begins without a belief: the source is still too cold to heat.
TEST(TemperatureProfile, AnotherControllerMayTakeOverWhileTheSourceIsCold) {
    Experiment experiment = modelBased();
    experiment.source.temperatureProfile = {
        {0.0, kelvinFromCelsius(10.0)}, {100.0, kelvinFromCelsius(10.0)}, {200.0, kelvinFromCelsius(200.0)}};
    ASSERT_TRUE(validate(experiment));
    LoopOnRig run(experiment);
    run.startRun(true);
    run.periods(20);
    EXPECT_EQ(run.loop.state(), RunState::Running);
    experiment.controller.kind = ControllerKind::Adaptive;
    ASSERT_TRUE(run.loop.setController(experiment.controller));
    run.periods(600);
    EXPECT_EQ(run.loop.state(), RunState::Settled);
}

} // namespace bask
