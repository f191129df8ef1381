// The simulated Modbus line: very bytes, registers by profile, a plate that heats, named faults.

#include "engine/device_simulators/modbus_simulator.h"

#include "engine/base/message_code.h"
#include "tests/support/modbus_client.h"
#include "tests/support/shipped_profile.h"

#include <gtest/gtest.h>

#include <cmath>

namespace bask {
namespace {

using Registers = std::vector<std::uint16_t>;

using test::shipped;

class ModbusSimulatorTest : public testing::Test {
protected:
    std::string said(const ModbusRequest& request) {
        m_sim.receive(test::requestBytes(request), m_now_s);
        m_now_s += 0.01;
        return m_sim.transmit(m_now_s);
    }
    Registers asked(const ModbusRequest& request) {
        return test::replyRegisters(said(request), request.unit, request.function);
    }
    void pass(double s) {
        m_now_s += s;
        m_sim.transmit(m_now_s);
    }

    ModbusSimulator m_sim;
    double m_now_s = 100.0;
};

// Catches registers that are not where the profile has them.
TEST_F(ModbusSimulatorTest, ThermometerHoldsItsChannels) {
    m_sim.addThermometer(3, shipped("modmux-pm6rtd"), 293.15);
    m_sim.setTemperature(3, 1, 333.15);
    EXPECT_EQ(asked({3, 4, 1, 3}), (Registers{200, 600, 200}));
    EXPECT_EQ(asked({3, 4, 7, 1}), Registers{0xE002});
    EXPECT_EQ(asked({3, 3, 1, 1}), Registers{0xE002}) << "holding registers are others";
    EXPECT_EQ(asked({3, 4, 1, 0}), Registers{0xE003});
    EXPECT_EQ(said({4, 4, 1, 1}), "") << "another unit of the line is silent";
}

// Catches requests lost where they come in pieces or two at once, and noise that stops the line.
TEST_F(ModbusSimulatorTest, PiecesMergedAndNoise) {
    m_sim.addThermometer(1, shipped("thermasgard-rtm1"), 293.15);
    const std::string request = test::requestBytes({1, 4, 0, 1});
    m_sim.receive(request.substr(0, 3), m_now_s);
    m_sim.receive(request.substr(3) + request, m_now_s + 0.02);
    const std::string both = m_sim.transmit(m_now_s + 0.1);
    EXPECT_EQ(both.size(), 14u);
    m_sim.receive("\x01\x04garbage", m_now_s + 0.2);
    m_sim.receive(request, m_now_s + 1.0); // after a gap
    EXPECT_EQ(m_sim.transmit(m_now_s + 1.1), both.substr(0, 7));
}

// Catches answers that come before a device could give them.
TEST_F(ModbusSimulatorTest, AnswersTakeTheirTime) {
    m_sim.addThermometer(1, shipped("thermasgard-rtm1"), 293.15);
    m_sim.receive(test::requestBytes({1, 4, 0, 1}), m_now_s);
    EXPECT_EQ(m_sim.transmit(m_now_s), "");
    EXPECT_NE(m_sim.transmit(m_now_s + ModbusSimulator::kReplyTime_s), "");
}

// Catches a plate that heats without being told, cools while told, or overshoots.
TEST_F(ModbusSimulatorTest, PlateNearsItsSetPointAndCools) {
    SimulatedPlate plate;
    plate.ambient_K = 293.15;
    m_sim.addController(1, shipped("pixsys-drr245"), plate);
    EXPECT_EQ(asked({1, 6, 1001, 1, {800}}), Registers{});
    EXPECT_NEAR(m_sim.setPoint_K(1), 353.15, 1e-9);
    pass(60.0);
    EXPECT_NEAR(m_sim.plate_K(1), 293.15, 1e-9) << "stopped";
    EXPECT_EQ(asked({1, 6, 1016, 1, {1}}), Registers{});
    pass(60.0);
    EXPECT_NEAR(m_sim.plate_K(1), 353.15 - 60.0 * std::exp(-1.0), 0.1);
    pass(600.0);
    EXPECT_EQ(asked({1, 3, 1000, 2}), (Registers{800, 800}));
    EXPECT_EQ(asked({1, 6, 1016, 1, {0}}), Registers{});
    pass(300.0);
    EXPECT_NEAR(m_sim.plate_K(1), 293.15 + 60.0 * std::exp(-1.0), 0.1);
    EXPECT_EQ(m_sim.writes(), 3);
}

// Catches a watchdog that never bites, bites while it is fed, or bites from the wrong moment.
TEST_F(ModbusSimulatorTest, WatchdogStopsAControllerThatNobodyAsks) {
    m_sim.addController(1, shipped("pixsys-drr245"));
    asked({1, 6, 1001, 1, {800}});
    asked({1, 6, 1022, 1, {5000}});
    asked({1, 6, 1016, 1, {1}});
    for (int i = 0; i < 10; ++i) {
        pass(4.0);
        asked({1, 3, 1000, 1});
        EXPECT_TRUE(m_sim.isOn(1));
    }
    const double before_K = m_sim.plate_K(1);
    pass(4.9);
    EXPECT_TRUE(m_sim.isOn(1));
    pass(100.0);
    EXPECT_FALSE(m_sim.isOn(1));
    EXPECT_LT(m_sim.plate_K(1), before_K);
}

// Catches words in the wrong order: the manual's own example, 75.0 as 0x0000 0x4296.
TEST_F(ModbusSimulatorTest, FloatsLowWordFirst) {
    m_sim.addController(1, shipped("watlow-ez-zone"));
    EXPECT_EQ(asked({1, 16, 2160, 2, {0x0000, 0x4296}}), Registers{});
    EXPECT_NEAR(m_sim.setPoint_K(1), 297.039, 1e-3);
    EXPECT_EQ(asked({1, 3, 2160, 2}), (Registers{0x0000, 0x4296}));
}

// Catches a fault that is not what its name says.
TEST_F(ModbusSimulatorTest, FaultsAreWhatTheyAreCalled) {
    m_sim.addThermometer(1, shipped("modmux-pm6rtd"), 293.15);
    const ModbusRequest two{1, 4, 1, 2};
    const std::string sound = said(two);
    const auto with = [&](const char* fault) {
        EXPECT_TRUE(m_sim.setFault(fault).ok());
        return said(two);
    };
    EXPECT_EQ(with("silent"), "");
    EXPECT_EQ(test::replyRegisters(with("open"), 1, 4), (Registers{0x8000, 0x8000}));
    EXPECT_EQ(test::replyRegisters(with("short"), 1, 4), (Registers{0x8000, 0x8000}));
    EXPECT_EQ(test::replyRegisters(with("wrong-unit"), 2, 4), (Registers{200, 200}));
    EXPECT_EQ(test::replyRegisters(with("short-reply"), 1, 4), Registers{200});
    EXPECT_EQ(with("exception"), modbusException(1, 4, 4));
    EXPECT_EQ(test::replyRegisters(with("bad-crc"), 1, 4), (Registers{0xFFFF, 0xFFFF}));
    EXPECT_EQ(with("late-reply"), "");
    EXPECT_EQ(m_sim.transmit(m_now_s + 1.0), sound);
    m_now_s += 1.0;
    EXPECT_EQ(with("frozen"), sound);
    m_sim.setTemperature(1, 0, 350.0);
    EXPECT_EQ(said(two), sound);
    EXPECT_EQ(with("none").size(), sound.size());
    EXPECT_NE(said(two), sound);
    EXPECT_EQ(m_sim.setFault("broken").error().code(), MessageCode::ValueUnknown);
    EXPECT_EQ(m_sim.faults().size(), 12u);
}

// Catches a jump that stays, and a rise of another slope.
TEST_F(ModbusSimulatorTest, ReadingsJumpAndRise) {
    m_sim.addThermometer(1, shipped("modmux-pm6rtd"), 293.15);
    const auto shown_degC = [&] { return 0.1 * asked({1, 4, 1, 1}).at(0); };
    ASSERT_TRUE(m_sim.setFault("jumping").ok());
    EXPECT_NEAR(shown_degC(), 50.0, 0.1);
    pass(0.5);
    EXPECT_NEAR(shown_degC(), 20.0, 0.1);
    pass(0.5);
    EXPECT_NEAR(shown_degC(), 50.0, 0.1);
    ASSERT_TRUE(m_sim.setFault("rising").ok());
    pass(10.0);
    EXPECT_NEAR(shown_degC(), 40.0, 0.2);
    ASSERT_TRUE(m_sim.setFault("none").ok());
    EXPECT_NEAR(shown_degC(), 20.0, 0.1);
}

// Catches a frozen device whose registers go on.
TEST_F(ModbusSimulatorTest, FrozenKeepsWhatItHeld) {
    m_sim.addController(1, shipped("eurotherm-2400"));
    asked({1, 6, 24, 1, {90}});
    const Registers before = asked({1, 3, 1, 1});
    ASSERT_TRUE(m_sim.setFault("frozen").ok());
    pass(300.0);
    EXPECT_GT(m_sim.plate_K(1), 350.0);
    EXPECT_EQ(asked({1, 3, 1, 1}), before);
}

// Catches sensor faults that are told elsewhere than the device tells them.
TEST_F(ModbusSimulatorTest, SensorFaultsAreToldWhereTheDeviceTellsThem) {
    m_sim.addThermometer(16, shipped("benshaw-remote-rtd"), 293.15);
    m_sim.addThermometer(2, shipped("isma-sfar-1m-1ti1do"), 293.15);
    m_sim.addThermometer(3, shipped("waveshare-8ch-4-20ma"), 293.15);
    m_sim.addController(4, shipped("eurotherm-2400"));
    m_sim.addController(5, shipped("pixsys-drr245"));
    EXPECT_EQ(asked({2, 4, 50, 1}), Registers{1}) << "connected";
    ASSERT_TRUE(m_sim.setFault("open").ok());
    EXPECT_EQ(asked({16, 4, 8, 2}), (Registers{0, 0xFF}));
    EXPECT_EQ(asked({16, 4, 0, 1}), Registers{20});
    EXPECT_EQ(asked({2, 4, 50, 1}), Registers{0});
    EXPECT_EQ(asked({3, 4, 0, 1}), Registers{0});
    EXPECT_EQ(asked({4, 3, 258, 1}), Registers{1});
    EXPECT_EQ(asked({5, 3, 1014, 1}), Registers{8});
    ASSERT_TRUE(m_sim.setFault("short").ok());
    EXPECT_EQ(asked({16, 4, 8, 2}), (Registers{0xFF, 0}));
    EXPECT_EQ(asked({3, 4, 0, 1}), Registers{21600});
}

} // namespace
} // namespace bask
