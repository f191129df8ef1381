#include "engine/drivers/namur_heater.h"

#include "engine/base/message_code.h"
#include "engine/base/units.h"
#include "engine/device_simulators/namur_simulator.h"
#include "tests/engine/drivers/test_links.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace bask {
namespace {

const double kSixty_K = kelvinFromCelsius(60.0);

/// A plate that the test plays: what it answers to each line, at once.
class NamurHeaterTest : public testing::Test {
protected:
    /// Lines sent in `time_s`, answered by m_answers.
    std::vector<std::string> run(double time_s) {
        std::vector<std::string> lines;
        for (double t = 0.0; t < time_s - 1e-9; t += 0.01) {
            m_heater.work();
            std::string sent = m_link.takeSent();
            for (std::size_t end = 0; (end = sent.find("\r\n")) != std::string::npos;
                 sent.erase(0, end + 2)) {
                lines.push_back(sent.substr(0, sent.find_last_not_of(' ', end - 1) + 1));
                if (m_takesSetPoint && lines.back().starts_with("OUT_SP_1 "))
                    m_answers["IN_SP_1"] = lines.back().substr(9) + " 1 \r\n";
                m_heard[lines.back()].push_back(m_clock.now_s());
                if (const auto answer = m_answers.find(lines.back()); answer != m_answers.end())
                    m_link.say(answer->second);
            }
            EXPECT_EQ(sent, "") << "half a line";
            m_clock.advance(0.01);
        }
        return lines;
    }
    std::size_t count(const std::string& line) { return m_heard[line].size(); }

    ManualClock m_clock;
    test::ScriptedLink m_link{"/dev/ttyTEST"};
    NamurHeater m_heater{m_link, m_clock, {}};
    std::map<std::string, std::string> m_answers{{"IN_NAME", "IKARCT \r\n"},
                                                 {"IN_PV_2", "25.5 2 \r\n"},
                                                 {"IN_SP_1", "60.0 1 \r\n"},
                                                 {"OUT_WD1@30", "30.0 \r\n"}};
    std::map<std::string, std::vector<double>> m_heard;
    bool m_takesSetPoint = true;
};

// Catches a driver that does not ask as the manual says, or that tells a temperature newer than its question.
TEST_F(NamurHeaterTest, asksForNameTemperatureAndSetPoint) {
    EXPECT_EQ(m_heater.status().link, LinkState::Closed);
    EXPECT_FALSE(m_heater.read().ok());
    run(0.01);
    EXPECT_EQ(m_heater.status().link, LinkState::Opening);
    m_takesSetPoint = false;
    run(2.0);
    const DeviceStatus status = m_heater.status();
    EXPECT_EQ(status.link, LinkState::Live);
    EXPECT_EQ(status.identity, "IKARCT");
    EXPECT_EQ(status.problem, Message{});
    EXPECT_NEAR(status.rate_Hz, 5.0, 1.0);
    EXPECT_NEAR(status.replyTime_s, 0.01, 1e-9);
    const auto reading = m_heater.read();
    ASSERT_TRUE(reading.ok());
    EXPECT_TRUE(reading->valid);
    EXPECT_DOUBLE_EQ(reading->value_K, kelvinFromCelsius(25.5));
    EXPECT_DOUBLE_EQ(reading->time_s, m_heard["IN_PV_2"].back());
    EXPECT_DOUBLE_EQ(m_heater.setPoint_K().value(), kSixty_K);
    EXPECT_EQ(m_heater.discards(), 0);
    EXPECT_EQ(count("START_1"), 0u);
    EXPECT_EQ(count("OUT_WD1@30"), 0u) << "nothing asks for heat";
    EXPECT_FALSE(m_heater.isManual());
}

// Catches the plate's own sensor read where the probe is to be.
TEST_F(NamurHeaterTest, readsTheProbeWhereItIsSet) {
    test::ScriptedLink link{"/dev/ttyTEST"};
    NamurHeater heater(link, m_clock, {true, 30.0});
    for (int i = 0; i < 100; ++i) {
        heater.work();
        const std::string sent = link.takeSent();
        EXPECT_EQ(sent.find("IN_PV_2"), std::string::npos);
        if (sent == "IN_SP_1 \r\n")
            link.say("0.0 1 \r\n");
        if (sent == "IN_NAME \r\n")
            link.say("IKARCT \r\n");
        if (sent == "IN_PV_1 \r\n")
            link.say("33.0 1 \r\n");
        m_clock.advance(0.01);
    }
    EXPECT_DOUBLE_EQ(heater.read().value().value_K, kelvinFromCelsius(33.0));
    EXPECT_THROW(NamurHeater(link, m_clock, {false, 10.0}), std::invalid_argument);
}

// Catches a plate left hot from before, since it is told to stop when Bask comes.
TEST_F(NamurHeaterTest, aPlateJustFoundIsToldToStop) {
    EXPECT_EQ(m_heater.heatState(), HeatState::Unknown);
    EXPECT_EQ(run(0.1).at(0), "STOP_1");
    EXPECT_EQ(m_heater.heatState(), HeatState::Unknown) << "it has not said so yet";
    run(5.0);
    EXPECT_EQ(m_heater.heatState(), HeatState::Off);
    EXPECT_EQ(count("STOP_1"), 3u) << "it does not say whether it heard the first";
    EXPECT_EQ(count("OUT_SP_1 0.0"), 1u);
    EXPECT_FALSE(m_heater.heating());
}

// Catches heat before the watchdog, and a watchdog that is fed too late or without the heat's being asked
// for.
TEST_F(NamurHeaterTest, heatIsWatchedOverByThePlateItself) {
    run(1.0);
    const double begin_s = m_clock.now_s();
    std::vector<std::string> lines;
    for (int i = 0; i < 600; ++i) {
        ASSERT_TRUE(m_heater.keepHeating(kSixty_K, 1.05).ok());
        EXPECT_TRUE(m_heater.heating());
        for (const std::string& line : run(0.1))
            lines.push_back(line);
    }
    const auto at = [&](const char* line) { return std::ranges::find(lines, line) - lines.begin(); };
    EXPECT_LT(at("OUT_WD1@30"), at("OUT_SP_1 60.0"));
    EXPECT_LT(at("OUT_SP_1 60.0"), at("START_1"));
    EXPECT_LT(m_heard["START_1"].at(0), begin_s + 1.0);
    EXPECT_EQ(count("START_1"), 1u);
    EXPECT_EQ(count("OUT_SP_1 60.0"), 1u);
    const std::vector<double> fed = m_heard["OUT_WD1@30"];
    ASSERT_GE(fed.size(), 7u);
    for (std::size_t i = 1; i < fed.size(); ++i)
        EXPECT_LT(fed[i] - fed[i - 1], 10.0) << "a third of its time";

    // Nothing keeps saying on.
    run(0.95);
    m_heard.clear();
    run(0.06);
    EXPECT_EQ(count("STOP_1"), 1u);
    run(0.3);
    EXPECT_FALSE(m_heater.heating());
    run(60.0);
    EXPECT_EQ(count("OUT_WD1@30"), 0u);
    EXPECT_EQ(count("START_1"), 0u);
    EXPECT_EQ(count("STOP_1"), 3u);
}

// Catches an engine that was held up for a while and then feeds the watchdog or starts the heat.
TEST_F(NamurHeaterTest, anEngineThatWasHeldUpStopsTheHeatFirst) {
    run(1.0);
    ASSERT_TRUE(m_heater.keepHeating(kSixty_K, 1.0).ok());
    run(0.5);
    m_heard.clear();
    m_clock.advance(20.0);
    EXPECT_TRUE(m_heater.heating()) << "nobody has told it to stop";
    EXPECT_EQ(run(0.01).at(0), "STOP_1");
    run(30.0);
    EXPECT_FALSE(m_heater.heating());
    EXPECT_EQ(count("OUT_WD1@30"), 0u);
}

// Catches a plate whose watchdog ends every run with an error, though the engine lives and has switched it
// off.
TEST_F(NamurHeaterTest, theWatchdogStaysQuietAfterTheHeatWasSwitchedOff) {
    run(1.0);
    ASSERT_TRUE(m_heater.keepHeating(kSixty_K, 10.0).ok());
    run(1.0);
    ASSERT_TRUE(m_heater.heatOff().ok());
    m_heard.clear();
    run(60.0);
    EXPECT_GE(count("OUT_WD1@30"), 6u);
    EXPECT_EQ(count("START_1"), 0u);
}

// Catches an order to stop that waits for an answer that does not come.
TEST_F(NamurHeaterTest, heatOffGoesOutAtOnce) {
    run(1.0);
    ASSERT_TRUE(m_heater.keepHeating(kSixty_K, 10.0).ok());
    run(1.0);
    m_answers.clear();
    run(0.3);
    EXPECT_TRUE(m_heater.heatOff().ok());
    EXPECT_EQ(m_link.takeSent(), "STOP_1 \r\n");
    EXPECT_TRUE(m_heater.heating()) << "not seen to be off";
    EXPECT_EQ(m_heater.heatState(), HeatState::On) << "not yet";
    EXPECT_TRUE(m_heater.heatOff().ok());
    EXPECT_EQ(m_link.takeSent(), "") << "not a flood, however often it is asked for";
    m_link.unplug();
    EXPECT_EQ(m_heater.heatOff().error().code(), MessageCode::LinkLost);
    m_heater.work();
    EXPECT_EQ(m_heater.heatState(), HeatState::Unknown);
}

// Catches a set point that the plate did not take, and one that it forgets when it starts.
TEST_F(NamurHeaterTest, theSetPointIsReadBackAndCompared) {
    m_takesSetPoint = false;
    m_answers["IN_SP_1"] = "0.0 1 \r\n";
    run(1.0);
    for (int i = 0; i < 40; ++i) {
        ASSERT_TRUE(m_heater.keepHeating(kSixty_K, 1.0).ok());
        run(0.1);
    }
    EXPECT_GE(count("OUT_SP_1 60.0"), 3u) << "said again";
    const DeviceStatus status = m_heater.status();
    EXPECT_EQ(status.link, LinkState::Live);
    EXPECT_EQ(status.problem, (Message{MessageCode::SafetySetPointOther, {"60", "0"}}));
    EXPECT_DOUBLE_EQ(m_heater.setPoint_K().value(), kelvinFromCelsius(0.0));

    m_answers["IN_SP_1"] = "60 1 \r\n";
    for (int i = 0; i < 20; ++i) {
        ASSERT_TRUE(m_heater.keepHeating(kSixty_K, 1.0).ok());
        run(0.1);
    }
    EXPECT_EQ(m_heater.status().problem, Message{});
    // A new one is not yet the one read back.
    m_takesSetPoint = true;
    for (int i = 0; i < 10; ++i) {
        ASSERT_TRUE(m_heater.keepHeating(kelvinFromCelsius(80.0), 1.0).ok());
        run(0.1);
        EXPECT_EQ(m_heater.status().problem, Message{});
    }
    EXPECT_EQ(count("OUT_SP_1 80.0"), 1u);
}

// Catches set points and times that no plate has, sent on.
TEST_F(NamurHeaterTest, whatNoPlateCanBeSetToIsRefused) {
    run(1.0);
    EXPECT_EQ(m_heater.keepHeating(kelvinFromCelsius(311.0), 1.0).error().code(),
              MessageCode::ValueOutOfRange);
    EXPECT_EQ(m_heater.keepHeating(kelvinFromCelsius(-1.0), 1.0).error().code(),
              MessageCode::ValueOutOfRange);
    EXPECT_FALSE(m_heater.keepHeating(std::nan(""), 1.0).ok());
    EXPECT_EQ(m_heater.keepHeating(kSixty_K, 0.0).error().code(), MessageCode::ValueNotPositive);
    EXPECT_FALSE(m_heater.heating());
}

// Catches an answer of another sensor, in pieces, late, or unasked, taken for the temperature.
TEST_F(NamurHeaterTest, onlyWhatFitsTheQuestionIsUsed) {
    run(1.0);
    const auto good = m_heater.read().value().value_K;
    m_answers["IN_PV_2"] = "99.0 1 \r\n";
    run(0.5);
    EXPECT_EQ(m_heater.read().value().value_K, good);
    EXPECT_GE(m_heater.status().discarded, 1);
    EXPECT_EQ(m_heater.status().link, LinkState::Live);
    EXPECT_EQ(m_heater.status().problem,
              (Message{MessageCode::DeviceAnswersWrong, {"/dev/ttyTEST", "\"99.0 1 \""}}));

    m_answers["IN_PV_2"] = "26.5 2 \r\n";
    run(4.0);
    EXPECT_EQ(m_heater.status().problem, Message{}) << "told for a while only";
    const int before = m_heater.discards();
    m_answers.erase("IN_PV_2");
    while (run(0.01) != std::vector<std::string>{"IN_PV_2"}) {
    }
    for (const char* piece : {"2", "7.", "5 2", " \r", "\n"}) {
        m_link.say(piece);
        run(0.02);
    }
    EXPECT_DOUBLE_EQ(m_heater.read().value().value_K, kelvinFromCelsius(27.5));
    EXPECT_EQ(m_heater.discards(), before);
}

// Catches an answer that comes after its time taken for the next question's.
TEST_F(NamurHeaterTest, aLateAnswerIsNotTakenForTheNextOne) {
    run(1.0);
    m_answers.erase("IN_PV_2");
    while (run(0.01) != std::vector<std::string>{"IN_PV_2"}) {
    }
    run(NamurHeater::kDeadline_s + 0.05);
    const int before = m_heater.discards();
    const double heard = m_heater.read().value().time_s;
    m_link.say("70.0 2 \r\n");
    run(0.02);
    EXPECT_EQ(m_heater.discards(), before + 1);
    EXPECT_EQ(m_heater.read().value().time_s, heard);
}

// Catches a plate that is set up to drive a stirrer, and a plug that is bridged, taken for well.
TEST_F(NamurHeaterTest, aPlateThatSpeaksUnaskedIsTold) {
    run(1.0);
    m_link.say("IN_PV_4 \r\n");
    run(0.02);
    EXPECT_EQ(m_heater.status().problem.code, MessageCode::DeviceAnswersWrong);
    EXPECT_EQ(m_heater.status().problem.args.at(1), "\"IN_PV_4 \"");
}

// Catches a temperature that is no temperature given as a number.
TEST_F(NamurHeaterTest, anImpossibleTemperatureIsAFault) {
    m_answers["IN_PV_2"] = "850.0 2 \r\n";
    run(1.0);
    const Reading reading = m_heater.read().value();
    EXPECT_FALSE(reading.valid);
    EXPECT_EQ(reading.fault, SensorFault::OutOfRange);
}

// Catches a plate that is not there told as heating.
TEST_F(NamurHeaterTest, aPlateThatNeverAnsweredIsNotHeating) {
    m_answers.clear();
    for (int i = 0; i < 100; ++i) {
        run(0.1);
        ASSERT_FALSE(m_heater.heating()) << i;
    }
    EXPECT_EQ(m_heater.status().link, LinkState::Opening);
}

// Catches a plate that has no name and is lost over the question.
TEST_F(NamurHeaterTest, aPlateWithoutNameIsReadAllTheSame) {
    m_answers.erase("IN_NAME");
    run(1.5);
    for (int i = 0; i < 100; ++i) {
        run(0.1);
        ASSERT_EQ(m_heater.status().link, LinkState::Live) << i;
    }
    EXPECT_EQ(count("IN_NAME"), 3u);
}

// Promise: nothing is heated that would stay hot. Catches a plate without a watchdog that is heated all the
// same, and one whose watchdog fails in a run.
TEST_F(NamurHeaterTest, aPlateWithoutWatchdogIsNotHeated) {
    run(1.0);
    EXPECT_TRUE(m_heater.hasWatchdog());
    const auto heat = [&](double time_s) {
        Result<void> newest;
        for (double t = 0.0; t < time_s && newest; t += 0.1) {
            newest = m_heater.keepHeating(kSixty_K, 1.0);
            run(0.1);
        }
        return newest;
    };
    ASSERT_TRUE(heat(20.0).ok());
    m_answers.erase("OUT_WD1@30");
    m_heard.clear();
    const auto failed = heat(20.0);
    ASSERT_FALSE(failed.ok());
    EXPECT_EQ(failed.error().code(), MessageCode::DeviceAnswersWrong);
    EXPECT_NE(failed.error().message.args.at(1).text().find("OUT_WD1@30"), std::string::npos);
    EXPECT_EQ(count("OUT_WD1@30"), 2u) << "one miss may be noise";
    ASSERT_GE(count("STOP_1"), 1u);
    EXPECT_LT(m_heard["STOP_1"].at(0), m_heard["OUT_WD1@30"].at(0) + 1.5);
    EXPECT_FALSE(m_heater.keepHeating(kSixty_K, 1.0).ok()) << "until somebody has switched off";
    EXPECT_FALSE(m_heater.hasWatchdog());
    EXPECT_EQ(m_heater.status().link, LinkState::Live);

    EXPECT_TRUE(m_heater.heatOff().ok());
    run(5.0);
    m_heard.clear();
    EXPECT_FALSE(heat(20.0).ok());
    EXPECT_EQ(count("START_1") + count("OUT_SP_1 60.0"), 0u) << "not before the watchdog is said back";
}

// Catches heat refused where somebody has said that it may be without a watchdog.
TEST_F(NamurHeaterTest, onlyWhereItIsAllowedAPlateIsHeatedWithoutWatchdog) {
    NamurHeater heater(m_link, m_clock, {false, 30.0, true});
    std::string all;
    for (int i = 0; i < 3000; ++i) {
        heater.work();
        const std::string sent = m_link.takeSent();
        all += sent;
        if (sent == "IN_PV_2 \r\n")
            m_link.say("25.5 2 \r\n");
        if (sent == "IN_SP_1 \r\n")
            m_link.say(all.find("OUT_SP_1 60.0") == std::string::npos ? "0.0 1 \r\n" : "60.0 1 \r\n");
        if (i > 500) {
            ASSERT_TRUE(heater.keepHeating(kSixty_K, 1.0).ok()) << i;
        }
        m_clock.advance(0.01);
    }
    EXPECT_NE(all.find("START_1"), std::string::npos);
    EXPECT_TRUE(heater.heating());
    EXPECT_FALSE(heater.hasWatchdog());
}

// Promise: off is seen, not believed. Catches a plate that ignores its order told as off, and its watchdog
// fed, which is what would still switch it off.
TEST_F(NamurHeaterTest, aPlateThatDoesNotStopIsToldAndNotFed) {
    run(1.0);
    ASSERT_TRUE(m_heater.keepHeating(kSixty_K, 60.0).ok());
    run(1.0);
    m_takesSetPoint = false;
    m_heard.clear();
    EXPECT_TRUE(m_heater.heatOff().ok());
    for (int i = 0; i < 600; ++i) { // as an engine that asks again while it heats
        const auto off = m_heater.heatOff();
        EXPECT_EQ(off.ok(), i < 31) << i;
        if (!off) {
            EXPECT_EQ(off.error().message, (Message{MessageCode::SafetySetPointOther, {"0", "60"}}));
        }
        EXPECT_TRUE(m_heater.heating());
        EXPECT_EQ(m_heater.heatState(), i < 31 ? HeatState::On : HeatState::Unknown);
        run(0.1);
    }
    EXPECT_EQ(count("OUT_WD1@30"), 0u);
    EXPECT_GE(count("STOP_1"), 3u + 5u);
    EXPECT_LE(count("STOP_1"), 3u + 6u) << "not worn out";
    EXPECT_EQ(count("STOP_1"), count("OUT_SP_1 0.0"));
    m_takesSetPoint = true;
    run(11.0);
    EXPECT_FALSE(m_heater.heating());
    EXPECT_TRUE(m_heater.heatOff().ok());
    run(1.0);
    EXPECT_GE(count("OUT_WD1@30"), 1u);
}

// Catches a set point that comes late taken for the probe's temperature: both are of channel 1.
TEST_F(NamurHeaterTest, aLateSetPointIsNotTakenForTheProbes) {
    test::ScriptedLink link{"/dev/ttyTEST"};
    NamurHeater heater(link, m_clock, {true, 30.0});
    bool isLate = false;
    double late_s = 1e300;
    for (int i = 0; i < 1000; ++i) {
        heater.work();
        const std::string sent = link.takeSent();
        if (sent == "IN_PV_1 \r\n")
            link.say("33.0 1 \r\n");
        if (sent == "IN_SP_1 \r\n" && i > 500 && !std::exchange(isLate, true))
            late_s = m_clock.now_s() + 2.0 * NamurHeater::kDeadline_s - 0.05;
        else if (sent == "IN_SP_1 \r\n")
            link.say("250.0 1 \r\n");
        if (m_clock.now_s() >= late_s) {
            late_s = 1e300;
            link.say("250.0 1 \r\n");
        }
        if (heater.read()) {
            EXPECT_LT(heater.read()->value_K, kelvinFromCelsius(34.0));
        }
        m_clock.advance(0.01);
    }
    EXPECT_TRUE(isLate);
}

// Catches a silent plate taken for live, heat that is asked for over a dead line, one that is not found
// again, and one that goes on heating by itself when it is.
TEST_F(NamurHeaterTest, aLostPlateIsToldFoundAgainAndStopped) {
    run(1.0);
    ASSERT_TRUE(m_heater.keepHeating(kSixty_K, 60.0).ok());
    run(1.0);
    const auto answers = m_answers;
    m_answers.clear();
    run(NamurHeater::kSilence_s + 0.1);
    EXPECT_TRUE(m_heater.heating()) << "not seen to be off";
    EXPECT_EQ(m_heater.heatState(), HeatState::Unknown);
    EXPECT_EQ(m_heater.status().link, LinkState::Lost);
    EXPECT_EQ(m_heater.status().problem, (Message{MessageCode::DeviceSilent, {"/dev/ttyTEST", "2"}}));
    EXPECT_EQ(m_heater.read().error().code(), MessageCode::DeviceSilent);
    EXPECT_EQ(m_heater.keepHeating(kSixty_K, 60.0).error().code(), MessageCode::DeviceSilent);
    run(10.0);
    EXPECT_GE(m_link.opened(), 4) << "opened anew: it may have another cable";
    m_heard.clear();
    m_answers = answers;
    run(2.0);
    EXPECT_EQ(m_heater.status().link, LinkState::Live);
    EXPECT_FALSE(m_heater.heating());
    EXPECT_EQ(count("START_1"), 0u);
    EXPECT_GE(count("STOP_1"), 1u);

    m_link.unplug();
    EXPECT_EQ(m_heater.status().link, LinkState::Lost);
    EXPECT_EQ(m_heater.read().error().code(), MessageCode::LinkLost);
    const int opens = m_link.opened();
    run(10.0);
    EXPECT_LE(m_link.opened() - opens, 21) << "at most every half second";
    EXPECT_EQ(m_heater.status().problem.code, MessageCode::LinkNotOpened);
    m_link.plug();
    const double begin_s = m_clock.now_s();
    while (m_heater.status().link != LinkState::Live && m_clock.now_s() < begin_s + 5.0)
        run(0.01);
    EXPECT_LT(m_clock.now_s() - begin_s, 2.0);
}

/// The same driver against the simulated plate.
class NamurPlateTest : public testing::Test {
protected:
    void run(double time_s, std::optional<double> setPoint_K = std::nullopt) {
        for (double t = 0.0; t < time_s - 1e-9; t += 0.01) {
            if (setPoint_K)
                (void)m_heater.keepHeating(*setPoint_K, 1.0);
            m_heater.work();
            m_clock.advance(0.01);
        }
    }

    ManualClock m_clock;
    NamurSimulator m_plate;
    test::DeviceLink m_link{m_plate, m_clock};
    NamurHeater m_heater{m_link, m_clock, {false, 20.0}};
};

// Catches the two of them reading the manual differently: heat comes on, is read, and goes off.
TEST_F(NamurPlateTest, heatsReadsAndStops) {
    run(1.0);
    EXPECT_EQ(m_heater.status().identity, "IKA simulated");
    run(120.0, kSixty_K);
    EXPECT_TRUE(m_plate.isOn());
    EXPECT_NEAR(m_plate.setPoint_K(), kSixty_K, 0.06);
    EXPECT_GT(m_plate.temperature_K(), kelvinFromCelsius(50.0));
    EXPECT_NEAR(m_heater.read().value().value_K, m_plate.temperature_K(), 0.2);
    EXPECT_FALSE(m_plate.isTripped());
    EXPECT_EQ(m_heater.status().problem, Message{});
    ASSERT_TRUE(m_heater.heatOff().ok());
    run(1.0);
    EXPECT_FALSE(m_plate.isOn());
    EXPECT_FALSE(m_heater.heating());
}

// Catches heat that stays on when the engine is dead: killed, hung, or its cable is off.
TEST_F(NamurPlateTest, aDeadEngineLeavesAPlateThatGoesOff) {
    run(1.0);
    run(30.0, kSixty_K);
    ASSERT_TRUE(m_plate.isOn());
    m_clock.advance(19.0);
    m_plate.transmit(m_clock.now_s()); // the plate's own time goes on
    m_clock.advance(1.1);
    m_plate.transmit(m_clock.now_s());
    EXPECT_FALSE(m_plate.isOn());
    EXPECT_TRUE(m_plate.isTripped());
}

// Catches a fault of the plate that the driver does not tell, or takes for a temperature.
TEST_F(NamurPlateTest, eachFaultIsTold) {
    run(1.0);
    run(5.0, kSixty_K);
    ASSERT_TRUE(m_plate.setFault("wrong-channel").ok());
    run(3.0, kSixty_K);
    EXPECT_EQ(m_heater.status().link, LinkState::Lost);
    EXPECT_EQ(m_heater.status().problem.code, MessageCode::DeviceAnswersWrong);
    ASSERT_TRUE(m_plate.setFault("garbage").ok());
    run(3.0, kSixty_K);
    EXPECT_EQ(m_heater.status().problem.code, MessageCode::DeviceAnswersWrong);
    ASSERT_TRUE(m_plate.setFault("silent").ok());
    run(6.0, kSixty_K);
    EXPECT_EQ(m_heater.status().problem.code, MessageCode::DeviceSilent);
    EXPECT_EQ(m_heater.discards() > 3, true);
    ASSERT_TRUE(m_plate.setFault("setpoint-zero").ok());
    run(8.0, kSixty_K);
    EXPECT_EQ(m_heater.status().problem.code, MessageCode::SafetySetPointOther);
    ASSERT_TRUE(m_plate.setFault("none").ok());
    run(3.0, kSixty_K);
    EXPECT_EQ(m_heater.status().problem, Message{});
}

} // namespace
} // namespace bask
