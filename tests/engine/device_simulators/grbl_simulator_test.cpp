#include "engine/device_simulators/grbl_simulator.h"

#include "engine/base/message_code.h"

#include <gtest/gtest.h>

namespace bask {
namespace {

/// A person at a terminal.
class GrblSimulatorTest : public testing::Test {
protected:
    void make(const GrblSimulatorConfig& config) { m_robot.emplace(config); }
    void send(const std::string& bytes) { m_robot->receive(bytes, m_now_s); }
    std::string after(double time_s) {
        m_now_s += time_s;
        return m_robot->transmit(m_now_s);
    }
    std::string say(const std::string& line, double time_s = 0.01) {
        send(line + "\n");
        return after(time_s);
    }
    std::string status() {
        send("?");
        const std::string told = after(0.0);
        return told.substr(0, told.find("|Bf"));
    }
    double x() const { return m_robot->positions()[0]; }

    double m_now_s = 0.0;
    std::optional<GrblSimulator> m_robot{std::in_place};
};

// Catches an ok that is told when the motion ends and not when it is queued, and a motion of another length.
TEST_F(GrblSimulatorTest, AJogIsAcknowledgedAtOnceAndEndsWhereItWasTold) {
    EXPECT_EQ(say("$J=G21G90G53X10.000A-5.000F600.0"), "ok\r\n");
    EXPECT_EQ(m_robot->state(), "Jog");
    after(2.0);
    EXPECT_EQ(status(), "<Idle|MPos:10.000,0.000,0.000,-5.000");
    EXPECT_DOUBLE_EQ(m_robot->positions()[3], -5.0);
}

// Catches a feed that counts the turning axis apart: F holds for all axes together, degrees as millimetres.
TEST_F(GrblSimulatorTest, FeedHoldsForMixedMoves) {
    GrblSimulatorConfig config;
    config.acceleration_mm_s2 = 0.0;
    make(config);
    say("$J=G21G90G53X3.000A4.000F300.0", 0.98); // 5 in one second
    EXPECT_EQ(m_robot->state(), "Jog");
    after(0.03);
    EXPECT_EQ(m_robot->state(), "Idle");
}

// Catches ramps that overshoot or stop at once: 10 mm/s by 20 mm/s2 takes 2.5 mm up and 2.5 mm down.
TEST_F(GrblSimulatorTest, MotorsRamp) {
    GrblSimulatorConfig config;
    config.acceleration_mm_s2 = 20.0;
    make(config);
    say("$J=G21G90G53X10.000F600.0", 0.5);
    EXPECT_NEAR(x(), 2.45, 0.1);
    send("\x85");
    after(0.6);
    EXPECT_EQ(m_robot->state(), "Idle");
    EXPECT_NEAR(x(), 5.0, 0.15);
    const double stood = x();
    after(1.0);
    EXPECT_EQ(x(), stood);
}

// The overtaking hazard: what is taken out of the stream comes before a line that has not been taken.
TEST_F(GrblSimulatorTest, ACancelOvertakesAJog) {
    send("$J=G21G90G53X10.000F600.0\n\x85");
    EXPECT_EQ(after(2.0), "ok\r\n");
    EXPECT_NEAR(x(), 10.0, 1e-9); // Grbl: not in a jog yet, and so it runs in full
    GrblSimulatorConfig config;
    config.isHal = true;
    make(config);
    send("$J=G21G90G53X10.000F600.0\n\x85");
    EXPECT_EQ(after(2.0), ""); // grblHAL drops it, without an answer
    EXPECT_EQ(x(), 0.0);
}

// Catches refusals of the interface document told with another number, or motion in spite of them.
TEST_F(GrblSimulatorTest, RefusesWhatGrblRefuses) {
    EXPECT_EQ(say("$J=G21G90X1"), "error:22\r\n");
    EXPECT_EQ(say("$J=G21G90F100"), "error:16\r\n");
    EXPECT_EQ(say("$J=G55X1F100"), "error:16\r\n");
    EXPECT_EQ(say("$J=X1X2F100"), "error:25\r\n");
    EXPECT_EQ(say("$J=X1B2F100"), "error:20\r\n");
    EXPECT_EQ(say("$J=X..F"), "error:2\r\n");
    EXPECT_EQ(say("G1 X5"), "error:22\r\n");
    EXPECT_EQ(say("hello"), "error:2\r\n");
    EXPECT_EQ(say("$Q"), "error:3\r\n");
    EXPECT_EQ(say(std::string(90, 'X')), "error:11\r\n");
    EXPECT_EQ(say(""), "ok\r\n");
    EXPECT_EQ(x(), 0.0);
    say("$J=G21G90G53X10F600");
    EXPECT_EQ(say("G1 X5 F100"), "error:9\r\n");
    EXPECT_EQ(say("$110=5"), "error:8\r\n");
}

// Catches a hold that flushes lines: they wait, and run at `~`; 0x18 at rest keeps the place.
TEST_F(GrblSimulatorTest, HeldLinesRunWhenReleased) {
    say("$J=G21G90G53X1F600", 1.0);
    send("!");
    EXPECT_EQ(status(), "<Hold:0|MPos:1.000,0.000,0.000,0.000");
    EXPECT_EQ(say("$J=G21G90G53X5F600", 1.0), "");
    send("~");
    EXPECT_EQ(after(2.0), "ok\r\n");
    EXPECT_NEAR(x(), 5.0, 1e-9);
    send("!");
    say("$J=G21G90G53X9F600");
    send("\x18");
    EXPECT_EQ(after(0.1), "\r\nGrbl 1.1h ['$' for help]\r\n");
    EXPECT_EQ(status(), "<Idle|MPos:5.000,0.000,0.000,0.000");
    after(2.0);
    EXPECT_NEAR(x(), 5.0, 1e-9);
}

// Catches a G-code move that does not hold, resume and end, or a dwell that is acknowledged before it is
// over.
TEST_F(GrblSimulatorTest, MovesHoldResumeAndDwell) {
    EXPECT_EQ(say("G90 G1 X10 F600", 0.3), "ok\r\n");
    send("!");
    after(0.5);
    const double paused = x();
    EXPECT_EQ(m_robot->state(), "Hold:0");
    after(1.0);
    EXPECT_EQ(x(), paused);
    send("~");
    after(2.0);
    EXPECT_NEAR(x(), 10.0, 1e-9);
    EXPECT_EQ(say("G4 P0.5", 0.4), "");
    EXPECT_EQ(after(0.2), "ok\r\n");
    EXPECT_EQ(say("G0 X0", 2.0), "ok\r\n");
    EXPECT_NEAR(x(), 0.0, 1e-9);
}

// Catches a reset in motion that is harmless: the place is not sure and the controller locked.
TEST_F(GrblSimulatorTest, AResetInMotionLocks) {
    say("$J=G21G90G53X10F600", 0.3);
    send("\x18");
    EXPECT_EQ(after(0.0), "ALARM:3\r\n\r\nGrbl 1.1h ['$' for help]\r\n[MSG:'$H'|'$X' to unlock]\r\n");
    EXPECT_EQ(say("$J=G21G90G53X10F600"), "error:9\r\n");
    EXPECT_EQ(say("$X"), "[MSG:Caution: Unlocked]\r\nok\r\n");
    EXPECT_EQ(say("$J=G21G90G53X10F600"), "ok\r\n");
}

// Catches soft limits that hold before the robot was homed, and homing that leaves it lost.
TEST_F(GrblSimulatorTest, SoftLimitsHoldOnceHomed) {
    GrblSimulatorConfig config;
    config.upper[0] = 50.0;
    config.hasSoftLimits = true;
    config.start = {20.0, 0.0, 0.0, 0.0};
    make(config);
    EXPECT_EQ(say("$J=G21G90G53X50.5F6000"), "ok\r\n");
    after(2.0);
    send("$H\n");
    after(0.1);
    EXPECT_EQ(m_robot->state(), "Home");
    send("?");
    EXPECT_EQ(after(0.1), ""); // Grbl tells nothing while it homes
    EXPECT_EQ(after(3.0), "ok\r\n");
    EXPECT_EQ(status(), "<Idle|MPos:0.000,0.000,0.000,0.000");
    EXPECT_EQ(say("$J=G21G90G53X50.5F6000"), "error:15\r\n");
    EXPECT_EQ(say("G1 X50.5 F6000"), "ALARM:2\r\n[MSG:Reset to continue]\r\nok\r\n");
}

// Catches a limit switch that does not stop, or an alarm that a mere unlock ends.
TEST_F(GrblSimulatorTest, LimitSwitchesStop) {
    GrblSimulatorConfig config;
    config.upper[0] = 5.0;
    make(config);
    EXPECT_EQ(say("$J=G21G90G53X50F600", 3.0), "ok\r\nALARM:1\r\n[MSG:Reset to continue]\r\n");
    EXPECT_NEAR(x(), 6.0, 0.05);
    EXPECT_EQ(say("$X"), "error:9\r\n");
    send("\x18");
    after(0.0);
    EXPECT_EQ(say("$X"), "[MSG:Caution: Unlocked]\r\nok\r\n");
}

// Catches a fault that is named but not there.
TEST_F(GrblSimulatorTest, EachFaultIsThere) {
    const auto raise = [&](const std::string& name) { ASSERT_TRUE(m_robot->setFault(name)) << name; };
    say("$J=G21G90G53X1F600", 1.0);
    raise("silent");
    EXPECT_EQ(say("?"), "");
    raise("slow-ok");
    EXPECT_EQ(say("$J=G21G90G53X2F600", 2.9), "");
    EXPECT_EQ(after(0.2), "ok\r\n");
    after(1.0);
    raise("lost-steps");
    EXPECT_EQ(say("$J=G21G90G53X3F600", 1.0), "ok\r\n");
    EXPECT_EQ(status(), "<Idle|MPos:2.000,0.000,0.000,0.000");
    raise("door");
    EXPECT_EQ(after(0.0), "[MSG:Check Door]\r\n");
    EXPECT_EQ(m_robot->state(), "Door:1");
    raise("none");
    EXPECT_EQ(m_robot->state(), "Door:0");
    send("~");
    EXPECT_EQ(m_robot->state(), "Idle");
    raise("alarm");
    EXPECT_EQ(after(0.0), "ALARM:1\r\n[MSG:Reset to continue]\r\n");
    raise("restart");
    EXPECT_EQ(after(0.0), "\r\nGrbl 1.1h ['$' for help]\r\n");
    EXPECT_EQ(status(), "<Idle|MPos:0.000,0.000,0.000,0.000"); // it is not there
    EXPECT_NEAR(x(), 2.0, 1e-9);
    raise("garbage");
    std::string spoilt;
    for (int i = 0; i < 100; ++i)
        spoilt += say("$I");
    raise("none");
    std::string whole;
    for (int i = 0; i < 100; ++i)
        whole += say("$I");
    EXPECT_NE(spoilt, whole);
    EXPECT_EQ(m_robot->setFault("nonsense").error().code(), MessageCode::ValueUnknown);
    for (const std::string& name : m_robot->faults())
        raise(name);
}

// Catches a work offset added the wrong way, and inches told as millimetres.
TEST_F(GrblSimulatorTest, TellsItsPlaceAsItIsSet) {
    GrblSimulatorConfig config;
    config.tellsWork = true;
    config.workOffset = {1.0, 2.0, 0.0, 0.0};
    config.start = {25.4, 0.0, 0.0, 0.0};
    make(config);
    EXPECT_EQ(status(), "<Idle|WPos:24.400,-2.000,0.000,0.000");
    config.tellsWork = false;
    config.tellsInches = true;
    make(config);
    EXPECT_EQ(status(), "<Idle|MPos:1.000,0.000,0.000,0.000");
}

} // namespace
} // namespace bask
