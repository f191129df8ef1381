// Modbus TCP through sockets: the same devices and profiles as on a serial line.

#include "engine/base/message_code.h"
#include "engine/device_simulators/modbus_simulator.h"
#include "engine/device_simulators/tcp_server.h"
#include "engine/drivers/modbus_heater.h"
#include "engine/drivers/modbus_tcp_link.h"
#include "engine/drivers/modbus_thermometer.h"
#include "engine/drivers/tcp_link.h"
#include "engine/protocols/modbus_profile.h"
#include "tests/support/wait_for.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace bask::test {
namespace {

const ModbusProfile& profileOf(std::string_view name) {
    return *std::ranges::find(shippedProfiles(), name, &ModbusProfile::name);
}

class ModbusTcpSocketTest : public testing::Test {
protected:
    ModbusTcpSocketTest() {
        units.addThermometer(1, profileOf("labjack-t7-thermocouples"), 300.0);
        units.addController(4, profileOf("pixsys-drr245"));
        plugIn();
        link = linkTo(server->port());
    }

    void plugIn(int port = 0) { server = TcpServer::create(units, port).value(); }
    std::unique_ptr<ModbusTcpLink> linkTo(int port) {
        return std::make_unique<ModbusTcpLink>(std::make_unique<TcpLink>("127.0.0.1", port), clock);
    }
    template <class Condition> bool until(Condition condition, int limit_ms = 20000) {
        return waitFor(
            [&] {
                if (server)
                    server->work(clock.now_s());
                return condition();
            },
            limit_ms);
    }

    SteadyClock clock;
    ModbusSimulator units{ModbusSimulator::Frames::Tcp};
    std::unique_ptr<TcpServer> server;
    std::unique_ptr<ModbusTcpLink> link;
};

} // namespace

// Catches a lost connection that is not told, is not found again, or keeps its old value.
TEST_F(ModbusTcpSocketTest, ThermocouplesAreLostAndFoundAgain) {
    const ModbusProfile& profile = profileOf("labjack-t7-thermocouples");
    units.setTemperature(1, 2, 373.25);
    auto thermometer = ModbusThermometer::create(*link, clock, {1, profile, {0, 2}}).value();
    const auto isRead = [&] {
        thermometer->work();
        return thermometer->read().ok();
    };
    ASSERT_TRUE(until(isRead)) << describe(thermometer->read().error());
    EXPECT_NEAR(thermometer->read().value().at(0).value_K, 300.0, 1e-3);
    EXPECT_NEAR(thermometer->read().value().at(1).value_K, 373.25, 1e-3);
    const int port = server->port();
    server.reset();
    ASSERT_TRUE(until([&] { return !isRead(); }));
    EXPECT_EQ(thermometer->status().link, LinkState::Lost);
    ASSERT_TRUE(until([&] {
        thermometer->work();
        return thermometer->status().problem.code == MessageCode::LinkNotOpened;
    })) << "nobody listens there";
    plugIn(port);
    units.setTemperature(1, 0, 310.0);
    ASSERT_TRUE(until(isRead));
    EXPECT_NEAR(thermometer->read().value().at(0).value_K, 310.0, 1e-3);
    EXPECT_TRUE(std::ranges::all_of(units.functions(), [](int function) { return function == 3; }))
        << "nothing is written";
}

TEST_F(ModbusTcpSocketTest, AnAddressHasOneUserOnThisComputer) {
    link->open();
    ASSERT_TRUE(until([&] { return link->isOpen(); }));
    const auto second = linkTo(server->port());
    second->open();
    EXPECT_NE(describe(second->problem()).find("another Bask"), std::string::npos);
}

// Catches a controller on a network that heats without its watchdog, or is not seen off.
TEST_F(ModbusTcpSocketTest, AControllerHeatsAndGoesOff) {
    auto heater = ModbusHeater::create(*link, clock, {4, profileOf("pixsys-drr245")}).value();
    const auto works = [&](auto condition) {
        return until([&] {
            heater->work();
            return condition();
        });
    };
    ASSERT_TRUE(works([&] { return heater->heatState() == HeatState::Off; }));
    ASSERT_TRUE(works([&] { return heater->keepHeating(373.15, 5.0) && units.isOn(4); }));
    EXPECT_EQ(units.registerAt(4, 3, 1022), 30000) << "its watchdog, ms";
    EXPECT_NEAR(units.setPoint_K(4), 373.15, 0.1);
    (void)heater->heatOff();
    EXPECT_TRUE(works([&] { return !units.isOn(4) && heater->heatState() == HeatState::Off; }));
}

} // namespace bask::test
