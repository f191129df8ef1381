#include "engine/device_simulators/dobot_simulator.h"

#include "engine/base/message_code.h"

#include <gtest/gtest.h>

namespace bask {
namespace {

class DobotSimulatorTest : public testing::Test {
protected:
    std::string say(ByteDevice& port, const std::string& command, double time_s = 0.1) {
        port.receive(command, m_now_s);
        m_now_s += time_s;
        return port.transmit(m_now_s);
    }
    std::string ask(const std::string& command) { return say(m_arm.dashboard(), command); }
    std::string move(const std::string& command, double time_s = 0.1) {
        return say(m_arm.motion(), command, time_s);
    }

    double m_now_s = 0.0;
    DobotSimulator m_arm;
    DobotFeedbackReader m_reader;
};

// Catches replies in another form than the maker's: the command as it came, case not counted.
TEST_F(DobotSimulatorTest, RepliesAsTheMakersGuideTells) {
    EXPECT_EQ(ask("RobotMode()"), "0,{5},RobotMode();");
    EXPECT_EQ(ask("eNabLErobOt()"), "0,{},eNabLErobOt();");
    EXPECT_EQ(ask("Mov(1)"), "-10000,{},Mov(1);");
    EXPECT_EQ(ask("User(0)Tool(0)"), "0,{},User(0);0,{},Tool(0);");
    EXPECT_EQ(move("MovL(1,2)"), "-20000,{},MovL(1,2);");
    EXPECT_EQ(move("MovL(1,x,3,4)"), "-30001,{},MovL(1,x,3,4);");
    EXPECT_EQ(move("MovL(210,0,50,0,SpeedL=50,AccL=20)"), "0,{},MovL(210,0,50,0,SpeedL=50,AccL=20);");
}

// Catches a move at another speed, or a stop that does not stop: 50 % of 500 mm/s.
TEST_F(DobotSimulatorTest, MovesAndStops) {
    move("MovL(300,0,50,0,SpeedL=50)", 0.22); // 20 ms on their way
    EXPECT_EQ(m_arm.mode(), DobotMode::Running);
    EXPECT_NEAR(m_arm.position()[0], 250.0, 1.0);
    ask("ResetRobot()");
    EXPECT_NEAR(m_arm.position()[0], 250.0, 1.0);
    EXPECT_EQ(ask("RobotMode()"), "0,{5},RobotMode();");
}

// Catches an alarm that is not there, or ends without being cleared and enabled.
TEST_F(DobotSimulatorTest, AlarmsAreClearedThenEnabled) {
    move("MovL(500,0,50,0)"); // out of reach
    EXPECT_EQ(ask("GetErrorID()"), "0,{[\n\t[17],\n\t[],\n\t[],\n\t[],\n\t[]\n]\n},GetErrorID();");
    EXPECT_EQ(ask("EnableRobot()"), "-1,{},EnableRobot();");
    EXPECT_EQ(move("MovL(200,0,50,0)"), "-1,{},MovL(200,0,50,0);");
    ask("ClearError()");
    EXPECT_EQ(ask("RobotMode()"), "0,{4},RobotMode();");
    ask("EnableRobot()");
    EXPECT_EQ(ask("RobotMode()"), "0,{5},RobotMode();");
    EXPECT_EQ(ask("GetErrorID()"), "0,{[\n\t[],\n\t[],\n\t[],\n\t[],\n\t[]\n]\n},GetErrorID();");
}

// Catches a queue that goes on by itself after an alarm: what was in it waits, what comes is taken and waits,
// until Continue(); and a reset that leaves it full.
TEST_F(DobotSimulatorTest, AnAlarmStopsTheQueueUntilItIsContinued) {
    move("MovL(300,0,50,0,SpeedL=10)");
    ASSERT_TRUE(m_arm.setFault("alarm"));
    ask("ClearError()");
    ask("EnableRobot()");
    EXPECT_EQ(move("MovL(200,0,50,0)"), "0,{},MovL(200,0,50,0);");
    EXPECT_EQ(m_arm.mode(), DobotMode::Idle);
    EXPECT_EQ(m_arm.queued(), 2U);
    ask("User(3)");
    EXPECT_EQ(ask("Continue()"), "0,{},Continue();");
    EXPECT_EQ(m_arm.mode(), DobotMode::Running);
    ASSERT_TRUE(m_arm.setFault("alarm"));
    ask("ClearError()");
    ask("ResetRobot()");
    EXPECT_EQ(m_arm.queued(), 0U);
}

// Catches frames that are chosen at once, or by a disabled arm.
TEST_F(DobotSimulatorTest, FramesGoThroughTheQueue) {
    const auto user = [&] {
        m_reader.add(m_arm.feedback().transmit(m_now_s += 0.01));
        int last = -1;
        while (const auto packet = m_reader.next())
            last = packet->user;
        return last;
    };
    move("MovL(300,0,50,0,SpeedL=50)");
    ask("User(2)");
    EXPECT_EQ(user(), 0);
    m_now_s += 1.0;
    EXPECT_EQ(user(), 2);
    ask("DisableRobot()");
    EXPECT_EQ(ask("User(0)"), "0,{},User(0);");
    EXPECT_EQ(user(), 2);
    ask("EnableRobot()");
    EXPECT_EQ(user(), 2);
}

// Catches packets at another rate, or a reader that comes late and gets all of the past.
TEST_F(DobotSimulatorTest, TellsItsPlaceEveryEightMilliseconds) {
    m_arm.feedback().transmit(1.0);
    std::size_t packets = 0;
    for (int i = 1; i <= 200; ++i)
        packets += m_arm.feedback().transmit(1.0 + 0.005 * i).size() / DobotFeedbackReader::kPacketBytes;
    EXPECT_NEAR(static_cast<double>(packets), 125.0, 15.0);
    EXPECT_LE(m_arm.feedback().transmit(60.0).size(), 10 * DobotFeedbackReader::kPacketBytes);
}

TEST_F(DobotSimulatorTest, EachFaultIsThere) {
    for (const std::string& name : m_arm.faults())
        EXPECT_TRUE(m_arm.motion().setFault(name)) << name;
    EXPECT_EQ(m_arm.setFault("nonsense").error().code(), MessageCode::ValueUnknown);
    DobotSimulator fresh;
    ASSERT_TRUE(fresh.setFault("paused"));
    EXPECT_EQ(fresh.mode(), DobotMode::Paused);
    ASSERT_TRUE(fresh.setFault("alarm"));
    EXPECT_EQ(fresh.mode(), DobotMode::Error);
    ASSERT_TRUE(fresh.setFault("disabled"));
    EXPECT_EQ(fresh.mode(), DobotMode::Disabled);
    ASSERT_TRUE(fresh.setFault("silent"));
    EXPECT_EQ(fresh.feedback().transmit(1.0), "");
}

} // namespace
} // namespace bask
