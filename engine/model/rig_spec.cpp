#include "engine/model/rig_spec.h"

#include "engine/base/message_code.h"
#include "engine/base/plain_text.h"
#include "engine/base/pose.h"
#include "engine/drivers/driver_catalogue.h"
#include "engine/model/checker.h"
#include "engine/protocols/modbus_frame.h"
#include "engine/protocols/network_address.h"
#include "engine/protocols/register_values.h"

#include <algorithm>
#include <stdexcept>

namespace bask {
namespace {

constexpr std::size_t kMaxText = 1000;

Result<void> checkRange(const std::string& where, double value, double min, double max,
                        const char* unit = "") {
    Checker check;
    check.range(where, value, min, max, unit);
    return check.result();
}

Result<void> checkPort(const std::string& where, const std::string& port, const char* key = "port") {
    if (port.empty())
        return Error(MessageCode::JsonMissingKey, where, {key});
    const auto isControl = [](char c) { return static_cast<unsigned char>(c) < 0x20; };
    if (port.size() > kMaxText || std::ranges::any_of(port, isControl))
        return Error(MessageCode::ValueUnknown, where, {port.substr(0, 20), "a path or a host's name"});
    return {};
}

Result<void> checkDriver(DeviceRole role, const std::string& where, const std::string& key) {
    std::string known;
    for (const DriverFacts* driver : driversOf(role)) {
        if (driver->key == key)
            return {};
        known += (known.empty() ? "" : ", ") + std::string(driver->key);
    }
    return Error(MessageCode::ValueUnknown, where, {plainWords(key), known});
}

/// What every device has, and its driver's parameters; `path` ends with a dot.
template <class Spec> Result<void> checkDevice(DeviceRole role, const std::string& path, const Spec& spec) {
    if (const auto fit = checkDriver(role, path + "driver", spec.driver); !fit)
        return fit;
    const auto& driver = driverOf(spec);
    if (driver.link == DriverLink::None)
        return {};
    const char* const key = portKey(driver);
    if (const auto fit = checkPort(path + key, spec.port, key); !fit)
        return fit;
    if (driver.isModbus && driver.link == DriverLink::Network && !networkAddress(spec.port, kModbusTcpPort))
        return Error(
            MessageCode::ValueUnknown, path + key,
            {plainWords(spec.port), "an address such as 192.168.1.20, logger:1502 or [fe80::1]:502"});
    Checker check;
    check.parameters(path + "serial.", serialParameters(), spec.serial);
    std::size_t own = 0;
    for (const auto& parameter : driver.parameters) {
        own += spec.own.count(keyOf(*parameter.facts));
        if (parameter.applies(spec))
            check.parameter(path, *parameter.facts, parameter.get(spec));
    }
    if (own != spec.own.size())
        throw std::invalid_argument("a device with values that its driver does not know: " + spec.driver);
    return check.result();
}

Result<void> checkRobot(const RobotDeviceSpec& robot, const std::array<bool, 6>& freeCoordinates) {
    if (const auto fit = checkDevice(DeviceRole::Robot, "robot.", robot); !fit)
        return fit;
    if (auto fit = checkAxes(robot.axes); !fit) {
        Error error = fit.error();
        error.where = "robot." + error.where;
        return error;
    }
    for (std::size_t i = 0; i < robot.axes.size(); ++i) {
        const double max = maxAxisOrigin(robot.axes[i].coordinate);
        if (const auto fit = checkRange("robot.axes[" + std::to_string(i) + "].origin", robot.axes[i].origin,
                                        -max, max, robot.axes[i].coordinate < 3 ? "m" : "rad");
            !fit)
            return fit;
    }
    for (std::size_t k = 0; k < freeCoordinates.size(); ++k)
        if (freeCoordinates[k] &&
            std::ranges::find(robot.axes, static_cast<int>(k), &AxisSpec::coordinate) == robot.axes.end())
            return Error(MessageCode::AxisMissing, "robot.axes", {kCoordinateNames[k]});
    return {};
}

Result<void> checkThermometer(const ThermometerDeviceSpec& thermometer, std::size_t sensors) {
    if (const auto fit = checkDevice(DeviceRole::Thermometer, "thermometer.", thermometer); !fit)
        return fit;
    const std::vector<int>& channels = thermometer.channels;
    if (channels.size() != sensors)
        return Error(MessageCode::ChannelCountWrong, "thermometer.channels",
                     {std::to_string(channels.size()), std::to_string(sensors)});
    const ThermometerDriver& driver = driverOf(thermometer);
    const int last = (driver.isModbus ? thermometer.profile.channels : driver.maxChannels) - 1;
    for (std::size_t i = 0; i < channels.size(); ++i) {
        const std::string where = "thermometer.channels[" + std::to_string(i) + "]";
        if (const auto fit = checkRange(where, channels[i], 0.0, last); !fit)
            return fit;
        if (std::ranges::count(channels, channels[i]) > 1)
            return Error(MessageCode::ChannelTwice, where, {std::to_string(channels[i])});
    }
    if (driver.isModbus && !thermometer.profile.channel)
        return Error(MessageCode::ProfileOther, "thermometer.profile", {thermometer.profile.name});
    return {};
}

Result<void> checkSource(const HeatSourceDeviceSpec& source) {
    if (const auto fit = checkDevice(DeviceRole::HeatSource, "source.", source); !fit)
        return fit;
    if (!driverOf(source).isModbus)
        return {};
    const ModbusProfile& profile = source.profile;
    if (!profile.processValue || !profile.setPoint)
        return Error(MessageCode::ProfileOther, "source.profile", {profile.name});
    if (!profile.watchdog && !source.mayHeatUnattended)
        return Error(MessageCode::SourceUnwatched, "source.profile", {profile.name});
    if (profile.watchdog)
        if (const auto fit = watchdogRegisters(profile, source.watchdog_s); !fit)
            return Error(fit.error().code(), "source.watchdog_s", fit.error().message.args);
    return {};
}

/// Empty for a program: each role has one of its own, even if their commands are the same.
template <class Spec> std::string portOf(const std::optional<Spec>& spec) {
    if (!spec || driverOf(*spec).link == DriverLink::Program)
        return {};
    const bool isAddress = driverOf(*spec).isModbus && driverOf(*spec).link == DriverLink::Network;
    const auto address = isAddress ? networkAddress(spec->port, kModbusTcpPort) : std::nullopt;
    return address ? address->host + ' ' + std::to_string(address->port)
                   : spec->port; // however it is written
}

/// Two Modbus devices may hang on one line, if they speak alike.
Result<void> checkPorts(const RigSpec& rig) {
    const bool isManual = rig.source && isManualSource(*rig.source);
    const std::string robot = portOf(rig.robot), thermometer = portOf(rig.thermometer),
                      source = isManual ? std::string() : portOf(rig.source);
    if (!robot.empty() && robot == thermometer)
        return Error(MessageCode::PortTwice, "thermometer.port", {rig.robot->port});
    if (!robot.empty() && robot == source)
        return Error(MessageCode::PortTwice, "source.port", {rig.robot->port});
    if (thermometer.empty() || thermometer != source)
        return {};
    const bool isSerial = driverOf(*rig.source).link == DriverLink::Serial;
    const bool isOneLine = driverOf(*rig.thermometer).isModbus && driverOf(*rig.source).isModbus &&
                           rig.thermometer->port == rig.source->port &&
                           (!isSerial || rig.thermometer->serial == rig.source->serial) &&
                           rig.thermometer->unit != rig.source->unit;
    if (!isOneLine)
        return Error(MessageCode::PortTwice, "source.port", {rig.source->port});
    return {};
}

} // namespace

bool isManualSource(const HeatSourceDeviceSpec& source) {
    return driverOf(source).link == DriverLink::None;
}

bool hasOneLine(const RigSpec& rig) {
    return rig.thermometer && rig.source && !portOf(rig.thermometer).empty() &&
           portOf(rig.thermometer) == portOf(rig.source);
}

Result<void> checkRig(const RigSpec& rig, std::size_t sensors, const std::array<bool, 6>& freeCoordinates) {
    Checker name;
    name.name("name", rig.name, kMaxText);
    if (name.failed())
        return name.result();
    if (rig.robot)
        if (const auto fit = checkRobot(*rig.robot, freeCoordinates); !fit)
            return fit;
    if (rig.thermometer)
        if (const auto fit = checkThermometer(*rig.thermometer, sensors); !fit)
            return fit;
    if (rig.source)
        if (const auto fit = checkSource(*rig.source); !fit)
            return fit;
    if (!rig.camera.empty())
        if (const auto fit = checkPort("camera", rig.camera); !fit)
            return fit;
    if (rig.thermalCamera)
        if (const auto fit = checkPort("thermal_camera.device", rig.thermalCamera->device); !fit)
            return fit;
    return checkPorts(rig);
}

} // namespace bask
