// Every row of the alarm table, raised on the simulated rig at 10 Hz: what is done, how soon, what is
// said and recorded; in a run, in a manual move and in idle.

#include "engine/base/message_code.h"
#include "engine/base/notice.h"
#include "engine/experiment/experiment_file.h"
#include "engine/model/hand_warm.h"
#include "engine/recording/alarm_history.h"
#include "engine/rig/missing_devices.h"
#include "engine/runtime/fault_script.h"
#include "engine/runtime/simulated_run.h"
#include "tests/engine/runtime/loop_on_rig.h"

#include <QTemporaryDir>

#include <cmath>
#include <ostream>

namespace bask {
namespace {

Experiment fastDisks() {
    Experiment experiment = twoDisks(40.0);
    experiment.sampling = {0.1, 30, 2};
    return experiment;
}

struct Rig : LoopOnRig {
    explicit Rig(const Experiment& from = fastDisks()) : LoopOnRig(from) {}
    /// Until the condition holds; answers how long that took, a large number when it never did.
    template <class Condition> double until(Condition condition, double max_s) {
        const double from_s = rig.clock().now_s();
        while (!condition() && rig.clock().now_s() < from_s + max_s) {
            periods(1);
            for (const TraceEvent& event : loop.takeRecord().events)
                events.push_back(event.message);
        }
        return condition() ? rig.clock().now_s() - from_s : 1e9;
    }
    bool isRecorded(MessageCode code) const {
        return std::ranges::any_of(events, [&](const Message& message) { return message.code == code; });
    }
    bool isAlarm(MessageCode code) const {
        return std::ranges::any_of(loop.alarmConditions(),
                                   [&](const AlarmCondition& c) { return c.message.code == code; });
    }
    void run(double for_s) {
        periods(40);
        ASSERT_TRUE(loop.arm());
        ASSERT_TRUE(loop.start(true));
        (void)until([] { return false; }, for_s);
        ASSERT_TRUE(loop.state() == RunState::Running || loop.state() == RunState::Settled);
        events.clear();
    }
    std::vector<Message> events;
};

/// A person keeps it hot, and typed its temperature long ago.
struct SourceByHand final : HeatSource {
    explicit SourceByHand(HeatSource& inner) : source(inner) {}
    Result<Reading> read() override {
        auto reading = source.read();
        reading->time_s -= 1000.0;
        return reading;
    }
    Result<void> keepHeating(double setPoint_K, double validFor_s) override {
        return source.keepHeating(setPoint_K, validFor_s);
    }
    Result<void> heatOff() override { return source.heatOff(); }
    bool heating() const override { return source.heating(); }
    HeatState heatState() const override { return source.heatState(); }
    bool isManual() const override { return true; }
    HeatSource& source;
};

struct RigByHand {
    void periods(int count) {
        for (int i = 0; i < count; ++i) {
            rig.advance(experiment.sampling.period_s);
            loop.tick();
        }
    }
    void startRun() {
        periods(40);
        ASSERT_TRUE(loop.arm());
        ASSERT_TRUE(loop.start(true));
    }

    const Experiment experiment = fastDisks();
    SimulatedRig rig{simulatedRigConfig(experiment)};
    SourceByHand source{rig.heatSource()};
    ServoLoop loop{experiment, {rig.robot(), rig.thermometer(), source, {}}, rig.clock()};
};

/// One row: fault, what it is told as, how soon, and the state at once and at the end.
struct Row {
    SimulatedFault fault;
    MessageCode code;
    double within_s;
    RunState atOnce;
    RunState atEnd;
};

void PrintTo(const Row& row, std::ostream* out) {
    *out << simulatedFaultName(row.fault);
}

class Ladder : public ::testing::TestWithParam<Row> {};

} // namespace

// Catches a row that is not watched, reacts too late or wrongly, leaves heat or motion on, or is not in the
// record.
TEST_P(Ladder, ReactsInARun) {
    const Row& row = GetParam();
    Rig rig;
    rig.run(20.0);
    setFault(rig.rig, row.fault, 1, true);
    const double took_s = rig.until([&] { return rig.isAlarm(row.code); }, row.within_s + 0.05);
    EXPECT_LE(took_s, row.within_s + 0.05);
    RecordProperty("seconds", std::to_string(took_s));
    EXPECT_EQ(rig.loop.state(), row.atOnce) << runStateName(rig.loop.state());
    EXPECT_TRUE(rig.isRecorded(row.code));
    EXPECT_EQ(rig.loop.alarmConditions().front().message.code, row.code);
    if (row.atOnce == RunState::Holding || row.atOnce == RunState::Fault) { // the robot stands
        rig.periods(row.fault == SimulatedFault::RobotSlow ? 3 : 1);
        const Vector6d at = rig.rig.simulatedRobot().coordinates();
        rig.periods(5);
        EXPECT_EQ(rig.rig.simulatedRobot().coordinates(), at);
    }
    if (row.atOnce != RunState::Holding) {
        EXPECT_LE(rig.until([&] { return !rig.rig.heatSource().heating(); }, 1.0), 1.0);
    }
    EXPECT_LE(rig.until([&] { return rig.loop.state() == row.atEnd; }, 60.0), 60.0)
        << runStateName(rig.loop.state());
    EXPECT_FALSE(rig.rig.heatSource().heating());
    for (const Message& message : rig.events)
        EXPECT_EQ(describe(message).find("nan"), std::string::npos) << describe(message);
}

INSTANTIATE_TEST_SUITE_P(
    Rows, Ladder,
    ::testing::Values(
        Row{SimulatedFault::SensorLost, MessageCode::ReasonSensorInvalid, 0.5, RunState::Holding,
            RunState::Fault},
        Row{SimulatedFault::SensorOpen, MessageCode::SafetySensorOpen, 0.5, RunState::Holding,
            RunState::Fault},
        Row{SimulatedFault::SensorShort, MessageCode::SafetySensorShort, 0.5, RunState::Holding,
            RunState::Fault},
        Row{SimulatedFault::SensorJumping, MessageCode::SafetySensorJump, 0.5, RunState::Holding,
            RunState::Fault},
        Row{SimulatedFault::SensorFrozen, MessageCode::SafetySensorFrozen, 30.0, RunState::Holding,
            RunState::Fault},
        Row{SimulatedFault::RobotLost, MessageCode::ReasonRobotLost, 0.1, RunState::Fault, RunState::Fault},
        Row{SimulatedFault::RobotAlarm, MessageCode::RobotAlarm, 0.1, RunState::Fault, RunState::Fault},
        Row{SimulatedFault::RobotRestarted, MessageCode::RobotPlaceUnsure, 0.1, RunState::Fault,
            RunState::Fault},
        Row{SimulatedFault::RobotSlow, MessageCode::RobotSlow, 1.0, RunState::Fault, RunState::Fault},
        Row{SimulatedFault::SourceLost, MessageCode::ReasonSourceLost, 0.1, RunState::Stopping,
            RunState::Fault},
        Row{SimulatedFault::SourceSilent, MessageCode::SafetySourceSilent, 3.2, RunState::Stopping,
            RunState::Fault},
        Row{SimulatedFault::SourceNotHeating, MessageCode::SafetySourceNotHeating, 180.0, RunState::Stopping,
            RunState::Fault},
        Row{SimulatedFault::SourceLimited, MessageCode::SafetySetPointOther, 10.2, RunState::Stopping,
            RunState::Fault},
        Row{SimulatedFault::SourceOverheats, MessageCode::SafetySourceHot, 26.0, RunState::Stopping,
            RunState::Fault}),
    [](const auto& row) {
        std::string name = simulatedFaultName(row.param.fault);
        std::erase(name, '-');
        return name;
    });

// Catches limits of an object that are not watched in a run, or that do not act in their order.
TEST(Safety, AHotObjectHoldsTheRunAndIsThenTakenAway) {
    Experiment experiment = fastDisks();
    experiment.safety.warming_K = 50.0; // or the run ends because something else heats the object
    Rig rig(experiment);
    rig.run(20.0);
    setFault(rig.rig, SimulatedFault::ObjectHot, 0, true);
    ASSERT_LE(rig.until([&] { return rig.isAlarm(MessageCode::SafetyObjectWarm); }, 60.0), 60.0);
    EXPECT_EQ(rig.loop.state(), RunState::Holding);
    EXPECT_NEAR(rig.loop.latest().objects[0].measured_K, rig.experiment.safety.warning_K, 1.0);
    ASSERT_LE(rig.until([&] { return rig.isAlarm(MessageCode::SafetyObjectHot); }, 30.0), 30.0);
    EXPECT_NEAR(rig.loop.latest().objects[0].measured_K, rig.experiment.safety.trip_K, 1.0);
    EXPECT_EQ(rig.loop.state(), RunState::Stopping);
    EXPECT_FALSE(rig.loop.heat().isOn());
    ASSERT_LE(rig.until([&] { return rig.loop.state() == RunState::Fault; }, 60.0), 60.0);
    EXPECT_NEAR(rig.rig.simulatedRobot().coordinates()[kZ], rig.experiment.robot.upper[kZ], 2e-3);
    const auto refused = rig.loop.reset();
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().code(), MessageCode::SafetyObjectHot);
}

// Catches an object that runs away from its target without a word until its warning limit.
TEST(Safety, AnObjectThatSomethingElseHeatsIsTakenAway) {
    Rig rig;
    rig.run(60.0);
    setFault(rig.rig, SimulatedFault::ObjectHot, 0, true);
    EXPECT_LE(rig.until([&] { return rig.isAlarm(MessageCode::SafetyHeatedOtherwise); }, 18.0), 18.0);
    EXPECT_LT(rig.loop.latest().objects[0].measured_K, rig.experiment.safety.warning_K - 30.0);
    EXPECT_EQ(rig.loop.state(), RunState::Stopping) << "in a hold it would stay in the source's light";
    EXPECT_FALSE(rig.loop.heat().isOn());
    ASSERT_LE(rig.until([&] { return rig.loop.state() == RunState::Fault; }, 30.0), 30.0);
    EXPECT_TRUE(rig.isAlarm(MessageCode::SafetyHeatedOtherwise)) << "the heat is off, and it warms on";
    const auto refused = rig.loop.reset();
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().code(), MessageCode::SafetyHeatedOtherwise);
    setFault(rig.rig, SimulatedFault::ObjectHot, 0, false);
    EXPECT_LE(rig.until([&] { return !rig.isAlarm(MessageCode::SafetyHeatedOtherwise); }, 80.0), 60.0);
    EXPECT_TRUE(rig.loop.reset());
    EXPECT_TRUE(rig.isRecorded(MessageCode::EventAlarmOver));
    EXPECT_FALSE(rig.isRecorded(MessageCode::EventSensorBack));
}

// Catches a source that runs away from its set point without a word until its trip limit, and a run that is
// settled meanwhile.
TEST(Safety, ASourceFarAboveItsSetPointIsTold) {
    Rig rig;
    rig.run(60.0);
    setFault(rig.rig, SimulatedFault::SourceOverheats, 0, true);
    EXPECT_LE(rig.until([&] { return rig.isAlarm(MessageCode::SafetySourceOver); }, 15.0), 13.0);
    EXPECT_LT(*rig.loop.readings().source_K(), sourceTripLimit_K(rig.experiment) - 20.0);
    EXPECT_EQ(rig.loop.state(), RunState::Running) << "told, no more";
    setFault(rig.rig, SimulatedFault::SourceOverheats, 0, false);
    EXPECT_LE(rig.until([&] { return !rig.isAlarm(MessageCode::SafetySourceOver); }, 60.0), 60.0)
        << "it cools";
}

// Catches an object that something heats while the heat is off, told at its limits only; a word for a hand;
// and a note that ends something, or comes before the retreat at the trip limit.
TEST(Safety, AnObjectThatWarmsWithTheHeatOffIsToldBeforeItsLimits) {
    for (const bool isArmed : {false, true}) {
        Rig rig;
        rig.periods(40);
        ASSERT_TRUE(!isArmed || rig.loop.arm());
        const RunState before = rig.loop.state();
        setFault(rig.rig, SimulatedFault::ObjectHot, 1, true);
        EXPECT_LE(rig.until([&] { return rig.isAlarm(MessageCode::SafetyHeatedAtRest); }, 40.0), 30.0);
        const double told_K = rig.loop.latest().objects[1].measured_K;
        EXPECT_GT(told_K, kByHand_K);
        EXPECT_LT(told_K, rig.experiment.safety.warning_K - 25.0);
        EXPECT_EQ(rig.loop.state(), isArmed ? before : RunState::NotReady) << "told, and nothing is armed";
        EXPECT_EQ(rig.reasonGiven(MessageCode::SafetyHeatedAtRest), !isArmed);
        EXPECT_FALSE(rig.loop.arm());
        ASSERT_LE(rig.until([&] { return rig.loop.state() == RunState::Stopping; }, 60.0), 60.0);
        EXPECT_NEAR(rig.loop.latest().objects[1].measured_K, rig.experiment.safety.trip_K, 1.0);
        for (const AlarmCondition& condition : rig.loop.alarmConditions())
            if (condition.message.code == MessageCode::SafetyHeatedAtRest) {
                EXPECT_FALSE(condition.cause.empty()) << "under that of the limit";
            }
        setFault(rig.rig, SimulatedFault::ObjectHot, 1, false);
        EXPECT_LE(rig.until([&] { return !rig.isAlarm(MessageCode::SafetyHeatedAtRest); }, 90.0), 60.0);
        EXPECT_FALSE(rig.isAlarm(MessageCode::SafetyHeatedOtherwise));
    }
}

// Catches a run that is armed with an object above its warning limit, where it could not begin.
TEST(Safety, NothingIsArmedAboveTheWarningLimit) {
    Rig rig;
    rig.periods(40);
    ASSERT_TRUE(rig.loop.arm() && rig.loop.disarm()); // zeroed while cold
    ASSERT_EQ(rig.loop.state(), RunState::Ready);
    setFault(rig.rig, SimulatedFault::ObjectHot, 1, true);
    ASSERT_LE(rig.until([&] { return rig.isAlarm(MessageCode::SafetyObjectWarm); }, 90.0), 90.0);
    setFault(rig.rig, SimulatedFault::ObjectHot, 1, false);
    rig.periods(2);
    ASSERT_TRUE(rig.isAlarm(MessageCode::SafetyObjectWarm));
    EXPECT_EQ(rig.loop.state(), RunState::NotReady);
    const auto armed = rig.loop.arm();
    ASSERT_FALSE(armed);
    EXPECT_EQ(armed.error().code(), MessageCode::SafetyObjectWarm);
    EXPECT_TRUE(rig.reasonGiven(MessageCode::SafetyObjectWarm));
    ASSERT_LE(rig.until([&] { return !rig.isAlarm(MessageCode::SafetyObjectWarm); }, 300.0), 300.0);
    EXPECT_LE(rig.until([&] { return rig.loop.state() == RunState::Ready; }, 300.0), 300.0);
    EXPECT_TRUE(rig.loop.arm());
}

// Catches an object that gets too hot while nobody runs anything, also in a move and with the run armed.
TEST(Safety, AHotObjectIsTakenAwayInEveryState) {
    for (const std::string state : {"idle", "moving", "armed"}) {
        Rig rig;
        rig.periods(40);
        if (state == "moving") {
            Vector6d goal = rig.experiment.start;
            goal[kZ] -= 0.1;
            ASSERT_TRUE(rig.loop.moveTo(goal));
        } else if (state == "armed") {
            ASSERT_TRUE(rig.loop.arm());
        }
        setFault(rig.rig, SimulatedFault::ObjectHot, 1, true);
        ASSERT_LE(rig.until([&] { return rig.loop.state() == RunState::Stopping; }, 80.0), 80.0) << state;
        EXPECT_NEAR(rig.loop.latest().objects[1].measured_K, rig.experiment.safety.trip_K, 1.0);
        EXPECT_TRUE(rig.isRecorded(MessageCode::SafetyObjectHot));
        ASSERT_LE(rig.until([&] { return rig.loop.state() == RunState::Fault; }, 60.0), 60.0) << state;
        EXPECT_NEAR(rig.rig.simulatedRobot().coordinates()[kZ], rig.experiment.robot.upper[kZ], 2e-3);
        EXPECT_TRUE(rig.loop.takeRecord().samples.empty()) << "no run";
    }
}

// Catches devices that are only watched in a run, and a robot that moves by itself for a cable that came off.
TEST(Safety, DevicesAreWatchedInIdleAndNothingMovesForThem) {
    for (const auto& [fault, code] :
         {std::pair(SimulatedFault::RobotLost, MessageCode::ReasonRobotLost),
          std::pair(SimulatedFault::RobotAlarm, MessageCode::RobotAlarm),
          std::pair(SimulatedFault::RobotRestarted, MessageCode::RobotPlaceUnsure),
          std::pair(SimulatedFault::SourceLost, MessageCode::ReasonSourceLost),
          std::pair(SimulatedFault::SourceSilent, MessageCode::SafetySourceSilent),
          std::pair(SimulatedFault::SourceHeatsAlone, MessageCode::SafetySourceHeatsUnasked)}) {
        Rig rig;
        rig.periods(40);
        const Vector6d at = rig.rig.simulatedRobot().coordinates();
        setFault(rig.rig, fault, 0, true);
        EXPECT_LE(rig.until([&] { return rig.loop.state() == RunState::Fault; }, 15.0), 12.0);
        EXPECT_TRUE(rig.isRecorded(code)) << messageName(code);
        rig.periods(20);
        EXPECT_EQ(rig.rig.simulatedRobot().coordinates(), at);
        EXPECT_FALSE(rig.loop.arm());
        EXPECT_FALSE(rig.loop.reset()) << messageName(code) << " while it lasts";
        setFault(rig.rig, fault, 0, false);
        // A source that has heated has to cool first.
        const auto isReset = [&] { return rig.loop.state() != RunState::Fault || rig.loop.reset().ok(); };
        EXPECT_LE(rig.until(isReset, 200.0), 130.0) << messageName(code);
        rig.periods(2);
        EXPECT_EQ(rig.loop.state(), RunState::Ready);
    }
}

// Catches an alarm "heats although its heat is off" beside a plate that cools, until somebody resets; and a
// fault that goes with it.
TEST(Safety, ThatASourceHeatsUnaskedIsOverBeforeItsFault) {
    Rig rig;
    rig.periods(40);
    setFault(rig.rig, SimulatedFault::SourceHeatsAlone, 0, true);
    ASSERT_LE(rig.until([&] { return rig.loop.state() == RunState::Fault; }, 15.0), 12.0);
    ASSERT_TRUE(rig.isAlarm(MessageCode::SafetySourceHeatsUnasked));
    rig.periods(50);
    EXPECT_TRUE(rig.isAlarm(MessageCode::SafetySourceHeatsUnasked)) << "it goes on";
    setFault(rig.rig, SimulatedFault::SourceHeatsAlone, 0, false);
    const auto isOver = [&] { return !rig.isAlarm(MessageCode::SafetySourceHeatsUnasked); };
    EXPECT_LE(rig.until(isOver, 200.0), 130.0);
    EXPECT_TRUE(rig.isRecorded(MessageCode::EventAlarmOver));
    EXPECT_EQ(rig.loop.state(), RunState::Fault) << "latched";
    EXPECT_TRUE(rig.loop.reset());
}

// Catches a manual move that goes on blindly; and one that cannot be made any more, though it is wanted.
TEST(Safety, ALostSensorEndsAManualMoveOnce) {
    Rig rig;
    rig.periods(40);
    Vector6d goal = rig.experiment.start;
    goal[kX] += 0.15;
    ASSERT_TRUE(rig.loop.moveTo(goal));
    rig.periods(10);
    setFault(rig.rig, SimulatedFault::SensorOpen, 0, true);
    EXPECT_LE(rig.until([&] { return !rig.loop.motion().isMoving(); }, 2.0), 0.5);
    EXPECT_TRUE(rig.isAlarm(MessageCode::SafetySensorOpen));
    ASSERT_TRUE(rig.loop.moveTo(goal)); // a person has seen the alarm and wants it all the same
    rig.periods(20);
    EXPECT_TRUE(rig.loop.motion().isMoving());
}

// The sensor came off its object and shows the room. Catches a controller that goes on heating for ever.
TEST(Safety, ASensorThatDoesNotWarmNearTheSourceEndsTheRun) {
    Rig rig;
    setFault(rig.rig, SimulatedFault::SensorOff, 0, true);
    rig.run(1.0);
    const double took_s = rig.until([&] { return rig.isAlarm(MessageCode::SafetyNotWarming); }, 300.0);
    ASSERT_LE(took_s, 250.0);
    EXPECT_GE(took_s, 10.0);
    RecordProperty("seconds", std::to_string(took_s));
    EXPECT_EQ(rig.loop.state(), RunState::Stopping);
    EXPECT_FALSE(rig.loop.heat().isOn());
    EXPECT_EQ(rig.loop.reasons().front().args.at(0), "left");
}

// Catches a sensor that was off its object before a later run began, which was never told: the room's
// temperature was measured long ago then, and a colder room explained everything.
TEST(Safety, ASensorThatIsOffBeforeALaterRunEndsIt) {
    for (const bool wasDistrusted : {false, true}) {
        Rig rig(readExperiment(BASK_EXAMPLES "/three-objects.json").value());
        ASSERT_NO_FATAL_FAILURE(rig.run(60.0));
        setFault(rig.rig, SimulatedFault::SensorOff, 1, wasDistrusted);
        (void)rig.until([] { return false; }, 30.0);
        setFault(rig.rig, SimulatedFault::SensorOff, 1, false);
        (void)rig.loop.stop();
        (void)rig.until([] { return false; }, 1500.0);
        (void)rig.loop.reset();

        setFault(rig.rig, SimulatedFault::SensorOff, 1, true);
        rig.periods(10);
        if (wasDistrusted) {
            ASSERT_TRUE(rig.loop.confirmSensor(1)) << "a person looked at another one";
        }
        rig.periods(40);
        ASSERT_TRUE(rig.loop.arm());
        ASSERT_TRUE(rig.loop.start(true));
        EXPECT_LE(rig.until([&] { return rig.isAlarm(MessageCode::SafetyNotWarming); }, 600.0), 240.0);
        EXPECT_EQ(rig.loop.state(), RunState::Stopping);
        EXPECT_LT(rig.rig.trueTemperatures_K()[1], kelvinFromCelsius(75.0));
    }
}

// Catches a sensor that came off and is believed again, since it reads the room for long enough; a run that
// is resumed on its reading; and one that is back on its object and not believed.
TEST(Safety, ASensorThatCameOffIsDistrustedUntilItAgrees) {
    Rig rig;
    rig.run(1.0);
    ASSERT_LE(rig.until([&] { return rig.loop.latest().objects[0].true_K > kelvinFromCelsius(36.0); }, 300.0),
              300.0);
    EXPECT_EQ(rig.loop.sensorTrust(0), SensorTrust::Trusted);
    setFault(rig.rig, SimulatedFault::SensorOff, 0, true);
    EXPECT_LE(rig.until([&] { return rig.isAlarm(MessageCode::SafetySensorJump); }, 1.0), 1.0);
    rig.periods(100); // a reading of the room has long been no jump any more
    EXPECT_TRUE(rig.isAlarm(MessageCode::SafetySensorJump));
    EXPECT_EQ(rig.loop.sensorTrust(0), SensorTrust::Distrusted);
    EXPECT_EQ(rig.loop.sensorTrust(1), SensorTrust::Trusted);
    EXPECT_NEAR(rig.loop.readings().sensors().told_K(0, rig.rig.clock().now_s()), rig.rig.environment_K(),
                0.5);
    EXPECT_GT(rig.loop.readings().sensors().age_s(0, rig.rig.clock().now_s()), 9.0);
    const auto refused = rig.loop.resume();
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().code(), MessageCode::ReasonSensorDistrusted);
    setFault(rig.rig, SimulatedFault::SensorOff, 0, false);
    EXPECT_LE(rig.until([&] { return !rig.isAlarm(MessageCode::SafetySensorJump); }, 1.0), 1.0);
    EXPECT_EQ(rig.loop.sensorTrust(0), SensorTrust::Trusted);
    EXPECT_TRUE(rig.loop.resume());
}

// Catches a range that is told as the reason although the reading is in it.
TEST(Safety, ASensorThatMayBeRightByNowIsNotToldToBeImpossible) {
    Rig rig;
    rig.run(1.0);
    ASSERT_LE(rig.until([&] { return rig.loop.latest().objects[0].true_K > kelvinFromCelsius(36.0); }, 300.0),
              300.0);
    setFault(rig.rig, SimulatedFault::SensorOff, 0, true);
    ASSERT_LE(rig.until([&] { return rig.loop.sensorTrust(0) == SensorTrust::Distrusted; }, 10.0), 10.0);
    EXPECT_EQ(rig.loop.readings().distrust(0).code, MessageCode::ReasonSensorDistrusted);
    const auto isInRange = [&] {
        const SensorChannels& sensors = rig.loop.readings().sensors();
        return sensors.bounds(0)->contain(sensors.told_K(0, rig.rig.clock().now_s()), 0.0);
    };
    ASSERT_LE(rig.until(isInRange, 1800.0), 1800.0);
    ASSERT_EQ(rig.loop.sensorTrust(0), SensorTrust::Distrusted);
    EXPECT_EQ(rig.loop.readings().distrust(0).code, MessageCode::ReasonSensorUndecided);
}

// Catches a sensor that came off, went to the room's temperature by itself, so that no reading was a jump,
// and is believed again after a Reset.
TEST(Safety, ASensorThatSlidesOffItsObjectIsDistrusted) {
    for (const double lag_s : {2.0, 15.0}) {
        Rig rig;
        rig.run(1.0);
        ASSERT_LE(
            rig.until([&] { return rig.loop.latest().objects[0].true_K > kelvinFromCelsius(38.0); }, 300.0),
            300.0);
        rig.rig.simulatedThermometer().setOffLag(lag_s);
        setFault(rig.rig, SimulatedFault::SensorOff, 0, true);
        EXPECT_LE(rig.until([&] { return rig.loop.sensorTrust(0) == SensorTrust::Distrusted; }, 180.0),
                  180.0);
        EXPECT_EQ(rig.loop.sensorTrust(1), SensorTrust::Trusted);
        ASSERT_LE(rig.until([&] { return rig.loop.state() == RunState::Fault; }, 120.0), 120.0) << lag_s;
        rig.periods(600);
        ASSERT_TRUE(rig.loop.reset());
        rig.periods(100);
        EXPECT_EQ(rig.loop.state(), RunState::NotReady);
        EXPECT_TRUE(rig.reasonGiven(MessageCode::ReasonSensorDoubted) ||
                    rig.reasonGiven(MessageCode::SafetySensorJump))
            << lag_s;
        EXPECT_FALSE(rig.loop.arm());
        EXPECT_FALSE(rig.loop.setHeat(kelvinFromCelsius(100.0)));
        ASSERT_TRUE(rig.loop.confirmSensor(0));
        rig.periods(40);
        EXPECT_EQ(rig.loop.sensorTrust(0), SensorTrust::Trusted);
        EXPECT_EQ(rig.loop.state(), RunState::Ready);
    }
}

// Catches a fault that states in bold red what is over.
TEST(Safety, ALatchedFaultIsNoAlarmOnceItsConditionIsSeenToBeOver) {
    Rig rig;
    rig.run(10.0);
    setFault(rig.rig, SimulatedFault::SourceLost, 0, true);
    rig.periods(5);
    EXPECT_TRUE(rig.isAlarm(MessageCode::ReasonSourceLost));
    ASSERT_LE(rig.until([&] { return rig.loop.state() == RunState::Fault; }, 60.0), 60.0);
    setFault(rig.rig, SimulatedFault::SourceLost, 0, false);
    rig.periods(5);
    EXPECT_FALSE(rig.isAlarm(MessageCode::ReasonSourceLost));
    EXPECT_EQ(rig.loop.state(), RunState::Fault);
    EXPECT_TRUE(rig.reasonGiven(MessageCode::ReasonSourceLost)) << "it is why there is a fault";
}

// Catches a distrust that no person can end, or that ends without a word in the record.
TEST(Safety, APersonConfirmsADistrustedSensor) {
    Rig rig;
    rig.run(1.0);
    ASSERT_LE(rig.until([&] { return rig.loop.latest().objects[1].true_K > kelvinFromCelsius(36.0); }, 300.0),
              300.0);
    setFault(rig.rig, SimulatedFault::SensorOff, 1, true);
    ASSERT_LE(rig.until([&] { return rig.loop.state() == RunState::Fault; }, 120.0), 120.0);
    ASSERT_TRUE(rig.loop.reset());
    rig.periods(600); // the object cools: where it is nobody knows
    EXPECT_EQ(rig.loop.sensorTrust(1), SensorTrust::Distrusted);
    EXPECT_EQ(rig.loop.state(), RunState::NotReady);
    EXPECT_FALSE(rig.loop.setHeat(kelvinFromCelsius(100.0)));
    rig.events.clear();
    (void)rig.loop.takeRecord();
    EXPECT_FALSE(rig.loop.confirmSensor(2));
    ASSERT_TRUE(rig.loop.confirmSensor(1));
    const LoopRecord record = rig.loop.takeRecord();
    ASSERT_EQ(record.commands.size(), 1U);
    EXPECT_EQ(record.commands.front().name, "confirm-sensor");
    ASSERT_EQ(record.events.size(), 1U);
    EXPECT_EQ(record.events.front().message.code, MessageCode::EventSensorConfirmed);
    rig.periods(40);
    EXPECT_EQ(rig.loop.sensorTrust(1), SensorTrust::Trusted);
    EXPECT_EQ(rig.loop.state(), RunState::Ready);
    EXPECT_FALSE(rig.isAlarm(MessageCode::SafetySensorJump));
}

// Catches a sensor that gave no value, came back on nothing, and is believed.
TEST(Safety, ASensorThatComesBackElsewhereIsDistrusted) {
    Rig rig;
    rig.run(1.0);
    ASSERT_LE(rig.until([&] { return rig.loop.latest().objects[0].true_K > kelvinFromCelsius(36.0); }, 300.0),
              300.0);
    setFault(rig.rig, SimulatedFault::SensorLost, 0, true);
    rig.periods(120);
    setFault(rig.rig, SimulatedFault::SensorOff, 0, true);
    rig.periods(10);
    EXPECT_EQ(rig.loop.sensorTrust(0), SensorTrust::Distrusted);
    setFault(rig.rig, SimulatedFault::SensorLost, 0, true);
    rig.periods(5);
    setFault(rig.rig, SimulatedFault::SensorLost, 0, false);
    rig.periods(5);
    EXPECT_EQ(rig.loop.sensorTrust(0), SensorTrust::Trusted);
}

// Catches a sensor that stopped while its object rests and is shown as if it were new.
TEST(Safety, ASensorWithoutItsNoiseIsToldAndStale) {
    Experiment experiment = fastDisks();
    experiment.simulation.sensorNoise_K = 0.2;
    experiment.sampling = {1.0, 10, 2};
    Rig rig(experiment);
    rig.periods(300);
    EXPECT_TRUE(rig.loop.alarmConditions().empty());
    setFault(rig.rig, SimulatedFault::SensorFrozen, 1, true);
    EXPECT_NEAR(rig.until([&] { return rig.isAlarm(MessageCode::SafetySensorQuiet); }, 60.0), 17.0, 8.0);
    EXPECT_EQ(rig.loop.sensorTrust(1), SensorTrust::Stale);
    EXPECT_EQ(rig.loop.alarmConditions().front().priority, 3);
    EXPECT_EQ(rig.loop.state(), RunState::Ready) << "told, no more";
    setFault(rig.rig, SimulatedFault::SensorFrozen, 1, false);
    rig.periods(3); // until a new value is filtered out of the old ones
    EXPECT_EQ(rig.loop.sensorTrust(1), SensorTrust::Trusted);
}

// Without a camera. Catches two loose contacts that are told instead.
TEST(Safety, SwappedSensorsAreNamed) {
    Rig rig;
    rig.run(20.0);
    setFault(rig.rig, SimulatedFault::ObjectHot, 0, true);
    const auto& objects = rig.loop.latest().objects;
    ASSERT_LE(rig.until([&] { return objects[0].measured_K > objects[1].measured_K + 12.0; }, 20.0), 20.0);
    setFault(rig.rig, SimulatedFault::ObjectHot, 0, false);
    rig.periods(1);
    setFault(rig.rig, SimulatedFault::SensorsSwapped, 0, true);
    EXPECT_LE(rig.until([&] { return rig.isAlarm(MessageCode::SafetySensorsSwapped); }, 1.0), 0.5);
    EXPECT_FALSE(rig.isAlarm(MessageCode::SafetySensorJump));
    EXPECT_EQ(rig.loop.state(), RunState::Stopping);
    EXPECT_FALSE(rig.loop.heat().isOn());
    EXPECT_EQ(rig.loop.sensorTrust(0), SensorTrust::Distrusted);
    EXPECT_EQ(rig.loop.sensorTrust(1), SensorTrust::Distrusted);
}

// Equally warm when they are swapped: none jumps. Catches that one of them is blamed, and words that are not
// true of a temperature that falls by 8 K.
TEST(Safety, SensorsThatFollowEachOthersHeatAreNamed) {
    Rig rig(readExperiment(BASK_EXAMPLES "/three-objects.json").value());
    rig.run(150.0);
    setFault(rig.rig, SimulatedFault::SensorsSwapped, 1, true);
    EXPECT_LE(rig.until([&] { return !rig.loop.alarmConditions().empty(); }, 150.0), 150.0);
    ASSERT_TRUE(rig.isAlarm(MessageCode::SafetySensorsSeemSwapped));
    const Message told = rig.loop.alarmConditions().front().message;
    EXPECT_EQ(told.args.at(0), "bunny");
    EXPECT_EQ(told.args.at(1), "hand");
    EXPECT_EQ(rig.loop.state(), RunState::Stopping);
    EXPECT_EQ(rig.loop.sensorTrust(1), SensorTrust::Distrusted);
    EXPECT_EQ(rig.loop.sensorTrust(2), SensorTrust::Distrusted);
}

// The example as it is shipped. Catches an object that warms far beyond its target by a reading that stays,
// and another cause that is named.
TEST(Safety, AFrozenSensorHoldsTheExampleBeforeItsObjectIsHot) {
    const Experiment experiment = readExperiment(BASK_EXAMPLES "/three-objects.json").value();
    struct Case {
        int object;
        double frozen_s;
        double max_s; ///< until it is found
    };
    // In the first seconds little is known of the object: it is slower to be found, and far from its target.
    for (const auto& [object, frozen_s, max_s] :
         {Case{1, 0.0, 40.0}, Case{1, 2.0, 30.0}, Case{1, 5.0, 10.0}, Case{1, 10.0, 10.0},
          Case{1, 15.0, 10.0}, Case{1, 20.0, 15.0}, Case{1, 25.0, 15.0}, Case{0, 0.0, 60.0},
          Case{0, 15.0, 10.0}, Case{0, 50.0, 10.0}, Case{2, 0.0, 40.0}, Case{2, 20.0, 10.0},
          Case{2, 50.0, 20.0}}) {
        SCOPED_TRACE(experiment.objects[static_cast<std::size_t>(object)].name + " at " +
                     std::to_string(frozen_s) + " s");
        Rig rig(experiment);
        rig.run(frozen_s);
        setFault(rig.rig, SimulatedFault::SensorFrozen, object, true);
        EXPECT_LE(rig.until([&] { return rig.isAlarm(MessageCode::SafetySensorFrozen); }, max_s), max_s);
        EXPECT_EQ(rig.loop.state(), RunState::Holding);
        const auto i = static_cast<std::size_t>(object);
        EXPECT_LT(rig.loop.latest().objects[i].true_K, experiment.objects[i].target_K + 5.0);
        for (const AlarmCondition& condition : rig.loop.alarmConditions())
            EXPECT_TRUE(condition.cause.empty() ==
                        (condition.message.code == MessageCode::SafetySensorFrozen))
                << describe(condition.message);
    }
}

// A reading that stays does no harm where nothing changes: an object at its target. Catches one that is lost.
TEST(Safety, AFrozenSensorOfASettledObjectDoesNotLeadItAway) {
    Rig rig(readExperiment(BASK_EXAMPLES "/three-objects.json").value());
    rig.run(60.0);
    setFault(rig.rig, SimulatedFault::SensorFrozen, 1, true);
    double max_K = 0.0;
    static_cast<void>(rig.until(
        [&] {
            max_K = std::max(max_K, rig.loop.latest().objects[1].true_K);
            return false;
        },
        200.0));
    EXPECT_LT(max_K, rig.experiment.objects[1].target_K + 2.0);
}

// Catches heat that stays on unnoticed since the source did not take the order.
TEST(Safety, HeatThatCannotBeSwitchedOffIsTold) {
    Rig rig;
    rig.run(10.0);
    setFault(rig.rig, SimulatedFault::SourceKeepsHeat, 0, true);
    ASSERT_TRUE(rig.loop.stop());
    rig.periods(1);
    EXPECT_TRUE(rig.isAlarm(MessageCode::SafetyHeatNotOff));
    EXPECT_TRUE(rig.rig.heatSource().heating());
    setFault(rig.rig, SimulatedFault::SourceKeepsHeat, 0, false);
    rig.periods(2);
    EXPECT_FALSE(rig.isAlarm(MessageCode::SafetyHeatNotOff));
    EXPECT_FALSE(rig.rig.heatSource().heating());
    EXPECT_LE(rig.until([&] { return rig.loop.state() == RunState::Stopped; }, 60.0), 60.0);
    EXPECT_EQ(rig.loop.outcome(), "fault") << "no run that ended as meant";
}

// Catches an alarm of a sensor that stays active until somebody resets, beside the event that it is back.
TEST(Safety, AFrozenSensorIsOverWhenItMovesAgain) {
    Rig rig;
    rig.run(20.0);
    setFault(rig.rig, SimulatedFault::SensorFrozen, 1, true);
    ASSERT_LE(rig.until([&] { return rig.loop.state() == RunState::Fault; }, 120.0), 120.0);
    ASSERT_TRUE(rig.isAlarm(MessageCode::SafetySensorFrozen));
    EXPECT_FALSE(rig.isRecorded(MessageCode::EventSensorBack));
    setFault(rig.rig, SimulatedFault::SensorFrozen, 1, false);
    EXPECT_LE(rig.until([&] { return !rig.isAlarm(MessageCode::SafetySensorFrozen); }, 5.0), 5.0);
    (void)rig.until([] { return false; }, 1.0);
    EXPECT_EQ(rig.isRecorded(MessageCode::EventSensorBack), rig.loop.sensorTrust(1) == SensorTrust::Trusted);
    EXPECT_EQ(rig.loop.state(), RunState::Fault) << "latched";
}

// A person keeps it hot. Catches an operator who believes that STOP has switched it off.
TEST(Safety, ASourceHeatedByHandIsSaidToStayHot) {
    RigByHand rig;
    ASSERT_NO_FATAL_FAILURE(rig.startRun());
    rig.periods(100);
    ASSERT_EQ(rig.loop.state(), RunState::Running);
    rig.loop.emergencyStop();
    rig.periods(1);
    EXPECT_TRUE(std::ranges::any_of(rig.loop.reasons(), [](const Message& reason) {
        return reason.code == MessageCode::SafetyHeatByHand;
    }));
}

// Catches a real rig that can be run before anybody has looked at it.
TEST(Safety, ARealRigStartsFaultedUntilAPersonResets) {
    const Experiment experiment = fastDisks();
    SimulatedRig rig(simulatedRigConfig(experiment));
    ServoLoop loop(experiment, {rig.robot(), rig.thermometer(), rig.heatSource(), {}, nullptr, true},
                   rig.clock());
    const auto periods = [&](int count) {
        for (int i = 0; i < count; ++i) {
            rig.advance(experiment.sampling.period_s);
            loop.tick();
        }
    };
    periods(50);
    ASSERT_EQ(loop.state(), RunState::Fault);
    EXPECT_EQ(loop.reasons().front().code, MessageCode::SafetyStartUp);
    rig.simulatedRobot().setTrouble(RobotTrouble::Restarted);
    periods(1);
    const auto refused = loop.reset();
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().code(), MessageCode::RobotPlaceUnsure);
    ASSERT_TRUE(rig.robot().home());
    ASSERT_TRUE(loop.reset());
    periods(2);
    EXPECT_EQ(loop.state(), RunState::Ready);
}

// Catches ports that are called lost before they had time to open, a reset that comes before they are, and
// ports that nobody misses.
TEST(Safety, DevicesAreGivenTimeToConnectAndThenMissed) {
    Experiment experiment = fastDisks();
    SimulatedRig rig(simulatedRigConfig(experiment));
    rig.simulatedRobot().setTrouble(RobotTrouble::LinkLost);
    ServoLoop loop(experiment, {rig.robot(), rig.thermometer(), rig.heatSource(), {}, nullptr, true},
                   rig.clock());
    const auto periods = [&](int count) {
        for (int i = 0; i < count; ++i) {
            rig.advance(experiment.sampling.period_s);
            loop.tick();
        }
    };
    const auto isOnlyStartUp = [&] {
        const auto alarms = loop.alarmConditions();
        return alarms.size() == 1 && alarms.front().message.code == MessageCode::SafetyStartUp;
    };
    periods(29);
    EXPECT_TRUE(isOnlyStartUp());
    const auto refused = loop.reset();
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().message, (Message{MessageCode::CommandNotNow, {"Reset", "Connecting"}}));
    periods(2);
    EXPECT_FALSE(isOnlyStartUp());
    const auto missed = loop.reset();
    ASSERT_FALSE(missed);
    EXPECT_EQ(missed.error().code(), MessageCode::ReasonRobotLost);
    rig.simulatedRobot().setTrouble(RobotTrouble::None);
    periods(1);
    EXPECT_TRUE(loop.reset());

    rig.simulatedRobot().setTrouble(RobotTrouble::LinkLost); // it has answered: no time is given any more
    ServoLoop again(experiment, {rig.robot(), rig.thermometer(), rig.heatSource(), {}, nullptr, true},
                    rig.clock());
    rig.simulatedRobot().setTrouble(RobotTrouble::None);
    rig.advance(0.1);
    again.tick();
    rig.simulatedRobot().setTrouble(RobotTrouble::LinkLost);
    rig.advance(0.1);
    again.tick();
    EXPECT_EQ(again.alarmConditions().back().message.code, MessageCode::ReasonRobotLost);
}

// Catches a rig that is in alarm before anything of it was set up, and one without a device that can be run.
TEST(Safety, WhatIsNotSetUpIsNoAlarmAndNotReady) {
    const Experiment experiment = fastDisks();
    SimulatedRig rig(simulatedRigConfig(experiment));
    MissingRobot noRobot;
    MissingThermometer noThermometer("thermometer");
    MissingHeatSource noSource;
    const auto isMissing = [](const Message& reason) { return reason.code == MessageCode::RigIncomplete; };
    ServoLoop empty(experiment, {noRobot, noThermometer, noSource, {}, nullptr, true}, rig.clock());
    ServoLoop part(experiment, {noRobot, rig.thermometer(), rig.heatSource(), {}, nullptr, true},
                   rig.clock());
    const auto periods = [&](ServoLoop& loop, int count) {
        for (int i = 0; i < count; ++i) {
            rig.advance(experiment.sampling.period_s);
            loop.tick();
        }
    };
    periods(empty, 100);
    EXPECT_EQ(empty.state(), RunState::NotReady);
    EXPECT_TRUE(empty.alarmConditions().empty());
    EXPECT_EQ(std::ranges::count_if(empty.reasons(), isMissing), 3);
    periods(part, 100);
    EXPECT_EQ(part.alarmConditions().size(), 1U);
    EXPECT_EQ(part.alarmConditions().front().message.code, MessageCode::SafetyStartUp);
    ASSERT_TRUE(part.reset());
    periods(part, 50);
    EXPECT_EQ(part.state(), RunState::NotReady);
    EXPECT_EQ(std::ranges::count_if(part.reasons(), isMissing), 1);
    EXPECT_FALSE(part.arm());
}

// Catches a loop that was held up without anybody being told.
TEST(Safety, ALateLoopIsNoted) {
    Rig rig;
    rig.run(5.0);
    rig.rig.advance(1.5);
    rig.periods(1);
    EXPECT_TRUE(rig.isAlarm(MessageCode::SafetyLoopLate));
    EXPECT_EQ(rig.loop.state(), RunState::Running);
    for (const AlarmCondition& condition : rig.loop.alarmConditions())
        EXPECT_EQ(condition.priority, 3);
}

// Catches a warning limit that acts on its edge alone: a run that begins, or goes on, above it.
TEST(Safety, NoRunBeginsOrGoesOnAboveAWarningLimit) {
    Rig rig;
    rig.periods(40);
    ASSERT_TRUE(rig.loop.arm());
    setFault(rig.rig, SimulatedFault::ObjectHot, 0, true);
    ASSERT_LE(rig.until([&] { return rig.isAlarm(MessageCode::SafetyObjectWarm); }, 80.0), 80.0);
    setFault(rig.rig, SimulatedFault::ObjectHot, 0, false);
    ASSERT_EQ(rig.loop.state(), RunState::Armed);
    const auto refused = rig.loop.start(true);
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().code(), MessageCode::SafetyObjectWarm);
    ASSERT_LE(rig.until([&] { return !rig.isAlarm(MessageCode::SafetyObjectWarm); }, 600.0), 600.0);
    rig.periods(60); // or something else has just heated it
    ASSERT_TRUE(rig.loop.start(true));
    setFault(rig.rig, SimulatedFault::ObjectHot, 0, true);
    ASSERT_LE(rig.until([&] { return rig.loop.state() == RunState::Holding; }, 80.0), 80.0);
    setFault(rig.rig, SimulatedFault::ObjectHot, 0, false);
    EXPECT_EQ(rig.loop.remedy().code, MessageCode::RemedyStop);
    const auto held = rig.loop.resume();
    ASSERT_FALSE(held);
    EXPECT_EQ(held.error().code(), MessageCode::SafetyObjectWarm);
}

// Catches what the engine did by itself without why, and a fault whose remedy cannot be done in a fault.
TEST(Safety, TheCauseStandsInTheEventAndTheRemedyFitsTheState) {
    Rig rig;
    rig.run(20.0);
    setFault(rig.rig, SimulatedFault::SensorOpen, 1, true);
    ASSERT_LE(rig.until([&] { return rig.loop.state() == RunState::Fault; }, 90.0), 90.0);
    const Message open{MessageCode::SafetySensorOpen, {"right"}};
    const auto isRecorded = [&](const Message& message) {
        return std::ranges::find(rig.events, message) != rig.events.end();
    };
    EXPECT_TRUE(isRecorded(messageAbout(MessageCode::EventHeldFor, open)));
    EXPECT_TRUE(isRecorded(messageAbout(MessageCode::EventStoppedFor, open)));
    EXPECT_TRUE(isRecorded(
        {MessageCode::EventSensorLostTooLong, {formatNumber(rig.experiment.safety.pauseLimit_s), "right"}}));
    for (const Message& reason : rig.loop.reasons())
        EXPECT_EQ(describe(reason).find("resume"), std::string::npos) << describe(reason);
    EXPECT_EQ(rig.loop.remedy(), (Message{MessageCode::RemedyReset, {}}));
    setFault(rig.rig, SimulatedFault::RobotLost, 0, true);
    rig.periods(2);
    EXPECT_EQ(rig.loop.remedy().code, MessageCode::RemedyWait);
}

// Catches a loss that a run, or the heat, first waits for and then ends for, counted as two alarms.
TEST(Safety, ALossThatLastsIsOneAlarm) {
    for (const bool isRun : {true, false}) {
        Rig rig;
        if (isRun) {
            rig.run(20.0);
        } else {
            rig.periods(40);
            ASSERT_TRUE(rig.loop.setHeat(kelvinFromCelsius(60.0)));
        }
        setFault(rig.rig, SimulatedFault::SensorOpen, 1, true);
        ASSERT_LE(rig.until([&] { return rig.loop.state() == RunState::Fault; }, 90.0), 90.0) << isRun;
        EXPECT_EQ(std::ranges::count(rig.events, MessageCode::SafetySensorOpen, &Message::code), 2)
            << "noted, then latched";
        std::vector<TraceEvent> events;
        for (const Message& message : rig.events)
            events.push_back({static_cast<double>(events.size()), message});
        EXPECT_EQ(std::ranges::count_if(alarmSpells(events, 1e3),
                                        [](const AlarmSpell& spell) {
                                            return spell.message.code == MessageCode::SafetySensorOpen;
                                        }),
                  1)
            << isRun;
    }
}

// Catches an alarm that was over and is back before a reset, and that the record does not tell again; and one
// that is told in every period.
TEST(Safety, AnAlarmThatComesBackInAFaultIsRecordedAgain) {
    for (const auto& each : {std::pair(SimulatedFault::RobotLost, MessageCode::ReasonRobotLost),
                             std::pair(SimulatedFault::SourceSilent, MessageCode::SafetySourceSilent),
                             std::pair(SimulatedFault::ObjectHot, MessageCode::SafetyObjectHot)}) {
        const MessageCode code = each.second;
        Rig rig;
        rig.periods(40);
        const auto ends = [&] {
            return std::ranges::count_if(rig.events, [&](const Message& message) {
                const auto over = messageWithin(message);
                return message.code == MessageCode::EventAlarmOver && over && over->code == code;
            });
        };
        for (int time = 1; time <= 2; ++time) {
            setFault(rig.rig, each.first, 0, true);
            ASSERT_LE(rig.until([&] { return rig.isAlarm(code); }, 100.0), 100.0) << messageName(code);
            (void)rig.until([] { return false; }, 1.0);
            setFault(rig.rig, each.first, 0, false);
            ASSERT_LE(rig.until([&] { return !rig.isAlarm(code); }, 600.0), 600.0) << messageName(code);
            EXPECT_GE(ends(), time) << messageName(code);
            EXPECT_EQ(std::ranges::count(rig.events, code, &Message::code), ends()) << messageName(code);
        }
    }
}

// Catches one lost link that is ten alarms, and a fault that is another alarm than the condition it is for.
TEST(Safety, OneLostLinkIsOneCause) {
    for (const SimulatedFault fault :
         {SimulatedFault::RobotLost, SimulatedFault::SourceLost, SimulatedFault::SensorOpen}) {
        Rig rig;
        rig.run(20.0);
        std::vector<std::string> causes;
        setFault(rig.rig, fault, 0, true);
        const auto look = [&] {
            for (const AlarmCondition& condition : rig.loop.alarmConditions())
                if (condition.cause.empty() && std::ranges::find(causes, condition.key) == causes.end())
                    causes.push_back(condition.key);
            return false;
        };
        (void)rig.until(look, 60.0);
        setFault(rig.rig, fault, 0, false);
        if (fault == SimulatedFault::RobotLost)
            setFault(rig.rig, SimulatedFault::RobotRestarted, 0, true);
        (void)rig.until(look, 5.0);
        EXPECT_EQ(causes.size(), 1U) << simulatedFaultName(fault) << ": " << causes.back();
        const auto alarms = rig.loop.alarmConditions();
        EXPECT_LE(
            std::ranges::count_if(alarms, [](const AlarmCondition& alarm) { return alarm.cause.empty(); }),
            1);
    }
}

// Catches the minutes after a fault, which are what people want to see, that nobody records.
TEST(Safety, TheRecordGoesOnThroughAFaultUntilEverythingIsCold) {
    for (const bool isStop : {true, false}) {
        Experiment experiment = twoDisks(80.0);
        experiment.sampling = {1.0, 5, 2};
        Rig rig(experiment);
        rig.run(300.0);
        (void)rig.loop.takeRecord();
        if (isStop)
            rig.loop.emergencyStop();
        else
            setFault(rig.rig, SimulatedFault::RobotAlarm, 0, true);
        rig.periods(1);
        ASSERT_EQ(rig.loop.state(), RunState::Fault);
        const std::string outcome = isStop ? "emergency-stop" : "fault";
        EXPECT_EQ(rig.loop.outcome(), outcome);
        const double end_s = rig.loop.runTime_s();
        std::vector<TraceSample> samples;
        for (int i = 0; i < 3600 && rig.loop.isCooling(); ++i) {
            rig.periods(1);
            const LoopRecord rows = rig.loop.takeRecord();
            samples.insert(samples.end(), rows.samples.begin(), rows.samples.end());
        }
        EXPECT_FALSE(rig.loop.isCooling());
        ASSERT_GT(samples.size(), 30U);
        EXPECT_NEAR(samples.back().source_K, experiment.environment_K + kHandWarm_K, 1.0);
        EXPECT_NEAR(samples.front().time_s, end_s, 0.01) << "its time goes on";
        EXPECT_NEAR(samples.back().time_s, end_s + static_cast<double>(samples.size() - 1), 0.01);
        for (const ObjectSample& object : samples.back().objects)
            EXPECT_LT(object.estimated_K, kelvinFromCelsius(40.0));
        EXPECT_EQ(rig.loop.outcome(), outcome);
        rig.periods(10);
        EXPECT_TRUE(rig.loop.takeRecord().samples.empty());
    }
}

// Catches a record that ends while objects that are still cool stand before a hot source.
TEST(Safety, TheRecordGoesOnWhileObjectsCanStillWarm) {
    Experiment experiment = twoDisks(60.0);
    experiment.sampling = {1.0, 5, 2};
    SimulatedRig rig(simulatedRigConfig(experiment));
    ServoLoop loop(experiment, {rig.robot(), rig.thermometer(), rig.heatSource(), {}, nullptr, true},
                   rig.clock());
    const auto periods = [&](int count) {
        for (int i = 0; i < count; ++i) {
            rig.advance(1.0);
            loop.tick();
        }
    };
    periods(10);
    ASSERT_TRUE(loop.reset());
    periods(10);
    ASSERT_TRUE(loop.arm());
    ASSERT_TRUE(loop.start(true));
    periods(5);
    loop.emergencyStop();
    periods(20);
    EXPECT_TRUE(loop.isCooling());
    ASSERT_TRUE(loop.retreatNow());
    periods(120);
    EXPECT_TRUE(loop.isCooling()) << "off the source they stay as they are, but a hand would not";
    EXPECT_TRUE(loop.areObjectsCold());
    periods(2400);
    EXPECT_FALSE(loop.isCooling());
    EXPECT_LT(loop.latest().source_K, experiment.environment_K + kHandWarm_K);
}

// Catches a record that ends a second after STOP, a lost robot or its alarm, since the objects are still
// cool: what the hot source does then is told and not recorded.
TEST(Safety, TheRecordHasTheAlarmsOfASourceThatIsStillHot) {
    for (const SimulatedFault fault :
         {SimulatedFault::None, SimulatedFault::RobotLost, SimulatedFault::RobotAlarm}) {
        SCOPED_TRACE(simulatedFaultName(fault));
        Rig rig;
        rig.run(2.0);
        if (fault == SimulatedFault::None)
            rig.loop.emergencyStop();
        else
            setFault(rig.rig, fault, 0, true);
        ASSERT_LT(rig.until([&] { return rig.loop.state() == RunState::Fault; }, 10.0), 10.0);
        for (const ObjectSample& object : rig.loop.latest().objects)
            ASSERT_LT(object.estimated_K, kelvinFromCelsius(40.0));
        (void)rig.until([] { return false; }, 60.0);
        EXPECT_TRUE(rig.loop.isCooling());
        setFault(rig.rig, SimulatedFault::SourceHeatsAlone, 0, true);
        ASSERT_LT(rig.until([&] { return rig.isAlarm(MessageCode::SafetySourceHeatsUnasked); }, 60.0), 60.0);
        EXPECT_TRUE(rig.isRecorded(MessageCode::SafetySourceHeatsUnasked));
        EXPECT_FALSE(rig.isRecorded(MessageCode::EventCold));
        rig.periods(1);
        EXPECT_EQ(rig.loop.takeRecord().samples.size(), 1U) << "its samples, too";
    }
}

// Catches a source that tells nothing taken for a cold one.
TEST(Safety, TheRecordGoesOnWhileNobodyKnowsTheSource) {
    Experiment experiment = fastDisks();
    experiment.sampling = {1.0, 5, 2};
    Rig rig(experiment);
    rig.run(2.0);
    setFault(rig.rig, SimulatedFault::SourceSilent, 0, true);
    rig.loop.emergencyStop();
    rig.periods(1800); // by now it is cold
    EXPECT_TRUE(rig.loop.areObjectsCold());
    EXPECT_TRUE(rig.loop.isCooling());
    clearFaults(rig.rig);
    rig.periods(2);
    EXPECT_FALSE(rig.loop.isCooling());
}

// Catches a record without an end, since nobody types that the plate has cooled.
TEST(Safety, TheRecordDoesNotWaitForASourceThatAPersonHeats) {
    RigByHand rig;
    ASSERT_NO_FATAL_FAILURE(rig.startRun());
    rig.periods(20);
    rig.loop.emergencyStop();
    EXPECT_TRUE(rig.loop.isCooling());
    rig.periods(2);
    EXPECT_GT(rig.loop.latest().source_K, rig.experiment.environment_K + kHandWarm_K);
    EXPECT_FALSE(rig.loop.isCooling());
}

// Catches objects that are warm again and taken for cold: a board would be shown to the camera.
TEST(Safety, ObjectsThatWarmAgainAfterTheRunAreNotCold) {
    Rig rig;
    rig.run(2.0);
    rig.loop.emergencyStop();
    rig.periods(2);
    EXPECT_TRUE(rig.loop.areObjectsCold());
    setFault(rig.rig, SimulatedFault::ObjectHot, 0, true);
    EXPECT_LT(rig.until([&] { return !rig.loop.areObjectsCold(); }, 200.0), 200.0);
    EXPECT_TRUE(rig.loop.isCooling());
}

// Catches a record that goes on for days, since what it waits for is never told.
TEST(Safety, TheRecordEndsSixHoursAfterTheRunAtTheLatest) {
    Experiment experiment = fastDisks();
    experiment.sampling = {1.0, 5, 2};
    Rig rig(experiment);
    rig.run(2.0);
    setFault(rig.rig, SimulatedFault::SourceSilent, 0, true);
    rig.loop.emergencyStop();
    rig.rig.advance(5.9 * 3600.0);
    rig.periods(1);
    EXPECT_TRUE(rig.loop.isCooling());
    rig.rig.advance(0.2 * 3600.0);
    (void)rig.until([] { return false; }, 1.0);
    EXPECT_FALSE(rig.loop.isCooling());
    EXPECT_TRUE(rig.isRecorded(MessageCode::EventRecordEnded));
    EXPECT_FALSE(rig.isRecorded(MessageCode::EventCold));
}

// Catches a record that delays the next run, or is delayed with nobody there who waits for it.
TEST(Safety, AHotSourceDelaysNeitherResetNorTheNextRunNorAHeadlessOne) {
    Rig rig;
    rig.run(2.0);
    rig.loop.emergencyStop();
    EXPECT_EQ(rig.loop.outcome(), "emergency-stop");
    rig.periods(1);
    ASSERT_TRUE(rig.loop.reset());
    rig.periods(60);
    EXPECT_TRUE(rig.loop.isCooling()) << "a reset cools nothing";
    ASSERT_TRUE(rig.loop.arm());
    EXPECT_FALSE(rig.loop.isCooling());
    ASSERT_TRUE(rig.loop.start(true));
    rig.periods(10);
    rig.loop.setRecordEnd(RecordEnd::ObjectsCold);
    rig.loop.emergencyStop();
    EXPECT_TRUE(rig.loop.isCooling());
    rig.periods(2);
    EXPECT_FALSE(rig.loop.isCooling());
}

// Catches a disk that fills up unnoticed.
TEST(Safety, AFullDiskIsToldOnceAndIsOverWhenThereIsRoom) {
    Rig rig;
    rig.run(1.0);
    rig.loop.setDiskFree_MB(99.0);
    rig.periods(1);
    EXPECT_TRUE(rig.isAlarm(MessageCode::SafetyDiskLow));
    rig.loop.setDiskFree_MB(105.0); // within the hysteresis
    rig.periods(1);
    EXPECT_TRUE(rig.isAlarm(MessageCode::SafetyDiskLow));
    rig.loop.setDiskFree_MB(120.0);
    rig.periods(1);
    EXPECT_FALSE(rig.isAlarm(MessageCode::SafetyDiskLow));
}

// Catches a script that is not played, at other times than its own, or that is not in the session.
TEST(Safety, AScriptedFaultIsInTheRecordWithWhatWasDone) {
    const QTemporaryDir folder;
    Experiment experiment = fastDisks();
    experiment.simulation.faults = {{10.0, SimulatedFault::SensorOpen, 1, 12.0},
                                    {15.0, SimulatedFault::RobotLost, 0, {}}};
    SimulatedRunOptions options;
    options.duration_s = 30.0;
    options.sessionPath = folder.filePath("faults.bask").toStdString();
    const auto outcome = runSimulated(experiment, options);
    ASSERT_TRUE(outcome) << describe(outcome.error());
    EXPECT_TRUE(outcome->fault);
    const auto session = readSession(options.sessionPath);
    ASSERT_TRUE(session) << describe(session.error());
    EXPECT_EQ(session->outcome, "fault");
    const auto at_s = [&](const Message& message) {
        const auto event = std::ranges::find(session->events, message, &TraceEvent::message);
        return event == session->events.end() ? -1.0 : event->time_s;
    };
    EXPECT_NEAR(at_s({MessageCode::EventObjectFault, {"sensor-open", "right"}}), 10.0, 0.11);
    EXPECT_NEAR(at_s({MessageCode::SafetySensorOpen, {"right"}}), 10.4, 0.21);
    EXPECT_NEAR(at_s({MessageCode::EventSensorBack, {"right"}}), 12.1, 0.21);
    EXPECT_NEAR(at_s({MessageCode::ReasonRobotLost, {"simulated link lost"}}), 15.1, 0.21);
}

// Examples as they are shipped. Catches limits that cry wolf.
TEST(Safety, NoFalseAlarmOverExamples) {
    for (const std::string name : {"three-objects.json", "paper-adaptive.json", "bare-aluminium.json",
                                   "paper/unfeasible-targets-80-80-80.json"}) {
        const auto experiment = readExperiment(BASK_EXAMPLES "/" + name);
        ASSERT_TRUE(experiment) << describe(experiment.error());
        SimulatedRunOptions options;
        options.duration_s = std::min(2400.0, experiment->simulation.durationLimit_s);
        const auto outcome = runSimulated(*experiment, options);
        ASSERT_TRUE(outcome);
        for (const TraceEvent& event : outcome->events)
            EXPECT_TRUE(alarmPriority(event.message.code) == 0 || isNotice(event.message.code))
                << name << " at " << event.time_s << ": " << describe(event.message);
    }
}

} // namespace bask
