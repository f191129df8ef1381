// Another device that is plugged in where one is remembered.

#include "engine/base/units.h"
#include "tests/engine/runtime/rig_on_ports.h"

namespace bask {
namespace {

struct ExchangedDeviceTest : test::RigOnPorts {
    /// All are met, and another engine starts.
    void meet() {
        load();
        ASSERT_TRUE(sees([&] {
            const auto met = readDeviceMemory(deviceFile);
            return met && met->size() == 3;
        }));
        start();
        // That of the first engine would switch off whatever is at its port, if that has not seen it off yet.
        test::endGuardsOf(folder.path());
        for (test::Watched& device : devices)
            (void)device.takeWritten();
    }
    MessageCode problemOf(DeviceRole role) const {
        const auto it = std::ranges::find(engine->last.devices, role, &RigDeviceState::role);
        return it == engine->last.devices.end() ? MessageCode::None : it->status.problem.code;
    }
    /// At the robot's port, or the plate's.
    void exchange(std::size_t i, ByteDevice& other) {
        servers[i].reset();
        devices[i].become(other);
        serve(i);
    }
    static GrblSimulatorConfig otherGrbl() {
        GrblSimulatorConfig config = test::arduino();
        config.name = "other";
        return config;
    }
};

} // namespace

// Catches devices that are new each time, and those that are the same and are refused.
TEST_F(ExchangedDeviceTest, TheSameDevicesAreTakenAgain) {
    ASSERT_NO_FATAL_FAILURE(meet());
    ASSERT_NO_FATAL_FAILURE(beginWell());
    EXPECT_EQ(readDeviceMemory(deviceFile)->at(memoryKey(*experiment.rig->source)).signature,
              "IKA simulated");
}

// Catches a robot that is moved, or asked to, at the port of another one.
TEST_F(ExchangedDeviceTest, NothingIsWrittenToAnotherRobotUntilItIsAccepted) {
    ASSERT_NO_FATAL_FAILURE(meet());
    GrblSimulator other(otherGrbl());
    exchange(0, other);
    load();
    ASSERT_TRUE(sees([&] { return problemOf(DeviceRole::Robot) == MessageCode::DeviceExchanged; }));
    engine->send(ClearRobotAlarm{});
    engine->send(HomeRobot{});
    engine->send(Reset{});
    ASSERT_NO_FATAL_FAILURE(waitForSamples(1.0));
    std::string written = devices[0].takeWritten();
    std::erase(written, '?');
    for (const std::string question : {"$$\n", "$I\n"})
        for (std::size_t at = written.find(question); at != std::string::npos; at = written.find(question))
            written.erase(at, question.size());
    EXPECT_EQ(written, "");
    EXPECT_EQ(engine->last.state, RunState::Fault);

    engine->send(AcceptDevice{DeviceRole::Robot});
    ASSERT_TRUE(sees([&] { return isLive(DeviceRole::Robot); }));
    EXPECT_TRUE(sees([&] { return !engine->last.isPlaceSure; })) << "nobody has said where this one is";
    ASSERT_TRUE(sees([&] {
        const auto met = readDeviceMemory(deviceFile);
        return met && met->size() == 3 &&
               met->at(memoryKey(*experiment.rig->robot)).signature.find("other") != std::string::npos;
    }));
}

// Catches two plates whose plugs were swapped.
TEST_F(ExchangedDeviceTest, NothingIsWrittenToAnotherPlateUntilItIsAccepted) {
    ASSERT_NO_FATAL_FAILURE(meet());
    NamurSimulatorConfig config;
    config.name = "RCT digital";
    NamurSimulator other(config);
    exchange(2, other);
    load();
    ASSERT_TRUE(sees([&] { return problemOf(DeviceRole::HeatSource) == MessageCode::DeviceExchanged; }));
    engine->send(SetHeat{std::nullopt});
    engine->send(Reset{});
    ASSERT_NO_FATAL_FAILURE(waitForSamples(1.0));
    EXPECT_EQ(devices[2].takeWritten().find("OUT_"), std::string::npos);
    EXPECT_EQ(engine->last.state, RunState::Fault);
    engine->send(AcceptDevice{DeviceRole::HeatSource});
    ASSERT_TRUE(sees([&] { return areLive(); }));
}

// Catches a test read that writes to another device than the one that is known there.
TEST_F(ExchangedDeviceTest, ATestReadComparesFirst) {
    ASSERT_NO_FATAL_FAILURE(meet());
    NamurSimulatorConfig config;
    config.name = "RCT digital";
    NamurSimulator other(config);
    exchange(2, other);
    const RigSpec all = *experiment.rig;
    experiment.rig.reset();
    load();
    RigSpec plateAlone;
    plateAlone.source = all.source;
    engine->send(TryDevice{plateAlone});
    ASSERT_TRUE(sees([&] {
        return engine->last.tried &&
               engine->last.tried->state.status.problem.code == MessageCode::DeviceExchanged;
    }));
    EXPECT_TRUE(engine->last.tried->temperatures_K.empty());
    const std::string written = devices[2].takeWritten();
    EXPECT_EQ(written.find("OUT_"), std::string::npos) << written;
    EXPECT_EQ(written.find("STOP"), std::string::npos) << written;
}

// Catches an adapter that got another one's number and is opened, which may reset what is behind it.
TEST_F(ExchangedDeviceTest, APortOfAnotherNameIsNotOpened) {
    ASSERT_TRUE(writeDeviceMemory(
        {{memoryKey(*experiment.rig->robot), {"usb-FTDI_FT232R_USB_UART_A1-if00-port0", ""}}}, deviceFile));
    start();
    load();
    ASSERT_TRUE(sees([&] { return problemOf(DeviceRole::Robot) == MessageCode::DeviceExchanged; }));
    ASSERT_NO_FATAL_FAILURE(waitForSamples(1.0));
    EXPECT_EQ(opened()[0], 0);
    engine->send(AcceptDevice{DeviceRole::Robot});
    ASSERT_TRUE(sees([&] { return isLive(DeviceRole::Robot); }));
}

// The same of the heater's port, which its guard opens. Catches a guard that is not told which port it is.
TEST_F(ExchangedDeviceTest, AHeatersPortOfAnotherNameIsNotOpenedByItsGuard) {
    const std::string name = "usb-FTDI_FT232R_USB_UART_A2-if00-port0";
    ASSERT_TRUE(writeDeviceMemory({{memoryKey(*experiment.rig->source), {name, ""}}}, deviceFile));
    start();
    load();
    ASSERT_TRUE(sees([&] { return problemOf(DeviceRole::HeatSource) == MessageCode::DeviceExchanged; }));
    ASSERT_NO_FATAL_FAILURE(waitForSamples(1.0));
    EXPECT_EQ(opened()[2], 0);
    engine->send(AcceptDevice{DeviceRole::HeatSource});
    ASSERT_TRUE(sees([&] { return isLive(DeviceRole::HeatSource); }));
}

} // namespace bask
