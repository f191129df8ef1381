// Ways from the heat in every state: by the verb, and by itself after a countdown; a robot that does not go.

#include "engine/base/message_code.h"
#include "engine/runtime/fault_script.h"
#include "tests/engine/runtime/loop_on_rig.h"

namespace bask {
namespace {

Experiment nearSource() {
    Experiment experiment = twoDisks(40.0);
    experiment.sampling = {0.1, 30, 2};
    experiment.start[kZ] = 0.06;
    return experiment;
}

/// Takes orders, and does not move where its drives are off.
struct WeakRobot final : Robot {
    explicit WeakRobot(Robot& from) : inner(from) {}
    Result<RobotState> state() override {
        auto state = inner.state();
        if (state)
            state->moving = state->moving || isHoming;
        return state;
    }
    Result<void> setTwist(const Vector6d& twist, double validFor_s) override {
        return isOff ? Result<void>() : inner.setTwist(twist, validFor_s);
    }
    Result<void> halt() override { return inner.halt(); }
    Result<void> home() override { return inner.home(); }
    void setRetreating(bool isRetreating) override { isRetreat = isRetreating; }
    Result<void> clearAlarm() override { return inner.clearAlarm(); }
    std::optional<RobotLag> lagAt(double speed_m_s, double, double validFor_s) const override {
        asked_m_s = speed_m_s;
        asked_s = validFor_s;
        return lag;
    }
    RobotReach reach() const override { return own; }
    Robot& inner;
    std::optional<RobotLag> lag;
    RobotReach own;
    mutable double asked_m_s = 0.0, asked_s = 0.0;
    bool isOff = false, isHoming = false, isRetreat = false;
};

struct Bench {
    Bench()
        : rig(simulatedRigConfig(experiment)), robot(rig.robot()),
          loop(experiment, {robot, rig.thermometer(), rig.heatSource(), {}}, rig.clock()) {
        periods(40);
    }
    void periods(int count) {
        for (int i = 0; i < count; ++i) {
            rig.advance(experiment.sampling.period_s);
            loop.tick();
            for (const TraceEvent& event : loop.takeRecord().events)
                events.push_back(event.message);
        }
    }
    template <class Condition> bool until(Condition condition, double max_s) {
        for (double s = 0.0; s < max_s && !condition(); s += experiment.sampling.period_s)
            periods(1);
        return condition();
    }
    void run(double for_s) {
        ASSERT_TRUE(loop.arm());
        ASSERT_TRUE(loop.start(true));
        periods(static_cast<int>(for_s / experiment.sampling.period_s));
        ASSERT_TRUE(loop.state() == RunState::Running || loop.state() == RunState::Settled);
    }
    bool isAlarm(MessageCode code) const {
        return std::ranges::any_of(loop.alarmConditions(),
                                   [&](const AlarmCondition& c) { return c.message.code == code; });
    }
    bool isHot() const { return isAlarm(MessageCode::SafetyObjectHot); }
    bool isAway() const {
        return std::abs(rig.simulatedRobot().coordinates()[kZ] - experiment.robot.upper[kZ]) < 2e-3;
    }
    std::size_t told(MessageCode code) const {
        return static_cast<std::size_t>(std::ranges::count(events, code, &Message::code));
    }

    Experiment experiment = nearSource();
    mutable SimulatedRig rig;
    WeakRobot robot;
    ServoLoop loop;
    std::vector<Message> events;
};

} // namespace

// Catches a workspace beyond what the robot reaches: the retreat would end where the robot's own limits are.
TEST(Retreat, AWorkspaceBeyondTheRobotsReachIsNotReady) {
    Bench rig;
    ASSERT_EQ(rig.loop.state(), RunState::Ready);
    rig.robot.own.upper[kZ] = rig.experiment.robot.upper[kZ] - 0.05;
    rig.periods(1);
    EXPECT_EQ(rig.loop.state(), RunState::NotReady);
    const auto reasons = rig.loop.reasons();
    ASSERT_EQ(reasons.size(), 1U);
    EXPECT_EQ(reasons.front().code, MessageCode::ReasonReachShort);
    EXPECT_FALSE(rig.loop.arm());
    rig.robot.own.upper[kZ] = rig.experiment.robot.upper[kZ];
    rig.robot.own.lower[kY] = rig.experiment.robot.lower[kY] + 0.001;
    rig.periods(1);
    EXPECT_EQ(rig.loop.state(), RunState::NotReady);
    rig.robot.own.lower[kY] = rig.experiment.robot.lower[kY];
    rig.robot.own.upper[kThetaZ] = -1.0; // it is not free
    rig.periods(1);
    EXPECT_EQ(rig.loop.state(), RunState::Ready);
}

// Catches an object over its limit before a plate that stays hot, with no way out but by hand.
TEST(Retreat, TheVerbTakesObjectsAwayInEveryState) {
    for (const std::string state : {"ready", "armed", "running", "holding", "stop", "hiccup", "stopped"}) {
        Bench rig;
        if (state == "armed") {
            ASSERT_TRUE(rig.loop.arm());
        }
        if (state == "running" || state == "holding" || state == "stop" || state == "stopped")
            rig.run(2.0);
        if (state == "holding") {
            ASSERT_TRUE(rig.loop.hold());
        }
        if (state == "stop")
            rig.loop.emergencyStop();
        if (state == "stopped") {
            ASSERT_TRUE(rig.loop.stop());
            ASSERT_TRUE(rig.until([&] { return rig.loop.state() == RunState::Stopped; }, 60.0));
            Vector6d goal = rig.experiment.start;
            ASSERT_TRUE(rig.loop.moveTo(goal));
            ASSERT_TRUE(rig.until([&] { return !rig.loop.motion().isMoving(); }, 60.0));
        }
        if (state == "hiccup") {
            setFault(rig.rig, SimulatedFault::RobotAlarm, 0, true);
            rig.periods(2);
            const auto refused = rig.loop.retreatNow();
            ASSERT_FALSE(refused) << "it cannot move";
            EXPECT_EQ(refused.error().code(), MessageCode::RobotAlarm);
            setFault(rig.rig, SimulatedFault::RobotAlarm, 0, false);
            rig.periods(1);
        }
        EXPECT_FALSE(rig.isAway());
        const bool isFault = rig.loop.state() == RunState::Fault;
        const std::string outcome = rig.loop.outcome();
        EXPECT_EQ(rig.loop.keepsFromRetreat(), Message{}) << state;
        ASSERT_TRUE(rig.loop.retreatNow()) << state;
        EXPECT_EQ(rig.loop.state(), RunState::Stopping) << state;
        EXPECT_FALSE(rig.loop.heat().isOn());
        ASSERT_TRUE(rig.until([&] { return rig.loop.state() != RunState::Stopping; }, 60.0)) << state;
        EXPECT_TRUE(rig.isAway()) << state;
        EXPECT_EQ(rig.loop.state() == RunState::Fault, isFault)
            << state << ": it clears no fault, and makes none";
        if (isFault) {
            EXPECT_EQ(rig.loop.outcome(), outcome);
            EXPECT_TRUE(rig.loop.reset());
        }
    }
}

// Catches an object that gets hot after STOP and is left where it is; and a robot that moves without a word.
TEST(Retreat, AHotObjectInAFaultIsTakenAwayAfterACountdown) {
    Bench rig;
    rig.run(2.0);
    rig.loop.emergencyStop();
    setFault(rig.rig, SimulatedFault::ObjectHot, 1, true);
    ASSERT_TRUE(rig.until([&] { return rig.isHot(); }, 80.0));
    const auto pending = rig.loop.pending();
    ASSERT_TRUE(pending);
    EXPECT_EQ(pending->action.code, MessageCode::ActionRetreat);
    EXPECT_EQ(pending->cause.code, MessageCode::SafetyObjectHot);
    EXPECT_EQ(pending->cause.args.front(), "right");
    EXPECT_NEAR(pending->in_s, 10.0, 0.11);
    const Vector6d at = rig.rig.simulatedRobot().coordinates();
    rig.periods(98);
    EXPECT_EQ(rig.rig.simulatedRobot().coordinates(), at);
    EXPECT_NEAR(rig.loop.pending()->in_s, 0.2, 0.11);
    EXPECT_FALSE(rig.loop.reset()) << "it is hot";
    rig.periods(4);
    EXPECT_EQ(rig.loop.state(), RunState::Stopping);
    EXPECT_EQ(rig.told(MessageCode::EventRetreatFor), 1U);
    ASSERT_TRUE(rig.until([&] { return rig.loop.state() == RunState::Fault; }, 60.0));
    EXPECT_TRUE(rig.isAway());
    EXPECT_FALSE(rig.loop.pending());
    EXPECT_EQ(rig.loop.outcome(), "emergency-stop");
    EXPECT_EQ(rig.loop.reasons().front().code, MessageCode::ReasonEmergencyStop);
}

// Catches a STOP that the engine overrules.
TEST(Retreat, StopRefusesTheOneThatIsAnnouncedAndTheOneThatGoes) {
    for (const bool isMoving : {false, true}) {
        Bench rig;
        rig.loop.emergencyStop();
        setFault(rig.rig, SimulatedFault::ObjectHot, 1, true);
        ASSERT_TRUE(rig.until([&] { return rig.loop.pending().has_value(); }, 80.0));
        rig.periods(isMoving ? 110 : 50);
        ASSERT_EQ(rig.loop.state(), isMoving ? RunState::Stopping : RunState::Fault);
        rig.loop.emergencyStop();
        const Vector6d at = rig.rig.simulatedRobot().coordinates();
        rig.periods(200);
        rig.loop.emergencyStop(); // once more changes nothing
        rig.periods(200);
        EXPECT_TRUE(rig.isHot());
        EXPECT_FALSE(rig.loop.pending());
        EXPECT_EQ(rig.rig.simulatedRobot().coordinates(), at);
        EXPECT_EQ(rig.loop.remedy().code, MessageCode::RemedyRetreat);
        ASSERT_TRUE(rig.loop.retreatNow());
        ASSERT_TRUE(rig.until([&] { return rig.loop.state() == RunState::Fault; }, 60.0));
        EXPECT_TRUE(rig.isAway());
    }
}

// Catches a retreat that is called off because nobody sees the object any more.
TEST(Retreat, AnObjectIsHotUntilItIsSeenNotToBe) {
    Bench rig;
    rig.run(2.0);
    rig.loop.emergencyStop();
    setFault(rig.rig, SimulatedFault::ObjectHot, 1, true);
    ASSERT_TRUE(rig.until([&] { return rig.loop.pending().has_value(); }, 80.0));
    setFault(rig.rig, SimulatedFault::SensorOpen, 1, true);
    rig.periods(50);
    EXPECT_TRUE(rig.isHot());
    EXPECT_TRUE(rig.loop.pending());
    ASSERT_TRUE(rig.until([&] { return rig.loop.state() == RunState::Stopping; }, 10.0));
    ASSERT_TRUE(rig.until([&] { return rig.loop.state() == RunState::Fault; }, 60.0));
    EXPECT_TRUE(rig.isAway());
    EXPECT_TRUE(rig.robot.isRetreat == false);
}

// Catches a retreat that begins while the robot homes, waits for it in vain and breaks the homing off.
TEST(Retreat, WaitsForHoming) {
    Bench rig;
    ASSERT_TRUE(rig.loop.home());
    rig.robot.isHoming = rig.robot.isOff = true;
    rig.periods(2);
    for (const auto& refused : {rig.loop.arm(), rig.loop.moveTo(rig.experiment.start),
                                rig.loop.jog((Vector6d() << 0.01, 0, 0, 0, 0, 0).finished())}) {
        ASSERT_FALSE(refused);
        EXPECT_EQ(refused.error().code(), MessageCode::CommandNotNow);
    }
    setFault(rig.rig, SimulatedFault::ObjectHot, 1, true);
    ASSERT_TRUE(rig.until([&] { return rig.loop.state() == RunState::Stopping; }, 80.0));
    rig.periods(200); // longer than a robot may stand
    EXPECT_EQ(rig.loop.state(), RunState::Stopping);
    EXPECT_FALSE(rig.isAlarm(MessageCode::RobotDoesNotMove));
    rig.robot.isHoming = rig.robot.isOff = false;
    ASSERT_TRUE(rig.until([&] { return rig.loop.state() == RunState::Fault; }, 60.0));
    EXPECT_TRUE(rig.isAway());
}

// Catches a move by hand that never gets anywhere, and is on for ever without a word.
TEST(Retreat, AMoveThatDoesNotBeginIsAnAlarm) {
    Bench rig;
    rig.robot.isOff = true;
    Vector6d goal = rig.experiment.start;
    goal[kZ] += 0.02;
    ASSERT_TRUE(rig.loop.moveTo(goal));
    ASSERT_TRUE(rig.until([&] { return rig.loop.state() == RunState::Fault; }, 20.0));
    EXPECT_TRUE(rig.isAlarm(MessageCode::RobotDoesNotMove));
    EXPECT_FALSE(rig.loop.motion().isMoving());
}

// Catches a robot that nobody can trust, sent through the rig by itself.
TEST(Retreat, NothingMovesByItselfWithoutAPlace) {
    Bench rig;
    setFault(rig.rig, SimulatedFault::RobotRestarted, 0, true);
    setFault(rig.rig, SimulatedFault::ObjectHot, 1, true);
    ASSERT_TRUE(rig.until([&] { return rig.isHot(); }, 80.0));
    rig.periods(150);
    EXPECT_EQ(rig.loop.state(), RunState::Fault);
    EXPECT_FALSE(rig.loop.pending());
    EXPECT_FALSE(rig.isAway());
    ASSERT_TRUE(rig.loop.retreatNow()) << "a person sees where it goes";
    ASSERT_TRUE(rig.until([&] { return rig.loop.state() == RunState::Fault; }, 60.0));
    EXPECT_TRUE(rig.isAway());
}

// Catches a move that never began, taken for one that has arrived.
TEST(Retreat, ARobotThatDoesNotMoveIsAnAlarm) {
    Bench rig;
    rig.run(2.0);
    rig.robot.isOff = true;
    ASSERT_TRUE(rig.loop.stop());
    ASSERT_TRUE(rig.until([&] { return rig.loop.state() != RunState::Stopping; }, 60.0));
    EXPECT_EQ(rig.loop.state(), RunState::Fault);
    EXPECT_TRUE(rig.isAlarm(MessageCode::RobotDoesNotMove));
    EXPECT_EQ(rig.told(MessageCode::RobotDoesNotMove), 1U);
    EXPECT_EQ(rig.loop.outcome(), "fault");
    rig.robot.isOff = false;
    ASSERT_TRUE(rig.loop.retreatNow());
    ASSERT_TRUE(rig.until([&] { return rig.loop.state() == RunState::Fault; }, 60.0));
    EXPECT_TRUE(rig.isAway());
    EXPECT_TRUE(rig.loop.reset());
}

// Catches a retreat that takes far longer than anybody was told before the run.
TEST(Retreat, ASlowOneIsToldBeforeTheRun) {
    Bench rig;
    EXPECT_FALSE(rig.isAlarm(MessageCode::SafetyRobotSluggish));
    EXPECT_EQ(rig.robot.asked_m_s, rig.experiment.robot.maxSpeed_m_s);
    EXPECT_NEAR(rig.robot.asked_s, 0.15, 1e-12) << "as its velocities are valid";
    rig.robot.lag = RobotLag{"$120=10", 0.15, 1.1, 0.0029};
    ASSERT_TRUE(rig.until([&] { return rig.isAlarm(MessageCode::SafetyRobotSluggish); }, 2.0));
    const auto conditions = rig.loop.alarmConditions();
    const auto told = std::ranges::find(conditions, MessageCode::SafetyRobotSluggish,
                                        [](const AlarmCondition& c) { return c.message.code; });
    EXPECT_EQ(told->message.args.at(3), "100") << "over the whole height of the workspace";
    EXPECT_EQ(rig.loop.state(), RunState::Ready);
    rig.run(1.0); // told, not forbidden
}

// Catches a countdown that is missing or wrong where the engine waits for a person.
TEST(Pending, TellsWhatALostSensorWillLeadTo) {
    Bench rig;
    rig.run(2.0);
    EXPECT_FALSE(rig.loop.pending());
    setFault(rig.rig, SimulatedFault::SensorOpen, 0, true);
    ASSERT_TRUE(rig.until([&] { return rig.loop.state() == RunState::Holding; }, 2.0));
    auto pending = rig.loop.pending();
    ASSERT_TRUE(pending);
    EXPECT_EQ(pending->action.code, MessageCode::ActionEndRun);
    EXPECT_EQ(pending->cause, (Message{MessageCode::SafetySensorOpen, {"left"}}));
    EXPECT_NEAR(pending->in_s, rig.experiment.safety.pauseLimit_s, 0.11);
    EXPECT_EQ(rig.loop.remedy().code, MessageCode::RemedyStop);
    const double in_s = pending->in_s;
    rig.periods(static_cast<int>(in_s / 0.1) - 2);
    EXPECT_EQ(rig.loop.state(), RunState::Holding);
    rig.periods(5);
    EXPECT_EQ(rig.loop.state(), RunState::Stopping);
    EXPECT_FALSE(rig.loop.pending());
}

TEST(Pending, ASensorThatComesBackEndsTheCountdown) {
    Bench rig;
    rig.run(2.0);
    setFault(rig.rig, SimulatedFault::SensorOpen, 0, true);
    ASSERT_TRUE(rig.until([&] { return rig.loop.pending().has_value(); }, 2.0));
    setFault(rig.rig, SimulatedFault::SensorOpen, 0, false);
    ASSERT_TRUE(rig.until([&] { return !rig.loop.pending(); }, 2.0));
    EXPECT_EQ(rig.loop.state(), RunState::Holding);
    EXPECT_EQ(rig.loop.remedy().code, MessageCode::RemedyResume);
}

} // namespace bask
