#include "engine/runtime/real_rig.h"

#include "engine/devices/video_camera.h"
#include "engine/drivers/byte_link_on_thread.h"
#include "engine/drivers/dobot_robot.h"
#include "engine/drivers/grbl_robot.h"
#include "engine/drivers/hand_heater.h"
#include "engine/drivers/modbus_heater.h"
#include "engine/drivers/modbus_link_on_thread.h"
#include "engine/drivers/modbus_thermometer.h"
#include "engine/drivers/namur_heater.h"
#include "engine/drivers/qt_modbus_link.h"
#include "engine/drivers/serial_link.h"
#include "engine/drivers/stream_thermometer.h"
#include "engine/drivers/tcp_link.h"
#include "engine/runtime/missing_devices.h"

#include <QCoreApplication>

#include <algorithm>
#include <chrono>
#include <map>
#include <numeric>
#include <thread>

namespace bask {
namespace {

constexpr double kFastestPoll_s = 0.1;
constexpr double kFarewell_s = 0.3;        ///< for the last words: stand still, heat off
constexpr double kLongestFarewell_s = 2.0; ///< for a heat source that is not seen off
constexpr int kDobotDashboard = 29999, kDobotMotion = 30003, kDobotFeedback = 30004;
constexpr int kStreamChannels = 16; ///< tried, before it is known how many there are

/// A device's channels in the objects' order.
class PickedChannels final : public Thermometer {
public:
    PickedChannels(Thermometer& all, std::vector<int> picked) : m_all(all), m_picked(std::move(picked)) {}

    int channels() const override { return static_cast<int>(m_picked.size()); }
    Result<std::vector<Reading>> read() override {
        const auto all = m_all.read();
        if (!all)
            return all.error();
        std::vector<Reading> out;
        for (const int channel : m_picked)
            out.push_back(all->at(static_cast<std::size_t>(channel)));
        return out;
    }

private:
    Thermometer& m_all;
    std::vector<int> m_picked;
};

} // namespace

struct RealRig::Parts {
    struct Entry {
        DeviceRole role;
        std::string port;
        Device* device;
    };

    explicit Parts(const Clock& now) : clock(now) {}

    ModbusLink& modbus(const std::string& port, const SerialSettings& settings) {
        auto& link = modbusLinks[port];
        if (!link)
            link = std::make_unique<ModbusLinkOnThread>(
                port, [=, this] { return std::make_unique<QtModbusLink>(port, settings, clock); });
        return *link;
    }
    ByteLink& serial(const std::string& port, const SerialSettings& settings) {
        return *byteLinks.emplace_back(std::make_unique<ByteLinkOnThread>(
            port, [=] { return std::make_unique<SerialLink>(port, settings); }));
    }
    ByteLink& tcp(const std::string& host, int port) {
        return *byteLinks.emplace_back(std::make_unique<TcpLink>(host, port));
    }
    /// As the device that plays this role, and as one that is given time to work.
    template <class Driver, class Role>
    void put(DeviceRole role, const std::string& port, std::unique_ptr<Driver> driver,
             std::unique_ptr<Role>& place) {
        entries.push_back({role, port, driver.get()});
        place = std::move(driver);
    }
    template <class Driver, class Role>
    void put(DeviceRole role, const std::string& port, Result<std::unique_ptr<Driver>> made,
             std::unique_ptr<Role>& place) {
        if (!made) // what checkRig lets pass can be made
            throw std::invalid_argument(describe(made.error()));
        put(role, port, std::move(*made), place);
    }

    void addRobot(const RobotDeviceSpec& spec, const Vector6d& fixed) {
        auto robotGuard = [this](const Vector6d& target) {
            const auto state = robot->state();
            return guard && state && guard(state->coordinates, target);
        };
        if (spec.driver == RobotDriver::Dobot) {
            put(DeviceRole::Robot, spec.port,
                std::make_unique<DobotRobot>(tcp(spec.port, kDobotDashboard), tcp(spec.port, kDobotMotion),
                                             tcp(spec.port, kDobotFeedback), clock, AxisMap(spec.axes, fixed),
                                             robotGuard),
                robot);
            return;
        }
        put(DeviceRole::Robot, spec.port,
            std::make_unique<GrblRobot>(serial(spec.port, spec.serial), clock, AxisMap(spec.axes, fixed),
                                        robotGuard, spec.mustHome),
            robot);
    }
    void addThermometer(const ThermometerDeviceSpec& spec, double period_s) {
        if (spec.driver == ThermometerDriver::Modbus) {
            std::vector<int> all(static_cast<std::size_t>(spec.profile.channels));
            std::iota(all.begin(), all.end(), 0);
            put(DeviceRole::Thermometer, spec.port,
                ModbusThermometer::create(modbus(spec.port, spec.serial), clock,
                                          {spec.unit, spec.profile,
                                           spec.channels.empty() ? all : spec.channels,
                                           std::max(kFastestPoll_s, period_s)}),
                thermometer);
            return;
        }
        const int channels =
            spec.channels.empty() ? kStreamChannels : 1 + *std::ranges::max_element(spec.channels);
        put(DeviceRole::Thermometer, spec.port,
            std::make_unique<StreamThermometer>(serial(spec.port, spec.serial), clock, channels),
            thermometer);
        if (!spec.channels.empty())
            picked = std::make_unique<PickedChannels>(*thermometer, spec.channels);
    }
    void addSource(const HeatSourceDeviceSpec& spec) {
        switch (spec.driver) {
        case HeatSourceDriver::ByHand: {
            auto made = std::make_unique<HandHeater>(clock);
            byHand = made.get();
            return put(DeviceRole::HeatSource, {}, std::move(made), source);
        }
        case HeatSourceDriver::Namur:
            return put(DeviceRole::HeatSource, spec.port,
                       std::make_unique<NamurHeater>(
                           serial(spec.port, spec.serial), clock,
                           NamurHeaterConfig{spec.isProbeUsed, spec.watchdog_s, spec.mayHeatUnattended}),
                       source);
        case HeatSourceDriver::Modbus:
            ModbusHeaterSettings settings{spec.unit, spec.profile};
            settings.watchdog_s = spec.watchdog_s;
            return put(DeviceRole::HeatSource, spec.port,
                       ModbusHeater::create(modbus(spec.port, spec.serial), clock, settings), source);
        }
    }
    void add(const RigSpec& rig, const Vector6d& fixed, double period_s) {
        if (rig.robot)
            addRobot(*rig.robot, fixed);
        if (rig.thermometer)
            addThermometer(*rig.thermometer, period_s);
        if (rig.source)
            addSource(*rig.source);
        if (!rig.camera.empty())
            camera = std::make_unique<VideoCamera>(rig.camera, clock);
    }

    const Clock& clock;
    StepGuard guard;
    std::vector<std::unique_ptr<ByteLink>> byteLinks; ///< longer than the drivers
    std::map<std::string, std::unique_ptr<ModbusLink>> modbusLinks;
    std::unique_ptr<Robot> robot;
    std::unique_ptr<Thermometer> thermometer;
    std::unique_ptr<PickedChannels> picked;
    std::unique_ptr<HeatSource> source;
    HandHeater* byHand = nullptr; ///< source, where it is one
    std::unique_ptr<VideoCamera> camera;
    std::vector<Entry> entries;
    MissingRobot noRobot;
    MissingThermometer noThermometer;
    MissingHeatSource noSource;
};

RealRig::RealRig(const Experiment& experiment, const Clock& clock) : m_parts(std::make_unique<Parts>(clock)) {
    m_parts->add(*experiment.rig, experiment.start, experiment.sampling.period_s);
}

RealRig::RealRig(const RigSpec& rig, const Clock& clock) : m_parts(std::make_unique<Parts>(clock)) {
    m_parts->add(rig, Vector6d::Zero(), kFastestPoll_s);
}

RealRig::~RealRig() = default;

bool RealRig::sayLastWords() {
    const SteadyClock wall;
    const double begun_s = wall.now_s();
    const auto isOff = [&] { return m_parts->byHand != nullptr || !heatSource().heating(); };
    const auto spent_s = [&] { return wall.now_s() - begun_s; };
    while (!m_parts->entries.empty() && spent_s() < (isOff() ? kFarewell_s : kLongestFarewell_s)) {
        work();
        QCoreApplication::processEvents(QEventLoop::ExcludeUserInputEvents);
        std::this_thread::sleep_for(std::chrono::milliseconds(2));
    }
    return isOff();
}

void RealRig::work() {
    for (const Parts::Entry& entry : m_parts->entries)
        entry.device->work();
}

Robot& RealRig::robot() {
    return m_parts->robot ? *m_parts->robot : m_parts->noRobot;
}

Thermometer& RealRig::thermometer() {
    if (m_parts->picked)
        return *m_parts->picked;
    return m_parts->thermometer ? *m_parts->thermometer : m_parts->noThermometer;
}

HeatSource& RealRig::heatSource() {
    return m_parts->source ? *m_parts->source : m_parts->noSource;
}

Camera* RealRig::camera() {
    return m_parts->camera.get();
}

void RealRig::setGuard(StepGuard guard) {
    m_parts->guard = std::move(guard);
}

Result<void> RealRig::typeSourceTemperature(double temperature_K) {
    if (m_parts->byHand == nullptr)
        return Error(MessageCode::RigIncomplete, {}, {"heat source kept by hand"});
    return m_parts->byHand->setTemperature(temperature_K);
}

std::vector<RigDeviceState> RealRig::devices() const {
    std::vector<RigDeviceState> out;
    for (const Parts::Entry& entry : m_parts->entries) {
        RigDeviceState state{entry.role, entry.port, entry.device->status()};
        state.age_s = m_parts->clock.now_s() - state.status.lastReply_s;
        out.push_back(std::move(state));
    }
    return out;
}

} // namespace bask
