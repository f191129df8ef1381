#include "engine/session/rig_json.h"

#include "engine/session/json_quantities.h"

#include <nlohmann/json.hpp>

#include <algorithm>

namespace bask {
namespace {

using nlohmann::json;
using Json = nlohmann::ordered_json;

const std::map<std::string, RobotDriver> kRobotDrivers{{"grbl", RobotDriver::Grbl},
                                                       {"dobot", RobotDriver::Dobot}};
const std::map<std::string, ThermometerDriver> kThermometerDrivers{{"modbus", ThermometerDriver::Modbus},
                                                                   {"stream", ThermometerDriver::Stream}};
const std::map<std::string, HeatSourceDriver> kHeatSourceDrivers{{"by_hand", HeatSourceDriver::ByHand},
                                                                 {"namur", HeatSourceDriver::Namur},
                                                                 {"modbus", HeatSourceDriver::Modbus}};
const std::map<std::string, char> kParities{{"none", 'N'}, {"even", 'E'}, {"odd", 'O'}};

template <class T> std::string wordOf(const std::map<std::string, T>& table, T value) {
    const auto it = std::ranges::find_if(table, [&](const auto& entry) { return entry.second == value; });
    return it == table.end() ? std::string() : it->first;
}

std::map<std::string, int> coordinates() {
    std::map<std::string, int> out;
    for (std::size_t k = 0; k < kCoordinateNames.size(); ++k)
        out[kCoordinateNames[k]] = static_cast<int>(k);
    return out;
}

/// What is left out is as `usual`.
void readSerial(Fields& device, const SerialSettings& usual, SerialSettings& out) {
    out = usual;
    readPart(device, "serial", false, [&](const json& j, const std::string& path) {
        Fields fields(j, path, device.failure());
        fields.read("baud", out.baud);
        fields.read("data_bits", out.dataBits);
        fields.readWord("parity", kParities, out.parity);
        fields.read("stop_bits", out.stopBits);
        fields.close();
    });
}

/// One that comes with Bask by its name, or the whole profile.
void readProfile(Fields& device, bool required, ModbusProfile& out) {
    const json* j = device.find("profile", required);
    if (j == nullptr || device.failure())
        return;
    const std::string path = device.pathOf("profile");
    if (j->is_object()) {
        auto profile = modbusProfileFromJson(j->dump(), path);
        if (profile)
            out = std::move(*profile);
        else if (!device.failure())
            device.failure() = profile.error();
        return;
    }
    if (!j->is_string())
        return device.fail(MessageCode::JsonWrongType, path, {"a name or an object", typeName(*j)});
    const auto& shipped = shippedProfiles();
    const auto it = std::ranges::find(shipped, j->get<std::string>(), &ModbusProfile::name);
    if (it != shipped.end()) {
        out = *it;
        return;
    }
    std::string known;
    for (const ModbusProfile& profile : shipped)
        known += (known.empty() ? "" : ", ") + profile.name;
    device.fail(MessageCode::ValueUnknown, path, {plainWords(j->get<std::string>()), known});
}

void readAxis(const json& j, const std::string& path, Failure& failure, AxisSpec& out) {
    static const std::map<std::string, int> kCoordinates = coordinates();
    Fields fields(j, path, failure);
    std::string letter;
    fields.read("letter", letter, true);
    fields.readWord("coordinate", kCoordinates, out.coordinate, true);
    fields.read("reversed", out.reversed);
    fields.read("origin", coordinateUnit(out.coordinate), out.origin);
    fields.close();
    if (failure)
        return;
    if (letter.size() != 1)
        return fields.fail(MessageCode::AxisLetterUnknown, path + ".letter", {plainWords(letter)});
    out.letter = letter.front();
}

void readAxes(Fields& robot, std::vector<AxisSpec>& out) {
    const json* j = robot.find("axes");
    if (j == nullptr)
        return;
    const std::string path = robot.pathOf("axes");
    if (!j->is_array())
        return robot.fail(MessageCode::JsonWrongType, path, {"an array", typeName(*j)});
    out.clear();
    for (std::size_t i = 0; i < j->size() && !robot.failure(); ++i)
        readAxis((*j)[i], path + '[' + std::to_string(i) + ']', robot.failure(), out.emplace_back());
}

void readRobotDevice(const json& j, const std::string& path, Failure& failure, RobotDeviceSpec& out) {
    Fields fields(j, path, failure);
    fields.readWord("driver", kRobotDrivers, out.driver, true);
    fields.read("port", out.port, true);
    readSerial(fields, usualSerial(out.driver), out.serial);
    readAxes(fields, out.axes);
    if (fields.find("must_home") != nullptr)
        fields.read("must_home", out.mustHome.emplace());
    fields.close();
}

void readThermometerDevice(const json& j, const std::string& path, Failure& failure,
                           ThermometerDeviceSpec& out) {
    Fields fields(j, path, failure);
    fields.readWord("driver", kThermometerDrivers, out.driver, true);
    fields.read("port", out.port, true);
    readSerial(fields, usualSerial(out.driver), out.serial);
    fields.read("unit", out.unit);
    readProfile(fields, out.driver == ThermometerDriver::Modbus, out.profile);
    std::vector<double> channels;
    fields.read("channels", channels);
    for (const double channel : channels) {
        out.channels.push_back(static_cast<int>(std::clamp(channel, -1.0, 1e6)));
        if (out.channels.back() != channel)
            fields.fail(MessageCode::JsonWrongType, fields.pathOf("channels"),
                        {"whole numbers", formatNumber(channel)});
    }
    fields.close();
}

bool hasWatchdog(const HeatSourceDeviceSpec& source) {
    return source.driver != HeatSourceDriver::Modbus || source.profile.watchdog;
}

void readSourceDevice(const json& j, const std::string& path, Failure& failure, HeatSourceDeviceSpec& out) {
    Fields fields(j, path, failure);
    fields.readWord("driver", kHeatSourceDrivers, out.driver, true);
    fields.read("port", out.port);
    readSerial(fields, usualSerial(out.driver), out.serial);
    fields.read("unit", out.unit);
    readProfile(fields, out.driver == HeatSourceDriver::Modbus, out.profile);
    if (hasWatchdog(out)) // or it would seem to have one
        fields.read("watchdog_s", out.watchdog_s);
    fields.read("unattended_heat", out.mayHeatUnattended);
    fields.read("probe", out.isProbeUsed);
    fields.close();
}

Json serialJson(const SerialSettings& serial) {
    return {{"baud", serial.baud},
            {"data_bits", serial.dataBits},
            {"parity", wordOf(kParities, serial.parity)},
            {"stop_bits", serial.stopBits}};
}

Json profileJson(const ModbusProfile& profile) {
    const auto& shipped = shippedProfiles();
    if (std::ranges::find(shipped, profile) != shipped.end())
        return profile.name;
    return Json::parse(modbusProfileToJson(profile));
}

Json robotJson(const RobotDeviceSpec& robot) {
    Json j;
    j["driver"] = wordOf(kRobotDrivers, robot.driver);
    j["port"] = robot.port;
    j["serial"] = serialJson(robot.serial);
    j["axes"] = Json::array();
    for (const AxisSpec& axis : robot.axes) {
        Json a;
        a["letter"] = std::string(1, axis.letter);
        a["coordinate"] = kCoordinateNames[static_cast<std::size_t>(axis.coordinate)];
        a["reversed"] = axis.reversed;
        putQuantity(a, "origin", coordinateUnit(axis.coordinate), axis.origin);
        j["axes"].push_back(std::move(a));
    }
    if (robot.mustHome)
        j["must_home"] = *robot.mustHome;
    return j;
}

Json thermometerJson(const ThermometerDeviceSpec& thermometer) {
    Json j;
    j["driver"] = wordOf(kThermometerDrivers, thermometer.driver);
    j["port"] = thermometer.port;
    j["serial"] = serialJson(thermometer.serial);
    if (thermometer.driver == ThermometerDriver::Modbus) {
        j["unit"] = thermometer.unit;
        j["profile"] = profileJson(thermometer.profile);
    }
    j["channels"] = thermometer.channels;
    return j;
}

Json sourceJson(const HeatSourceDeviceSpec& source) {
    Json j;
    j["driver"] = wordOf(kHeatSourceDrivers, source.driver);
    if (source.driver == HeatSourceDriver::ByHand)
        return j;
    j["port"] = source.port;
    j["serial"] = serialJson(source.serial);
    if (source.driver == HeatSourceDriver::Modbus) {
        j["unit"] = source.unit;
        j["profile"] = profileJson(source.profile);
    } else {
        j["probe"] = source.isProbeUsed;
    }
    if (hasWatchdog(source))
        j["watchdog_s"] = source.watchdog_s;
    j["unattended_heat"] = source.mayHeatUnattended;
    return j;
}

} // namespace

void readRig(const json& j, const std::string& path, Failure& failure, RigSpec& out) {
    Fields fields(j, path, failure);
    fields.read("name", out.name);
    readPart(fields, "robot", false, [&](const json& part, const std::string& where) {
        readRobotDevice(part, where, failure, out.robot.emplace());
    });
    readPart(fields, "thermometer", false, [&](const json& part, const std::string& where) {
        readThermometerDevice(part, where, failure, out.thermometer.emplace());
    });
    readPart(fields, "source", false, [&](const json& part, const std::string& where) {
        readSourceDevice(part, where, failure, out.source.emplace());
    });
    fields.read("camera", out.camera);
    fields.close();
}

Json rigJson(const RigSpec& rig) {
    Json j = Json::object(); // also without a device
    if (!rig.name.empty())
        j["name"] = rig.name;
    if (rig.robot)
        j["robot"] = robotJson(*rig.robot);
    if (rig.thermometer)
        j["thermometer"] = thermometerJson(*rig.thermometer);
    if (rig.source)
        j["source"] = sourceJson(*rig.source);
    if (!rig.camera.empty())
        j["camera"] = rig.camera;
    return j;
}

} // namespace bask
