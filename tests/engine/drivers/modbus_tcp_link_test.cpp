// Modbus over TCP: the same devices and profiles as on a serial line.

#include "engine/base/message_code.h"
#include "engine/device_simulators/modbus_tcp_simulator.h"
#include "engine/device_simulators/tcp_server.h"
#include "engine/drivers/driver_catalogue.h"
#include "engine/drivers/modbus_heater.h"
#include "engine/drivers/modbus_tcp_link.h"
#include "engine/drivers/modbus_thermometer.h"
#include "engine/protocols/modbus_profile.h"
#include "tests/support/wait_for.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace bask::test {
namespace {

const ModbusProfile& profileOf(const std::string& name) {
    return *std::ranges::find(shippedProfiles(), name, &ModbusProfile::name);
}

class ModbusTcpLinkTest : public testing::Test {
protected:
    using Registers = std::vector<std::uint16_t>;

    ModbusTcpLinkTest() {
        units.addThermometer(1, profileOf("labjack-t-series-thermocouples"), 300.0);
        for (const int address : {60028, 60029}) // its serial number
            units.setRegister(1, 3, address, 7);
        units.addThermometer(3, profileOf("modmux-pm6rtd"), 293.15);
        units.addController(4, profileOf("pixsys-drr245"));
        plugIn();
        link = std::make_unique<ModbusTcpLink>("127.0.0.1:" + std::to_string(server->port()), clock);
    }

    void plugIn(int port = 0) { server = TcpServer::create(device, port).value(); }
    template <class Condition> bool until(Condition condition, int limit_ms = 8000) {
        return waitFor(
            [&] {
                if (server)
                    server->work(clock.now_s());
                return condition();
            },
            limit_ms);
    }
    void openLink() {
        link->open();
        ASSERT_TRUE(until([&] { return link->isOpen(); })) << describe(link->problem());
    }
    ModbusReply ask(const ModbusRequest& request) {
        EXPECT_TRUE(until([&] { return link->isFree(); })) << describe(link->problem());
        const int number = link->send(request);
        std::optional<ModbusReply> reply;
        EXPECT_TRUE(until([&] { return (reply = link->takeReply(number)).has_value(); }));
        return *reply;
    }
    MessageCode refusal(const ModbusRequest& request) {
        const ModbusReply reply = ask(request);
        return reply ? MessageCode::None : reply.error().code();
    }

    SteadyClock clock;
    ModbusSimulator units;
    ModbusTcpSimulator device{units};
    std::unique_ptr<TcpServer> server;
    std::unique_ptr<ModbusTcpLink> link;
};

} // namespace

TEST(NetworkAddress, IsReadAsPeopleWriteIt) {
    struct Written {
        const char* text;
        const char* host; ///< empty: none
        int port;
    };
    for (const Written& each : {Written{"192.168.1.20", "192.168.1.20", 502},
                                {"logger:1502", "logger", 1502},
                                {"[fe80::1]:503", "fe80::1", 503},
                                {"[::1]", "::1", 502},
                                {"fe80::1", "fe80::1", 502},
                                {"logger:", "", 0},
                                {":502", "", 0},
                                {"logger:70000", "", 0},
                                {"logger:0", "", 0},
                                {"logger:-1", "", 0},
                                {"logger:5x", "", 0},
                                {"", "", 0},
                                {"[::1", "", 0},
                                {"[::1]x", "", 0},
                                {"/dev/ttyUSB0", "", 0},
                                {"two words", "", 0}}) {
        const auto read = networkAddress(each.text, 502);
        ASSERT_EQ(read.has_value(), each.port != 0) << each.text;
        if (read) {
            EXPECT_EQ(read->host, each.host);
            EXPECT_EQ(read->port, each.port);
        }
    }
}

// Catches requests or replies that are put together or taken apart wrongly, and units that are mixed up.
TEST_F(ModbusTcpLinkTest, ReadsAndWrites) {
    openLink();
    units.setTemperature(3, 1, 333.15);
    EXPECT_EQ(ask({3, 4, 1, 3}).value(), (Registers{200, 600, 200}));
    EXPECT_TRUE(ask({4, 6, 1001, 1, {800}}).value().empty());
    EXPECT_EQ(ask({4, 3, 1000, 2}).value(), (Registers{230, 800}));
    EXPECT_TRUE(ask({4, 16, 1001, 1, {700}}).value().empty());
    EXPECT_EQ(units.registerAt(4, 3, 1001), 700);
    EXPECT_EQ(refusal({3, 4, 500, 1}), MessageCode::DeviceException);
    (void)link->send({3, 4, 1, 1});
    EXPECT_FALSE(link->isFree());
    EXPECT_THROW(link->send({3, 4, 1, 1}), std::logic_error);
}

// Promise: a reply that does not fit is never used; the next question is answered rightly again.
TEST_F(ModbusTcpLinkTest, RepliesThatDoNotFitAreNotUsed) {
    openLink();
    for (const auto& [name, code] :
         {std::pair("short-reply", MessageCode::DeviceAnswersWrong),
          std::pair("wrong-id", MessageCode::DeviceSilent), std::pair("silent", MessageCode::DeviceSilent),
          std::pair("exception", MessageCode::DeviceException)}) {
        ASSERT_TRUE(device.setFault(name)) << name;
        EXPECT_EQ(refusal({3, 4, 1, 2}), code) << name;
        ASSERT_TRUE(device.setFault("none"));
        EXPECT_EQ(ask({3, 4, 1, 2}).value(), (Registers{200, 200})) << name;
    }
}

// Catches 60.0 degC of channel 2 told for channel 1.
TEST_F(ModbusTcpLinkTest, ALateReplyIsNotTakenForTheNextOne) {
    openLink();
    units.setTemperature(3, 1, 333.15);
    ASSERT_TRUE(device.setFault("late-reply"));
    EXPECT_EQ(refusal({3, 4, 2, 2}), MessageCode::DeviceSilent);
    ASSERT_TRUE(device.setFault("none"));
    for (int i = 0; i < 5; ++i)
        EXPECT_EQ(ask({3, 4, 1, 1}).value(), Registers{200}) << i;
}

// Catches a lost connection that is not told, is not found again, or leaves its request open for ever.
TEST_F(ModbusTcpLinkTest, IsFoundAgain) {
    openLink();
    const int port = server->port();
    const int number = link->send({3, 4, 1, 1});
    server.reset();
    ASSERT_TRUE(until([&] { return !link->isOpen(); }));
    EXPECT_EQ(link->problem().code, MessageCode::LinkLost);
    std::optional<ModbusReply> reply;
    ASSERT_TRUE(until([&] { return (reply = link->takeReply(number)).has_value(); }));
    EXPECT_FALSE(*reply);
    link->open();
    ASSERT_TRUE(until([&] { return link->problem().code == MessageCode::LinkNotOpened; }))
        << "nobody listens";
    EXPECT_NE(describe(link->problem()).find("refused"), std::string::npos) << describe(link->problem());
    plugIn(port);
    openLink();
    EXPECT_EQ(ask({3, 4, 1, 1}).value(), Registers{200});
}

TEST_F(ModbusTcpLinkTest, IsOpenOnceOnThisComputer) {
    openLink();
    ModbusTcpLink second(link->name(), clock), none("two words", clock);
    second.open();
    EXPECT_NE(describe(second.problem()).find("another Bask"), std::string::npos);
    none.open();
    EXPECT_NE(describe(none.problem()).find("it is no address"), std::string::npos);
}

// Catches a LabJack whose numbers of two registers are read the wrong way round, and anything written to it.
TEST_F(ModbusTcpLinkTest, ReadsTheThermocouplesOfALabJack) {
    units.setTemperature(1, 2, 373.25);
    auto thermometer =
        ModbusThermometer::create(*link, clock, {1, profileOf("labjack-t-series-thermocouples"), {0, 2}})
            .value();
    ASSERT_TRUE(until([&] {
        thermometer->work();
        return thermometer->read().ok();
    })) << describe(thermometer->read().error());
    const auto readings = thermometer->read().value();
    ASSERT_EQ(readings.size(), 2U);
    EXPECT_NEAR(readings[0].value_K, 300.0, 1e-3);
    EXPECT_NEAR(readings[1].value_K, 373.25, 1e-3);
    EXPECT_TRUE(std::ranges::all_of(device.functions(), [](int function) { return function == 3; }));
}

// Catches a controller on a network that heats without its watchdog, or is not seen off.
TEST_F(ModbusTcpLinkTest, HeatsAndSwitchesOff) {
    ModbusHeaterSettings settings{4, profileOf("pixsys-drr245")};
    auto heater = ModbusHeater::create(*link, clock, settings).value();
    const auto works = [&](auto condition) {
        return until(
            [&] {
                heater->work();
                return condition();
            },
            20000);
    };
    ASSERT_TRUE(works([&] { return heater->heatState() == HeatState::Off; }));
    ASSERT_TRUE(works([&] { return heater->keepHeating(373.15, 5.0) && units.isOn(4); }));
    EXPECT_NEAR(units.setPoint_K(4), 373.15, 0.1);
    (void)heater->heatOff();
    EXPECT_TRUE(works([&] { return !units.isOn(4) && heater->heatState() == HeatState::Off; }));
}

} // namespace bask::test
