#include "engine/session/rig_spec.h"

#include "engine/base/message_code.h"
#include "engine/base/pose.h"
#include "engine/protocols/register_values.h"

#include <algorithm>

namespace bask {
namespace {

constexpr std::size_t kMaxText = 1000;
constexpr double kMaxOrigin_m = 5.0;
constexpr double kMaxOrigin_rad = 6.2831853071795862;

Error outOfRange(const std::string& where, double value, double least, double most, const char* unit = "") {
    return {MessageCode::ValueOutOfRange,
            where,
            {formatNumber(value, 10), formatNumber(least), formatNumber(most), unit}};
}

Result<void> checkRange(const std::string& where, double value, double least, double most,
                        const char* unit = "") {
    if (!(value >= least && value <= most))
        return outOfRange(where, value, least, most, unit);
    return {};
}

Result<void> checkPort(const std::string& where, const std::string& port) {
    if (port.empty())
        return Error(MessageCode::JsonMissingKey, where, {"port"});
    const auto isControl = [](char c) { return static_cast<unsigned char>(c) < 0x20; };
    if (port.size() > kMaxText || std::ranges::any_of(port, isControl))
        return Error(MessageCode::ValueUnknown, where, {port.substr(0, 20), "a path or a host's name"});
    return {};
}

Result<void> checkSerial(const std::string& where, const SerialSettings& serial) {
    if (const auto fit = checkRange(where + ".baud", serial.baud, 300.0, 4e6, "baud"); !fit)
        return fit;
    if (const auto fit = checkRange(where + ".data_bits", serial.dataBits, 7.0, 8.0); !fit)
        return fit;
    return checkRange(where + ".stop_bits", serial.stopBits, 1.0, 2.0);
}

Result<void> checkRobot(const RobotDeviceSpec& robot, const std::array<bool, 6>& freeCoordinates) {
    if (const auto fit = checkPort("robot.port", robot.port); !fit)
        return fit;
    if (const auto fit = checkSerial("robot.serial", robot.serial); !fit)
        return fit;
    if (auto fit = checkAxes(robot.axes); !fit) {
        Error error = fit.error();
        error.where = "robot." + error.where;
        return error;
    }
    for (std::size_t i = 0; i < robot.axes.size(); ++i) {
        const double most = robot.axes[i].coordinate < 3 ? kMaxOrigin_m : kMaxOrigin_rad;
        if (const auto fit = checkRange("robot.axes[" + std::to_string(i) + "].origin", robot.axes[i].origin,
                                        -most, most, robot.axes[i].coordinate < 3 ? "m" : "rad");
            !fit)
            return fit;
    }
    for (std::size_t k = 0; k < freeCoordinates.size(); ++k)
        if (freeCoordinates[k] &&
            std::ranges::find(robot.axes, static_cast<int>(k), &AxisSpec::coordinate) == robot.axes.end())
            return Error(MessageCode::AxisMissing, "robot.axes", {kCoordinateNames[k]});
    return {};
}

Result<void> checkThermometer(const ThermometerDeviceSpec& thermometer, std::size_t objects) {
    if (const auto fit = checkPort("thermometer.port", thermometer.port); !fit)
        return fit;
    if (const auto fit = checkSerial("thermometer.serial", thermometer.serial); !fit)
        return fit;
    if (const auto fit = checkRange("thermometer.unit", thermometer.unit, 1.0, 247.0); !fit)
        return fit;
    const std::vector<int>& channels = thermometer.channels;
    if (channels.size() != objects)
        return Error(MessageCode::ChannelCountWrong, "thermometer.channels",
                     {std::to_string(channels.size()), std::to_string(objects)});
    const bool isModbus = thermometer.driver == ThermometerDriver::Modbus;
    const int last = isModbus ? thermometer.profile.channels - 1 : 63;
    for (std::size_t i = 0; i < channels.size(); ++i) {
        const std::string where = "thermometer.channels[" + std::to_string(i) + "]";
        if (const auto fit = checkRange(where, channels[i], 0.0, last); !fit)
            return fit;
        if (std::ranges::count(channels, channels[i]) > 1)
            return Error(MessageCode::ChannelTwice, where, {std::to_string(channels[i])});
    }
    if (isModbus && !thermometer.profile.channel)
        return Error(MessageCode::ProfileOther, "thermometer.profile", {thermometer.profile.name});
    return {};
}

Result<void> checkSource(const HeatSourceDeviceSpec& source) {
    if (source.driver == HeatSourceDriver::ByHand)
        return {};
    if (const auto fit = checkPort("source.port", source.port); !fit)
        return fit;
    if (const auto fit = checkSerial("source.serial", source.serial); !fit)
        return fit;
    if (const auto fit = checkRange("source.unit", source.unit, 1.0, 247.0); !fit)
        return fit;
    if (const auto fit = checkRange("source.watchdog_s", source.watchdog_s, 20.0, 1500.0, "s"); !fit)
        return fit;
    if (source.driver != HeatSourceDriver::Modbus)
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

/// Two Modbus devices may hang on one line, if they speak alike.
Result<void> checkPorts(const RigSpec& rig) {
    const bool hasSource = rig.source && rig.source->driver != HeatSourceDriver::ByHand;
    if (rig.robot && rig.thermometer && rig.robot->port == rig.thermometer->port)
        return Error(MessageCode::PortTwice, "thermometer.port", {rig.robot->port});
    if (rig.robot && hasSource && rig.robot->port == rig.source->port)
        return Error(MessageCode::PortTwice, "source.port", {rig.robot->port});
    if (!rig.thermometer || !hasSource || rig.thermometer->port != rig.source->port)
        return {};
    const bool isOneLine = rig.thermometer->driver == ThermometerDriver::Modbus &&
                           rig.source->driver == HeatSourceDriver::Modbus &&
                           rig.thermometer->serial == rig.source->serial &&
                           rig.thermometer->unit != rig.source->unit;
    if (!isOneLine)
        return Error(MessageCode::PortTwice, "source.port", {rig.source->port});
    return {};
}

} // namespace

SerialSettings usualSerial(RobotDriver) {
    return {115200, 8, 'N', 1};
}

SerialSettings usualSerial(ThermometerDriver driver) {
    return driver == ThermometerDriver::Modbus ? SerialSettings{19200, 8, 'E', 1}
                                               : SerialSettings{115200, 8, 'N', 1};
}

SerialSettings usualSerial(HeatSourceDriver driver) {
    switch (driver) {
    case HeatSourceDriver::Namur:
        return {9600, 7, 'E', 1};
    case HeatSourceDriver::Modbus:
        return {19200, 8, 'E', 1};
    case HeatSourceDriver::ByHand:
        break;
    }
    return {}; // no line
}

bool hasOneLine(const RigSpec& rig) {
    return rig.thermometer && rig.source && rig.thermometer->port == rig.source->port;
}

Result<void> checkRig(const RigSpec& rig, std::size_t objects, const std::array<bool, 6>& freeCoordinates) {
    if (rig.name.size() > kMaxText)
        return outOfRange("name", static_cast<double>(rig.name.size()), 0.0, kMaxText, "characters");
    if (rig.robot)
        if (const auto fit = checkRobot(*rig.robot, freeCoordinates); !fit)
            return fit;
    if (rig.thermometer)
        if (const auto fit = checkThermometer(*rig.thermometer, objects); !fit)
            return fit;
    if (rig.source)
        if (const auto fit = checkSource(*rig.source); !fit)
            return fit;
    if (!rig.camera.empty())
        if (const auto fit = checkPort("camera", rig.camera); !fit)
            return fit;
    return checkPorts(rig);
}

} // namespace bask
