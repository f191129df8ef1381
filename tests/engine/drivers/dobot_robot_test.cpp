#include "engine/device_simulators/dobot_simulator.h"
#include "engine/drivers/dobot_robot.h"
#include "tests/engine/drivers/test_links.h"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <random>

namespace bask::test {
namespace {

const std::vector<AxisSpec> kArmAxes{{'X', 0, false, 0.0}, {'Y', 1, false, 0.0}, {'Z', 2, false, 0.0}};

class DobotRobotTest : public testing::Test {
protected:
    void make(const DobotSimulatorConfig& config = {}, std::vector<AxisSpec> axes = kArmAxes) {
        m_robot.reset();
        m_arm = std::make_unique<DobotSimulator>(config);
        m_dashboard = std::make_unique<DeviceLink>(m_arm->dashboard(), m_clock);
        m_motion = std::make_unique<DeviceLink>(m_arm->motion(), m_clock);
        m_feedback = std::make_unique<DeviceLink>(m_arm->feedback(), m_clock);
        m_robot = std::make_unique<DobotRobot>(
            *m_dashboard, *m_motion, *m_feedback, m_clock, AxisMap(std::move(axes), Vector6d::Zero()),
            [this](const Vector6d& target) { return m_guard(target); }, config.fullSpeed_mm_s);
    }
    void makeLive(const DobotSimulatorConfig& config = {}) {
        make(config);
        run(0.5);
        ASSERT_EQ(m_robot->status().link, LinkState::Live) << describe(m_robot->status().problem);
    }
    void run(double time_s) {
        for (const double end_s = m_clock.now_s() + time_s; m_clock.now_s() < end_s - 1e-9;) {
            m_clock.advance(0.005);
            m_robot->work();
        }
    }
    bool drive(const Vector6d& twist, double time_s) {
        bool isTaken = false;
        for (double t = 0.0; t < time_s - 1e-9; t += 0.1) {
            isTaken = m_robot->setTwist(twist, 0.15).ok();
            run(0.1);
        }
        return isTaken;
    }
    MessageCode alarm() {
        const auto state = m_robot->state();
        return state ? state->alarm.code : state.error().code();
    }
    double y() const { return m_arm->position()[1]; }
    /// The largest over 20 ms each while it is driven, mm/s.
    double fastest_mm_s(const Vector6d& twist, double time_s) {
        double out = 0.0;
        for (double t = 0.0; t < time_s - 1e-9; t += 0.02) {
            const double before = y();
            if (std::fmod(t + 1e-9, 0.1) < 0.02)
                (void)m_robot->setTwist(twist, 0.15);
            run(0.02);
            out = std::max(out, (y() - before) / 0.02);
        }
        return out;
    }

    ManualClock m_clock;
    MotionGuard m_guard = [](const Vector6d&) { return true; };
    std::unique_ptr<DobotSimulator> m_arm;
    std::unique_ptr<DeviceLink> m_dashboard, m_motion, m_feedback;
    std::unique_ptr<DobotRobot> m_robot;
    const Vector6d m_left = (Vector6d() << 0, 0.005, 0, 0, 0, 0).finished(); ///< 5 mm/s
};

// Catches a place in other units or of another axis, and one that is told newer than it was measured.
TEST_F(DobotRobotTest, TellsWhereItIs) {
    make({}, {{'Z', 2, false, 0.0}, {'R', 5, false, 0.1}});
    EXPECT_EQ(m_robot->status().link, LinkState::Closed);
    run(0.5);
    const auto state = m_robot->state();
    ASSERT_TRUE(state);
    EXPECT_TRUE(state->coordinates.isApprox((Vector6d() << 0, 0, 0.05, 0, 0, 0.1).finished(), 1e-12));
    EXPECT_TRUE(state->isPlaceSure);
    EXPECT_LE(state->time_s, m_clock.now_s() - 0.008);
    EXPECT_GT(state->time_s, m_clock.now_s() - 0.03);
    EXPECT_EQ(m_robot->home().error().code(), MessageCode::RobotCannotHome);
}

// Catches a velocity that is not held, the axes that have no coordinate moved, or motion that does not
// expire.
TEST_F(DobotRobotTest, FollowsAVelocity) {
    makeLive();
    EXPECT_TRUE(drive(m_left, 10.0));
    EXPECT_GT(y(), 0.6 * 50.0);
    EXPECT_LT(y(), 50.0 + 0.75);
    RecordProperty("mm_of_50", std::to_string(y()));
    run(0.4);
    const double stood = y();
    run(2.0);
    EXPECT_EQ(y(), stood);
    EXPECT_DOUBLE_EQ(m_arm->position()[3], 0.0);
    EXPECT_EQ(m_robot->discarded(), 0);
    EXPECT_FALSE(m_robot->state()->moving);
}

// Catches moves that are quicker than the experiment allows: twice as quick to make up for the pauses, or
// rounded up to a percentage of the arm's own speed.
TEST_F(DobotRobotTest, NoMoveIsQuickerThanItIsLimitedTo) {
    for (const double largest_m_s : {0.02, 0.005, 0.0007}) {
        makeLive();
        m_robot->limitSpeed(largest_m_s, 0.1);
        run(0.5);
        const double from = y();
        const Vector6d wanted = largest_m_s / 0.005 * m_left;
        EXPECT_LE(fastest_mm_s(wanted, 5.0), 1000.0 * largest_m_s * 1.01 + 1e-9) << largest_m_s;
        EXPECT_GT(y() - from, 0.6 * 5000.0 * largest_m_s) << largest_m_s;
        EXPECT_EQ(alarm(), MessageCode::None) << describe(m_robot->state()->alarm);
    }
}

// Catches an arm whose own full speed is set otherwise than it is taken for.
TEST_F(DobotRobotTest, AnArmThatIsTooQuickIsStopped) {
    DobotSimulatorConfig config;
    makeLive(config);
    config.fullSpeed_mm_s = 2000.0;
    m_robot.reset();
    m_arm = std::make_unique<DobotSimulator>(config);
    m_dashboard = std::make_unique<DeviceLink>(m_arm->dashboard(), m_clock);
    m_motion = std::make_unique<DeviceLink>(m_arm->motion(), m_clock);
    m_feedback = std::make_unique<DeviceLink>(m_arm->feedback(), m_clock);
    m_robot = std::make_unique<DobotRobot>(*m_dashboard, *m_motion, *m_feedback, m_clock,
                                           AxisMap(kArmAxes, Vector6d::Zero()),
                                           [](const Vector6d&) { return true; });
    run(0.5);
    const double from = y();
    drive(4.0 * m_left, 1.0);
    EXPECT_EQ(m_robot->state()->alarm.args.at(1).text().find("it moves faster than it may"), 0U);
    EXPECT_LT(y() - from, 20.0);
    const double stood = y();
    run(1.0);
    EXPECT_EQ(y(), stood);
}

// Catches a halt that comes to the arm before the move that it is for, and is not repeated.
TEST_F(DobotRobotTest, AHaltThatOvertakesItsMoveStillStopsIt) {
    DobotSimulatorConfig config;
    config.moveDelay_s = 0.2;
    config.fullSpeed_mm_s = 100.0;
    makeLive(config);
    ASSERT_TRUE(m_robot->setTwist(4.0 * m_left, 0.5)); // 10 mm
    run(0.05);
    EXPECT_TRUE(m_robot->halt());
    EXPECT_TRUE(m_robot->state()->moving);
    run(3.0);
    EXPECT_LT(y(), 2.5);
    EXPECT_GT(y(), 0.0); // it had begun
    EXPECT_FALSE(m_robot->state()->moving);
    EXPECT_EQ(alarm(), MessageCode::None);
    m_dashboard->takeSent();
    EXPECT_TRUE(m_robot->halt());
    EXPECT_EQ(m_dashboard->takeSent(), "");
    EXPECT_TRUE(drive(m_left, 2.0));
    EXPECT_GT(y(), 3.0);
}

// Catches an arm in alarm that is driven on, or whose alarm has no number, or cannot be ended.
TEST_F(DobotRobotTest, AlarmsAreToldAndCleared) {
    makeLive();
    drive(m_left, 1.0);
    ASSERT_TRUE(m_arm->setFault("alarm"));
    run(0.2);
    EXPECT_EQ(m_robot->state()->alarm,
              (Message{MessageCode::RobotAlarm, {"22", "as listed in the robot's manual"}}));
    EXPECT_EQ(m_robot->setTwist(m_left, 0.1).error().code(), MessageCode::RobotAlarm);
    EXPECT_TRUE(m_robot->clearAlarm());
    run(0.5);
    EXPECT_EQ(m_arm->mode(), DobotMode::Idle);
    EXPECT_EQ(alarm(), MessageCode::None);
    EXPECT_TRUE(m_robot->state()->isPlaceSure); // absolute encoders
    EXPECT_TRUE(drive(m_left, 1.0));
}

// Catches steps that pile up in a queue that an alarm has stopped, or that go off together when it is
// started; and one that is stopped without a word.
TEST_F(DobotRobotTest, AStoppedQueueIsEmptiedAndContinued) {
    DobotSimulatorConfig config;
    config.fullSpeed_mm_s = 100.0;
    makeLive(config);
    ASSERT_TRUE(m_robot->setTwist(4.0 * m_left, 0.5));
    run(0.15);
    ASSERT_TRUE(m_arm->setFault("alarm"));
    run(0.2);
    const double stood = y();
    ASSERT_EQ(m_arm->queued(), 1U);
    m_dashboard->takeSent();
    EXPECT_TRUE(m_robot->clearAlarm());
    run(1.0);
    const std::string sent = m_dashboard->takeSent();
    EXPECT_LT(sent.find("ClearError()"), sent.find("ResetRobot()"));
    EXPECT_LT(sent.find("ResetRobot()"), sent.find("EnableRobot()"));
    EXPECT_LT(sent.rfind("ResetRobot()"), sent.find("User(0)"));
    EXPECT_LT(sent.find("Tool(0)"), sent.find("Continue()"));
    EXPECT_NE(sent.find("Continue()"), std::string::npos);
    EXPECT_EQ(y(), stood);
    EXPECT_EQ(alarm(), MessageCode::None);
    EXPECT_TRUE(drive(m_left, 1.0));
    EXPECT_GT(y(), stood + 2.0);
}

// Catches a step that was taken and never made, counted as made and followed by the next.
TEST_F(DobotRobotTest, AStepThatIsNotCarriedOutIsToldAndDropped) {
    makeLive();
    const auto ask = [&](const char* command) { m_arm->dashboard().receive(command, m_clock.now_s()); };
    ASSERT_TRUE(m_arm->setFault("alarm")); // so short that no packet tells
    ask("ClearError()");
    ask("EnableRobot()");
    m_feedback->work();
    run(0.5);
    for (int i = 0; i < 10; ++i) {
        drive(m_left, 0.1);
        ASSERT_LE(m_arm->queued(), 1U);
    }
    run(0.5);
    EXPECT_EQ(m_arm->queued(), 0U);
    EXPECT_EQ(m_robot->state()->alarm.args.at(1), "a step was taken and not carried out");
    EXPECT_FALSE(drive(m_left, 0.2));
    EXPECT_TRUE(m_robot->clearAlarm());
    EXPECT_TRUE(drive(m_left, 1.0));
    EXPECT_GT(y(), 2.0);
}

// Catches a place that is told, and moves that are made, in frames that somebody chose before.
TEST_F(DobotRobotTest, FramesAreChosenAndWatched) {
    DobotSimulatorConfig config;
    config.user = 2;
    config.tool = 1;
    config.startsDisabled = true;
    makeLive(config);
    EXPECT_FALSE(m_robot->state()->isPlaceSure);
    EXPECT_EQ(alarm(), MessageCode::RobotDisabled);
    EXPECT_TRUE(m_robot->clearAlarm());
    run(0.5);
    EXPECT_EQ(alarm(), MessageCode::None);
    EXPECT_TRUE(m_robot->state()->isPlaceSure);
    EXPECT_TRUE(drive(m_left, 1.0));
    run(1.0);
    m_arm->dashboard().receive("Tool(3)", m_clock.now_s());
    run(1.0);
    EXPECT_EQ(m_robot->state()->alarm.args.at(1), "it moves in another frame than user 0 and tool 0");
    m_motion->takeSent();
    EXPECT_FALSE(drive(m_left, 0.5));
    EXPECT_EQ(m_motion->takeSent(), "");
    EXPECT_TRUE(m_robot->clearAlarm());
    run(0.5);
    EXPECT_EQ(alarm(), MessageCode::None);
    EXPECT_TRUE(drive(m_left, 0.5));
}

// Catches an arm that is far slower than it is taken for, and one whose speed was left at a part by somebody.
TEST_F(DobotRobotTest, ItsSpeedIsKnown) {
    DobotSimulatorConfig config;
    config.speedFactor = 0.01;
    makeLive(config);
    m_robot->limitSpeed(0.1, 0.1);
    run(0.5);
    EXPECT_TRUE(drive(m_left, 3.0));
    EXPECT_GT(y(), 8.0);
    run(1.0);
    m_arm->dashboard().receive("SpeedFactor(1)", m_clock.now_s());
    m_dashboard->takeSent();
    EXPECT_FALSE(drive(m_left, 2.0));
    EXPECT_EQ(m_robot->state()->alarm.args.at(1).text().find("a step took over twice its time"), 0U);
    EXPECT_NE(m_dashboard->takeSent().find("ResetRobot()"), std::string::npos);
    EXPECT_FALSE(m_robot->state()->moving);
    EXPECT_TRUE(m_robot->clearAlarm());
    EXPECT_TRUE(drive(m_left, 1.0));
}

// Catches a slow arm, a step that was not carried out or another frame in place of an engine that was held
// up: what it reads then had waited, and is of the time that the packets tell.
TEST_F(DobotRobotTest, AStallOfTheEngineIsNoLateStep) {
    makeLive();
    for (int i = 0; i < 30; ++i) {
        ASSERT_TRUE(m_robot->setTwist(m_left, 0.15));
        run(0.005 + 0.005 * i);
        for (int k = 0; k < 110; ++k) { // the links hold it all
            m_clock.advance(0.01);
            m_motion->work();
            m_feedback->work();
        }
        run(0.3);
        ASSERT_EQ(alarm(), MessageCode::None) << i << ' ' << describe(m_robot->state()->alarm);
    }
    EXPECT_GT(y(), 10.0);
}

// Catches an arm that is enabled by itself, or not when a person says so.
TEST_F(DobotRobotTest, ADisabledArmIsEnabledByAPerson) {
    DobotSimulatorConfig config;
    config.startsDisabled = true;
    makeLive(config);
    EXPECT_EQ(alarm(), MessageCode::RobotDisabled);
    run(10.0);
    EXPECT_EQ(m_arm->mode(), DobotMode::Disabled);
    EXPECT_TRUE(m_robot->clearAlarm());
    run(0.5);
    EXPECT_EQ(alarm(), MessageCode::None);
    EXPECT_TRUE(drive(m_left, 1.0));
    ASSERT_TRUE(m_arm->setFault("disabled"));
    run(6.0);
    EXPECT_FALSE(drive(m_left, 0.2));
    EXPECT_EQ(alarm(), MessageCode::RobotDisabled);
}

// Catches a paused move that goes on when the pause is cleared.
TEST_F(DobotRobotTest, APauseIsDropped) {
    DobotSimulatorConfig config;
    config.fullSpeed_mm_s = 100.0;
    makeLive(config);
    ASSERT_TRUE(m_robot->setTwist(4.0 * m_left, 0.5));
    run(0.15);
    ASSERT_TRUE(m_arm->setFault("paused"));
    run(0.5);
    EXPECT_EQ(alarm(), MessageCode::RobotHeld);
    const double stood = y();
    EXPECT_TRUE(m_robot->clearAlarm());
    run(2.0);
    EXPECT_EQ(y(), stood);
    EXPECT_EQ(alarm(), MessageCode::None);
    EXPECT_TRUE(drive(m_left, 1.0));
}

TEST_F(DobotRobotTest, WhatGoesWrongInAMoveIsTold) {
    makeLive();
    ASSERT_TRUE(m_arm->setFault("lost-steps"));
    drive(m_left, 1.0);
    EXPECT_EQ(alarm(), MessageCode::RobotElsewhere);
    EXPECT_FALSE(m_robot->state()->isPlaceSure);
    ASSERT_TRUE(m_arm->setFault("none"));
    EXPECT_TRUE(m_robot->clearAlarm());
    EXPECT_TRUE(drive(m_left, 1.0));
    run(1.0);
    ASSERT_TRUE(m_arm->setFault("slow-reply"));
    const double stood = y();
    EXPECT_TRUE(m_robot->setTwist(4.0 * m_left, 0.5));
    run(2.2);
    EXPECT_EQ(alarm(), MessageCode::RobotSlow);
    EXPECT_EQ(m_robot->clearAlarm().error().code(), MessageCode::RobotSlow);
    ASSERT_TRUE(m_arm->setFault("none"));
    run(2.0);
    EXPECT_LT(y() - stood, 6.0); // stopped on its way, though it began late
    EXPECT_TRUE(m_robot->clearAlarm());
    EXPECT_TRUE(drive(m_left, 1.0));
}

// Catches a dead arm that is believed, or not found again; one port of the three is enough.
TEST_F(DobotRobotTest, LostPortsAreFoundAgain) {
    makeLive();
    for (DeviceLink* link : {m_dashboard.get(), m_motion.get(), m_feedback.get()}) {
        link->unplug();
        run(0.05);
        EXPECT_EQ(m_robot->status().link, LinkState::Lost);
        EXPECT_EQ(m_robot->state().error().code(), MessageCode::LinkLost);
        const int before = link->opened();
        run(5.0);
        EXPECT_LE(link->opened() - before, 11);
        link->plug();
        run(2.0);
        EXPECT_EQ(m_robot->status().link, LinkState::Live);
    }
    ASSERT_TRUE(m_arm->setFault("silent"));
    run(1.2);
    EXPECT_EQ(m_robot->state().error().code(), MessageCode::DeviceSilent);
    ASSERT_TRUE(m_arm->setFault("none"));
    run(4.0);
    EXPECT_EQ(m_robot->status().link, LinkState::Live);
    EXPECT_TRUE(drive(m_left, 0.5));
}

// Catches an arm on its way to another place than it was sent to that is let go on, and replies to something
// else that are taken for its own.
TEST(DobotBytes, AnArmThatLeavesItsWayIsStopped) {
    ManualClock clock;
    ScriptedLink dashboard, motion, feedback;
    DobotRobot robot(dashboard, motion, feedback, clock, AxisMap(kArmAxes, Vector6d::Zero()),
                     [](const Vector6d&) { return true; });
    const auto run = [&](DobotMode mode, double x) {
        for (int i = 0; i < 4; ++i) {
            feedback.say(dobotPacket({mode, {x, 0.0, 0.0, 7.0}}));
            clock.advance(0.005);
            robot.work();
        }
    };
    run(DobotMode::Idle, 200.0);
    EXPECT_EQ(dashboard.takeSent(), "SpeedFactor(4)"); // 20 of 500 mm/s
    dashboard.say("0,{},SpeedFactor(4);");
    run(DobotMode::Idle, 200.0);
    EXPECT_EQ(dashboard.takeSent(), "User(0)");
    dashboard.say("0,{},Tool(0);0,{},User(0)");
    run(DobotMode::Idle, 200.0);
    EXPECT_EQ(robot.discarded(), 1);
    EXPECT_EQ(dashboard.takeSent(), "");
    dashboard.say(";");
    run(DobotMode::Idle, 200.0);
    EXPECT_EQ(dashboard.takeSent(), "Tool(0)");
    EXPECT_FALSE(robot.state());
    dashboard.say("0,{},Tool(0);");
    run(DobotMode::Idle, 200.0);
    ASSERT_TRUE(robot.state());
    ASSERT_TRUE(robot.setTwist((Vector6d() << 0.01, 0, 0, 0, 0, 0).finished(), 10.0));
    run(DobotMode::Idle, 200.0);
    EXPECT_EQ(motion.takeSent(), "MovL(205.000,0.000,0.000,7.000,SpeedL=100,AccL=20)");
    motion.say("0,{},MovL(205.000,0.000,0.000,7.000,SpeedL=100,AccL=20);");
    run(DobotMode::Running, 203.0);
    EXPECT_EQ(robot.state()->alarm.code, MessageCode::None);
    EXPECT_EQ(dashboard.takeSent(), "");
    run(DobotMode::Running, 206.0);
    EXPECT_EQ(dashboard.takeSent(), "ResetRobot()");
    EXPECT_EQ(robot.state()->alarm, (Message{MessageCode::RobotElsewhere, {"1", "0.5"}}));
}

// Catches frames that were refused and are thought to be set, an arm that is lost for a query that nobody
// answers, a clearing that waits for it, and a stall of the engine taken for the arm's silence.
TEST(DobotBytes, RefusalsAndMissingReplies) {
    ManualClock clock;
    ScriptedLink dashboard, motion, feedback;
    DobotRobot robot(dashboard, motion, feedback, clock, AxisMap(kArmAxes, Vector6d::Zero()),
                     [](const Vector6d&) { return true; });
    const auto run = [&](DobotMode mode, int turns = 4) {
        for (int i = 0; i < turns; ++i) {
            feedback.say(dobotPacket({mode, {200.0, 0.0, 0.0, 7.0}}));
            clock.advance(0.005);
            robot.work();
        }
        return dashboard.takeSent();
    };
    EXPECT_EQ(run(DobotMode::Idle), "SpeedFactor(4)");
    dashboard.say("0,{},SpeedFactor(4);");
    EXPECT_EQ(run(DobotMode::Idle), "User(0)");
    dashboard.say("-1,{},User(0);");
    EXPECT_EQ(run(DobotMode::Idle), "");
    EXPECT_EQ(robot.state()->alarm, (Message{MessageCode::RobotRefused, {"-1", "not carried out"}}));
    EXPECT_TRUE(robot.clearAlarm());
    EXPECT_EQ(run(DobotMode::Idle), "SpeedFactor(4)");
    dashboard.say("0,{},SpeedFactor(4);");
    EXPECT_EQ(run(DobotMode::Error), "User(0)");
    dashboard.say("0,{},User(0);");
    run(DobotMode::Error);
    dashboard.say("0,{},Tool(0);");
    EXPECT_EQ(run(DobotMode::Error), "GetErrorID()");
    run(DobotMode::Error, 2000);
    EXPECT_EQ(robot.status().link, LinkState::Live);
    EXPECT_TRUE(robot.clearAlarm());
    EXPECT_EQ(run(DobotMode::Error), "ClearError()");
    dashboard.say("0,{[\n\t[-2],\n\t[],\n\t[]\n]\n},GetErrorID();0,{},ClearError();");
    EXPECT_EQ(run(DobotMode::Error), "ResetRobot()");
    EXPECT_EQ(robot.state()->alarm.args.at(0), "-2");
    clock.advance(3.0);
    robot.work();
    EXPECT_EQ(robot.status().link, LinkState::Live);
    EXPECT_EQ(feedback.opened(), 1);
}

// Catches packets of another firmware that are only called silence, or are neither counted nor told.
TEST(DobotBytes, PacketsThatCannotBeReadAreTold) {
    ManualClock clock;
    ScriptedLink dashboard("dashboard"), motion("motion"), feedback("feedback");
    DobotRobot robot(dashboard, motion, feedback, clock, AxisMap(kArmAxes, Vector6d::Zero()),
                     [](const Vector6d&) { return true; });
    const auto run = [&](const std::string& packet, double time_s) {
        for (const double end_s = clock.now_s() + time_s; clock.now_s() < end_s;) {
            feedback.say(packet);
            clock.advance(0.008);
            robot.work();
        }
    };
    const std::string right = dobotPacket({DobotMode::Paused, {200.0, 0.0, 0.0, 7.0}});
    std::string other = right;
    other.replace(48, 8, std::string("\x10\x32\x54\x76\x98\xba\xdc\xfe", 8));
    run(other, 3.5);
    EXPECT_EQ(robot.status().problem,
              (Message{MessageCode::DeviceOther,
                       {"feedback", "1440 bytes with test word 0xfedcba9876543210; its "
                                    "firmware may be of another version"}}));
    EXPECT_GT(robot.status().discarded, 300);
    run(right, 1.0);
    EXPECT_EQ(robot.status().link, LinkState::Live);
    const int before = robot.status().discarded;
    run(right, 5.0);
    EXPECT_EQ(robot.status().discarded, before);
    EXPECT_EQ(robot.status().problem.code, MessageCode::None);
    run(right.substr(0, 700), 0.001); // a damaged one
    run(right, 0.1);
    EXPECT_EQ(robot.status().link, LinkState::Live);
    EXPECT_GT(robot.status().discarded, before);
    EXPECT_EQ(robot.status().problem.code, MessageCode::DeviceAnswersWrong);
    run(other, 1.5);
    EXPECT_EQ(robot.status().link, LinkState::Lost);
    EXPECT_EQ(robot.status().problem.code, MessageCode::DeviceOther);
}

// Catches packets that had waited and are told as new.
TEST(DobotBytes, AWaitingPacketIsAsOldAsItsClockTells) {
    ManualClock clock;
    ScriptedLink dashboard, motion, feedback;
    DobotRobot robot(dashboard, motion, feedback, clock, AxisMap(kArmAxes, Vector6d::Zero()),
                     [](const Vector6d&) { return true; });
    std::uint64_t time_ms = 1'700'000'000'000;
    const auto say = [&] {
        feedback.say(dobotPacket({DobotMode::Paused, {200.0, 0.0, 0.0, 7.0}, 0, 0, time_ms += 8}));
    };
    for (int i = 0; i < 100; ++i) {
        say();
        clock.advance(0.008);
        robot.work();
    }
    EXPECT_NEAR(robot.state()->time_s, clock.now_s() - 0.008, 0.003);
    clock.advance(2.0);
    for (int i = 0; i < 45; ++i) // what the link held of two seconds
        say();
    robot.work();
    EXPECT_NEAR(robot.state()->time_s, clock.now_s() - 2.0 + 0.36 - 0.008, 0.003);
    time_ms += 2000 - 360;
    say();
    clock.advance(0.008);
    robot.work();
    EXPECT_NEAR(robot.state()->time_s, clock.now_s() - 0.008, 0.006);
    time_ms -= 3'600'000; // its clock was set
    for (int i = 0; i < 2; ++i) {
        say();
        clock.advance(0.008);
        robot.work();
    }
    EXPECT_NEAR(robot.state()->time_s, clock.now_s() - 0.008, 0.009);
}

// Catches an axis that the arm does not have, and numbers without sense.
TEST_F(DobotRobotTest, BrokenSettingsAreTold) {
    make({}, {{'X', 0, false, 0.0}, {'A', 3, false, 0.0}});
    run(1.0);
    EXPECT_EQ(m_robot->state().error().code(), MessageCode::DeviceAnswersWrong);
    makeLive();
    EXPECT_THROW((void)m_robot->setTwist(Vector6d::Constant(std::nan("")), 0.1), std::invalid_argument);
}

// Catches a move whose target was not approved, or a second one before the first is over, over random
// commands and faults.
TEST_F(DobotRobotTest, NoTargetIsOutsideAndOneMoveAtATime) {
    m_guard = [](const Vector6d& q) {
        return std::abs(q[1]) <= 0.03 && q[2] >= 0.02 && q[2] <= 0.08 && std::abs(q[0] - 0.2) <= 0.03;
    };
    makeLive();
    std::mt19937 random(11);
    const auto uniform = [&](double a, double b) { return std::uniform_real_distribution(a, b)(random); };
    const auto faults = m_arm->faults();
    int moves = 0;
    double slowUntil_s = 0.0; // a move that the arm takes late outlives its link here
    for (int i = 0; i < 30'000 && !HasFatalFailure(); ++i) {
        const double action = uniform(0.0, 1000.0);
        if (action < 500.0)
            (void)m_robot->setTwist(0.03 * Vector6d::NullaryExpr([&] { return uniform(-1.0, 1.0); }),
                                    uniform(0.0, 1.0));
        else if (action < 560.0)
            (void)m_robot->halt();
        else if (action < 660.0)
            (void)m_robot->clearAlarm();
        else if (action < 664.0 && m_clock.now_s() > slowUntil_s) {
            ASSERT_TRUE(m_arm->setFault(faults[static_cast<std::size_t>(uniform(0.0, 7.999))]));
            slowUntil_s = m_clock.now_s() + 10.0;
        } else if (action < 680.0)
            ASSERT_TRUE(m_arm->setFault("none"));
        else if (action < 682.0 && m_clock.now_s() > slowUntil_s)
            m_motion->unplug();
        else if (action < 690.0)
            m_motion->plug();
        run(uniform(0.0, 0.1));
        const std::string sent = m_motion->takeSent();
        ASSERT_LE(m_arm->queued(), 1U);
        for (std::size_t at = sent.find("MovL("); at != std::string::npos; at = sent.find("MovL(", at + 1)) {
            double x = 0.0, py = 0.0, z = 0.0, turn = 0.0;
            ASSERT_EQ(std::sscanf(sent.c_str() + at, "MovL(%lf,%lf,%lf,%lf,", &x, &py, &z, &turn), 4);
            ASSERT_TRUE(m_guard((Vector6d() << x / 1000.0, py / 1000.0, z / 1000.0, 0, 0, 0).finished()))
                << sent;
            ASSERT_EQ(turn, 0.0);
            ++moves;
        }
    }
    EXPECT_GT(moves, 1000);
    RecordProperty("moves", moves);
}

} // namespace
} // namespace bask::test
