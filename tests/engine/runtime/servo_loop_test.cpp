// The state machine and its safe state, on the simulated rig with its manual clock.

#include "engine/base/message_code.h"
#include "tests/engine/runtime/loop_on_rig.h"

#include <cmath>

namespace bask {
namespace {

struct ServoLoopTest : public ::testing::Test, LoopOnRig {
    ServoLoopTest() : LoopOnRig(twoDisks(35.0)) {}
};

} // namespace

TEST_F(ServoLoopTest, IsNotReadyUntilTheEstimatorsAreFull) {
    periods(9);
    EXPECT_EQ(loop.state(), RunState::NotReady);
    EXPECT_TRUE(reasonGiven(MessageCode::ReasonEstimatorFilling));
    EXPECT_FALSE(loop.arm());
    periods(1);
    EXPECT_EQ(loop.state(), RunState::Ready);
    EXPECT_TRUE(loop.arm());
}

// Catches: a run with plates that nobody can have mounted so, started without a word.
TEST(ServoLoop, ObjectsInOnePlaceAreNotArmed) {
    Experiment experiment = twoDisks(35.0);
    experiment.objects[1].mounting = experiment.objects[0].mounting;
    LoopOnRig rig(experiment);
    rig.periods(20);
    EXPECT_EQ(rig.loop.state(), RunState::NotReady);
    EXPECT_TRUE(rig.reasonGiven(MessageCode::MountingOverlap));
    const auto armed = rig.loop.arm();
    ASSERT_FALSE(armed);
    EXPECT_EQ(armed.error().code(), MessageCode::MountingOverlap);
}

TEST_F(ServoLoopTest, NothingMovesOrHeatsBeforeStart) {
    periods(10);
    ASSERT_TRUE(loop.arm());
    periods(20);
    EXPECT_EQ(rig.simulatedRobot().coordinates(), experiment.start);
    EXPECT_FALSE(loop.heat().isOn());
    EXPECT_NEAR(rig.trueTemperatures_K()[0], experiment.environment_K, 1e-6);
}

// Catches what a person asks in a run, and has no row or no operator.
TEST_F(ServoLoopTest, RecordsWhatIsAskedOfOthersWithTheOperator) {
    periods(60);
    const auto ask = [&] {
        loop.reportSpeedAsked(4.0);
        loop.reportSourceTyped(453.15);
        loop.reportFaultAsked(SimulatedFault::SensorLost, 0, true);
        loop.reportFaultAsked(SimulatedFault::SourceLost, 0, false);
        loop.reportFaultAsked(SimulatedFault::None, 0, true);
    };
    ask();
    EXPECT_TRUE(loop.takeRecord().commands.empty()) << "nothing is recorded";
    loop.setOperator("A. Hu");
    ASSERT_TRUE(loop.arm());
    (void)loop.takeRecord();
    ask();
    std::string told;
    for (const CommandRow& command : loop.takeRecord().commands)
        told += command.operatorName + ": " + command.name + ' ' + command.value + '\n';
    EXPECT_EQ(told, "A. Hu: speed {\"factor\":4}\n"
                    "A. Hu: source-temperature {\"temperature_K\":453.15}\n"
                    "A. Hu: fault {\"fault\":\"sensor-lost\",\"object\":\"" +
                        experiment.objects[0].name +
                        "\"}\n"
                        "A. Hu: fault {\"fault\":\"source-lost\",\"on\":false}\n"
                        "A. Hu: fault {\"fault\":\"none\"}\n");
}

// Catches an Arm that is taken back and taken for the end of a run.
TEST_F(ServoLoopTest, DisarmingIsACommandAndStopsNoRun) {
    periods(60);
    ASSERT_TRUE(loop.arm());
    (void)loop.takeRecord();
    ASSERT_TRUE(loop.stop());
    const LoopRecord rows = loop.takeRecord();
    EXPECT_TRUE(rows.events.empty());
    ASSERT_EQ(rows.commands.size(), 1U);
    EXPECT_EQ(rows.commands[0].name, "disarm");
    EXPECT_EQ(loop.state(), RunState::Ready);
}

TEST_F(ServoLoopTest, VerbsThatDoNotFitTheStateAreRefusedInWords) {
    const auto refused = loop.start(false);
    ASSERT_FALSE(refused);
    EXPECT_EQ(describe(refused.error()), "\"Start\" cannot be done in the state \"Not ready\"");
    EXPECT_FALSE(loop.hold());
    EXPECT_FALSE(loop.resume());
    EXPECT_FALSE(loop.stop());
    EXPECT_FALSE(loop.reset());
}

TEST_F(ServoLoopTest, RunsSettlesAndStopsWithARetreat) {
    startRun();
    periods(150);
    EXPECT_EQ(loop.state(), RunState::Settled);
    EXPECT_TRUE(eventSeen(MessageCode::EventSettled));
    ASSERT_TRUE(loop.stop());
    EXPECT_EQ(loop.state(), RunState::Stopping);
    EXPECT_FALSE(loop.heat().isOn());
    const Vector6d at = rig.simulatedRobot().coordinates();
    periods(2);
    const Vector6d later = rig.simulatedRobot().coordinates();
    EXPECT_GT(later[kZ], at[kZ]);         // up first ...
    EXPECT_NEAR(later[kX], at[kX], 1e-9); // ... never sideways
    periods(40);
    EXPECT_EQ(loop.state(), RunState::Stopped);
    EXPECT_EQ(loop.outcome(), "settled");
    EXPECT_NEAR(rig.simulatedRobot().coordinates()[kZ], experiment.robot.upper[kZ], 2e-3);
    EXPECT_NEAR(rig.simulatedRobot().coordinates()[kThetaX], 0.0, 2e-3);
}

TEST_F(ServoLoopTest, HoldStandsStillAndResumeGoesOn) {
    startRun();
    periods(3);
    ASSERT_TRUE(loop.hold());
    const Vector6d at = rig.simulatedRobot().coordinates();
    periods(5);
    EXPECT_EQ(rig.simulatedRobot().coordinates(), at);
    EXPECT_TRUE(loop.heat().isOn());
    ASSERT_TRUE(loop.resume());
    periods(3);
    EXPECT_NE(rig.simulatedRobot().coordinates(), at);
}

// Catches: a lost robot that is shown where it was as if it were there, and one that has told nothing yet.
TEST_F(ServoLoopTest, TheAgeOfTheRobotsPlaceIsTold) {
    EXPECT_EQ(loop.motion().placeState(), PlaceState::Unknown);
    EXPECT_TRUE(std::isinf(loop.motion().placeAge_s()));
    EXPECT_TRUE(std::isinf(loop.readings().sourceAge_s()));
    periods(3);
    EXPECT_EQ(loop.motion().placeState(), PlaceState::Sure);
    EXPECT_LE(loop.motion().placeAge_s(), 0.1);
    EXPECT_LE(loop.readings().sourceAge_s(), experiment.sampling.period_s);
    const Vector6d at = loop.latest().coordinates;
    for (const RobotTrouble trouble : {RobotTrouble::LinkLost, RobotTrouble::Slow}) {
        rig.simulatedRobot().setTrouble(trouble);
        periods(12);
        EXPECT_EQ(loop.motion().placeState(), PlaceState::Unknown);
        EXPECT_GE(loop.motion().placeAge_s(), 11.0 * experiment.sampling.period_s);
        EXPECT_EQ(loop.latest().coordinates, at);
        rig.simulatedRobot().setTrouble(RobotTrouble::None);
        periods(1);
        EXPECT_EQ(loop.motion().placeState(), PlaceState::Sure);
    }
    rig.simulatedRobot().setTrouble(RobotTrouble::Restarted);
    periods(1);
    EXPECT_EQ(loop.motion().placeState(), PlaceState::Unsure);
}

// Catches: limits of the last command in the samples of a robot that is told to stand.
TEST_F(ServoLoopTest, WhileItStandsNothingHoldsItBack) {
    startRun();
    periods(3);
    ASSERT_TRUE(loop.latest().limits.any()) << "on the way from the start";
    ASSERT_TRUE(loop.hold());
    (void)loop.takeRecord();
    periods(2);
    const LoopRecord rows = loop.takeRecord();
    ASSERT_EQ(rows.samples.size(), 2U);
    for (const TraceSample& sample : rows.samples)
        EXPECT_FALSE(sample.limits.any());
}

TEST_F(ServoLoopTest, ALostSensorHoldsAndThenEndsTheRunWithARetreat) {
    startRun();
    periods(5);
    rig.simulatedThermometer().setLost(1, true);
    periods(3);
    EXPECT_EQ(loop.state(), RunState::Running); // may be readings that dropped out
    EXPECT_TRUE(std::isnan(loop.latest().objects[1].measured_K));
    periods(1);
    EXPECT_EQ(loop.state(), RunState::Holding);
    EXPECT_TRUE(reasonGiven(MessageCode::ReasonSensorInvalid));
    EXPECT_TRUE(std::isnan(loop.latest().objects[1].measured_K)); // shown as invalid, never as 0
    EXPECT_FALSE(loop.resume());
    periods(16);
    EXPECT_EQ(loop.state(), RunState::Stopping);
    EXPECT_FALSE(loop.heat().isOn());
    for (const TraceEvent& event : loop.takeRecord().events)
        EXPECT_EQ(describe(event.message).find("nan"), std::string::npos) << describe(event.message);
    periods(40);
    EXPECT_EQ(loop.outcome(), "fault") << "no operator has stopped it";
    EXPECT_TRUE(reasonGiven(MessageCode::ReasonSensorInvalid));
}

TEST_F(ServoLoopTest, ASensorThatComesBackAllowsResume) {
    startRun();
    periods(5);
    rig.simulatedThermometer().setLost(0, true);
    periods(4);
    rig.simulatedThermometer().setLost(0, false);
    periods(2);
    EXPECT_EQ(loop.state(), RunState::Holding); // never by itself
    EXPECT_TRUE(eventSeen(MessageCode::EventSensorBack));
    EXPECT_TRUE(loop.resume());
}

TEST_F(ServoLoopTest, ALostRobotIsAFaultWithTheHeatOff) {
    startRun();
    periods(5);
    rig.simulatedRobot().setLinkLost(true);
    periods(1);
    EXPECT_EQ(loop.state(), RunState::Fault);
    EXPECT_FALSE(loop.heat().isOn());
    EXPECT_TRUE(reasonGiven(MessageCode::ReasonRobotLost));
    rig.simulatedRobot().setLinkLost(false);
    periods(5);
    EXPECT_EQ(loop.state(), RunState::Fault); // latched
    ASSERT_TRUE(loop.reset());
    periods(2);
    EXPECT_EQ(loop.state(), RunState::Ready); // never restarts
}

TEST_F(ServoLoopTest, EmergencyStopActsAtOnceAndLatches) {
    startRun();
    periods(5);
    loop.emergencyStop();
    const Vector6d at = rig.simulatedRobot().coordinates();
    EXPECT_FALSE(loop.heat().isOn());
    periods(10);
    EXPECT_EQ(rig.simulatedRobot().coordinates(), at);
    EXPECT_EQ(loop.state(), RunState::Fault);
    EXPECT_EQ(loop.outcome(), "emergency-stop");
    EXPECT_FALSE(loop.arm());
}

TEST_F(ServoLoopTest, AnEngineThatDiesLeavesRobotAndHeatToExpire) {
    startRun();
    periods(4);
    rig.advance(10.0); // no tick: the engine is dead
    const Vector6d at = rig.simulatedRobot().coordinates();
    EXPECT_FALSE(rig.heatSource().heating());
    rig.advance(10.0);
    EXPECT_EQ(rig.simulatedRobot().coordinates(), at);
}

// Catches events that do not say which targets were set, and a reason that is lost or told when no run is on.
TEST_F(ServoLoopTest, EventsSayWhatWasSetAndWhyItCannotBeHeld) {
    periods(10);
    const Message reason{MessageCode::TargetNeedsMore, {"first", "1.2", "0.9"}};
    loop.takeRecord();
    loop.reportInfeasible(reason);
    EXPECT_TRUE(loop.takeRecord().events.empty());
    startRun();
    loop.takeRecord();
    ASSERT_TRUE(loop.setTargets({kelvinFromCelsius(38.25), kelvinFromCelsius(33.0)}));
    loop.reportInfeasible(reason);
    const std::vector<TraceEvent> events = loop.takeRecord().events;
    ASSERT_EQ(events.size(), 2U);
    EXPECT_EQ(events[0].message.code, MessageCode::EventTargetsChanged);
    EXPECT_EQ(events[0].message.args.at(0),
              experiment.objects[0].name + " 38.25 \u00b0C, " + experiment.objects[1].name + " 33 \u00b0C");
    EXPECT_EQ(events[1].message.code, reason.code);
    EXPECT_EQ(alarmPriority(events[1].message.code), 3);
}

TEST_F(ServoLoopTest, TargetsAndControllerChangeDuringARun) {
    startRun();
    periods(60);
    ASSERT_TRUE(loop.setTargets({kelvinFromCelsius(38.0), kelvinFromCelsius(33.0)}));
    EXPECT_FALSE(loop.setTargets({300.0}));
    ControllerSettings settings = experiment.controller;
    settings.levelServo.timeConstant_s = 12.0;
    (void)loop.takeRecord();
    ASSERT_TRUE(loop.setController(settings));
    const LoopRecord rows = loop.takeRecord();
    ASSERT_EQ(rows.commands.size(), 1U);
    EXPECT_NE(rows.commands[0].value.find("\"time_constant_s\":12.0"), std::string::npos)
        << rows.commands[0].value;
    periods(400);
    EXPECT_NEAR(rig.trueTemperatures_K()[0], kelvinFromCelsius(38.0), 0.5);
    EXPECT_NEAR(rig.trueTemperatures_K()[1], kelvinFromCelsius(33.0), 0.5);
    settings.kind = ControllerKind::Adaptive;
    ASSERT_TRUE(loop.setController(settings));
    periods(20);
    EXPECT_NE(loop.state(), RunState::Fault);
    settings.levelServo.timeConstant_s = -1.0;
    EXPECT_FALSE(loop.setController(settings));
}

TEST_F(ServoLoopTest, SamplesAreRecordedOncePerPeriodFromStart) {
    startRun();
    periods(20);
    const LoopRecord rows = loop.takeRecord();
    ASSERT_EQ(rows.samples.size(), 21U);
    for (std::size_t k = 0; k < rows.samples.size(); ++k)
        EXPECT_NEAR(rows.samples[k].time_s, static_cast<double>(k), 1e-9);
    EXPECT_TRUE(loop.takeRecord().samples.empty());
}

TEST_F(ServoLoopTest, StartIsRefusedWhileASensorIsLost) {
    periods(10);
    ASSERT_TRUE(loop.arm());
    rig.simulatedThermometer().setLost(0, true);
    periods(4);
    const auto refused = loop.start(false);
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().code(), MessageCode::ReasonSensorInvalid);
    EXPECT_FALSE(loop.heat().isOn());
    rig.simulatedThermometer().setLost(0, false);
    periods(1);
    EXPECT_TRUE(loop.start(false));
}

TEST_F(ServoLoopTest, ASensorLostDuringAnOperatorsHoldEndsInARetreatToo) {
    startRun();
    periods(5);
    ASSERT_TRUE(loop.hold());
    rig.simulatedThermometer().setLost(0, true);
    periods(21);
    EXPECT_EQ(loop.state(), RunState::Stopping);
    EXPECT_FALSE(loop.heat().isOn());
}

TEST_F(ServoLoopTest, EveryLossGetsItsOwnShortHold) {
    startRun();
    periods(5);
    rig.simulatedThermometer().setLost(0, true);
    periods(5);
    rig.simulatedThermometer().setLost(0, false);
    periods(60); // back, still held
    rig.simulatedThermometer().setLost(0, true);
    periods(10);
    EXPECT_EQ(loop.state(), RunState::Holding);
    periods(11);
    EXPECT_EQ(loop.state(), RunState::Stopping);
}

TEST_F(ServoLoopTest, ALostSourceLinkRetreatsBeforeTheFault) {
    startRun();
    periods(8);
    rig.simulatedHeatSource().setLinkLost(true);
    periods(1);
    EXPECT_EQ(loop.state(), RunState::Stopping);
    EXPECT_TRUE(reasonGiven(MessageCode::ReasonSourceLost));
    periods(40);
    EXPECT_EQ(loop.state(), RunState::Fault);
    EXPECT_NEAR(rig.simulatedRobot().coordinates()[kZ], experiment.robot.upper[kZ], 2e-3);
    EXPECT_FALSE(rig.heatSource().heating());
}

TEST_F(ServoLoopTest, PassingThroughTheBandIsNotASettledOutcome) {
    startRun();
    for (int i = 0; i < 200 && !loop.readings().allWithinBand(); ++i)
        periods(1);
    ASSERT_TRUE(loop.stop());
    EXPECT_EQ(loop.outcome(), "stopped");
}

/// Reads well, but takes no heating command.
class DeafHeatSource final : public HeatSource {
public:
    explicit DeafHeatSource(HeatSource& source) : m_source(source) {}
    Result<Reading> read() override { return m_source.read(); }
    Result<void> keepHeating(double setPoint_K, double validFor_s) override {
        if (deaf)
            return Error(MessageCode::ReasonSourceLost, {}, {"no acknowledgement"});
        return m_source.keepHeating(setPoint_K, validFor_s);
    }
    Result<void> heatOff() override { return m_source.heatOff(); }
    bool heating() const override { return m_source.heating(); }
    HeatState heatState() const override { return m_source.heatState(); }
    bool deaf = false;

private:
    HeatSource& m_source;
};

TEST(ServoLoop, AControllerNeverOverridesTheRetreat) {
    LoopWithSource<DeafHeatSource> rig(twoDisks(35.0));
    rig.periods(10);
    ASSERT_TRUE(rig.loop.arm());
    ASSERT_TRUE(rig.loop.start(false));
    rig.periods(4);
    rig.source.deaf = true;
    rig.periods(1); // the failed heating command ends the run within the control step
    ASSERT_EQ(rig.loop.state(), RunState::Stopping);
    const Vector6d at = rig.rig.simulatedRobot().coordinates();
    rig.periods(1);
    EXPECT_GT(rig.rig.simulatedRobot().coordinates()[kZ], at[kZ]);
    EXPECT_EQ(rig.rig.simulatedRobot().coordinates()[kX], at[kX]);
    EXPECT_EQ(rig.rig.simulatedRobot().coordinates()[kY], at[kY]);
}

TEST(ServoLoop, ARetreatEndsAlsoWhenTheRobotsStepsMissTheTop) {
    Experiment experiment = twoDisks(35.0);
    experiment.simulation.robotStep_m = 0.005;
    experiment.robot.upper[kZ] = 0.292;
    SimulatedRig rig(simulatedRigConfig(experiment));
    ServoLoop loop(experiment, {rig.robot(), rig.thermometer(), rig.heatSource(), {}}, rig.clock());
    const auto periods = [&](int count) {
        for (int i = 0; i < count; ++i) {
            rig.advance(experiment.sampling.period_s);
            loop.tick();
        }
    };
    periods(10);
    ASSERT_TRUE(loop.arm());
    ASSERT_TRUE(loop.start(false));
    periods(5);
    ASSERT_TRUE(loop.stop());
    periods(40);
    EXPECT_EQ(loop.state(), RunState::Stopped);
}

// Catches sensors zeroed on warm objects, on readings of before, or in the middle of a run.
TEST_F(ServoLoopTest, ZeroesAtAmbientOnly) {
    const auto refusal = [&] {
        const auto zeroed = loop.zeroSensors();
        return zeroed ? MessageCode::None : zeroed.error().code();
    };
    periods(5);
    EXPECT_EQ(refusal(), MessageCode::ReasonEstimatorFilling);
    periods(5);
    ASSERT_TRUE(loop.setHeat(kelvinFromCelsius(60.0)));
    periods(1);
    EXPECT_EQ(refusal(), MessageCode::ReasonNotAtAmbient);
    ASSERT_TRUE(loop.setHeat(std::nullopt));
    rig.simulatedThermometer().setLost(0, true);
    periods(4);
    EXPECT_EQ(refusal(), MessageCode::ReasonSensorInvalid);
    rig.simulatedThermometer().setLost(0, false);
    periods(1);
    EXPECT_EQ(refusal(), MessageCode::None);
    EXPECT_TRUE(eventSeen(MessageCode::EventZeroed));
    ASSERT_TRUE(loop.arm());
    EXPECT_FALSE(eventSeen(MessageCode::EventZeroed)); // it was done
    EXPECT_EQ(refusal(), MessageCode::SessionAlreadyRunning);
    ASSERT_TRUE(loop.start(true));
    EXPECT_EQ(refusal(), MessageCode::SessionAlreadyRunning);
    EXPECT_TRUE(loop.readings().sensors().zeroing());
}

// Catches warm objects that cannot be armed although their sensors were zeroed when they were cold.
TEST_F(ServoLoopTest, WarmObjectsAreArmedOnAnEarlierZeroing) {
    startRun();
    periods(120);
    ASSERT_TRUE(loop.stop());
    periods(40);
    ASSERT_EQ(loop.state(), RunState::Stopped);
    ASSERT_GT(rig.trueTemperatures_K()[0], experiment.environment_K + 6.0);
    ServoLoop next(experiment, {rig.robot(), rig.thermometer(), rig.heatSource(), {}, &rig.sourceTracker()},
                   rig.clock());
    for (int i = 0; i < 10; ++i) {
        rig.advance(experiment.sampling.period_s);
        next.tick();
    }
    const auto refused = next.arm();
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().code(), MessageCode::ReasonNotAtAmbient);
    next.useZeroing(*loop.readings().sensors().zeroing());
    EXPECT_TRUE(next.arm());
}

// Catches a run towards a temperature at which it is held for being too warm.
TEST_F(ServoLoopTest, ATargetAboveTheWarningLimitIsRefused) {
    periods(10);
    const std::vector<double> tooHot_K{kelvinFromCelsius(35.0), kelvinFromCelsius(121.0)};
    const Message why{MessageCode::TargetAboveWarning, {experiment.objects[1].name, "121", "120"}};
    ASSERT_TRUE(loop.setTargets(tooHot_K)); // what is in the field is what would run
    EXPECT_EQ(loop.state(), RunState::NotReady);
    EXPECT_EQ(loop.reasons(), std::vector<Message>{why});
    const auto unarmed = loop.arm();
    ASSERT_FALSE(unarmed);
    EXPECT_EQ(unarmed.error().message, why);
    ASSERT_TRUE(loop.setTargets({kelvinFromCelsius(35.0), kelvinFromCelsius(36.0)}));
    EXPECT_TRUE(loop.reasons().empty());
    ASSERT_TRUE(loop.arm());
    for (const RunState on : {RunState::Armed, RunState::Running}) {
        ASSERT_EQ(loop.state(), on);
        const auto refused = loop.setTargets(tooHot_K);
        ASSERT_FALSE(refused);
        EXPECT_EQ(refused.error().message, why);
        EXPECT_EQ(loop.experiment().objects[1].target_K, kelvinFromCelsius(36.0));
        if (on == RunState::Armed) {
            ASSERT_TRUE(loop.start(true));
        }
    }

    Experiment strict = experiment;
    strict.objects[0].warning_K = kelvinFromCelsius(34.0);
    LoopOnRig other(strict);
    other.periods(10);
    const auto arm = other.loop.arm();
    ASSERT_FALSE(arm);
    EXPECT_EQ(arm.error().code(), MessageCode::TargetAboveWarning);
}

// Catches: the same number twice where one object stands in the light of the other, or another one where none
// can.
TEST(ServoLoopRecord, HasTheViewFactorWithAndWithoutShade) {
    Experiment experiment = twoDisks(35.0);
    const auto latest = [&] {
        LoopOnRig on(experiment);
        on.periods(2);
        return on.loop.latest().objects;
    };
    for (const ObjectSample& object : latest())
        EXPECT_EQ(object.unshadedViewFactor, object.viewFactor);
    experiment.objects[0].mounting[kY] = 0.03;
    experiment.objects[0].mounting[kZ] = -0.04;
    const std::vector<ObjectSample> seen = latest();
    EXPECT_NEAR(seen[0].unshadedViewFactor, seen[0].viewFactor, 2e-6);
    EXPECT_GT(seen[1].unshadedViewFactor, 1.05 * seen[1].viewFactor);
}

} // namespace bask
