#include "engine/runtime/real_rig.h"

#include "engine/devices/video_camera.h"
#include "engine/drivers/byte_link_on_thread.h"
#include "engine/drivers/dobot_robot.h"
#include "engine/drivers/grbl_robot.h"
#include "engine/drivers/guarded_heater.h"
#include "engine/drivers/guarded_link.h"
#include "engine/drivers/hand_heater.h"
#include "engine/drivers/modbus_heater.h"
#include "engine/drivers/modbus_link_on_thread.h"
#include "engine/drivers/modbus_thermometer.h"
#include "engine/drivers/namur_heater.h"
#include "engine/drivers/qt_modbus_link.h"
#include "engine/drivers/rtu_link.h"
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
constexpr double kHandOver_s = 0.5;        ///< until the heater's guard says that it has taken over
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

/// What the devices are made from: those are the same for which it is.
struct Plan {
    Plan() = default;
    Plan(RigSpec devices, const Vector6d& start, double period_s) : rig(std::move(devices)) {
        if (rig.robot)
            for (int k = 0; k < 6; ++k)
                if (std::ranges::find(rig.robot->axes, k, &AxisSpec::coordinate) == rig.robot->axes.end())
                    fixed[k] = start[k];
        if (rig.thermometer && rig.thermometer->driver == ThermometerDriver::Modbus)
            poll_s = std::max(kFastestPoll_s, period_s);
    }
    explicit Plan(const Experiment& experiment)
        : Plan(*experiment.rig, experiment.start, experiment.sampling.period_s) {}

    bool hasSameRobot(const Plan& b) const { return rig.robot == b.rig.robot && fixed == b.fixed; }
    bool hasSameThermometer(const Plan& b) const {
        return rig.thermometer == b.rig.thermometer && poll_s == b.poll_s;
    }
    bool hasSameSource(const Plan& b) const { return rig.source == b.rig.source; }
    bool hasSameCamera(const Plan& b) const { return rig.camera == b.rig.camera; }

    RigSpec rig;
    Vector6d fixed = Vector6d::Zero(); ///< coordinates without an axis
    double poll_s = 0.0;               ///< of a Modbus thermometer
};

} // namespace

struct RealRig::Parts {
    struct Entry {
        DeviceRole role;
        std::string port, memoryKey;
        Device* device;
        std::function<std::string()> portId;
    };

    Parts(const Clock& now, std::optional<std::string> log) : clock(now), guardLog(std::move(log)) {}

    KnownDevice known(const std::string& memoryKey) const {
        const auto it = memory.find(memoryKey);
        return it == memory.end() ? KnownDevice() : it->second;
    }
    bool isGuarded(const std::string& port) const { return heaterGuard && heaterGuard->port() == port; }
    std::unique_ptr<ByteLink> guarded(const SerialSettings& settings) {
        const std::string port = heaterGuard->port();
        const auto direct = [=, this] {
            return std::make_unique<ByteLinkOnThread>(port, [=, portId = heaterGuard->portId()] {
                return std::make_unique<SerialLink>(port, settings, PortCheck(portId));
            });
        };
        return std::make_unique<GuardedLink>(*heaterGuard, direct, clock);
    }
    template <class Spec> ModbusLink& modbus(const Spec& spec) {
        auto& link = modbusLinks[spec.port];
        if (!link && isGuarded(spec.port))
            link = std::make_unique<RtuLink>(guarded(spec.serial), spec.serial, clock);
        if (!link)
            link = std::make_unique<ModbusLinkOnThread>(
                spec.port,
                [this, port = spec.port, settings = spec.serial, portId = known(memoryKey(spec)).portId] {
                    return std::make_unique<QtModbusLink>(port, settings, clock, QtModbusLink::kReply_s,
                                                          PortCheck(portId));
                });
        return *link;
    }
    template <class Spec> ByteLink& serial(DeviceRole role, const Spec& spec) {
        if (isGuarded(spec.port))
            return *byteLinks[role].emplace_back(guarded(spec.serial));
        return *byteLinks[role].emplace_back(std::make_unique<ByteLinkOnThread>(
            spec.port, [port = spec.port, settings = spec.serial, portId = known(memoryKey(spec)).portId] {
                return std::make_unique<SerialLink>(port, settings, PortCheck(portId));
            }));
    }
    ByteLink& tcp(const std::string& host, int port) {
        return *byteLinks[DeviceRole::Robot].emplace_back(std::make_unique<TcpLink>(host, port));
    }
    /// As the device that plays this role, and as one that is given time to work.
    template <class Spec, class Driver, class Role>
    void put(DeviceRole role, const Spec& spec, std::unique_ptr<Driver> driver,
             std::unique_ptr<Role>& place) {
        Entry entry{role, spec.port, memoryKey(spec), driver.get(), {}};
        if (const std::string signature = known(entry.memoryKey).signature; !signature.empty())
            driver->expect(signature);
        if (const auto links = byteLinks.find(role); links != byteLinks.end())
            entry.portId = [link = links->second.front().get()] { return link->portId(); };
        else if (const auto link = modbusLinks.find(spec.port); link != modbusLinks.end())
            entry.portId = [line = link->second.get()] { return line->portId(); };
        entries.push_back(std::move(entry));
        place = std::move(driver);
    }
    template <class Spec, class Driver, class Role>
    void put(DeviceRole role, const Spec& spec, Result<std::unique_ptr<Driver>> made,
             std::unique_ptr<Role>& place) {
        if (!made) // what checkRig lets pass can be made
            throw std::invalid_argument(describe(made.error()));
        put(role, spec, std::move(*made), place);
    }

    void addRobot(const RobotDeviceSpec& spec, const Vector6d& fixed) {
        auto robotGuard = [this](const Vector6d& target) {
            const auto state = robot->state();
            return guard && state && guard(state->coordinates, target);
        };
        if (spec.driver == RobotDriver::Dobot) {
            auto made = std::make_unique<DobotRobot>(
                tcp(spec.port, kDobotDashboard), tcp(spec.port, kDobotMotion), tcp(spec.port, kDobotFeedback),
                clock, AxisMap(spec.axes, fixed), robotGuard);
            arm = made.get();
            return put(DeviceRole::Robot, spec, std::move(made), robot);
        }
        put(DeviceRole::Robot, spec,
            std::make_unique<GrblRobot>(serial(DeviceRole::Robot, spec), clock, AxisMap(spec.axes, fixed),
                                        robotGuard, spec.mustHome),
            robot);
    }
    void addThermometer(const ThermometerDeviceSpec& spec, double poll_s) {
        if (spec.driver == ThermometerDriver::Modbus) {
            std::vector<int> all(static_cast<std::size_t>(spec.profile.channels));
            std::iota(all.begin(), all.end(), 0);
            put(DeviceRole::Thermometer, spec,
                ModbusThermometer::create(
                    modbus(spec), clock,
                    {spec.unit, spec.profile, spec.channels.empty() ? all : spec.channels, poll_s}),
                thermometer);
            return;
        }
        const int channels =
            spec.channels.empty() ? kStreamChannels : 1 + *std::ranges::max_element(spec.channels);
        put(DeviceRole::Thermometer, spec,
            std::make_unique<StreamThermometer>(serial(DeviceRole::Thermometer, spec), clock, channels),
            thermometer);
        if (!spec.channels.empty())
            picked = std::make_unique<PickedChannels>(*thermometer, spec.channels);
    }
    void addSource(const HeatSourceDeviceSpec& spec) {
        switch (spec.driver) {
        case HeatSourceDriver::ByHand: {
            auto made = std::make_unique<HandHeater>(clock);
            byHand = made.get();
            return put(DeviceRole::HeatSource, spec, std::move(made), source);
        }
        case HeatSourceDriver::Namur:
            put(DeviceRole::HeatSource, spec,
                std::make_unique<NamurHeater>(
                    serial(DeviceRole::HeatSource, spec), clock,
                    NamurHeaterConfig{spec.isProbeUsed, spec.watchdog_s, spec.mayHeatUnattended}),
                source);
            return guardSource(&NamurHeater::offProgram);
        case HeatSourceDriver::Modbus:
            ModbusHeaterSettings settings{spec.unit, spec.profile};
            settings.watchdog_s = spec.watchdog_s;
            auto made = ModbusHeater::create(modbus(spec), clock, settings);
            const ModbusHeater* heater = made ? made->get() : nullptr;
            put(DeviceRole::HeatSource, spec, std::move(made), source);
            return guardSource([heater, line = spec.serial] { return heater->offProgram(line); });
        }
    }
    void guardSource(std::function<guard::OffProgram()> off) {
        if (!heaterGuard)
            return;
        auto made = std::make_unique<GuardedHeater>(std::move(source), *heaterGuard, guardProgram(),
                                                    std::move(off), clock);
        guardedHeater = made.get();
        source = std::move(made);
    }
    void drop(DeviceRole role) {
        std::erase_if(entries, [role](const Entry& entry) { return entry.role == role; });
        if (role == DeviceRole::Robot) {
            arm = nullptr;
            robot.reset();
        }
        if (role == DeviceRole::Thermometer) {
            picked.reset();
            thermometer.reset();
        }
        if (role == DeviceRole::HeatSource) {
            byHand = nullptr;
            guardedHeater = nullptr;
            source.reset();
        }
        byteLinks.erase(role);
    }
    /// What is not the same is closed first: its ports may be those of the new ones.
    void change(const Plan& next) {
        if (!plan.hasSameRobot(next))
            drop(DeviceRole::Robot);
        const bool isSourceOther = !plan.hasSameSource(next);
        if (!plan.hasSameThermometer(next) ||
            (isSourceOther && (hasOneLine(plan.rig) || hasOneLine(next.rig))))
            drop(DeviceRole::Thermometer);
        if (isSourceOther)
            drop(DeviceRole::HeatSource);
        if (!plan.hasSameCamera(next))
            camera.reset();
        plan = next;
        std::erase_if(modbusLinks, [this](const auto& link) {
            return std::ranges::find(entries, link.first, &Entry::port) == entries.end();
        });
        const RigSpec& rig = plan.rig;
        if (isSourceOther)
            heaterGuard.reset();
        if (isSourceOther && guardLog && rig.source && rig.source->driver != HeatSourceDriver::ByHand)
            heaterGuard.emplace(rig.source->port, rig.source->serial, *guardLog, clock,
                                known(memoryKey(*rig.source)).portId);
        if (rig.robot && !robot)
            addRobot(*rig.robot, plan.fixed);
        if (rig.thermometer && !thermometer)
            addThermometer(*rig.thermometer, plan.poll_s);
        if (rig.source && !source)
            addSource(*rig.source);
        if (!rig.camera.empty() && !camera)
            camera = std::make_unique<VideoCamera>(rig.camera, clock);
        std::ranges::sort(entries, {}, &Entry::role);
    }

    Plan plan;
    DeviceMemory memory;
    const Clock& clock;
    const std::optional<std::string> guardLog; ///< empty: heaters have no guard
    StepGuard guard;
    std::optional<HeaterGuard> heaterGuard;                                 ///< longer than the links
    std::map<DeviceRole, std::vector<std::unique_ptr<ByteLink>>> byteLinks; ///< longer than the drivers
    std::map<std::string, std::unique_ptr<ModbusLink>> modbusLinks;
    std::unique_ptr<Robot> robot;
    std::unique_ptr<Thermometer> thermometer;
    std::unique_ptr<PickedChannels> picked;
    std::unique_ptr<HeatSource> source;
    DobotRobot* arm = nullptr;              ///< robot, where it is one
    HandHeater* byHand = nullptr;           ///< source, where it is one
    GuardedHeater* guardedHeater = nullptr; ///< the same
    std::unique_ptr<VideoCamera> camera;
    std::vector<Entry> entries;
    MissingRobot noRobot;
    MissingThermometer noThermometer;
    MissingHeatSource noSource;
};

RealRig::RealRig(const Experiment& experiment, const Clock& clock, const std::string& guardLog,
                 const DeviceMemory& memory)
    : m_parts(std::make_unique<Parts>(clock, guardLog)) {
    change(experiment, memory);
}

RealRig::RealRig(const RigSpec& rig, const Clock& clock, const DeviceMemory& memory)
    : m_parts(std::make_unique<Parts>(clock, std::nullopt)) {
    m_parts->memory = memory;
    m_parts->change({rig, Vector6d::Zero(), kFastestPoll_s});
}

RealRig::~RealRig() = default;

bool RealRig::isFor(const Experiment& experiment) const {
    const Plan& plan = m_parts->plan;
    const Plan other(experiment);
    return plan.hasSameRobot(other) && plan.hasSameThermometer(other) && plan.hasSameSource(other) &&
           plan.hasSameCamera(other);
}

void RealRig::change(const Experiment& experiment, const DeviceMemory& memory) {
    m_parts->memory = memory;
    m_parts->change(Plan(experiment));
}

void RealRig::forget(DeviceRole role, DeviceMemory& memory) {
    for (const Parts::Entry& entry : m_parts->entries)
        if (entry.role == role)
            memory.erase(entry.memoryKey);
    RigSpec& made = m_parts->plan.rig;
    if (role == DeviceRole::Robot)
        made.robot.reset();
    else if (role == DeviceRole::Thermometer)
        made.thermometer.reset();
    else if (role == DeviceRole::HeatSource)
        made.source.reset();
}

DeviceMemory RealRig::met() const {
    DeviceMemory out;
    for (const Parts::Entry& entry : m_parts->entries) {
        const DeviceStatus status = entry.device->status();
        if (entry.portId && status.link == LinkState::Live && status.signature)
            out[entry.memoryKey] = {entry.portId(), *status.signature};
    }
    return out;
}

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
    if (!isOff() && m_parts->heaterGuard)
        m_parts->heaterGuard->handOver(kHandOver_s); // it goes on until the device says so
    return isOff();
}

void RealRig::work() {
    if (m_parts->heaterGuard)
        m_parts->heaterGuard->work();
    for (const Parts::Entry& entry : m_parts->entries)
        entry.device->work();
    if (m_parts->guardedHeater != nullptr)
        m_parts->guardedHeater->work();
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

std::unique_ptr<Camera> RealRig::takeCamera() {
    return std::move(m_parts->camera);
}

bool RealRig::mayEndElsewhere() const {
    return m_parts->arm == nullptr && !m_parts->heaterGuard;
}

void RealRig::setGuard(StepGuard guard) {
    m_parts->guard = std::move(guard);
}

void RealRig::limitSpeed(const RobotLimits& limits) {
    if (m_parts->arm != nullptr)
        m_parts->arm->limitSpeed(limits.maxSpeed_m_s, limits.maxRotation_rad_s);
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
