#include "engine/device_simulators/namur_simulator.h"

#include "engine/base/message_code.h"
#include "engine/base/units.h"

#include <gtest/gtest.h>

#include <cmath>

namespace bask {
namespace {

class NamurSimulatorTest : public testing::Test {
protected:
    std::string answer(const std::string& command) {
        m_plate.receive(command + " \r\n", m_now_s);
        const std::string early = m_plate.transmit(m_now_s);
        EXPECT_EQ(early, "") << "an answer takes its time";
        m_now_s += 0.05;
        return m_plate.transmit(m_now_s);
    }
    void wait(double time_s) {
        m_now_s += time_s;
        EXPECT_EQ(m_plate.transmit(m_now_s), "") << "it never speaks first";
    }

    NamurSimulator m_plate;
    double m_now_s = 1000.0;
};

// Catches a plate that answers what the real one does not, or not as the manual says.
TEST_F(NamurSimulatorTest, answersAsTheManualSays) {
    EXPECT_EQ(answer("IN_NAME"), "IKA simulated \r\n");
    EXPECT_EQ(answer("IN_PV_1"), "20.0 1 \r\n");
    EXPECT_EQ(answer("IN_PV_2"), "20.0 2 \r\n");
    EXPECT_EQ(answer("IN_SP_1"), "0.0 1 \r\n");
    EXPECT_EQ(answer("OUT_SP_1 80.5"), "");
    EXPECT_EQ(answer("IN_SP_1"), "80.5 1 \r\n");
    EXPECT_EQ(answer("OUT_SP_1 400"), "") << "an error is not told";
    EXPECT_EQ(answer("IN_SP_1"), "80.5 1 \r\n");
    EXPECT_EQ(answer("in_pv_2"), "") << "capitals only";
    EXPECT_EQ(answer("OUT_WD1@30"), "30.0 \r\n");
    EXPECT_EQ(answer("OUT_WD1@10"), "") << "20 s are the least";
    m_plate.receive("IN_", m_now_s);
    m_plate.receive("PV_2", m_now_s);
    m_plate.receive(" \r", m_now_s);
    m_now_s += 0.05;
    EXPECT_EQ(m_plate.transmit(m_now_s), "20.0 2 \r\n") << "in pieces";
    EXPECT_EQ(answer("START_1"), "");
    EXPECT_EQ(answer("STOP_1"), "");
}

// Catches a plate that does not follow first-order heating and cooling.
TEST_F(NamurSimulatorTest, warmsAndCoolsWithItsTimeConstants) {
    answer("OUT_SP_1 120.0");
    wait(100.0);
    EXPECT_DOUBLE_EQ(m_plate.temperature_K(), kelvinFromCelsius(20.0)) << "not switched on";
    answer("START_1");
    const double before_K = m_plate.temperature_K();
    wait(60.0);
    EXPECT_NEAR(celsiusFromKelvin(m_plate.temperature_K()), 120.0 - 100.0 * std::exp(-1.0), 0.1);
    EXPECT_GT(m_plate.temperature_K(), before_K);
    answer("STOP_1");
    EXPECT_FALSE(m_plate.isOn());
    const double hot_degC = celsiusFromKelvin(m_plate.temperature_K());
    wait(600.0);
    EXPECT_NEAR(celsiusFromKelvin(m_plate.temperature_K()), 20.0 + (hot_degC - 20.0) * std::exp(-1.0), 0.1);
}

// Catches a watchdog that does not expire, expires although it is fed, or heats on until somebody looks.
TEST_F(NamurSimulatorTest, theWatchdogSwitchesItOff) {
    answer("OUT_SP_1 120.0");
    answer("OUT_WD1@20");
    answer("START_1");
    for (int i = 0; i < 5; ++i) {
        wait(15.0);
        EXPECT_TRUE(m_plate.isOn());
        EXPECT_EQ(answer("OUT_WD1@20"), "20.0 \r\n");
    }
    answer("IN_PV_2"); // asking does not feed it
    wait(19.0);
    EXPECT_TRUE(m_plate.isOn());
    const double then_K = m_plate.temperature_K();
    wait(3600.0);
    EXPECT_FALSE(m_plate.isOn());
    EXPECT_TRUE(m_plate.isTripped());
    EXPECT_LT(m_plate.temperature_K(), then_K);
    answer("START_1");
    EXPECT_TRUE(m_plate.isOn());
    EXPECT_FALSE(m_plate.isTripped());
}

// Catches a fault that is not what its name says, and one that stays.
TEST_F(NamurSimulatorTest, faultsAreWhatTheirNamesSay) {
    EXPECT_EQ(m_plate.setFault("broken").error().code(), MessageCode::ValueUnknown);
    const auto set = [&](const char* name) { ASSERT_TRUE(m_plate.setFault(name).ok()) << name; };
    set("silent");
    EXPECT_EQ(answer("IN_PV_2"), "");
    answer("OUT_SP_1 90");
    set("none");
    EXPECT_EQ(answer("IN_SP_1"), "0.0 1 \r\n") << "nor did it hear";
    set("wrong-channel");
    EXPECT_EQ(answer("IN_PV_2"), "20.0 5 \r\n");
    set("garbage");
    EXPECT_NE(answer("IN_PV_2"), "20.0 2 \r\n");
    set("setpoint-zero");
    answer("OUT_SP_1 90");
    EXPECT_EQ(answer("IN_SP_1"), "0.0 1 \r\n");
    set("no-heat");
    answer("OUT_SP_1 90");
    answer("START_1");
    wait(100.0);
    EXPECT_NEAR(celsiusFromKelvin(m_plate.temperature_K()), 20.0, 0.01);
    EXPECT_TRUE(m_plate.isOn());
    set("stuck-on");
    answer("STOP_1");
    wait(10.0);
    EXPECT_GT(celsiusFromKelvin(m_plate.temperature_K()), 50.0);
    EXPECT_FALSE(m_plate.isOn());
    set("none");
    const double before_K = m_plate.temperature_K();
    wait(100.0);
    EXPECT_LT(m_plate.temperature_K(), before_K);
}

} // namespace
} // namespace bask
