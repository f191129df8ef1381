#include "engine/rig/real_rig.h"

#include "engine/devices/video_camera.h"
#include "engine/devices/video_thermal_camera.h"
#include "engine/drivers/byte_link_on_thread.h"
#include "engine/drivers/driver_catalogue.h"
#include "engine/drivers/driver_make.h"
#include "engine/drivers/guarded_heater.h"
#include "engine/drivers/guarded_link.h"
#include "engine/drivers/logged_link.h"
#include "engine/drivers/modbus_tcp_link.h"
#include "engine/drivers/program_link.h"
#include "engine/drivers/rtu_link.h"
#include "engine/drivers/serial_link.h"
#include "engine/drivers/tcp_link.h"
#include "engine/protocols/modbus_frame.h"
#include "engine/protocols/network_address.h"
#include "engine/protocols/program_lines.h"
#include "engine/rig/missing_devices.h"

#include <QCoreApplication>

#include <algorithm>
#include <chrono>
#include <map>
#include <thread>

namespace bask {

bool isSameDevice(const std::optional<ThermalCameraSpec>& a, const std::optional<ThermalCameraSpec>& b) {
    return a && b ? a->device == b->device && a->profile == b->profile : a.has_value() == b.has_value();
}
namespace {

constexpr double kFarewell_s = 0.3;        ///< for the last words: stand still, heat off
constexpr double kLongestFarewell_s = 2.0; ///< for a heat source that is not seen off
constexpr double kHandOver_s = 0.5;        ///< until the heater's guard says that it has taken over

/// What the devices are made from: those are the same for which it is.
struct Plan {
    Plan() = default;
    Plan(RigSpec devices, const Vector6d& start) : rig(std::move(devices)) {
        if (rig.robot)
            for (int k = 0; k < 6; ++k)
                if (std::ranges::find(rig.robot->axes, k, &AxisSpec::coordinate) == rig.robot->axes.end())
                    fixed[k] = start[k];
    }
    explicit Plan(const Experiment& experiment) : Plan(*experiment.rig, experiment.start) {}

    bool hasSameRobot(const Plan& b) const { return rig.robot == b.rig.robot && fixed == b.fixed; }
    bool hasSameThermometer(const Plan& b) const { return rig.thermometer == b.rig.thermometer; }
    bool hasSameSource(const Plan& b) const { return rig.source == b.rig.source; }
    bool hasSameCamera(const Plan& b) const { return rig.camera == b.rig.camera; }
    bool hasSameThermalCamera(const Plan& b) const {
        return isSameDevice(rig.thermalCamera, b.rig.thermalCamera);
    }

    RigSpec rig;
    Vector6d fixed = Vector6d::Zero(); ///< coordinates without an axis
};

DeviceStatus statusOf(ThermalCamera& camera) {
    DeviceStatus status;
    const LeftOutPictures leftOut = camera.leftOut();
    status.discarded = static_cast<int>(leftOut.count);
    if (leftOut.last)
        status.lastDiscarded = leftOut.last->message;
    const auto newest = camera.newest();
    if (newest) {
        status.link = LinkState::Live;
        status.lastReply_s = (*newest)->time_s;
    } else {
        status.problem = newest.error().message;
        status.link = status.problem.code == MessageCode::CameraLost ? LinkState::Lost : LinkState::Opening;
    }
    return status;
}

/// One that looks at its port on a thread of its own; an empty `portId` takes whatever port has that name.
std::unique_ptr<ByteLink> serialLink(const std::string& port, const SerialSettings& settings,
                                     const std::string& portId) {
    return std::make_unique<ByteLinkOnThread>(
        port, [=] { return std::make_unique<SerialLink>(port, settings, PortCheck(portId)); });
}

std::unique_ptr<ByteLink> modbusTcpBytes(const std::string& address) {
    // What is no address is no host either: the link says so.
    const auto [host, port] =
        networkAddress(address, kModbusTcpPort).value_or(NetworkAddress{address, kModbusTcpPort});
    return std::make_unique<TcpLink>(host, port);
}

} // namespace

struct RealRig::Parts {
    struct Entry {
        DeviceRole role;
        DriverLink link;
        std::string port, memoryKey;
        Device* device;
        std::function<std::string()> portId;
    };

    Parts(const Clock& now, std::optional<std::string> log, std::shared_ptr<const ConfirmedPrograms> allowed,
          std::shared_ptr<TrafficLog> kept)
        : clock(now), guardLog(std::move(log)), programs(std::move(allowed)), traffic(std::move(kept)) {}

    /// Of one device.
    class Links final : public DriverLinks {
    public:
        Links(Parts& parts, DeviceRole role, DriverLink kind, const DeviceSpec& spec, std::string portId)
            : m_parts(parts), m_role(role), m_kind(kind), m_spec(spec), m_portId(std::move(portId)) {}

        const Clock& clock() const override { return m_parts.clock; }
        ByteLink& serial() override { return add(line()); }
        ModbusLink& modbus() override {
            auto& link = m_parts.modbusLinks[m_spec.port];
            if (!link && m_kind == DriverLink::Network)
                link = std::make_unique<ModbusTcpLink>(logged(modbusTcpBytes(m_spec.port)), clock());
            if (!link)
                link = std::make_unique<RtuLink>(logged(line()), m_spec.serial, clock());
            return *link;
        }
        ByteLink& tcp(int port) override { return add(std::make_unique<TcpLink>(m_spec.port, port)); }
        ByteLink& program(ProgramRole role) override {
            // A program counts its lines from its start.
            return add(std::make_unique<ProgramLink>(m_spec.port, programRoleWord(role), m_parts.programs,
                                                     m_parts.traffic),
                       LoggedLink::After::Restarted);
        }

    private:
        std::unique_ptr<ByteLink> line() {
            return m_parts.isGuarded(m_spec.port) ? m_parts.guarded(m_spec.serial)
                                                  : serialLink(m_spec.port, m_spec.serial, m_portId);
        }
        std::unique_ptr<ByteLink> logged(std::unique_ptr<ByteLink> link,
                                         LoggedLink::After after = LoggedLink::After::Same) {
            if (!m_parts.traffic)
                return link;
            return std::make_unique<LoggedLink>(std::move(link), m_parts.traffic, clock(), &m_parts.desk,
                                                after);
        }
        ByteLink& add(std::unique_ptr<ByteLink> link, LoggedLink::After after = LoggedLink::After::Same) {
            return *m_parts.byteLinks[m_role].emplace_back(logged(std::move(link), after));
        }

        Parts& m_parts;
        DeviceRole m_role;
        DriverLink m_kind;
        const DeviceSpec& m_spec;
        std::string m_portId;
    };

    KnownDevice known(const std::string& memoryKey) const {
        const auto it = memory.find(memoryKey);
        return it == memory.end() ? KnownDevice() : it->second;
    }
    bool isGuarded(const std::string& port) const { return heaterGuard && heaterGuard->port() == port; }
    std::unique_ptr<ByteLink> guarded(const SerialSettings& settings) {
        const auto direct = [=, this, port = heaterGuard->port()] {
            return serialLink(port, settings, heaterGuard->portId());
        };
        return std::make_unique<GuardedLink>(*heaterGuard, direct, clock);
    }
    /// As the device that plays this role, and as one that is given time to work.
    template <class Spec, class Role, class Make>
    std::function<guard::OffProgram()> add(DeviceRole role, const Spec& spec, std::unique_ptr<Role>& place,
                                           Make make) {
        const KnownDevice before = known(memoryKey(spec));
        Links own(*this, role, driverOf(spec).link, spec, before.portId);
        MadeDevice<Role> made = make(own);
        Entry entry{role, driverOf(spec).link, spec.port, memoryKey(spec), made.device, {}};
        if (!before.signature.empty())
            made.device->expect(before.signature);
        if (const auto links = byteLinks.find(role); links != byteLinks.end())
            entry.portId = [link = links->second.front().get()] { return link->portId(); };
        else if (const auto link = modbusLinks.find(spec.port); link != modbusLinks.end())
            entry.portId = [line = link->second.get()] { return line->portId(); };
        entries.push_back(std::move(entry));
        place = std::move(made.role);
        return std::move(made.offProgram);
    }

    void addRobot(const RobotDeviceSpec& spec, const Vector6d& fixed) {
        add(DeviceRole::Robot, spec, robot, [&](DriverLinks& links) {
            return driverOf(spec).make(links, spec, AxisMap(spec.axes, fixed),
                                       [this](const Vector6d& target) {
                                           const auto state = robot->state();
                                           return guard && state && guard(state->coordinates, target);
                                       });
        });
    }
    void addThermometer(const ThermometerDeviceSpec& spec) {
        add(DeviceRole::Thermometer, spec, thermometer,
            [&](DriverLinks& links) { return driverOf(spec).make(links, spec); });
    }
    void addSource(const HeatSourceDeviceSpec& spec) {
        auto off = add(DeviceRole::HeatSource, spec, source,
                       [&](DriverLinks& links) { return driverOf(spec).make(links, spec); });
        if (!heaterGuard)
            return;
        if (!off)
            throw std::invalid_argument("a heater's driver does not tell how it is switched off: " +
                                        spec.driver);
        auto made = std::make_unique<GuardedHeater>(std::move(source), *heaterGuard, guardProgram(),
                                                    std::move(off), clock);
        guardedHeater = made.get();
        source = std::move(made);
    }
    void drop(DeviceRole role) {
        std::erase_if(entries, [role](const Entry& entry) { return entry.role == role; });
        if (role == DeviceRole::Robot)
            robot.reset();
        if (role == DeviceRole::Thermometer)
            thermometer.reset();
        if (role == DeviceRole::HeatSource) {
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
        if (!plan.hasSameThermalCamera(next))
            thermalCamera.reset();
        plan = next;
        std::erase_if(modbusLinks, [this](const auto& link) {
            return std::ranges::find(entries, link.first, &Entry::port) == entries.end();
        });
        const RigSpec& rig = plan.rig;
        if (isSourceOther)
            heaterGuard.reset();
        if (isSourceOther && guardLog && rig.source && driverOf(*rig.source).link == DriverLink::Serial)
            heaterGuard.emplace(rig.source->port, rig.source->serial, *guardLog, clock,
                                known(memoryKey(*rig.source)).portId);
        if (rig.robot && !robot)
            addRobot(*rig.robot, plan.fixed);
        if (rig.thermometer && !thermometer)
            addThermometer(*rig.thermometer);
        if (rig.source && !source)
            addSource(*rig.source);
        if (!rig.camera.empty() && !camera)
            camera = std::make_unique<VideoCamera>(rig.camera, clock);
        if (rig.thermalCamera && !thermalCamera)
            thermalCamera = std::make_unique<VideoThermalCamera>(rig.thermalCamera->device,
                                                                 rig.thermalCamera->profile, clock);
        std::ranges::sort(entries, {}, &Entry::role);
    }

    Plan plan;
    DeviceMemory memory;
    const Clock& clock;
    const std::optional<std::string> guardLog; ///< empty: heaters have no guard
    const std::shared_ptr<const ConfirmedPrograms> programs;
    const std::shared_ptr<TrafficLog> traffic; ///< null: nobody keeps it
    LinkDesk desk;                             ///< longer than the links
    StepGuard guard;
    std::optional<HeaterGuard> heaterGuard;                                 ///< longer than the links
    std::map<DeviceRole, std::vector<std::unique_ptr<ByteLink>>> byteLinks; ///< longer than the drivers
    std::map<std::string, std::unique_ptr<ModbusLink>> modbusLinks;
    std::unique_ptr<Robot> robot;
    std::unique_ptr<Thermometer> thermometer;
    std::unique_ptr<HeatSource> source;
    GuardedHeater* guardedHeater = nullptr; ///< source, where it is one
    bool isSourceDoubted = false;
    std::unique_ptr<VideoCamera> camera;
    std::unique_ptr<VideoThermalCamera> thermalCamera;
    std::vector<Entry> entries;
    MissingRobot noRobot;
    MissingThermometer noThermometer{"thermometer"};
    MissingHeatSource noSource;
};

RealRig::RealRig(const Experiment& experiment, const Clock& clock, const std::string& guardLog,
                 const DeviceMemory& memory, std::shared_ptr<const ConfirmedPrograms> programs,
                 std::shared_ptr<TrafficLog> traffic)
    : m_parts(std::make_unique<Parts>(clock, guardLog, std::move(programs), std::move(traffic))) {
    change(experiment, memory);
}

RealRig::RealRig(const RigSpec& rig, const Clock& clock, const DeviceMemory& memory,
                 std::shared_ptr<const ConfirmedPrograms> programs, std::shared_ptr<TrafficLog> traffic)
    : m_parts(std::make_unique<Parts>(clock, std::nullopt, std::move(programs), std::move(traffic))) {
    m_parts->memory = memory;
    m_parts->change({rig, Vector6d::Zero()});
}

RealRig::~RealRig() = default;

bool RealRig::isFor(const Experiment& experiment) const {
    const Plan& plan = m_parts->plan;
    const Plan other(experiment);
    return plan.hasSameRobot(other) && plan.hasSameThermometer(other) && plan.hasSameSource(other) &&
           plan.hasSameCamera(other) && plan.hasSameThermalCamera(other);
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
    const auto isOff = [&] {
        return heatSource().isManual() || (!heatSource().heating() && !m_parts->isSourceDoubted);
    };
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

Result<void> RealRig::sendByHand(const std::string& link, const std::string& bytes) {
    auto sent = m_parts->desk.send(link, bytes);
    if (sent && m_parts->source && !m_parts->source->isManual()) {
        m_parts->isSourceDoubted = true;
        if (m_parts->guardedHeater != nullptr)
            m_parts->guardedHeater->doubt();
    }
    return sent;
}

bool RealRig::isSourceDoubted() const {
    return m_parts->isSourceDoubted;
}

void RealRig::endByHand() {
    m_parts->desk.end();
}

void RealRig::work() {
    m_parts->desk.work();
    if (m_parts->heaterGuard)
        m_parts->heaterGuard->work();
    for (const Parts::Entry& entry : m_parts->entries)
        entry.device->work();
    m_parts->isSourceDoubted = m_parts->isSourceDoubted && heatSource().heatState() != HeatState::Off;
    if (m_parts->guardedHeater != nullptr)
        m_parts->guardedHeater->work();
}

Robot& RealRig::robot() {
    return m_parts->robot ? *m_parts->robot : m_parts->noRobot;
}

Thermometer& RealRig::thermometer() {
    return m_parts->thermometer ? *m_parts->thermometer : m_parts->noThermometer;
}

HeatSource& RealRig::heatSource() {
    return m_parts->source ? *m_parts->source : m_parts->noSource;
}

Camera* RealRig::camera() {
    return m_parts->camera.get();
}

ThermalCamera* RealRig::thermalCamera() {
    return m_parts->thermalCamera.get();
}

std::unique_ptr<ThermalCamera> RealRig::takeThermalCamera() {
    return std::move(m_parts->thermalCamera);
}

std::unique_ptr<Camera> RealRig::takeCamera() {
    return std::move(m_parts->camera);
}

bool RealRig::mayEndElsewhere() const {
    const auto isOnNetwork = [](const Parts::Entry& entry) { return entry.link == DriverLink::Network; };
    return std::ranges::none_of(m_parts->entries, isOnNetwork) && !m_parts->heaterGuard;
}

void RealRig::setGuard(StepGuard guard) {
    m_parts->guard = std::move(guard);
}

void RealRig::setPeriod(double period_s) {
    thermometer().setPeriod(period_s);
}

void RealRig::limitSpeed(const RobotLimits& limits) {
    robot().limitSpeed(limits.maxSpeed_m_s, limits.maxRotation_rad_s);
}

Result<void> RealRig::typeSourceTemperature(double temperature_K) {
    return heatSource().setTemperature(temperature_K);
}

std::vector<RigDeviceState> RealRig::devices() const {
    std::vector<RigDeviceState> out;
    const auto add = [&](DeviceRole role, const std::string& port, DeviceStatus status) {
        const double age_s = m_parts->clock.now_s() - status.lastReply_s;
        out.push_back({role, port, std::move(status), age_s});
    };
    for (const Parts::Entry& entry : m_parts->entries)
        add(entry.role, entry.port, entry.device->status());
    if (m_parts->thermalCamera)
        add(DeviceRole::ThermalCamera, m_parts->plan.rig.thermalCamera->device,
            statusOf(*m_parts->thermalCamera));
    return out;
}

} // namespace bask
