#include "engine/base/units.h"
#include "tests/engine/drivers/robot_on_simulator.h"

#include <cmath>

namespace bask::test {
namespace {

class GrblRobotTest : public RobotOnSimulator {};

// Catches a robot that is used before its settings are known, or told without its name, place and time.
TEST_F(GrblRobotTest, TellsWhereItIs) {
    GrblSimulatorConfig config;
    config.start = {10.0, -20.0, 30.0, 45.0};
    make(config);
    EXPECT_EQ(m_robot->status().link, LinkState::Closed);
    run(0.01);
    EXPECT_EQ(m_robot->status().link, LinkState::Opening);
    EXPECT_EQ(m_robot->state().error().code(), MessageCode::RobotOpening);
    run(1.0);
    const auto state = m_robot->state();
    ASSERT_TRUE(state);
    EXPECT_TRUE(state->coordinates.isApprox(
        (Vector6d() << 0.01, -0.02, 0.03, radFromDeg(45.0), 0.0, 0.0).finished(), 1e-9));
    EXPECT_FALSE(state->moving);
    EXPECT_LE(state->time_s, m_clock.now_s());
    EXPECT_GE(state->time_s, m_clock.now_s() - 0.25);
    EXPECT_EQ(m_robot->status().identity, "Grbl 1.1h");
    EXPECT_EQ(m_robot->status().problem.code, MessageCode::None);
    run(5.0);
    EXPECT_NEAR(m_robot->status().rate_Hz, 5.0, 0.5);
}

// Catches steps that are lost between two others, or are made twice: the velocity is held but for the
// moments between steps.
TEST_F(GrblRobotTest, FollowsAVelocity) {
    makeLive();
    EXPECT_TRUE(drive(m_right, 10.0));
    EXPECT_GT(x_mm(), 0.6 * 50.0);
    EXPECT_LT(x_mm(), 50.0 + 0.75);
    RecordProperty("mm_of_50", std::to_string(x_mm()));
    EXPECT_TRUE(m_robot->state()->moving);
    run(1.0);
    EXPECT_FALSE(m_robot->state()->moving);
    EXPECT_EQ(m_robot->discarded(), 0);
}

// Catches motion that goes on when nobody asks for it any more: an engine that is dead, or only its loop.
TEST_F(GrblRobotTest, ADeadEngineStopsItWithinAStep) {
    for (const bool isLoopOnly : {true, false}) {
        makeLive();
        drive(m_right, 1.0);
        ASSERT_TRUE(m_robot->setTwist(m_right, 10.0));
        run(0.5);
        ASSERT_TRUE(m_robot->setTwist(m_right, 0.15));
        const double then = x_mm();
        if (isLoopOnly) {
            run(3.0);
            EXPECT_LT(x_mm() - then, 5.0 * (0.15 + 0.15) + 2.5);
        } else {
            m_clock.advance(3.0);
            m_link->work();
            EXPECT_LT(x_mm() - then, 5.0 * 0.5 + 0.1);
        }
        EXPECT_EQ(m_device->state(), "Idle");
    }
}

// Catches a velocity about one axis that turns another, a direction or origin that is lost, degrees for
// radians.
TEST_F(GrblRobotTest, AxesAreMapped) {
    GrblSimulatorConfig config;
    config.start = {0.0, 0.0, 0.0, 0.0};
    make(config, false, {{'X', 2, true, 0.2}, {'A', 5, false, 0.1}});
    run(1.0);
    clear();
    drive((Vector6d() << 0.0, 0.0, -0.01, 0.0, 0.0, 0.05).finished(), 5.0);
    run(1.0);
    EXPECT_GT(x_mm(), 25.0);
    EXPECT_GT(m_device->positions()[3], degFromRad(0.125));
    EXPECT_EQ(m_device->positions()[1], 0.0);
    const auto q = m_robot->state()->coordinates;
    EXPECT_NEAR(q[2], 0.2 - x_mm() / 1000.0, 2e-6);
    EXPECT_NEAR(q[5], 0.1 + radFromDeg(m_device->positions()[3]), 2e-5);
    // Both axes keep step with each other.
    EXPECT_NEAR((0.2 - q[2]) / (q[5] - 0.1), 0.01 / 0.05, 1e-3);
}

// Catches a velocity so slow that each of its steps is rounded away: 1 um/s for 100 s are 0.1 mm.
TEST_F(GrblRobotTest, SlowVelocitiesAddUp) {
    makeLive();
    drive((Vector6d() << 1e-6, 0, 0, 0, 0, 0).finished(), 100.0);
    run(1.0);
    EXPECT_NEAR(x_mm(), 0.1, 0.03);
}

// Catches a step into what the guard forbids, and one that stops far before it.
TEST_F(GrblRobotTest, StepsEndAtTheWorkspace) {
    m_guard = [](const Vector6d& target) { return target[0] <= 0.012; };
    makeLive();
    drive(m_right, 5.0);
    EXPECT_LE(x_mm(), 12.0);
    EXPECT_GT(x_mm(), 11.9);
    EXPECT_EQ(m_robot->status().problem.code, MessageCode::RobotStepOutside);
    EXPECT_EQ(m_robot->status().link, LinkState::Live);
    drive(-m_right, 2.0); // and it can go back
    EXPECT_LT(x_mm(), 7.0);
    run(6.0);
    EXPECT_EQ(m_robot->status().problem.code, MessageCode::None);
}

// Catches a halt that lets the step run out, or that the robot forgets; both kinds of controller.
TEST_F(GrblRobotTest, HaltStopsAtOnce) {
    for (const bool isHal : {false, true}) {
        GrblSimulatorConfig config;
        config.isHal = isHal;
        makeLive(config);
        EXPECT_TRUE(m_robot->setTwist(4.0 * m_right, 0.5)); // 10 mm
        run(0.2);
        EXPECT_TRUE(m_robot->state()->moving);
        EXPECT_TRUE(m_robot->halt());
        const double then = x_mm();
        run(0.5);
        EXPECT_LT(x_mm() - then, 1.0);
        EXPECT_GT(then, 1.0);
        EXPECT_FALSE(m_robot->state()->moving);
        EXPECT_TRUE(m_robot->state()->isPlaceSure); // a step that was cancelled ends anywhere
        m_link->takeSent();
        EXPECT_TRUE(m_robot->halt());
        EXPECT_EQ(m_link->takeSent(), ""); // nothing to stop
        drive(m_right, 1.0);
        EXPECT_GT(x_mm(), then + 2.0); // and it goes on when told
    }
}

// The overtaking hazard: the cancel comes to the controller before the jog that it is for.
TEST_F(GrblRobotTest, AHaltThatOvertakesItsStepStillStopsIt) {
    for (const bool isHal : {false, true}) {
        GrblSimulatorConfig config;
        config.isHal = isHal;
        config.lineTime_s = 0.1;
        makeLive(config);
        run(1.0);
        EXPECT_TRUE(m_robot->setTwist(4.0 * m_right, 0.5)); // 10 mm
        run(kTick_s);
        ASSERT_EQ(linesIn(m_link->takeSent(), "$J=").size(), 1U);
        EXPECT_TRUE(m_robot->halt());
        run(3.0);
        const double stood = x_mm();
        EXPECT_LT(stood, 2.5) << isHal;
        EXPECT_EQ(m_device->state(), "Idle");
        EXPECT_EQ(m_robot->state()->alarm.code, MessageCode::None) << describe(m_robot->state()->alarm);
        drive(m_right, 2.0); // grblHAL dropped the line without an answer; it goes on nevertheless
        EXPECT_GT(x_mm(), stood + 1.0) << isHal;
    }
}

// Catches a controller that lost its place and everything it was told, and is driven on.
TEST_F(GrblRobotTest, ARestartIsSeen) {
    makeLive();
    drive(m_right, 2.0);
    ASSERT_TRUE(m_device->setFault("restart"));
    m_link->takeSent();
    EXPECT_FALSE(drive(m_right, 1.0));
    EXPECT_EQ(alarm(), MessageCode::RobotRestarted);
    EXPECT_FALSE(m_robot->state()->isPlaceSure);
    EXPECT_TRUE(linesIn(m_link->takeSent(), "$J=").empty());
    m_robot->setRetreating(true); // from the heat it goes without a place
    EXPECT_TRUE(drive(m_right, 0.5));
    m_robot->setRetreating(false);
    EXPECT_TRUE(m_robot->halt());
    run(0.5);
    EXPECT_FALSE(drive(m_right, 0.5));
    m_link->takeSent();
    clear();
    EXPECT_EQ(alarm(), MessageCode::None);
    EXPECT_TRUE(m_robot->state()->isPlaceSure);
    EXPECT_TRUE(drive(m_right, 1.0));
    EXPECT_FALSE(linesIn(m_link->takeSent(), "$J=").empty());
}

// Catches a homing that failed, which Grbl tells after seconds of silence and then starts anew, told as a
// robot that does not answer, as a restart or as an alarm without its number.
TEST_F(GrblRobotTest, AHomingThatFailsIsToldByItsAlarm) {
    for (const bool isHal : {false, true}) {
        GrblSimulatorConfig config;
        config.isHal = isHal;
        makeLive(config, true);
        ASSERT_TRUE(m_device->setFault("homing-fails"));
        ASSERT_TRUE(m_robot->home());
        run(4.0);
        EXPECT_TRUE(m_robot->state()->moving);
        for (int i = 0; i < 50; ++i) { // from its first word on
            run(0.1);
            ASSERT_EQ(m_robot->status().link, LinkState::Live) << describe(m_robot->status().problem);
        }
        EXPECT_EQ(m_robot->state()->alarm,
                  (Message{MessageCode::RobotAlarm, {"9", "homing switch not found"}}));
        EXPECT_FALSE(m_robot->state()->moving);
        EXPECT_FALSE(m_robot->state()->isPlaceSure);
        EXPECT_EQ(m_link->opened(), 1);
        ASSERT_TRUE(m_device->setFault("none"));
        clear();
        run(1.0);
        EXPECT_EQ(alarm(), MessageCode::RobotPlaceUnsure) << "nothing has restarted it";
        ASSERT_TRUE(m_robot->home());
        run(2.0);
        EXPECT_EQ(alarm(), MessageCode::None);
        EXPECT_TRUE(drive(m_right, 0.5));
    }
}

// Catches a robot that was found in an alarm in which it answers nothing, and cannot be homed before it has.
TEST_F(GrblRobotTest, OneFoundInAnAlarmIsHomed) {
    GrblSimulatorConfig config;
    config.start = {100.0, 0.0, 0.0, 0.0};
    make(config, true);
    ASSERT_TRUE(m_device->setFault("alarm"));
    run(2.0);
    ASSERT_EQ(alarm(), MessageCode::RobotAlarm);
    ASSERT_TRUE(m_device->setFault("none"));
    ASSERT_TRUE(m_robot->home());
    EXPECT_TRUE(m_robot->state()->moving) << "from now on";
    run(6.0);
    EXPECT_EQ(alarm(), MessageCode::None);
    EXPECT_TRUE(m_robot->state()->isPlaceSure);
    EXPECT_FALSE(m_robot->state()->moving);
}

// Catches an alarm that is cleared together with the doubt about the place that it left.
TEST_F(GrblRobotTest, AfterALimitSwitchThePlaceIsNotSure) {
    makeLive();
    drive(m_right, 1.0);
    ASSERT_TRUE(m_device->setFault("alarm"));
    run(0.1);
    ASSERT_EQ(alarm(), MessageCode::RobotAlarm);
    EXPECT_EQ(argTexts(m_robot->state()->alarm), (std::vector<std::string>{"1", "hard limit"}));
    EXPECT_EQ(m_robot->setTwist(m_right, 0.15).error().code(), MessageCode::RobotAlarm);
    m_link->takeSent();
    clear(); // a reset, since a mere unlock is refused; then the unlock
    run(0.5);
    EXPECT_EQ(m_device->state(), "Idle");
    EXPECT_EQ(alarm(), MessageCode::RobotPlaceUnsure);
    EXPECT_FALSE(m_robot->state()->isPlaceSure);
    EXPECT_FALSE(drive(m_right, 0.5));
    EXPECT_TRUE(linesIn(m_link->takeSent(), "$J=").empty());
    clear();
    EXPECT_EQ(alarm(), MessageCode::None);
    EXPECT_TRUE(drive(m_right, 0.5));
}

// Catches homing that does not end the doubts, or a robot taken for dead while it tells nothing.
TEST_F(GrblRobotTest, HomingMakesThePlaceSure) {
    GrblSimulatorConfig config;
    config.startsLocked = true;
    config.start = {100.0, 0.0, 0.0, 0.0};
    makeLive(config, true);
    EXPECT_EQ(alarm(), MessageCode::RobotAlarm);
    ASSERT_TRUE(m_robot->home());
    run(1.5); // 2 s of silence
    EXPECT_EQ(m_device->state(), "Home");
    EXPECT_TRUE(m_robot->state()->moving);
    EXPECT_EQ(m_robot->home().error().code(), MessageCode::CommandNotNow);
    run(2.0);
    EXPECT_EQ(alarm(), MessageCode::None);
    EXPECT_TRUE(m_robot->state()->isPlaceSure);
    EXPECT_NEAR(m_robot->state()->coordinates[0], 0.0, 1e-9);
    EXPECT_EQ(m_link->opened(), 1);
    EXPECT_TRUE(drive(m_right, 1.0));
}

TEST_F(GrblRobotTest, WhatMustBeHomedIsNotSureBefore) {
    makeLive({}, true);
    EXPECT_EQ(alarm(), MessageCode::RobotPlaceUnsure);
    EXPECT_EQ(m_robot->clearAlarm().error().code(), MessageCode::RobotPlaceUnsure);
    EXPECT_FALSE(drive(m_right, 0.5));
    EXPECT_EQ(x_mm(), 0.0);
    ASSERT_TRUE(m_robot->home());
    run(1.0);
    EXPECT_EQ(alarm(), MessageCode::None);
}

// Catches homing that is got round: what was found by an earlier one counts after one that was stopped, or
// after the place was lost in an alarm; also with a grblHAL that tells on and on that it was homed.
TEST_F(GrblRobotTest, APlaceThatWasLostMustBeHomedAnew) {
    for (const bool isHal : {false, true})
        for (const bool isStopped : {false, true}) {
            GrblSimulatorConfig config;
            config.isHal = isHal;
            config.start = {100.0, 0.0, 0.0, 0.0};
            makeLive(config, true);
            ASSERT_TRUE(m_robot->home());
            run(4.0);
            ASSERT_EQ(alarm(), MessageCode::None);
            EXPECT_TRUE(drive(m_right, 5.0));
            run(1.0);
            if (isStopped) {
                ASSERT_TRUE(m_robot->home());
                run(0.2);
                EXPECT_TRUE(m_robot->halt());
                run(0.5);
            } else {
                ASSERT_TRUE(m_device->setFault("alarm"));
                run(0.5);
                ASSERT_TRUE(m_device->setFault("none"));
            }
            ASSERT_EQ(alarm(), MessageCode::RobotAlarm);
            clear();
            run(5.0);
            EXPECT_EQ(m_device->state(), "Idle");
            for (int i = 0; i < 3; ++i) {
                EXPECT_EQ(m_robot->clearAlarm().error().code(), MessageCode::RobotPlaceUnsure);
                EXPECT_FALSE(drive(m_right, 3.0));
                EXPECT_FALSE(m_robot->state()->isPlaceSure);
            }
            ASSERT_TRUE(m_robot->home());
            run(4.0);
            EXPECT_EQ(alarm(), MessageCode::None);
            EXPECT_TRUE(drive(m_right, 0.5));
        }
}

// Catches a controller that says zero wherever it was switched on, and is believed.
TEST_F(GrblRobotTest, ThePlaceIsNotSureBeforeItIsConfirmed) {
    make({});
    run(1.0);
    EXPECT_EQ(alarm(), MessageCode::RobotPlaceUnsure);
    EXPECT_FALSE(m_robot->state()->isPlaceSure);
    m_link->takeSent();
    EXPECT_FALSE(drive(m_right, 0.5));
    EXPECT_TRUE(linesIn(m_link->takeSent(), "$J=").empty());
    clear();
    EXPECT_EQ(alarm(), MessageCode::None);
    EXPECT_TRUE(m_robot->state()->isPlaceSure);
    EXPECT_TRUE(drive(m_right, 0.5));
}

// Catches homing that is switched on in the controller and not asked for.
TEST_F(GrblRobotTest, AControllerThatHomesIsToBeHomed) {
    makeLive({}, std::nullopt);
    EXPECT_EQ(alarm(), MessageCode::RobotPlaceUnsure);
    EXPECT_EQ(m_robot->clearAlarm().error().code(), MessageCode::RobotPlaceUnsure);
    ASSERT_TRUE(m_robot->home());
    run(1.0);
    EXPECT_EQ(alarm(), MessageCode::None);

    GrblSimulatorConfig without;
    without.canHome = false;
    makeLive(without, std::nullopt);
    EXPECT_EQ(alarm(), MessageCode::None) << "confirmed";
}

// Catches a controller that was reset by the opening of its port before it had ever been heard.
TEST_F(GrblRobotTest, ARestartWhileItIsOpenedIsSeen) {
    GrblSimulatorConfig config;
    config.isHal = true;
    make(config);
    run(1.0);
    ASSERT_TRUE(m_robot->home());
    run(1.0);
    ASSERT_TRUE(m_robot->state()->isPlaceSure);
    m_robot = std::make_unique<GrblRobot>(
        *m_link, m_clock, AxisMap(kFourAxes, Vector6d::Zero()),
        [this](const Vector6d& target) { return m_guard(target); }, std::nullopt);
    run(1.0);
    EXPECT_TRUE(m_robot->state()->isPlaceSure) << "it tells that it was homed, and went on";
    m_robot = std::make_unique<GrblRobot>(
        *m_link, m_clock, AxisMap(kFourAxes, Vector6d::Zero()),
        [this](const Vector6d& target) { return m_guard(target); }, std::nullopt);
    run(0.1);
    m_device->restart();
    run(1.0);
    EXPECT_EQ(alarm(), MessageCode::RobotPlaceUnsure);
}

TEST_F(GrblRobotTest, HomingIsRefusedWhereThereIsNone) {
    GrblSimulatorConfig config;
    config.canHome = false;
    makeLive(config);
    EXPECT_EQ(m_robot->home().error().code(), MessageCode::RobotCannotHome);
}

// Catches homing that cannot be stopped, or that leaves the place for sure.
TEST_F(GrblRobotTest, HaltEndsHoming) {
    GrblSimulatorConfig config;
    config.start = {100.0, 0.0, 0.0, 0.0};
    makeLive(config);
    ASSERT_TRUE(m_robot->home());
    run(0.5);
    EXPECT_TRUE(m_robot->halt());
    run(0.1);
    EXPECT_EQ(m_device->state(), "Alarm");
    EXPECT_EQ(alarm(), MessageCode::RobotAlarm);
    EXPECT_FALSE(m_robot->state()->isPlaceSure);
    const double stood = x_mm();
    run(1.0);
    EXPECT_EQ(x_mm(), stood);
    clear();
    run(0.5);
    EXPECT_EQ(alarm(), MessageCode::RobotPlaceUnsure);
}

// Catches a stop that does nothing while lines of somebody else run, and one that costs the place.
TEST_F(GrblRobotTest, HaltEndsWhatSomebodyElseRuns) {
    makeLive();
    m_device->receive("G1X50F1000\n", m_clock.now_s());
    run(1.0);
    EXPECT_TRUE(m_robot->state()->moving);
    EXPECT_TRUE(m_robot->halt());
    const double then = x_mm();
    run(1.0);
    EXPECT_LT(x_mm() - then, 2.0);
    EXPECT_EQ(m_device->state(), "Idle");
    EXPECT_EQ(alarm(), MessageCode::None);
    EXPECT_TRUE(m_robot->state()->isPlaceSure);
    EXPECT_TRUE(drive(m_right, 1.0));
}

// Catches a held robot whose waiting line runs when it is released, and a clear that moves.
TEST_F(GrblRobotTest, AHoldIsToldAndFlushed) {
    makeLive();
    drive(m_right, 1.0);
    run(0.5);
    m_device->receive("!", m_clock.now_s());
    EXPECT_TRUE(m_robot->setTwist(m_right, 0.5)); // it does not know yet: this line waits in the controller
    run(0.5);
    EXPECT_EQ(alarm(), MessageCode::RobotHeld);
    EXPECT_EQ(argTexts(m_robot->state()->alarm), std::vector<std::string>{"Hold:0"});
    const double stood = x_mm();
    clear();
    run(1.0);
    EXPECT_EQ(m_device->state(), "Idle");
    EXPECT_EQ(alarm(), MessageCode::None);
    EXPECT_TRUE(m_robot->state()->isPlaceSure); // reset at rest
    EXPECT_EQ(x_mm(), stood);
    EXPECT_TRUE(drive(m_right, 1.0));
    EXPECT_GT(x_mm(), stood + 2.0);
}

// Catches a door that is taken for closed, and a robot that starts again by itself when it is.
TEST_F(GrblRobotTest, ADoorStopsAndStaysTold) {
    makeLive();
    drive(m_right, 1.0);
    ASSERT_TRUE(m_device->setFault("door"));
    run(0.5);
    EXPECT_EQ(alarm(), MessageCode::RobotHeld);
    EXPECT_EQ(m_robot->clearAlarm().error().code(), MessageCode::RobotHeld);
    ASSERT_TRUE(m_device->setFault("none"));
    m_device->receive("~", m_clock.now_s());
    const double stood = x_mm();
    EXPECT_FALSE(drive(m_right, 1.0));
    EXPECT_EQ(x_mm(), stood);
    clear();
    EXPECT_EQ(alarm(), MessageCode::None);
    EXPECT_TRUE(drive(m_right, 1.0));
}

// Catches a controller that is late unnoticed, and its late line running after all.
TEST_F(GrblRobotTest, ASlowControllerIsToldAndStopped) {
    makeLive();
    drive(m_right, 1.0);
    run(0.5);
    ASSERT_TRUE(m_device->setFault("slow-ok"));
    const double stood = x_mm();
    EXPECT_TRUE(m_robot->setTwist(4.0 * m_right, 0.5));
    run(2.1);
    EXPECT_EQ(alarm(), MessageCode::RobotSlow);
    EXPECT_EQ(m_robot->clearAlarm().error().code(), MessageCode::RobotSlow); // still owes an answer
    run(5.0);
    EXPECT_LT(x_mm() - stood, 2.5); // of 10 mm
    ASSERT_TRUE(m_device->setFault("none"));
    run(1.0);
    clear();
    EXPECT_EQ(alarm(), MessageCode::None);
    EXPECT_TRUE(drive(m_right, 1.0));
    EXPECT_GT(x_mm(), stood + 2.0);
}

// Catches steps that are counted as made though the motors stood.
TEST_F(GrblRobotTest, LostStepsAreSeen) {
    makeLive();
    ASSERT_TRUE(m_device->setFault("lost-steps"));
    drive(m_right, 0.5);
    EXPECT_EQ(alarm(), MessageCode::RobotElsewhere);
    EXPECT_EQ(argTexts(m_robot->state()->alarm), (std::vector<std::string>{"0.72", "0.5"}));
    EXPECT_FALSE(m_robot->state()->isPlaceSure);
    m_link->takeSent();
    EXPECT_FALSE(drive(m_right, 0.5));
    EXPECT_TRUE(linesIn(m_link->takeSent(), "$J=").empty());
    ASSERT_TRUE(m_device->setFault("none"));
    clear();
    EXPECT_TRUE(drive(m_right, 0.5));
}

// Catches a line that the controller refuses and the loop never hears of.
TEST_F(GrblRobotTest, ARefusedStepIsTold) {
    GrblSimulatorConfig config;
    config.isHal = true;
    config.upper[0] = 5.0;
    config.hasSoftLimits = true;
    makeLive(config);
    ASSERT_TRUE(m_robot->home());
    run(1.0);
    EXPECT_FALSE(drive(m_right, 3.0));
    EXPECT_EQ(alarm(), MessageCode::RobotRefused);
    EXPECT_EQ(argTexts(m_robot->state()->alarm), (std::vector<std::string>{"15", "jog beyond the travel"}));
    EXPECT_TRUE(m_robot->state()->isPlaceSure);
    EXPECT_LE(x_mm(), 5.0);
    m_robot->setRetreating(true); // another way is free all the same
    EXPECT_TRUE(drive(-m_right, 0.5));
    m_robot->setRetreating(false);
    EXPECT_FALSE(drive(m_right, 3.0));
    EXPECT_EQ(alarm(), MessageCode::RobotRefused);
    clear();
    EXPECT_TRUE(drive(-m_right, 0.5));
}

// Catches a dead device that is believed because its port is open, one that is asked for ever, and one that
// does not come back.
TEST_F(GrblRobotTest, ASilentRobotIsLostAndFoundAgain) {
    makeLive();
    drive(m_right, 1.0);
    run(0.5);
    ASSERT_TRUE(m_device->setFault("silent"));
    run(1.5);
    EXPECT_EQ(m_robot->status().link, LinkState::Lost);
    EXPECT_EQ(m_robot->status().problem.code, MessageCode::DeviceSilent);
    EXPECT_EQ(m_robot->state().error().code(), MessageCode::DeviceSilent);
    EXPECT_EQ(m_robot->setTwist(m_right, 0.15).error().code(), MessageCode::DeviceSilent);
    EXPECT_FALSE(m_robot->halt());
    run(20.0);
    EXPECT_LE(m_link->opened(), 12);
    EXPECT_LT(m_link->takeSent().size(), 600U);
    ASSERT_TRUE(m_device->setFault("none"));
    run(4.5);
    EXPECT_EQ(m_robot->status().link, LinkState::Live);
    EXPECT_EQ(alarm(), MessageCode::None); // where it was left
    EXPECT_TRUE(drive(m_right, 0.5));
}

// Catches an unplugged cable that costs time, or is found again late.
TEST_F(GrblRobotTest, AnUnpluggedCableIsFoundAgainWithinTwoSeconds) {
    makeLive();
    drive(m_right, 1.0);
    m_link->unplug();
    run(0.01);
    EXPECT_EQ(m_robot->status().link, LinkState::Lost);
    EXPECT_EQ(m_robot->state().error().code(), MessageCode::LinkLost);
    const int before = m_link->opened();
    run(10.0);
    EXPECT_LE(m_link->opened() - before, 20);
    EXPECT_EQ(m_robot->state().error().code(), MessageCode::LinkNotOpened);
    m_link->plug();
    run(2.0);
    EXPECT_EQ(m_robot->status().link, LinkState::Live);
    EXPECT_EQ(alarm(), MessageCode::None); // its step had ended in between
}

// Catches a robot that was moved, or started anew, while the cable was out.
TEST_F(GrblRobotTest, ARobotFoundElsewhereIsNotSure) {
    makeLive();
    drive(m_right, 1.0);
    m_link->unplug();
    run(1.0);
    m_device->receive("$J=G91X1F600\n", m_clock.now_s());
    run(1.0);
    m_link->plug();
    run(2.0);
    EXPECT_EQ(alarm(), MessageCode::RobotElsewhere);
    clear();
    EXPECT_EQ(alarm(), MessageCode::None);
    m_link->unplug();
    run(1.0);
    m_link->plug();
    run(0.6);
    m_device->restart(); // by the very opening of the port
    run(1.5);
    EXPECT_EQ(alarm(), MessageCode::RobotRestarted);
}

// Catches a restart that nobody heard because the port was closed for a moment: it stands where it tells to
// be, so that only what a restart resets can tell.
TEST_F(GrblRobotTest, ARestartBehindAClosedPortIsSeen) {
    enum class Meanwhile { Nothing, Restart, AnothersFeed };
    for (const Meanwhile meanwhile : {Meanwhile::Nothing, Meanwhile::Restart, Meanwhile::AnothersFeed}) {
        makeLive();
        run(1.0);
        m_link->unplug();
        run(0.3);
        if (meanwhile == Meanwhile::Restart)
            m_device->restart();
        if (meanwhile == Meanwhile::AnothersFeed)
            m_device->receive("F500\n", m_clock.now_s());
        run(0.2);
        m_link->plug();
        for (int i = 0; i < 40 && m_robot->status().link != LinkState::Live; ++i)
            run(0.05);
        ASSERT_EQ(m_robot->status().link, LinkState::Live);
        const MessageCode expected = meanwhile == Meanwhile::Nothing   ? MessageCode::None
                                     : meanwhile == Meanwhile::Restart ? MessageCode::RobotRestarted
                                                                       : MessageCode::RobotPlaceUnsure;
        EXPECT_EQ(alarm(), expected) << "from the first state on";
        run(2.0);
        EXPECT_EQ(alarm(), expected);
        EXPECT_EQ(drive(m_right, 1.0), meanwhile == Meanwhile::Nothing);
        clear();
        EXPECT_TRUE(drive(m_right, 1.0));
        EXPECT_GT(x_mm(), 2.0);
    }
}

// Catches a controller that is believed after its port was closed although it cannot tell whether it
// restarted.
TEST_F(GrblRobotTest, WhatCannotBeMarkedIsNotSureBehindAClosedPort) {
    make({});
    run(1.0);
    clear(); // and no time to mark it
    m_link->unplug();
    run(0.5);
    m_link->plug();
    run(2.0);
    EXPECT_EQ(alarm(), MessageCode::RobotPlaceUnsure);
    clear();
    run(1.0);
    m_device->receive("G1X1F60\n", m_clock.now_s()); // another's feed, seen: marked anew
    run(3.0);
    m_link->unplug();
    run(0.5);
    m_link->plug();
    run(2.0);
    EXPECT_EQ(alarm(), MessageCode::None);
}

// Catches an Arduino that is taken for dead while it starts, or for restarted when it had not been used yet.
TEST_F(GrblRobotTest, AFirstStartIsWaitedFor) {
    make({});
    ASSERT_TRUE(m_device->setFault("silent"));
    run(2.0);
    ASSERT_TRUE(m_device->setFault("none"));
    m_device->restart();
    run(0.6);
    EXPECT_EQ(m_robot->status().link, LinkState::Live);
    EXPECT_EQ(m_link->opened(), 1);
    EXPECT_EQ(m_robot->status().identity, "Grbl 1.1h");
    EXPECT_EQ(alarm(), MessageCode::RobotPlaceUnsure);
}

// Catches work positions that are used, which a G92 of anybody shifts unseen; and a remedy that does not
// help.
TEST_F(GrblRobotTest, WorkPositionsAreNotUsedAndTheRightReportIsNamed) {
    GrblSimulatorConfig config;
    config.isHal = true;
    config.start = {20.0, 0.0, 0.0, 0.0};
    config.workOffset = {5.0, -3.0, 0.0, 1.0};
    for (const bool tellsOffset : {false, true}) {
        config.tellsOffset = tellsOffset;
        makeLive(config);
        m_device->receive("G92X0\n", m_clock.now_s()); // of no effect on machine positions
        EXPECT_TRUE(drive(m_right, 1.0));
        EXPECT_NEAR(1000.0 * m_robot->state()->coordinates[0], x_mm(), 0.5);
        EXPECT_TRUE(m_robot->state()->isPlaceSure);
        run(1.0);
        m_device->receive("$10=510\n", m_clock.now_s());
        run(1.0);
        m_device->receive("G92X100\n", m_clock.now_s());
        run(5.0);
        EXPECT_EQ(m_robot->state().error().code(), MessageCode::DeviceAnswersWrong);
        EXPECT_EQ(m_robot->status().problem.args.at(1),
                  "its reports have no machine position (MPos); set $10=511 in it");
        const double stood = x_mm();
        EXPECT_FALSE(drive(m_right, 1.0));
        EXPECT_EQ(x_mm(), stood);
        m_device->receive("$10=511\n", m_clock.now_s());
        run(1.5);
        EXPECT_EQ(m_robot->status().link, LinkState::Live);
        EXPECT_EQ(alarm(), MessageCode::None);
        EXPECT_NEAR(1000.0 * m_robot->state()->coordinates[0], x_mm(), 1e-3);
    }
}

// Catches a place told in inches, or without an axis, that is used as if it were not.
TEST_F(GrblRobotTest, OtherWaysToTellThePlace) {
    GrblSimulatorConfig config;
    config.tellsInches = true;
    make(config);
    run(1.0);
    EXPECT_EQ(m_robot->state().error().code(), MessageCode::DeviceAnswersWrong);
    make({}, false, {{'X', 0, false, 0.0}, {'B', 4, false, 0.0}});
    run(1.0);
    EXPECT_EQ(m_robot->state().error().code(), MessageCode::DeviceAnswersWrong);
}

// Catches inches that somebody else sets while it is connected and that are taken for millimetres: its place
// is 25.4 times wrong, sure, and its next step goes back by nearly all of it.
TEST_F(GrblRobotTest, UnitsThatAreChangedByAnotherSenderAreSeen) {
    for (const bool isTold : {false, true}) {
        makeLive();
        drive(m_right, 4.0);
        run(1.0);
        const double stood = x_mm();
        ASSERT_GT(stood, 10.0);
        m_link->takeSent();
        if (isTold)
            m_device->receive("$13=1\n", m_clock.now_s()); // and its ok comes here
        else
            ASSERT_TRUE(m_device->setFault("inches"));
        EXPECT_FALSE(drive(m_right, 1.0));
        EXPECT_NEAR(x_mm(), stood, isTold ? 0.01 : 0.8);
        EXPECT_EQ(m_robot->state().error().code(), MessageCode::DeviceAnswersWrong);
        EXPECT_EQ(m_robot->status().problem.args.at(1), "it tells its place in inches; set $13=0 in it");
        if (isTold)
            m_device->receive("$13=0\n", m_clock.now_s());
        else
            ASSERT_TRUE(m_device->setFault("none"));
        run(2.0);
        EXPECT_EQ(m_robot->status().link, LinkState::Live);
        EXPECT_EQ(alarm(), isTold ? MessageCode::None : MessageCode::RobotElsewhere);
        EXPECT_EQ(m_robot->state()->isPlaceSure, isTold) << "its place was never told wrong";
        clear();
        EXPECT_NEAR(1000.0 * m_robot->state()->coordinates[0], x_mm(), 0.01);
        EXPECT_TRUE(drive(m_right, 1.0));
    }
}

// Catches units that were asked for before somebody else gave it lines, or moved it, and not again.
TEST_F(GrblRobotTest, UnitsAreAskedAgainAfterAnothersLines) {
    makeLive();
    for (const char* line : {"G21\n", "$G\n", "$100=250\n", "G91G1X1F60\n", "$J=G91X1F60\n"}) {
        run(2.0);
        m_link->takeSent();
        m_device->receive(line, m_clock.now_s());
        run(1.5);
        EXPECT_GE(linesIn(m_link->takeSent(), "$$").size(), 1U) << line;
        EXPECT_EQ(alarm(), MessageCode::None) << line << ": the place is as sure as before";
    }
    run(5.0);
    EXPECT_TRUE(linesIn(m_link->takeSent(), "$$").empty());
}

// Catches a robot that was moved between two reports, and is moved on as if it were where it was.
TEST_F(GrblRobotTest, AJumpAtRestIsElsewhere) {
    makeLive();
    run(1.0);
    m_device->receive("$J=G91X2F6000\n", m_clock.now_s());
    m_clock.advance(0.15); // over before it is asked again
    run(1.0);
    EXPECT_EQ(alarm(), MessageCode::RobotElsewhere);
    EXPECT_FALSE(drive(m_right, 0.5));
    clear();
    EXPECT_TRUE(drive(m_right, 0.5));
}

// Catches accelerations left as the factory sets them, in which steps of this speed are hardly begun: nobody
// is told before, and the robot crawls without a word.
TEST_F(GrblRobotTest, ARobotThatCannotFollowItsStepsIsTold) {
    GrblSimulatorConfig config;
    makeLive(config);
    EXPECT_FALSE(m_robot->lagAt(0.025, 0.1, 0.5)) << "500 mm/s2 are enough";
    config.acceleration_mm_s2 = 10.0;
    makeLive(config);
    const auto lag = m_robot->lagAt(0.025, 0.1, 0.5);
    ASSERT_TRUE(lag);
    EXPECT_EQ(lag->setting, "$120=10");
    EXPECT_EQ(lag->planned_s, 0.5);
    EXPECT_NEAR(lag->taken_s, 2.0 * std::sqrt(12.5 / 10.0), 1e-9);
    EXPECT_NEAR(lag->mean_m_s, 0.0125 / lag->taken_s, 1e-9);
    EXPECT_FALSE(m_robot->lagAt(0.001, 0.01, 0.5)) << "slow enough";
    ASSERT_TRUE(m_robot->setTwist(5.0 * m_right, 0.5)); // 12.5 mm
    run(1.4);
    EXPECT_EQ(alarm(), MessageCode::None);
    run(0.4);
    EXPECT_EQ(alarm(), MessageCode::RobotStepLate);
    EXPECT_EQ(m_robot->setTwist(m_right, 0.15).error().code(), MessageCode::RobotStepLate);
    run(2.0);
    EXPECT_LT(x_mm(), 12.5);
    EXPECT_FALSE(m_robot->state()->moving);
    EXPECT_TRUE(m_robot->state()->isPlaceSure);
    m_robot->setRetreating(true); // it goes on as it can
    const double then_s = m_clock.now_s(), from = x_mm();
    while (x_mm() - from < 50.0 && m_clock.now_s() - then_s < 60.0) {
        (void)m_robot->setTwist(5.0 * m_right, 0.5);
        run(0.1);
    }
    EXPECT_EQ(alarm(), MessageCode::None);
    EXPECT_NEAR(m_clock.now_s() - then_s, 0.05 / lag->mean_m_s, 0.3 * 0.05 / lag->mean_m_s) << "as predicted";
    m_robot->setRetreating(false);

    config.acceleration_mm_s2 = 500.0;
    config.maxRate_mm_min = 100.0;
    makeLive(config);
    ASSERT_TRUE(m_robot->lagAt(0.025, 0.1, 0.5));
    EXPECT_EQ(m_robot->lagAt(0.025, 0.1, 0.5)->setting, "$110=100");
}

// Catches a slow robot in place of an engine that was held up while a step was under way.
TEST_F(GrblRobotTest, AStallOfTheEngineIsNoLateStep) {
    makeLive();
    for (int i = 0; i < 10; ++i) {
        ASSERT_TRUE(m_robot->setTwist(m_right, 0.5));
        run(0.06 + 0.01 * i);
        m_clock.advance(2.0);
        run(0.5);
        ASSERT_EQ(alarm(), MessageCode::None) << i;
    }
}

// Catches noise that is used, that is not counted or told, or that ends the link.
TEST_F(GrblRobotTest, GarbageIsDiscardedAndTold) {
    makeLive();
    ASSERT_TRUE(m_device->setFault("garbage"));
    run(20.0);
    EXPECT_GT(m_robot->discarded(), 2);
    EXPECT_EQ(m_robot->status().problem.code, MessageCode::DeviceAnswersWrong);
    ASSERT_TRUE(m_device->setFault("none"));
    run(10.0);
    EXPECT_EQ(m_robot->status().link, LinkState::Live);
    EXPECT_EQ(m_robot->status().problem.code, MessageCode::None);
}

// Catches a place that is told with a time after it was measured: on its way at a known speed, the robot is
// never told to have been where it was only earlier.
TEST_F(GrblRobotTest, NoPlaceIsNewerThanItWasMeasured) {
    GrblSimulatorConfig config;
    config.acceleration_mm_s2 = 0.0;
    makeLive(config);
    m_link->setDelay(0.06);
    run(1.0);
    std::vector<std::pair<double, double>> way; // time, where it truly was
    int compared = 0;
    for (int i = 0; i < 2000; ++i) {
        if (i % 20 == 0) {
            ASSERT_TRUE(m_robot->setTwist(m_right, 0.15));
        }
        run(kTick_s);
        way.emplace_back(m_clock.now_s(), x_mm());
        const auto state = m_robot->state();
        ASSERT_TRUE(state);
        for (const auto& [time_s, x] : way)
            if (std::abs(time_s - state->time_s) < 1e-9) {
                ASSERT_GE(1000.0 * state->coordinates[0], x - 1e-3) << time_s;
                ++compared;
            }
        if (way.size() > 200)
            way.erase(way.begin());
    }
    EXPECT_GT(compared, 1000);
    EXPECT_GT(x_mm(), 10.0);
}

// Catches numbers without sense that are stored and sent later.
TEST_F(GrblRobotTest, ATwistThatIsNotFiniteIsABrokenContract) {
    makeLive();
    Vector6d twist = m_right;
    twist[4] = std::nan("");
    EXPECT_THROW((void)m_robot->setTwist(twist, 0.1), std::invalid_argument);
    EXPECT_THROW((void)m_robot->setTwist(m_right, HUGE_VAL), std::invalid_argument);
}

} // namespace
} // namespace bask::test
