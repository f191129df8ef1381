// The driver of a Grbl robot against a script: what it sends, byte by byte, and what it makes of answers that
// come in pieces, together, late, twice or damaged.

#include "engine/drivers/grbl_robot.h"
#include "tests/engine/drivers/test_links.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace bask::test {
namespace {

class GrblBytesTest : public testing::Test {
protected:
    void run(double time_s) {
        for (const double end_s = m_clock.now_s() + time_s; m_clock.now_s() < end_s - 1e-9;) {
            m_clock.advance(0.005);
            m_robot.work();
        }
    }
    std::string sentAfter(double time_s) {
        run(time_s);
        return m_link.takeSent();
    }
    std::string answered(const std::string& answer, double time_s = 0.005) {
        m_link.say(answer);
        return sentAfter(time_s);
    }
    /// Opened, asked, set up.
    void goLive() {
        sentAfter(0.01);
        m_link.say("\r\nGrbl 1.1h ['$' for help]\r\n");
        ASSERT_EQ(sentAfter(0.25), "?");
        ASSERT_EQ(answered("<Idle|MPos:0.000,0.000,0.000>\r\n"), "$$\n");
        answered("$13=0\r\n$22=1\r\nok\r\n");
        answered("[VER:1.1h.20190825:left]\r\n[OPT:V,15,128]\r\nok\r\n");
        answered("<Idle|MPos:0.000,0.000,0.000>\r\n", 0.2);
        ASSERT_EQ(m_robot.status().link, LinkState::Live);
        ASSERT_EQ(m_robot.status().signature, "VER:1.1h.20190825:left");
        answered("<Idle|MPos:0.000,0.000,0.000>\r\n");
        ASSERT_TRUE(m_robot.clearAlarm());
        ASSERT_EQ(sentAfter(0.005), "F7\n");
        answered("ok\r\n", 0.2);
        answered("<Idle|MPos:0.000,0.000,0.000>\r\n");
    }
    MessageCode alarm() { return m_robot.state()->alarm.code; }

    ManualClock m_clock;
    ScriptedLink m_link;
    GrblRobot m_robot{m_link, m_clock,
                      AxisMap({{'X', 0, false, 0.0}, {'Z', 2, false, 0.0}}, Vector6d::Zero()),
                      [](const Vector6d&) { return true; }, false};
    const Vector6d m_twist = (Vector6d() << 0.003, 0, 0.004, 0, 0, 0).finished();
};

// Catches another line than the one that was meant, sent before it is due or a second time.
TEST_F(GrblBytesTest, OneStepAtATime) {
    goLive();
    ASSERT_TRUE(m_robot.setTwist(m_twist, 10.0));
    EXPECT_EQ(sentAfter(0.005), "$J=G21G90G53X1.500Z2.000F300.0\n"); // half a second at 5 mm/s
    const double sent_s = m_clock.now_s();
    for (int i = 0; i < 3; ++i)
        EXPECT_EQ(answered("<Idle|MPos:0.000,0.000,0.000>\r\n", 0.06), "?"); // not taken yet: no second one
    answered("o");
    EXPECT_EQ(answered("k\r\n<Jog|MPos:0.1,0.0,0.1>\r\n", 0.06), "?");
    EXPECT_TRUE(m_robot.state()->moving);
    std::string sent;
    while (sent.find('$') == std::string::npos)
        sent += answered("<Idle|MPos:1.500,0.000,2.000>\r\n");
    EXPECT_EQ(sent.substr(sent.find('$')), "$J=G21G90G53X3.000Z4.000F300.0\n");
    EXPECT_NEAR(m_clock.now_s() - sent_s, 0.5,
                0.01); // the time that the first one had, though it ended early
}

// Catches a robot on its way to another place than it was sent to (a digit damaged by the cable) that is let
// go on.
TEST_F(GrblBytesTest, ARobotThatLeavesItsWayIsStopped) {
    goLive();
    ASSERT_TRUE(m_robot.setTwist(m_twist, 10.0));
    sentAfter(0.005);
    answered("ok\r\n<Jog|MPos:0.300,0.000,0.400>\r\n");
    EXPECT_EQ(alarm(), MessageCode::None);
    EXPECT_EQ(answered("<Jog|MPos:0.400,0.000,2.600>\r\n").substr(0, 1), "\x85");
    EXPECT_EQ(m_robot.state()->alarm, (Message{MessageCode::RobotElsewhere, {"0.6", "0.5"}}));
    EXPECT_FALSE(m_robot.state()->isPlaceSure);
}

// Catches an acknowledgement of before that frees the way for the next line.
TEST_F(GrblBytesTest, StrayAcknowledgementsAreDiscarded) {
    goLive();
    EXPECT_EQ(m_robot.discarded(), 0);
    answered("ok\r\nerror:3\r\n");
    EXPECT_EQ(m_robot.status().discarded, 2);
    EXPECT_EQ(m_robot.status().problem.code, MessageCode::DeviceAnswersWrong);
    EXPECT_EQ(alarm(), MessageCode::None);
}

// Catches settings that are taken for read because of an ok that was left over.
TEST_F(GrblBytesTest, AnOkOfBeforeDoesNotEndTheSettings) {
    sentAfter(0.01);
    m_link.say("Grbl 1.1h ['$' for help]\r\n");
    sentAfter(0.25);
    ASSERT_EQ(answered("<Idle|MPos:0.000,0.000,0.000>\r\n"), "$$\n");
    answered("ok\r\n");
    EXPECT_EQ(m_robot.discarded(), 1);
    EXPECT_NE(m_robot.status().link, LinkState::Live);
    answered("$13=1\r\nok\r\n");
    answered("<Idle|MPos:1.000,0.000,0.000>\r\n", 0.3);
    EXPECT_EQ(m_robot.state().error().code(), MessageCode::DeviceAnswersWrong); // inches
}

// Catches a report that is pieced together from two, and one that is lost because its halves came apart.
TEST_F(GrblBytesTest, ReportsComeInPieces) {
    goLive();
    sentAfter(0.2);
    for (const char c : std::string("<Idle|MPos:7.000,0.000,8.000|Bf:15,128>\r\n"))
        answered(std::string(1, c));
    EXPECT_NEAR(m_robot.state()->coordinates[0], 0.007, 1e-12);
    answered("<Idle|MPos:9.0<Idle|MPos:9.000,0.000,8.000>\r\n");
    EXPECT_NEAR(m_robot.state()->coordinates[0], 0.007, 1e-12);
    EXPECT_EQ(m_robot.discarded(), 1);
}

// Catches a report that was on its way before it was asked for and is told as if it were new.
TEST_F(GrblBytesTest, AnUnaskedReportIsNoNewer) {
    goLive();
    const double before_s = m_robot.state()->time_s;
    answered("<Idle|MPos:3.000,0.000,0.000>\r\n", 0.005);
    EXPECT_NEAR(m_robot.state()->coordinates[0], 0.003, 1e-12);
    EXPECT_EQ(m_robot.state()->time_s, before_s);
}

// Catches a line whose acknowledgement was lost and that holds everything up for ever; and the opposite, that
// it is thought to be over while it may still run.
TEST_F(GrblBytesTest, ALostAcknowledgementIsSettledByAFence) {
    goLive();
    ASSERT_TRUE(m_robot.setTwist(m_twist, 0.105));
    EXPECT_EQ(sentAfter(0.005), "$J=G21G90G53X0.300Z0.400F300.0\n");
    std::string sent;
    for (int i = 0; i < 12; ++i)
        sent += answered("<Idle|MPos:0.300,0.000,0.400>\r\n", 0.05);
    EXPECT_EQ(sent.substr(sent.find('$')).substr(0, 3), "$G\n");
    EXPECT_EQ(sent.find("$G", sent.find('$') + 1), std::string::npos);
    ASSERT_TRUE(m_robot.setTwist(m_twist, 10.0));
    answered("[GC:G0 G54]\r\nok\r\n");
    EXPECT_EQ(m_robot.discarded(), 0);
    sent.clear();
    for (int i = 0; i < 20; ++i)
        sent += answered("<Idle|MPos:0.300,0.000,0.400>\r\n", 0.05);
    EXPECT_NE(sent.find("$J=G21G90G53X1.8"), std::string::npos) << sent;
}

// Catches settings whose line about the units was damaged, and inches that are taken for millimetres.
TEST_F(GrblBytesTest, WithoutItsUnitsItIsAskedAgain) {
    sentAfter(0.01);
    m_link.say("Grbl 1.1h ['$' for help]\r\n");
    sentAfter(0.25);
    ASSERT_EQ(answered("<Idle|MPos:0.000,0.000,0.000>\r\n"), "$$\n");
    answered("$10=1\r\n$1#=1\r\n$22=1\r\nok\r\n");
    answered("<Idle|MPos:1.000,0.000,0.000>\r\n", 0.1);
    EXPECT_EQ(m_robot.status().link, LinkState::Opening);
    EXPECT_EQ(m_robot.state().error().code(), MessageCode::DeviceAnswersWrong);
    std::string sent;
    for (int i = 0; i < 20; ++i)
        sent += answered("<Idle|MPos:1.000,0.000,0.000>\r\n", 0.05);
    EXPECT_NE(sent.find("$$"), std::string::npos);
    answered("$13=0\r\nok\r\n");
    answered("<Idle|MPos:1.000,0.000,0.000>\r\n", 0.01);
    EXPECT_EQ(m_robot.status().link, LinkState::Live);
}

// Catches a healthy link that is closed because the engine itself had stood still, which restarts an Arduino;
// and a dead robot that is not seen any more behind it.
TEST_F(GrblBytesTest, AStallOfTheEngineIsNotTheRobotsSilence) {
    goLive();
    m_clock.advance(5.0);
    EXPECT_EQ(sentAfter(0.005), "?");
    run(0.5);
    EXPECT_EQ(m_link.opened(), 1);
    EXPECT_EQ(m_robot.status().link, LinkState::Live);
    run(0.6);
    EXPECT_EQ(m_robot.status().link, LinkState::Lost);
    run(0.6); // opened again soon
    EXPECT_EQ(m_link.opened(), 2);
}

// Catches a stop of homing that is sent once and lost on the way, one that goes on for ever, and a second one
// that does nothing.
TEST_F(GrblBytesTest, AStopOfHomingIsRepeatedUntilItIsTaken) {
    goLive();
    ASSERT_TRUE(m_robot.home());
    EXPECT_EQ(sentAfter(0.01).find("$H\n"), 0U);
    run(1.0);
    m_link.takeSent();
    EXPECT_TRUE(m_robot.halt());
    EXPECT_EQ(m_link.takeSent(), "\x18");
    const std::string sent = sentAfter(0.7);
    EXPECT_EQ(std::ranges::count(sent, '\x18'), 2);
    EXPECT_TRUE(m_robot.halt());
    EXPECT_EQ(m_link.takeSent(), "\x18");
    m_link.say("ALARM:6\r\n\r\nGrbl 1.1h ['$' for help]\r\n[MSG:'$H'|'$X' to unlock]\r\n");
    run(0.01);
    m_link.say("\r\nGrbl 1.1h ['$' for help]\r\n"); // to the one that came second
    EXPECT_EQ(answered("<Alarm|MPos:0.000,0.000,0.000>\r\n", 0.9).find('\x18'), std::string::npos);
    EXPECT_EQ(m_robot.state()->alarm, (Message{MessageCode::RobotAlarm, {"6", "reset while homing"}}));
    EXPECT_FALSE(m_robot.state()->isPlaceSure);
}

// Catches a robot that homes on after its link was given up.
TEST_F(GrblBytesTest, ALostLinkEndsHoming) {
    goLive();
    ASSERT_TRUE(m_robot.home());
    run(1.0);
    m_link.takeSent();
    run(121.0);
    EXPECT_EQ(m_robot.status().link, LinkState::Lost);
    EXPECT_NE(m_link.takeSent().find('\x18'), std::string::npos);
}

// Catches a start-up block, or lines of somebody else, that run on through a stop; they are held first.
TEST_F(GrblBytesTest, WhatRunsIsHeldAndReset) {
    goLive();
    answered("<Run|MPos:1.000,0.000,0.000>\r\n");
    m_link.takeSent();
    EXPECT_TRUE(m_robot.halt());
    EXPECT_TRUE(m_robot.halt());
    EXPECT_EQ(m_link.takeSent(), "!");
    EXPECT_EQ(answered("<Hold:1|MPos:1.500,0.000,0.000>\r\n", 0.2).find('\x18'), std::string::npos);
    EXPECT_EQ(answered("<Hold:0|MPos:2.000,0.000,0.000>\r\n").substr(0, 1), "\x18");
    answered("Grbl 1.1h ['$' for help]\r\n<Run|MPos:2.000,0.000,0.000>\r\n"); // the block again
    EXPECT_EQ(alarm(), MessageCode::None);
    m_link.takeSent();
    EXPECT_TRUE(m_robot.halt());
    EXPECT_EQ(m_link.takeSent(), "\x18");
}

// Catches a hold that is lost and waited for.
TEST_F(GrblBytesTest, AHoldIsNotWaitedForWithoutEnd) {
    goLive();
    answered("<Run|MPos:1.000,0.000,0.000>\r\n");
    EXPECT_TRUE(m_robot.halt());
    std::string sent;
    for (int i = 0; i < 24; ++i)
        sent += answered("<Run|MPos:1.000,0.000,0.000>\r\n", 0.05);
    EXPECT_GE(std::ranges::count(sent, '!'), 3);
    EXPECT_EQ(std::ranges::count(sent, '\x18'), 1);
}

// Catches an acknowledgement that is told as a refusal, because its step had been given up meanwhile.
TEST_F(GrblBytesTest, AnOkToADroppedStepIsNoRefusal) {
    goLive();
    ASSERT_TRUE(m_robot.setTwist(m_twist, 10.0));
    sentAfter(0.005);
    answered("<Hold:0|MPos:0.000,0.000,0.000>\r\nok\r\n");
    EXPECT_EQ(alarm(), MessageCode::RobotHeld);
    answered("<Idle|MPos:0.000,0.000,0.000>\r\n");
    EXPECT_TRUE(m_robot.clearAlarm());
    EXPECT_EQ(alarm(), MessageCode::None);
}

// Catches another robot that is plugged in at the same port and is moved, homed or cleared.
TEST_F(GrblBytesTest, AnotherRobotIsWrittenNothing) {
    m_robot.expect("VER:1.1h.20190825:right");
    sentAfter(0.01);
    m_link.say("\r\nGrbl 1.1h ['$' for help]\r\n");
    sentAfter(0.25);
    ASSERT_EQ(answered("<Idle|MPos:0.000,0.000,0.000>\r\n"), "$$\n");
    EXPECT_EQ(answered("$13=0\r\n$22=1\r\nok\r\n"), "$I\n");
    EXPECT_NE(m_robot.status().link, LinkState::Live);
    answered("[VER:1.1h.20190825:left]\r\n[OPT:V,15,128]\r\nok\r\n");
    answered("<Idle|MPos:0.000,0.000,0.000>\r\n", 0.2);
    EXPECT_EQ(m_robot.status().link, LinkState::Opening);
    EXPECT_EQ(m_robot.status().problem,
              (Message{MessageCode::DeviceExchanged,
                       {"port", "VER:1.1h.20190825:right", "VER:1.1h.20190825:left"}}));
    EXPECT_EQ(m_robot.setTwist(m_twist, 10.0).error().code(), MessageCode::DeviceExchanged);
    EXPECT_EQ(m_robot.home().error().code(), MessageCode::DeviceExchanged);
    EXPECT_EQ(m_robot.clearAlarm().error().code(), MessageCode::DeviceExchanged);
    (void)m_robot.halt();
    std::string sent;
    for (int i = 0; i < 40; ++i)
        sent += answered("<Idle|MPos:0.000,0.000,0.000>\r\n", 0.1);
    EXPECT_EQ(sent.find_first_not_of('?'), std::string::npos) << sent;
}

// Catches a device of another kind that is only called silent.
TEST_F(GrblBytesTest, AnotherDeviceIsNamed) {
    sentAfter(0.3);
    m_link.say("echo:Marlin 2.1.2\r\n");
    run(3.0);
    EXPECT_EQ(m_robot.status().link, LinkState::Opening);
    EXPECT_EQ(m_robot.status().problem, (Message{MessageCode::DeviceOther, {"port", "echo:Marlin 2.1.2"}}));
}

// Catches unknown numbers that are hidden, or given a wrong meaning.
TEST_F(GrblBytesTest, UnknownNumbersAreShownRaw) {
    goLive();
    answered("ALARM:77\r\n");
    EXPECT_EQ(m_robot.state()->alarm, (Message{MessageCode::RobotAlarm, {"77", "not known to Bask"}}));
    EXPECT_FALSE(m_robot.state()->isPlaceSure);
}

} // namespace
} // namespace bask::test
