// Devices behind a program: what they do with its answers, and what they ask of it.

#include "engine/base/units.h"
#include "engine/drivers/program_heater.h"
#include "engine/drivers/program_robot.h"
#include "engine/drivers/program_thermometer.h"
#include "tests/engine/drivers/scripted_program.h"

#include <gtest/gtest.h>

#include <cmath>

namespace bask::test {
namespace {

using Json = ScriptedProgram::Json;

constexpr double kTick_s = 0.005;

class ProgramDriversTest : public testing::Test {
protected:
    template <class Driver> void run(Driver& device, double for_s) {
        const double until_s = m_clock.now_s() + for_s;
        while (m_clock.now_s() < until_s) {
            m_clock.advance(kTick_s);
            if (move)
                move(kTick_s);
            device.work();
        }
    }

    ManualClock m_clock;
    ScriptedProgram m_program{m_clock};
    std::function<void(double)> move;
};

/// An arm that moves x and turns about z, by velocities or by steps.
class ProgramRobotTest : public ProgramDriversTest {
protected:
    void make(const char* moves, bool mustHome = false) {
        m_program = ScriptedProgram(m_clock);
        m_program.hello = {{"protocol", 1},
                           {"role", "robot"},
                           {"name", "Arm"},
                           {"serial", "7"},
                           {"axes", {"theta_z", "x"}},
                           {"moves", moves},
                           {"can_home", true},
                           {"limits", {{"x", {-0.05, 0.05}}, {"theta_z", {-30.0, 40.0}}}}};
        m_program.state = [this] {
            return Json{{"position", {at[0], at[1]}},
                        {"moving", isMoving},
                        {"sure", isSure},
                        {"alarm", alarm},
                        {"age", age_s}};
        };
        m_program.obey = [this](const Json& request) { obey(request); };
        move = [this](double dt_s) { advance(dt_s); };
        robot = std::make_unique<ProgramRobot>(
            m_program, m_clock, AxisMap({{'X', kX, false, 0.1}, {'C', kThetaZ, true, 0.0}}, Vector6d::Zero()),
            [this](const Vector6d& target) { return mayGo(target); }, mustHome);
    }
    void makeLive(const char* moves) {
        make(moves);
        run(*robot, 0.5);
        ASSERT_TRUE(robot->state()) << describe(robot->state().error());
    }
    void obey(const Json& request) {
        const std::string what = request["do"];
        if (what == "velocity") {
            rates = {request["rates"][0], request["rates"][1]};
            until_s = m_clock.now_s() + request["valid_for"].get<double>();
        } else if (what == "step") {
            const double duration_s = request["duration"];
            for (std::size_t i = 0; i < 2; ++i)
                rates[i] = (request["to"][i].get<double>() - at[i]) / duration_s;
            until_s = m_clock.now_s() + duration_s;
        } else if (what == "stop" && !isDeaf) {
            until_s = -1.0;
        } else if (what == "clear") {
            isSure = true;
            alarm.clear();
        }
    }
    void advance(double dt_s) {
        isMoving = m_clock.now_s() <= until_s + 1e-9;
        for (std::size_t i = 0; i < 2 && isMoving; ++i)
            at[i] += direction * rates[i] * dt_s;
    }
    Vector6d twist(double x_m_s, double turn_rad_s = 0.0) const {
        Vector6d out = Vector6d::Zero();
        out[kX] = x_m_s;
        out[kThetaZ] = turn_rad_s;
        return out;
    }
    bool drive(const Vector6d& wanted, double for_s) {
        bool isTaken = true;
        for (double t_s = 0.0; t_s < for_s; t_s += 0.1) {
            isTaken = robot->setTwist(wanted, 0.15).ok() && isTaken;
            run(*robot, 0.1);
        }
        return isTaken;
    }

    std::array<double, 2> at{0.0, 0.0}, rates{0.0, 0.0}; ///< theta_z, x
    double until_s = -1.0, direction = 1.0, age_s = 0.0;
    bool isMoving = false, isSure = true, isDeaf = false;
    std::string alarm;
    std::function<bool(const Vector6d&)> mayGo = [](const Vector6d&) { return true; };
    std::unique_ptr<ProgramRobot> robot;
};

// Catches axes that are taken for one another, a direction or an origin that is lost, mm for m.
TEST_F(ProgramRobotTest, TellsWhereItIs) {
    at = {0.3, 0.02};
    make("steps");
    EXPECT_FALSE(robot->state());
    run(*robot, 0.3);
    const auto state = robot->state();
    ASSERT_TRUE(state) << describe(state.error());
    EXPECT_NEAR(state->coordinates[kX], 0.12, 1e-6);
    EXPECT_NEAR(state->coordinates[kThetaZ], -0.3, 1e-5);
    EXPECT_FALSE(state->moving);
    EXPECT_TRUE(state->isPlaceSure);
    EXPECT_LE(state->time_s, m_clock.now_s());
    EXPECT_GE(state->time_s, m_clock.now_s() - 0.1);
    EXPECT_EQ(robot->status().identity, "Arm, 7");
    EXPECT_EQ(robot->status().link, LinkState::Live);
    run(*robot, 2.0);
    EXPECT_GE(robot->status().rate_Hz, 10.0);
}

// Catches limits that are those of the program's own counting, where the rig says that an axis is reversed or
// begins elsewhere.
TEST_F(ProgramRobotTest, TellsItsReachInTheFrameOfTheRig) {
    make("steps");
    EXPECT_TRUE(std::isinf(robot->reach().upper[kX])) << "before it has said hello";
    run(*robot, 0.3);
    const RobotReach reach = robot->reach();
    EXPECT_NEAR(reach.lower[kX], 0.05, 1e-12);
    EXPECT_NEAR(reach.upper[kX], 0.15, 1e-12);
    EXPECT_NEAR(reach.lower[kThetaZ], -40.0, 1e-12);
    EXPECT_NEAR(reach.upper[kThetaZ], 30.0, 1e-12);
    EXPECT_TRUE(std::isinf(reach.lower[kZ]));
}

// Catches motion that does not follow, and one that goes on when nobody asks for it.
TEST_F(ProgramRobotTest, FollowsAVelocityAndStandsAfterIt) {
    for (const char* moves : {"velocity", "steps"}) {
        at = {0.0, 0.0};
        until_s = -1.0;
        makeLive(moves);
        EXPECT_TRUE(drive(twist(0.01, -0.1), 3.0)) << moves;
        EXPECT_TRUE(robot->state()->moving);
        EXPECT_NEAR(at[1], 0.03, 0.003) << moves;
        EXPECT_NEAR(at[0], 0.3, 0.03) << moves << ": the axis counts the other way";
        const double then = at[1];
        run(*robot, 1.0);
        EXPECT_LE(at[1] - then, 0.01 * 0.15 + 1e-4) << moves;
        EXPECT_FALSE(robot->state()->moving) << moves;
        EXPECT_EQ(robot->state()->alarm.code, MessageCode::None) << describe(robot->state()->alarm);
    }
}

// Catches a step that nobody has approved, and one that a refusal keeps coming back.
TEST_F(ProgramRobotTest, GoesOnlyWhereItMay) {
    for (const char* moves : {"velocity", "steps"}) {
        at = {0.0, 0.0};
        until_s = -1.0;
        mayGo = [](const Vector6d& target) { return target[kX] <= 0.11; };
        makeLive(moves);
        drive(twist(0.02), 3.0);
        EXPECT_GT(at[1], 0.008) << moves;
        EXPECT_LE(at[1], 0.01 + 0.02 * kTick_s + 1e-6) << moves << ": a velocity ends a tick late";
        EXPECT_EQ(robot->status().problem.code, MessageCode::RobotStepOutside);
        drive(twist(-0.02), 1.0);
        EXPECT_LT(at[1], 0.0) << moves << ": back it may go";
    }
    mayGo = [](const Vector6d&) { return true; };
    at = {0.0, 0.049};
    makeLive("steps");
    drive(twist(0.02), 1.0);
    EXPECT_LE(at[1], 0.05 + 1e-6) << "the limits of its hello";
}

// Catches a robot that runs away, or moves the wrong way, unnoticed.
TEST_F(ProgramRobotTest, ThatIsElsewhereStops) {
    for (const char* moves : {"velocity", "steps"}) {
        at = {0.0, 0.0};
        until_s = direction = -1.0;
        makeLive(moves);
        drive(twist(0.01), 1.0);
        EXPECT_EQ(robot->state()->alarm.code, MessageCode::RobotElsewhere) << moves;
        EXPECT_GT(at[1], -0.003) << moves;
        EXPECT_FALSE(robot->setTwist(twist(0.01), 0.15));
        ASSERT_TRUE(robot->clearAlarm());
        run(*robot, 0.2);
        EXPECT_EQ(robot->state()->alarm.code, MessageCode::None);
    }
    direction = 1.0;
    until_s = -1.0;
    makeLive("steps");
    at[1] += 0.002;
    run(*robot, 0.2);
    EXPECT_EQ(robot->state()->alarm.code, MessageCode::RobotElsewhere) << "pushed at rest";
}

// Catches a stop that is said once to a robot that does not hear it.
TEST_F(ProgramRobotTest, IsToldToStandUntilItDoes) {
    makeLive("velocity");
    drive(twist(0.01), 0.5);
    isDeaf = true;
    const int before = m_program.count("stop");
    until_s = m_clock.now_s() + 2.0;
    ASSERT_TRUE(robot->halt());
    EXPECT_EQ(m_program.count("stop"), before + 1) << "at once";
    run(*robot, 1.0);
    EXPECT_GE(m_program.count("stop"), before + 4);
    EXPECT_TRUE(robot->state()->moving);
    until_s = m_clock.now_s() + 100.0;
    run(*robot, 4.5);
    EXPECT_NE(describe(robot->state()->alarm).find("although it was told to stop"), std::string::npos);
    isDeaf = false;
    run(*robot, 0.5);
    EXPECT_FALSE(robot->state()->moving);
}

TEST_F(ProgramRobotTest, DoesNotMoveWithAnAlarmARefusalOrAnUnsurePlace) {
    makeLive("steps");
    alarm = "the door is open";
    run(*robot, 0.2);
    EXPECT_EQ(robot->state()->alarm.code, MessageCode::RobotReports);
    EXPECT_NE(describe(robot->state()->alarm).find("the door is open"), std::string::npos);
    EXPECT_FALSE(robot->setTwist(twist(0.01), 0.15));
    alarm.clear();
    isSure = false;
    run(*robot, 0.2);
    EXPECT_EQ(robot->setTwist(twist(0.01), 0.15).error().code(), MessageCode::RobotPlaceUnsure);
    robot->setRetreating(true);
    EXPECT_TRUE(robot->setTwist(twist(0.01), 0.15)) << "away from the heat";
    robot->setRetreating(false);
    ASSERT_TRUE(robot->clearAlarm());
    run(*robot, 0.2);
    m_program.refusals["step"] = "the brake is on";
    drive(twist(0.01), 0.3);
    EXPECT_EQ(robot->state()->alarm.code, MessageCode::ProgramRefuses);
    EXPECT_NE(describe(robot->state()->alarm).find("the brake is on"), std::string::npos);
    m_program.refusals.clear();
    ASSERT_TRUE(robot->clearAlarm());
    EXPECT_TRUE(drive(twist(0.01), 0.3));
}

TEST_F(ProgramRobotTest, MustBeHomedIfTheRigSaysSo) {
    make("steps", true);
    run(*robot, 0.5);
    EXPECT_FALSE(robot->state()->isPlaceSure);
    EXPECT_FALSE(robot->clearAlarm()) << "a person's word is not enough";
    ASSERT_TRUE(robot->home());
    EXPECT_TRUE(robot->state()->moving);
    run(*robot, 0.3);
    EXPECT_TRUE(robot->state()->isPlaceSure);
    EXPECT_FALSE(robot->state()->moving);
}

// Catches a program that drives other axes than the rig has: the objects would be elsewhere.
TEST_F(ProgramRobotTest, OfOtherAxesIsNotUsed) {
    make("steps");
    m_program.hello["axes"] = {"x", "y"};
    run(*robot, 0.5);
    EXPECT_FALSE(robot->state());
    EXPECT_EQ(robot->status().problem.code, MessageCode::ProgramOther);
    EXPECT_NE(describe(robot->status().problem).find("x, y"), std::string::npos);
    EXPECT_EQ(m_program.asked, std::vector<std::string>{"hello"});
}

// Catches a device in another's place that is commanded, or asked for anything but its name.
TEST_F(ProgramRobotTest, AnotherOneIsOnlyAskedForItsName) {
    make("steps");
    robot->expect("Arm, 6");
    run(*robot, 0.5);
    EXPECT_EQ(robot->status().problem.code, MessageCode::DeviceExchanged);
    EXPECT_FALSE(robot->home());
    EXPECT_FALSE(robot->setTwist(twist(0.01), 0.15));
    EXPECT_EQ(m_program.asked, std::vector<std::string>{"hello"});
}

struct Defect {
    const char* what;
    std::function<void(ScriptedProgram&)> raise;
    const char* words;
    double within_s;
};

// Catches a program that talks nonsense, or has a wrong clock, and goes on steering the robot.
TEST_F(ProgramRobotTest, ThatBreaksTheProtocolIsEnded) {
    for (const Defect& defect :
         {Defect{"no JSON", [](ScriptedProgram& p) { p.sayText("a\nb\nc\n"); }, "3 lines", 0.02},
          Defect{"seq",
                 [](ScriptedProgram& p) {
                     p.say({{"state", p.state()}}), p.seqOff += 5;
                 },
                 "", 0.5},
          Defect{"wrong id",
                 [](ScriptedProgram& p) {
                     for (int i = 0; i < 3; ++i)
                         p.say({{"id", 999}, {"ok", true}});
                 },
                 "999", 0.02},
          Defect{"line of 100 KB", [](ScriptedProgram& p) { p.sayText(std::string(100000, 'x')); },
                 "longer than", 0.02},
          Defect{"clock set", [](ScriptedProgram& p) { p.clockOff_s = -30.0; }, "clock", 0.5},
          Defect{"clock slow",
                 [](ScriptedProgram& p) {
                     p.clockOff_s = 0.5 * p.now_s();
                     p.clockRate = 0.5;
                 },
                 "clock", 1.6},
          Defect{"silent", [](ScriptedProgram& p) { p.isSilent = true; }, "has not answered", 1.5}}) {
        until_s = -1.0;
        makeLive("velocity");
        const int before = m_program.closed;
        if (std::string(defect.what) == "seq") {
            m_program.seqOff = 5; // one gap is told; the lines after it count on
            run(*robot, 0.3);
            EXPECT_GE(robot->status().discarded, 1);
            EXPECT_NE(describe(robot->status().problem).find("seq"), std::string::npos);
            EXPECT_EQ(m_program.closed, before);
            continue;
        }
        defect.raise(m_program);
        const double from_s = m_clock.now_s();
        while (m_program.closed == before && m_clock.now_s() - from_s < defect.within_s)
            run(*robot, kTick_s);
        EXPECT_GT(m_program.closed, before) << defect.what;
        EXPECT_NE(describe(robot->status().problem).find(defect.words), std::string::npos)
            << defect.what << ": " << describe(robot->status().problem);
        EXPECT_EQ(robot->status().link, LinkState::Lost) << defect.what;
        EXPECT_FALSE(robot->state()) << defect.what;
    }
}

// Catches a run that ends for one number that nobody can mean.
TEST_F(ProgramRobotTest, GoesOnAfterOneAnswerThatCannotBeUsed) {
    makeLive("velocity");
    at[1] = 5000.0;
    run(*robot, 0.055);
    at[1] = 0.0;
    drive(twist(0.01), 3.0);
    EXPECT_EQ(m_program.closed, 0);
    EXPECT_TRUE(robot->state()) << describe(robot->state().error());
    EXPECT_GE(robot->status().discarded, 1);
    EXPECT_NEAR(at[1], 0.03, 0.004);
}

// Catches a place that is taken for sure after half a homing, or a new start that counts from zero.
TEST_F(ProgramRobotTest, IsNotSureAfterAHomingThatWasStoppedOrANewStart) {
    makeLive("velocity");
    ASSERT_TRUE(robot->home());
    ASSERT_TRUE(robot->halt());
    run(*robot, 0.5);
    EXPECT_FALSE(robot->state()->isPlaceSure);
    ASSERT_TRUE(robot->home());
    run(*robot, 0.5);
    EXPECT_TRUE(robot->state()->isPlaceSure);
    m_program.isUp = false;
    run(*robot, 1.5);
    ASSERT_TRUE(robot->state());
    EXPECT_FALSE(robot->state()->isPlaceSure);
    EXPECT_EQ(robot->state()->alarm.code, MessageCode::RobotRestarted);
    EXPECT_TRUE(robot->clearAlarm());
    run(*robot, 0.2);
    EXPECT_TRUE(robot->state()->isPlaceSure);
}

// Catches a homing that is taken for done by a state from before it.
TEST_F(ProgramRobotTest, IsNotHomedByAnOldState) {
    make("steps", true);
    run(*robot, 0.5);
    age_s = 0.3;
    ASSERT_TRUE(robot->home());
    run(*robot, 0.2);
    EXPECT_FALSE(robot->state()->isPlaceSure);
    EXPECT_TRUE(robot->state()->moving);
    run(*robot, 0.4);
    EXPECT_TRUE(robot->state()->isPlaceSure);
}

// Catches a device that is slow for a moment, whose program is ended for it; and one that is believed for
// long.
TEST_F(ProgramRobotTest, ThatTellsNoStateIsLostUntilItDoes) {
    makeLive("velocity");
    m_program.refusals["read"] = "no answer from the arm";
    run(*robot, 0.8);
    EXPECT_TRUE(robot->state());
    EXPECT_NE(describe(robot->status().problem).find("no answer from the arm"), std::string::npos);
    run(*robot, 0.4);
    EXPECT_FALSE(robot->state());
    EXPECT_EQ(robot->status().link, LinkState::Lost);
    EXPECT_EQ(m_program.closed, 0);
    m_program.refusals.clear();
    run(*robot, 0.2);
    EXPECT_TRUE(robot->state());
}

class ProgramHeaterTest : public ProgramDriversTest {
protected:
    void make(bool hasWatchdog = true, bool mayHeatUnattended = false) {
        m_program = ScriptedProgram(m_clock);
        m_program.hello = {{"protocol", 1},
                           {"role", "heater"},
                           {"name", "Plate"},
                           {"max_temperature", 600.0},
                           {"watchdog", hasWatchdog}};
        m_program.state = [this] {
            return Json{{"temperature", temperature_K ? Json(*temperature_K) : Json()},
                        {"heating", isHeating},
                        {"set_point", told_K}};
        };
        m_program.obey = [this](const Json& request) {
            isHeating = request["do"] == "heat" || (request["do"] == "off" && isStuck && isHeating);
            if (isHeating && request.contains("set_point"))
                told_K = request["set_point"].get<double>() - off_K;
        };
        heater = std::make_unique<ProgramHeater>(m_program, m_clock, mayHeatUnattended);
        run(*heater, 0.5);
    }

    std::optional<double> temperature_K = 300.0;
    double told_K = 300.0, off_K = 0.0;
    bool isHeating = false, isStuck = false;
    std::unique_ptr<ProgramHeater> heater;
};

// Catches heat that stays on when nobody keeps it on, and a state that is shown as known.
TEST_F(ProgramHeaterTest, HeatsWhileItIsAskedTo) {
    isHeating = true; // by somebody else
    make();
    EXPECT_FALSE(isHeating) << "off comes first";
    EXPECT_EQ(m_program.asked[1] == "off" || m_program.asked[2] == "off", true);
    EXPECT_EQ(heater->heatState(), HeatState::Off);
    EXPECT_FALSE(heater->heating());
    for (int i = 0; i < 20; ++i) {
        ASSERT_TRUE(heater->keepHeating(500.0, 1.0));
        run(*heater, 0.25);
    }
    EXPECT_TRUE(isHeating && heater->heating());
    EXPECT_EQ(heater->heatState(), HeatState::On);
    EXPECT_EQ(heater->setPoint_K(), 500.0);
    EXPECT_LE(m_program.last("heat")["valid_for"], 1.0);
    run(*heater, 1.1);
    EXPECT_FALSE(isHeating) << "by itself";
    run(*heater, 0.3);
    EXPECT_EQ(heater->heatState(), HeatState::Off);
}

TEST_F(ProgramHeaterTest, IsOffOnlyWhenItSaysSo) {
    make();
    ASSERT_TRUE(heater->keepHeating(500.0, 10.0));
    run(*heater, 0.3);
    isStuck = true;
    EXPECT_TRUE(heater->heatOff());
    run(*heater, 1.0);
    EXPECT_TRUE(heater->heating());
    EXPECT_EQ(heater->heatState(), HeatState::On);
    EXPECT_GE(m_program.count("off"), 3) << "it is told again";
    run(*heater, 3.0);
    EXPECT_FALSE(heater->heatOff()) << "and that it is in vain";
    isStuck = false;
    run(*heater, 1.0);
    EXPECT_FALSE(heater->heating());
    EXPECT_TRUE(heater->heatOff());
}

TEST_F(ProgramHeaterTest, RefusesWhatItMayNot) {
    make();
    EXPECT_EQ(heater->keepHeating(601.0, 1.0).error().code(), MessageCode::ValueOutOfRange);
    EXPECT_EQ(heater->keepHeating(std::nan(""), 1.0).error().code(), MessageCode::ValueOutOfRange);
    EXPECT_EQ(heater->keepHeating(500.0, 0.0).error().code(), MessageCode::ValueNotPositive);
    EXPECT_EQ(m_program.count("heat"), 0);
    m_program.refusals["heat"] = "the fuse is out";
    ASSERT_TRUE(heater->keepHeating(500.0, 1.0));
    run(*heater, 0.2);
    EXPECT_EQ(heater->status().problem.code, MessageCode::ProgramRefuses);
    EXPECT_FALSE(heater->keepHeating(500.0, 1.0));
    EXPECT_TRUE(heater->heatOff());
    make(false);
    EXPECT_EQ(heater->cannotHeat().code, MessageCode::SourceUnwatched);
    EXPECT_FALSE(heater->keepHeating(500.0, 1.0));
    make(false, true);
    EXPECT_EQ(heater->cannotHeat().code, MessageCode::None);
    EXPECT_FALSE(heater->hasWatchdog());
}

TEST_F(ProgramHeaterTest, TellsASetPointThatIsOther) {
    off_K = 20.0;
    make();
    for (int i = 0; i < 5; ++i) {
        ASSERT_TRUE(heater->keepHeating(500.0, 1.0));
        run(*heater, 0.2);
    }
    EXPECT_EQ(heater->status().problem.code, MessageCode::SafetySetPointOther);
    temperature_K.reset();
    run(*heater, 0.2);
    ASSERT_TRUE(heater->read());
    EXPECT_FALSE(heater->read()->valid);
}

// Catches heat that is taken for off when the program is gone, and on again when it is back.
TEST_F(ProgramHeaterTest, ThatHasDiedIsNotKnown) {
    make();
    ASSERT_TRUE(heater->keepHeating(500.0, 10.0));
    run(*heater, 0.3);
    m_program.isUp = false;
    m_program.hasDied = true;
    run(*heater, 0.02);
    EXPECT_EQ(heater->heatState(), HeatState::Unknown);
    EXPECT_TRUE(heater->heating());
    EXPECT_EQ(heater->status().problem.code, MessageCode::ProgramEnded);
    EXPECT_FALSE(heater->keepHeating(500.0, 1.0));
    m_program.hasDied = false;
    const int heats = m_program.count("heat");
    run(*heater, 1.5);
    EXPECT_EQ(m_program.count("heat"), heats);
    EXPECT_EQ(heater->heatState(), HeatState::Off);
}

TEST_F(ProgramDriversTest, AThermometerTellsAgesFaultsAndUncertainties) {
    Json temperatures{300.0, nullptr, 310.0};
    m_program.hello = {{"protocol", 1}, {"role", "thermometer"}, {"name", "Logger"}, {"channels", 3}};
    m_program.state = [&] {
        return Json{{"temperatures", temperatures},
                    {"faults", {"", "open", ""}},
                    {"uncertainties", {0.1, 0.0, 0.3}},
                    {"age", 0.4}};
    };
    ProgramThermometer thermometer(m_program, m_clock, 2);
    EXPECT_FALSE(thermometer.read());
    run(thermometer, 0.5);
    auto readings = thermometer.read();
    ASSERT_TRUE(readings) << describe(readings.error());
    ASSERT_EQ(readings->size(), 3U);
    EXPECT_EQ(readings->at(0).value_K, 300.0);
    EXPECT_EQ(readings->at(0).standardUncertainty_K, 0.1);
    EXPECT_FALSE(readings->at(1).valid);
    EXPECT_EQ(readings->at(1).fault, SensorFault::Open);
    EXPECT_NEAR(readings->at(2).time_s, m_clock.now_s() - 0.45, 0.06);
    temperatures = {300.0, 300.0};
    run(thermometer, 0.5);
    EXPECT_GE(thermometer.status().discarded, 1) << "two temperatures instead of three";

    m_program.close();
    ProgramThermometer wanting(m_program, m_clock, 4);
    run(wanting, 0.5);
    EXPECT_EQ(wanting.status().problem.code, MessageCode::ProgramOther);
    EXPECT_FALSE(wanting.read());
}

} // namespace
} // namespace bask::test
