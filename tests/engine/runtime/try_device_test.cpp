// A device that is tried: the engine, its driver and a simulated device at the far end of a pty.

#include "engine/base/units.h"
#include "engine/device_simulators/grbl_simulator.h"
#include "engine/device_simulators/modbus_simulator.h"
#include "engine/device_simulators/namur_simulator.h"
#include "engine/device_simulators/pty_server.h"
#include "engine/device_simulators/tcp_server.h"
#include "engine/drivers/driver_catalogue.h"
#include "engine/drivers/traffic_log.h"
#include "tests/engine/runtime/engine_thread.h"

#include <QTemporaryDir>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace bask {
namespace {

Experiment bareDisk() {
    Experiment experiment;
    ObjectSpec object;
    object.name = "disk";
    object.shape = Disk{0.015};
    object.material = {"painted", 0.9, 0.9, 904.0, 2700.0, 0.001, 1.0};
    experiment.objects.push_back(object);
    return experiment;
}

struct TryDeviceTest : testing::Test {
    QTemporaryDir folder;
    std::string port = folder.filePath("port").toStdString();
    std::unique_ptr<PtyServer> server;
    SteadyClock clock;
    EngineThread engine;

    TryDeviceTest() { engine.send(LoadExperiment{bareDisk()}); } // one is there when a rig is set up
    void serve(ByteDevice& device) {
        auto made = PtyServer::create(device, port);
        ASSERT_TRUE(made) << describe(made.error());
        server = std::move(*made);
    }
    /// While the device works.
    template <class Condition> bool sees(Condition condition, int limit_ms = 60000) {
        return engine.waitFor(
            [&] {
                if (server)
                    server->work(clock.now_s());
                return condition();
            },
            limit_ms);
    }
    bool isLive() const {
        return engine.last.tried && engine.last.tried->state.status.link == LinkState::Live;
    }
    MessageCode problem() const {
        return engine.last.tried ? engine.last.tried->state.status.problem.code : MessageCode::None;
    }
    /// By its name.
    static const ModbusProfile& profile(const char* name) {
        return *std::ranges::find(shippedProfiles(), name, &ModbusProfile::name);
    }
    RigSpec thermometer() const {
        RigSpec rig;
        rig.thermometer.emplace().port = port;
        rig.thermometer->serial = driverOf(*rig.thermometer).serial;
        rig.thermometer->unit = 5;
        rig.thermometer->profile = profile("waveshare-8ch-4-20ma");
        return rig;
    }
};

} // namespace

// Catches a test read that tells only the channels in use, or none.
TEST_F(TryDeviceTest, AModbusThermometerTellsAllItsChannels) {
    ModbusSimulator module;
    module.addThermometer(5, profile("waveshare-8ch-4-20ma"), kelvinFromCelsius(25.0));
    module.setTemperature(5, 3, kelvinFromCelsius(80.0));
    serve(module);
    engine.send(TryDevice{thermometer()});
    ASSERT_TRUE(sees([&] {
        return isLive() && engine.last.tried->temperatures_K.size() == 8 &&
               std::isfinite(engine.last.tried->temperatures_K[7]);
    }));
    EXPECT_NEAR(engine.last.tried->temperatures_K[0], kelvinFromCelsius(25.0), 0.2);
    EXPECT_NEAR(engine.last.tried->temperatures_K[3], kelvinFromCelsius(80.0), 0.2);
    EXPECT_EQ(engine.last.tried->state.role, DeviceRole::Thermometer);

    RigSpec other = thermometer();
    other.thermometer->unit = 6; // nobody has this address
    engine.send(TryDevice{other});
    ASSERT_TRUE(sees([&] { return problem() == MessageCode::DeviceSilent; }));
    EXPECT_FALSE(isLive());

    engine.send(TryDevice{});
    ASSERT_TRUE(sees([&] { return !engine.last.tried; })); // and its port is free
}

// Catches an address that is opened as a serial port, and one that is none and ends the engine.
TEST_F(TryDeviceTest, AModbusThermometerAtAnAddressTellsItsChannels) {
    ModbusSimulator module(ModbusSimulator::Frames::Tcp);
    module.addThermometer(5, profile("waveshare-8ch-4-20ma"), kelvinFromCelsius(25.0));
    const auto host = TcpServer::create(module).value();
    RigSpec rig = thermometer();
    rig.thermometer->driver = "modbus_tcp";
    rig.thermometer->port = "127.0.0.1:" + std::to_string(host->port());
    engine.send(TryDevice{rig});
    ASSERT_TRUE(sees([&] {
        host->work(clock.now_s());
        return isLive() && engine.last.tried->temperatures_K.size() == 8;
    }));
    EXPECT_NEAR(engine.last.tried->temperatures_K[7], kelvinFromCelsius(25.0), 0.2);
    EXPECT_EQ(module.writes(), 0);
    rig.thermometer->port = "two words";
    engine.send(TryDevice{rig});
    ASSERT_TRUE(sees([&] { return problem() == MessageCode::LinkNotOpened; }));
}

// Catches a search that finds nothing, does not end, or writes.
TEST_F(TryDeviceTest, UnitsAreFoundWithTheirProfiles) {
    ModbusSimulator module(ModbusSimulator::Frames::Tcp);
    module.addThermometer(5, profile("waveshare-8ch-4-20ma"), kelvinFromCelsius(25.0));
    const auto host = TcpServer::create(module).value();
    ModbusSearchSpec spec{"127.0.0.1:" + std::to_string(host->port()), true};
    spec.firstUnit = 4;
    spec.lastUnit = 6;
    const auto works = [&](auto condition) {
        return sees([&] {
            host->work(clock.now_s());
            return condition();
        });
    };
    engine.send(FindUnits{spec, 7});
    ASSERT_TRUE(works([&] { return engine.last.search && engine.last.search->isOver; }));
    const ModbusSearchState& state = *engine.last.search;
    EXPECT_EQ(state.problem, Message{});
    EXPECT_EQ(state.number, 7);
    EXPECT_FALSE(engine.last.traffic->from(0).empty()) << "its traffic is kept, too";
    ASSERT_EQ(state.found.size(), 1U);
    EXPECT_EQ(state.found[0].unit, 5);
    EXPECT_TRUE(std::ranges::any_of(
        state.found[0].fits, [](const ProfileFit& fit) { return fit.profile == "waveshare-8ch-4-20ma"; }));
    EXPECT_EQ(module.writes(), 0);
    engine.send(FindUnits{});
    ASSERT_TRUE(works([&] { return !engine.last.search; }));
}

// Catches a console that shows nothing of a device, a person who sends past its driver, and a robot whose
// place is sure after that.
TEST_F(TryDeviceTest, TheTrafficIsKeptAndAPersonMaySend) {
    GrblSimulator robot;
    serve(robot);
    Experiment experiment = bareDisk();
    experiment.rig.emplace().robot.emplace().port = port;
    experiment.robot.free = {true, true, true, false, false, false};
    experiment.rig->robot->axes = {{'X', kX}, {'Y', kY}, {'Z', kZ}};
    const auto has = [&](TrafficKind kind, const char* bytes) {
        return std::ranges::any_of(engine.last.traffic->from(0), [&](const TrafficLog::Line& line) {
            return line->kind == kind && line->link == port && line->bytes.find(bytes) != std::string::npos;
        });
    };
    const auto status = [&] {
        return engine.last.devices.empty() ? DeviceStatus() : engine.last.devices[0].status;
    };
    engine.send(TryDevice{*experiment.rig});
    ASSERT_TRUE(sees([&] { return isLive(); }));
    EXPECT_TRUE(has(TrafficKind::Sent, "?"));
    EXPECT_TRUE(has(TrafficKind::Received, "[VER:"));
    engine.send(SendByHand{port, "G21\n"});
    ASSERT_TRUE(sees([&] { return engine.refusal.code == MessageCode::RigMissing; })) << "it is only tried";
    engine.send(TryDevice{});
    ASSERT_TRUE(sees([&] { return !engine.last.tried; }));

    engine.send(LoadExperiment{experiment});
    ASSERT_TRUE(sees([&] { return status().link == LinkState::Live; })) << describe(engine.refusal);
    engine.send(ClearRobotAlarm{});
    ASSERT_TRUE(sees([&] { return engine.last.isPlaceSure; }));
    engine.send(SendByHand{port, "G21\n"});
    ASSERT_TRUE(sees([&] { return status().problem.code == MessageCode::LinkByHand; }));
    EXPECT_TRUE(has(TrafficKind::SentByHand, "G21\n"));
    EXPECT_TRUE(std::ranges::any_of(engine.events, [](const TraceEvent& event) {
        return event.message.code == MessageCode::EventSentByHand;
    }));
    ASSERT_TRUE(sees([&] { return status().link == LinkState::Live; }, 10000)) << "its driver has it back";
    EXPECT_TRUE(sees([&] { return !engine.last.isPlaceSure; }, 3000)) << "whatever the person has done";
    engine.send(SendByHand{port, "?"});
    ASSERT_TRUE(sees([&] { return status().problem.code == MessageCode::LinkByHand; }));
    engine.send(EmergencyStop{});
    ASSERT_TRUE(sees([&] { return status().link == LinkState::Live; }, 2000)) << "a stop has it at once";
}

// Catches a robot that is moved or homed by being tried.
TEST_F(TryDeviceTest, AGrblRobotTellsWhereItIs) {
    GrblSimulatorConfig config;
    config.start = {12.5, -3.0, 150.0, 10.0};
    GrblSimulator robot(config);
    serve(robot);
    RigSpec rig;
    rig.robot.emplace().port = port;
    engine.send(TryDevice{rig});
    ASSERT_TRUE(sees([&] { return isLive() && engine.last.tried->coordinates; }));
    const Vector6d at = *engine.last.tried->coordinates;
    EXPECT_NEAR(at[kX], 0.0125, 1e-6);
    EXPECT_NEAR(at[kZ], 0.15, 1e-6);
    EXPECT_NEAR(at[kThetaX], radFromDeg(10.0), 1e-6);
    EXPECT_NE(engine.last.tried->state.status.identity.find("Grbl"), std::string::npos);
    EXPECT_EQ(robot.positions(), config.start);
}

// Catches a plate that is switched by being tried.
TEST_F(TryDeviceTest, ANamurPlateTellsItsTemperature) {
    NamurSimulatorConfig config;
    config.ambient_K = kelvinFromCelsius(23.0);
    NamurSimulator plate(config);
    serve(plate);
    RigSpec rig;
    rig.source.emplace().driver = "namur";
    rig.source->port = port;
    rig.source->serial = driverOf(*rig.source).serial;
    engine.send(TryDevice{rig});
    ASSERT_TRUE(sees([&] { return isLive() && engine.last.tried->temperatures_K.size() == 1; }));
    EXPECT_NEAR(engine.last.tried->temperatures_K[0], kelvinFromCelsius(23.0), 0.1);
    EXPECT_FALSE(plate.isOn());

    ASSERT_TRUE(plate.setFault("silent"));
    ASSERT_TRUE(sees([&] { return engine.last.tried->state.status.link == LinkState::Lost; }));
    EXPECT_EQ(problem(), MessageCode::DeviceSilent);
}

// Catches a mistyped port that only says "opening", and a device of another kind taken for the right one.
TEST_F(TryDeviceTest, AWrongPortIsToldInWords) {
    engine.send(TryDevice{thermometer()}); // nothing is there
    ASSERT_TRUE(sees([&] { return problem() == MessageCode::LinkNotOpened; }));
    EXPECT_EQ(engine.last.tried->state.status.problem.args.at(0), port);
    EXPECT_FALSE(engine.last.tried->state.status.problem.args.at(1).text().empty());

    NamurSimulator plate;
    serve(plate);
    RigSpec rig;
    rig.robot.emplace().port = port; // a hotplate's
    engine.send(TryDevice{rig});
    ASSERT_TRUE(sees(
        [&] { return problem() == MessageCode::DeviceSilent || problem() == MessageCode::DeviceOther; }));
    EXPECT_FALSE(isLive());
}

} // namespace bask
