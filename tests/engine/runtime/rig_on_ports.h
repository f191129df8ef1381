#pragma once
// A real rig whose devices are simulated at the far ends of pseudo-terminals, in the test's own thread.

#include "engine/base/suspend_watch.h"
#include "engine/device_simulators/grbl_simulator.h"
#include "engine/device_simulators/namur_simulator.h"
#include "engine/device_simulators/pty_server.h"
#include "engine/device_simulators/stream_simulator.h"
#include "engine/drivers/driver_catalogue.h"
#include "tests/engine/runtime/engine_thread.h"
#include "tests/support/guard_processes.h"

#include <QTemporaryDir>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <memory>
#include <utility>

namespace bask::test {

/// Counts how often its port was opened, and keeps what it was written.
class Watched final : public ByteDevice {
public:
    explicit Watched(ByteDevice& device) : m_device(&device) {}
    /// Another one.
    void become(ByteDevice& device) { m_device = &device; }
    void opened(double now_s) override {
        ++m_times;
        m_device->opened(now_s);
    }
    void receive(std::string_view bytes, double now_s) override {
        m_written += bytes;
        m_device->receive(bytes, now_s);
    }
    std::string transmit(double now_s) override { return m_device->transmit(now_s); }
    std::vector<std::string> faults() const override { return m_device->faults(); }
    Result<void> setFault(const std::string& name) override { return m_device->setFault(name); }
    int times() const { return m_times; }
    std::string takeWritten() { return std::exchange(m_written, {}); }

private:
    ByteDevice* m_device;
    int m_times = 0;
    std::string m_written;
};

inline GrblSimulatorConfig arduino() {
    GrblSimulatorConfig config;
    config.resetsWhenOpened = true;
    config.canHome = false;
    return config;
}

/// Sleeps when it is told to.
class SleepyClock final : public Clock {
public:
    explicit SleepyClock(std::shared_ptr<std::atomic<double>> slept_s) : m_slept_s(std::move(slept_s)) {}
    double now_s() const override { return AwakeClock().now_s() - *m_slept_s; }

private:
    std::shared_ptr<std::atomic<double>> m_slept_s;
};

struct RigOnPorts : testing::Test {
    QTemporaryDir folder;
    GrblSimulator grbl{arduino()};
    StreamSimulator stream{{}};
    NamurSimulator plate{{}};
    std::array<Watched, 3> devices{Watched(grbl), Watched(stream), Watched(plate)};
    std::array<std::unique_ptr<PtyServer>, 3> servers;
    SteadyClock clock;
    Experiment experiment;
    std::shared_ptr<std::atomic<double>> slept_s = std::make_shared<std::atomic<double>>(0.0);
    std::string deviceFile = folder.filePath("devices.json").toStdString();
    std::unique_ptr<EngineThread> engine;

    RigOnPorts() {
        start();
        for (std::size_t i = 0; i < devices.size(); ++i)
            serve(i);
        ObjectSpec object;
        object.name = "disk";
        object.shape = Disk{0.015};
        object.material = {"painted", 0.9, 0.9, 904.0, 2700.0, 0.001, 1.0};
        experiment.objects.push_back(object);
        experiment.sampling.period_s = 0.2;
        experiment.safety.stalePeriods = 10.0; // a busy machine is no fault
        RigSpec& rig = experiment.rig.emplace();
        rig.robot.emplace().port = port(0);
        // Where the axes read zero, the object is well above the source.
        for (AxisSpec& axis : rig.robot->axes)
            axis.origin = experiment.start[axis.coordinate];
        rig.robot->serial = driverOf(*rig.robot).serial;
        rig.thermometer.emplace().driver = "stream";
        rig.thermometer->port = port(1);
        rig.thermometer->serial = driverOf(*rig.thermometer).serial;
        rig.thermometer->channels = {0};
        rig.source.emplace().driver = "namur";
        rig.source->port = port(2);
        rig.source->serial = driverOf(*rig.source).serial;
    }
    ~RigOnPorts() override {
        engine.reset();
        endGuardsOf(folder.path());
    }
    RigOnPorts(const RigOnPorts&) = delete;
    RigOnPorts& operator=(const RigOnPorts&) = delete;

    /// Another engine, on this computer as it is now.
    void start() {
        engine.reset();
        engine =
            std::make_unique<EngineThread>(std::string(), deviceFile, std::make_unique<SleepyClock>(slept_s));
    }
    void serve(std::size_t i) {
        auto made = PtyServer::create(devices[i], port(i));
        ASSERT_TRUE(made) << describe(made.error());
        servers[i] = std::move(*made);
    }
    std::string port(std::size_t i) const { return folder.filePath(QString::number(i)).toStdString(); }

    /// While the devices work.
    template <class Condition> bool sees(Condition condition, int limit_ms = 30000) {
        return engine->waitFor(
            [&] {
                for (const auto& server : servers)
                    if (server) // its cable is in
                        server->work(clock.now_s());
                return condition();
            },
            limit_ms);
    }
    bool isLive(DeviceRole role) const {
        return std::ranges::any_of(engine->last.devices, [role](const RigDeviceState& device) {
            return device.role == role && device.status.link == LinkState::Live;
        });
    }
    bool areLive() const {
        return isLive(DeviceRole::Robot) && isLive(DeviceRole::Thermometer) && isLive(DeviceRole::HeatSource);
    }
    void load() {
        const std::uint64_t before = engine->last.loadId;
        engine->send(LoadExperiment{experiment});
        ASSERT_TRUE(sees([&] { return engine->last.loadId > before; })) << describe(engine->refusal);
    }
    /// A person has looked and says where the robot is.
    void beginWell() {
        load();
        ASSERT_TRUE(sees([&] { return areLive(); }));
        engine->send(ClearRobotAlarm{});
        ASSERT_TRUE(sees([&] {
            engine->send(Reset{});
            return engine->last.state == RunState::Ready;
        })) << reasons();
    }
    /// So that the robot is not where it says zero. A busy machine may have kept its answers for so long that
    /// the move was refused.
    void moveAside() {
        Vector6d there = engine->last.latest.coordinates;
        there[kX] += 0.01;
        ASSERT_TRUE(sees([&] {
            if (engine->last.isMoving)
                return false;
            if (grbl.positions().at(0) > 9.9)
                return true;
            if (engine->last.state == RunState::Fault)
                engine->send(Reset{});
            engine->send(MoveTo{there});
            return false;
        })) << reasons()
            << " | " << describe(engine->refusal);
    }
    void waitForSamples(double time_s) {
        const double from_s = engine->last.sampleTime_s;
        ASSERT_TRUE(sees([&] { return engine->last.sampleTime_s > from_s + time_s; }));
    }
    std::string reasons() const {
        std::string out = runStateName(engine->last.state);
        for (const Message& reason : engine->last.reasons)
            out += " | " + describe(reason);
        return out;
    }
    std::array<int, 3> opened() const { return {devices[0].times(), devices[1].times(), devices[2].times()}; }
};

} // namespace bask::test
