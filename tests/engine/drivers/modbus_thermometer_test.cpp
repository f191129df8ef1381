#include "engine/drivers/modbus_thermometer.h"

#include "tests/engine/drivers/modbus_fixture.h"

#include <gtest/gtest.h>

namespace bask {
namespace {

using test::shipped;

class ModbusThermometerTest : public test::ModbusDriverTest {
protected:
    std::unique_ptr<ModbusThermometer> made(const std::string& profile, std::vector<int> channels,
                                            double t_K = 293.15) {
        sim.addThermometer(7, shipped(profile), t_K);
        return ModbusThermometer::create(link, clock, {7, shipped(profile), std::move(channels)}).value();
    }
};

// Catches channels read one by one, mixed up, or with a time that is not their answer's.
TEST_F(ModbusThermometerTest, ChannelsComeInOneRequestInTheOrderOfTheObjects) {
    const auto thermometer = made("modmux-pm6rtd", {4, 1, 2});
    sim.setTemperature(7, 1, 333.15);
    sim.setTemperature(7, 4, 313.15);
    EXPECT_EQ(thermometer->channels(), 3);
    EXPECT_EQ(thermometer->status().link, LinkState::Closed);
    EXPECT_FALSE(thermometer->read().ok());
    run(*thermometer, 1.0);
    const auto readings = thermometer->read();
    ASSERT_TRUE(readings.ok()) << describe(readings.error());
    ASSERT_EQ(readings->size(), 3u);
    EXPECT_NEAR((*readings)[0].value_K, 313.15, 1e-9);
    EXPECT_NEAR((*readings)[1].value_K, 333.15, 1e-9);
    EXPECT_NEAR((*readings)[2].value_K, 293.15, 1e-9);
    for (const Reading& r : *readings) {
        EXPECT_TRUE(r.valid);
        EXPECT_LE(r.time_s, clock.now_s());
        EXPECT_GE(r.time_s, clock.now_s() - 0.11);
    }
    for (const ModbusRequest& r : link.sent) {
        EXPECT_EQ(r.unit, 7);
        EXPECT_EQ(r.address, 2);
        EXPECT_EQ(r.count, 4);
    }
}

// Catches polls that come faster or slower than they are set to, and a rate told wrongly.
TEST_F(ModbusThermometerTest, PollsAtItsPeriod) {
    const auto thermometer = made("thermasgard-rtm1", {0});
    run(*thermometer, 10.0);
    EXPECT_NEAR(static_cast<double>(link.sent.size()), 100.0, 2.0);
    const DeviceStatus status = thermometer->status();
    EXPECT_EQ(status.link, LinkState::Live);
    EXPECT_EQ(status.problem, Message{});
    EXPECT_NEAR(status.rate_Hz, 10.0, 0.6);
    EXPECT_NEAR(status.replyTime_s, 0.02, 0.006);
}

// Promise: no value is newer than it was measured. Catches a reading stamped when it is read out.
TEST_F(ModbusThermometerTest, AReadingKeepsItsTime) {
    const auto thermometer = made("thermasgard-rtm1", {0});
    run(*thermometer, 0.5);
    const double time_s = thermometer->read()->front().time_s;
    clock.advance(0.4); // the engine is held up
    EXPECT_EQ(thermometer->read()->front().time_s, time_s);
}

// Catches a reply that waited for an engine that was held up and is told as new.
TEST_F(ModbusThermometerTest, AReadingIsAsOldAsItsQuestion) {
    const auto thermometer = made("thermasgard-rtm1", {0});
    run(*thermometer, 0.5);
    const std::size_t before = link.sent.size();
    while (link.sent.size() == before)
        run(*thermometer, 0.005);
    const double asked_s = clock.now_s();
    clock.advance(5.0);
    run(*thermometer, 0.005);
    ASSERT_TRUE(thermometer->read());
    EXPECT_EQ(thermometer->read()->front().time_s, asked_s);
}

// Promise: open and shorted sensors never become a temperature, whatever way the device tells them.
TEST_F(ModbusThermometerTest, FaultySensorsAreInvalid) {
    struct Case {
        const char* profile;
        SensorFault open, shorted;
    };
    for (const Case& c : {Case{"modmux-pm6rtd", SensorFault::Open, SensorFault::Open},
                          Case{"benshaw-remote-rtd", SensorFault::Open, SensorFault::Short},
                          Case{"isma-sfar-1m-1ti1do", SensorFault::Open, SensorFault::OutOfRange},
                          Case{"waveshare-8ch-4-20ma", SensorFault::Open, SensorFault::Other},
                          Case{"generic-pt100-ohm", SensorFault::OutOfRange, SensorFault::Short},
                          Case{"adam-4015-0-100", SensorFault::OutOfRange, SensorFault::OutOfRange}}) {
        ASSERT_TRUE(sim.setFault("none").ok());
        const auto thermometer = made(c.profile, {0}, 323.15);
        run(*thermometer, 1.0);
        ASSERT_TRUE(thermometer->read().ok()) << c.profile;
        EXPECT_TRUE(thermometer->read()->front().valid) << c.profile;
        EXPECT_NEAR(thermometer->read()->front().value_K, 323.15, 0.6) << c.profile;
        for (const auto& [fault, expected] : {std::pair("open", c.open), std::pair("short", c.shorted)}) {
            ASSERT_TRUE(sim.setFault(fault).ok());
            run(*thermometer, 0.5);
            const Reading r = thermometer->read()->front();
            EXPECT_FALSE(r.valid) << c.profile << " " << fault;
            EXPECT_EQ(r.value_K, 0.0);
            EXPECT_EQ(r.fault, expected) << c.profile << " " << fault;
        }
    }
}

// Catches a status register that is asked for apart although it lies next to the values.
TEST_F(ModbusThermometerTest, StatusNextToTheValuesIsReadWithThem) {
    const auto benshaw = made("benshaw-remote-rtd", {0, 1, 2, 3, 4, 5, 6, 7});
    run(*benshaw, 1.0);
    for (const ModbusRequest& r : link.sent)
        EXPECT_EQ(r.count, 10);
}

// Catches a device that is called live by its link alone, or a problem without a cause.
TEST_F(ModbusThermometerTest, SilenceIsLossWithinASecond) {
    const auto thermometer = made("thermasgard-rtm1", {0});
    run(*thermometer, 1.0);
    ASSERT_TRUE(sim.setFault("silent").ok());
    run(*thermometer, 1.2);
    EXPECT_EQ(thermometer->status().link, LinkState::Lost);
    EXPECT_EQ(thermometer->status().problem.code, MessageCode::DeviceSilent);
    EXPECT_EQ(thermometer->read().error().code(), MessageCode::DeviceSilent);
    ASSERT_TRUE(sim.setFault("none").ok());
    run(*thermometer, 1.0);
    EXPECT_EQ(thermometer->status().link, LinkState::Live);
    EXPECT_TRUE(thermometer->read().ok());
}

// Catches replies thrown away unsaid.
TEST_F(ModbusThermometerTest, RepliesThatAreWrongAreCounted) {
    const auto thermometer = made("thermasgard-rtm1", {0});
    run(*thermometer, 1.0);
    EXPECT_EQ(thermometer->status().discarded, 0);
    int wrong = 3;
    before = [&](const ModbusRequest&) -> std::optional<ModbusReply> {
        if (wrong-- <= 0)
            return std::nullopt;
        return Error(MessageCode::DeviceAnswersWrong, "line", {"line", "another unit"});
    };
    run(*thermometer, 2.0);
    EXPECT_EQ(thermometer->status().discarded, 3);
}

// Catches an exception taken for an answer, and one asked for without a pause.
TEST_F(ModbusThermometerTest, ExceptionsAreToldAndNotHammered) {
    const auto thermometer = made("isma-sfar-1m-1ti1do", {0});
    ASSERT_TRUE(sim.setFault("exception").ok());
    run(*thermometer, 3.0);
    EXPECT_EQ(thermometer->status().link, LinkState::Opening);
    EXPECT_EQ(thermometer->status().problem.code, MessageCode::DeviceException);
    EXPECT_LE(link.sent.size(), 31u);
}

// Catches a status register that the device lacks leaving old values shown as live for ever.
TEST_F(ModbusThermometerTest, ARegisterThatIsNotThereIsTold) {
    const auto thermometer = made("isma-sfar-1m-1ti1do", {0});
    before = [](const ModbusRequest& r) -> std::optional<ModbusReply> {
        if (r.address == 52)
            return Error(MessageCode::DeviceException, "line", {"line", "7", "2"});
        return std::nullopt;
    };
    run(*thermometer, 3.0);
    EXPECT_EQ(thermometer->status().problem.code, MessageCode::DeviceException);
    EXPECT_FALSE(thermometer->read().ok());
    EXPECT_LE(link.sent.size(), 32u);
}

// Catches a driver that does not come back by itself, or tries without a pause.
TEST_F(ModbusThermometerTest, AnUnpluggedPortIsBackWithinTwoSeconds) {
    const auto thermometer = made("thermasgard-rtm1", {0});
    run(*thermometer, 1.0);
    link.unplug();
    run(*thermometer, 0.1);
    EXPECT_EQ(thermometer->status().link, LinkState::Lost);
    EXPECT_EQ(thermometer->status().problem.code, MessageCode::LinkNotOpened);
    run(*thermometer, 10.0);
    EXPECT_LE(link.opened, 23);
    EXPECT_EQ(thermometer->status().problem.code, MessageCode::LinkNotOpened);
    link.isPlugged = true;
    run(*thermometer, 1.0);
    EXPECT_EQ(thermometer->status().link, LinkState::Live);
    EXPECT_TRUE(thermometer->read()->front().valid);
}

// Catches one driver of a shared line that leaves the other no turn.
TEST_F(ModbusThermometerTest, TwoOnOneLineBothGetTheirTurns) {
    sim.addThermometer(8, shipped("thermasgard-rtm1"), 303.15);
    const auto first = made("isma-sfar-1m-1ti1do", {0});
    const auto second = ModbusThermometer::create(link, clock, {8, shipped("thermasgard-rtm1"), {0}}).value();
    struct Both {
        ModbusThermometer &a, &b;
        void work() {
            a.work();
            b.work();
        }
    } both{*first, *second};
    link.reply_s = 0.06; // the first alone could fill the line
    run(both, 5.0);
    EXPECT_EQ(first->status().link, LinkState::Live);
    EXPECT_EQ(second->status().link, LinkState::Live);
    EXPECT_GT(second->status().rate_Hz, 4.0);
    EXPECT_NEAR(second->read()->front().value_K, 303.15, 1e-9);
}

// Catches a channel between that is not set up and takes the others with it, and a request for it.
TEST_F(ModbusThermometerTest, ChannelsReadOneByOneAreRefusedOneByOne) {
    const ModbusProfile& profile = shipped("labjack-t7-thermocouples");
    sim.addThermometer(9, profile, 295.0);
    for (const int channel : {1, 3, 4})
        sim.removeChannel(9, channel);
    sim.setTemperature(9, 2, 373.25);
    const auto pair = ModbusThermometer::create(link, clock, {9, profile, {2, 0}}).value();
    run(*pair, 1.0);
    ASSERT_TRUE(pair->read().ok());
    EXPECT_NEAR(pair->read()->at(0).value_K, 373.25, 1e-3);
    EXPECT_NEAR(pair->read()->at(1).value_K, 295.0, 1e-3);
    EXPECT_LT(pair->read()->at(0).time_s, pair->read()->at(1).time_s)
        << "each has the time of its own request";
    const auto asked = [&](int address) {
        return std::ranges::any_of(link.sent, [&](const ModbusRequest& r) {
            return r.address <= address && address < r.address + r.count;
        });
    };
    EXPECT_TRUE(asked(7004));
    EXPECT_FALSE(asked(7002));
    const auto third = ModbusThermometer::create(link, clock, {9, profile, {0, 4, 2}}).value();
    run(*third, 1.0);
    ASSERT_TRUE(third->read().ok());
    EXPECT_TRUE(third->read()->at(0).valid);
    EXPECT_FALSE(third->read()->at(1).valid);
    EXPECT_EQ(third->read()->at(1).fault, SensorFault::Other);
    EXPECT_TRUE(third->read()->at(2).valid);
    EXPECT_EQ(third->status().link, LinkState::Live);
}

// Catches temperatures of a device that only happens to have registers there.
TEST_F(ModbusThermometerTest, ADeviceOfAnotherTypeIsNotRead) {
    const ModbusProfile& profile = shipped("labjack-t7-thermocouples");
    sim.addThermometer(9, profile, 295.0);
    sim.setRegister(9, 3, 60000, 0x4080); // 4.0F: a T4, which has no thermocouples
    const auto thermometer = ModbusThermometer::create(link, clock, {9, profile, {0}}).value();
    run(*thermometer, 1.0);
    EXPECT_EQ(thermometer->status().link, LinkState::Opening);
    EXPECT_EQ(thermometer->status().problem.code, MessageCode::DeviceAnswersWrong);
    EXPECT_NE(describe(thermometer->read().error()).find("its type holds 4"), std::string::npos)
        << describe(thermometer->read().error());
    sim.setRegister(9, 3, 60000, 0x4100); // 8.0F: a T8
    run(*thermometer, 1.0);
    EXPECT_EQ(thermometer->status().link, LinkState::Live);
    EXPECT_EQ(thermometer->status().signature, "125c 125d");
}

// Catches settings that no device has being tried on one.
TEST_F(ModbusThermometerTest, RefusesWhatItCannotDo) {
    const ModbusProfile& p = shipped("modmux-pm6rtd");
    const auto refusal = [&](const ModbusThermometerSettings& s) {
        return ModbusThermometer::create(link, clock, s).error();
    };
    EXPECT_EQ(refusal({1, ModbusProfile{}, {0}}).code(), MessageCode::JsonMissingKey);
    EXPECT_EQ(refusal({0, p, {0}}).where, "unit");
    EXPECT_EQ(refusal({248, p, {0}}).where, "unit");
    EXPECT_EQ(refusal({1, p, {}}).where, "channels");
    EXPECT_EQ(refusal({1, p, {0, 6}}).where, "channels");
    EXPECT_EQ(refusal({1, p, {0}, 0.05}).where, "period");
}

} // namespace
} // namespace bask
