#include "engine/experiment/rig_json.h"

#include "engine/base/plain_text.h"
#include "engine/drivers/driver_catalogue.h"
#include "engine/experiment/json_quantities.h"
#include "engine/experiment/parameter_json.h"
#include "engine/experiment/vision_json.h"

#include <nlohmann/json.hpp>

#include <algorithm>

namespace bask {
namespace {

using nlohmann::json;
using Json = nlohmann::ordered_json;

const std::map<std::string, char> kParities{{"none", 'N'}, {"even", 'E'}, {"odd", 'O'}};

std::string parityWord(char parity) {
    const auto it = std::ranges::find(kParities, parity, [](const auto& entry) { return entry.second; });
    return it == kParities.end() ? std::string() : it->first;
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
        readParameters(fields, serialParameters(), out);
        fields.readWord("parity", kParities, out.parity);
        fields.close();
    });
}

/// One that comes with Bask by its name, or the whole profile.
template <class Profile>
void readProfile(Fields& device, bool required, const std::vector<Profile>& shipped,
                 Result<Profile> (*parse)(const std::string& text, const std::string& where), Profile& out) {
    const json* j = device.find("profile", required);
    if (j == nullptr || device.failure())
        return;
    const std::string path = device.pathOf("profile");
    if (j->is_object()) {
        auto profile = parse(j->dump(), path);
        if (profile)
            out = std::move(*profile);
        else if (!device.failure())
            device.failure() = profile.error();
        return;
    }
    if (!j->is_string())
        return device.fail(MessageCode::JsonWrongType, path, {"a name or an object", typeName(*j)});
    const auto it = std::ranges::find(shipped, j->get<std::string>(), &Profile::name);
    if (it != shipped.end()) {
        out = *it;
        return;
    }
    std::string known;
    for (const Profile& profile : shipped)
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

/// Those of a program of one's own are told: no directions are usual.
void readAxes(Fields& robot, bool isRequired, std::vector<AxisSpec>& out) {
    if (robot.find("axes") != nullptr)
        out.clear();
    readEach(robot, "axes", isRequired, [&](const json& j, const std::string& path) {
        readAxis(j, path, robot.failure(), out.emplace_back());
    });
}

/// What every device has.
void readDevice(Fields& fields, DeviceRole role, bool isPortRequired, DeviceSpec& out) {
    std::map<std::string, const DriverFacts*> known;
    for (const DriverFacts* driver : driversOf(role))
        known[driver->key] = driver;
    const DriverFacts* driver = known.at(out.driver);
    fields.readWord("driver", known, driver, true);
    out.driver = driver->key;
    fields.read(portKey(*driver), out.port, isPortRequired);
    readSerial(fields, driver->serial, out.serial);
}

/// `ofRole`: those that some driver of the role has; of another driver they are not looked at.
template <class Spec> void readDeviceParameters(Fields& fields, ParameterTable<Spec> ofRole, Spec& out) {
    const auto& parameters = driverOf(out).parameters;
    for (const DeviceParameter<Spec>& parameter : parameters)
        if (parameter.applies(out))
            parameter.set(
                out, readParameter(fields, *parameter.facts, parameter.isWhole).value_or(parameter.get(out)));
    for (const Parameter<Spec>& other : ofRole)
        if (std::ranges::find(parameters, &other, &DeviceParameter<Spec>::facts) == parameters.end())
            fields.find(keyOf(other));
}

void readRobotDevice(const json& j, const std::string& path, Failure& failure, RobotDeviceSpec& out) {
    Fields fields(j, path, failure);
    readDevice(fields, DeviceRole::Robot, true, out);
    readAxes(fields, driverOf(out).link == DriverLink::Program, out.axes);
    if (fields.find("must_home") != nullptr)
        fields.read("must_home", out.mustHome.emplace());
    readDeviceParameters(fields, {}, out);
    fields.close();
}

void readThermometerDevice(const json& j, const std::string& path, Failure& failure,
                           ThermometerDeviceSpec& out) {
    Fields fields(j, path, failure);
    readDevice(fields, DeviceRole::Thermometer, true, out);
    readProfile(fields, driverOf(out).isModbus, shippedProfiles(), modbusProfileFromJson, out.profile);
    std::vector<double> channels;
    fields.read("channels", channels);
    for (const double channel : channels) {
        out.channels.push_back(static_cast<int>(std::clamp(channel, -1.0, 1e6)));
        if (out.channels.back() != channel)
            fields.fail(MessageCode::JsonWrongType, fields.pathOf("channels"),
                        {"whole numbers", formatNumber(channel)});
    }
    readDeviceParameters(fields, thermometerParameters(), out);
    fields.close();
}

void readSourceDevice(const json& j, const std::string& path, Failure& failure, HeatSourceDeviceSpec& out) {
    Fields fields(j, path, failure);
    readDevice(fields, DeviceRole::HeatSource, false, out);
    readProfile(fields, driverOf(out).isModbus, shippedProfiles(), modbusProfileFromJson, out.profile);
    readDeviceParameters(fields, heatSourceParameters(), out);
    fields.read("unattended_heat", out.mayHeatUnattended);
    fields.read("probe", out.isProbeUsed);
    fields.close();
}

void readThermalCamera(const json& j, const std::string& path, Failure& failure, ThermalCameraSpec& out) {
    Fields fields(j, path, failure);
    fields.read("device", out.device, true);
    readProfile(fields, true, shippedThermalProfiles(), thermalProfileFromJson, out.profile);
    readThermalCalibration(fields, failure, out.calibration);
    fields.close();
}

Json serialJson(const SerialSettings& serial) {
    Json j;
    for (const Parameter<SerialSettings>& parameter : serialParameters()) {
        putParameter(j, parameter, *parameter.get(serial), parameter.isWhole());
        if (parameter.name == std::string("data_bits")) // where files have it
            j["parity"] = parityWord(serial.parity);
    }
    return j;
}

Json deviceJson(const DeviceSpec& device, const DriverFacts& driver, bool hasLine) {
    Json j;
    j["driver"] = device.driver;
    j[portKey(driver)] = device.port;
    if (hasLine)
        j["serial"] = serialJson(device.serial);
    return j;
}

template <class Spec> void putDeviceParameters(Json& j, SetupStep step, const Spec& spec) {
    for (const DeviceParameter<Spec>& parameter : driverOf(spec).parameters)
        if (parameter.step == step && parameter.applies(spec))
            putParameter(j, *parameter.facts, parameter.get(spec), parameter.isWhole);
}

template <class Profile>
Json profileJson(const Profile& profile, const std::vector<Profile>& shipped,
                 std::string (*write)(const Profile&)) {
    if (std::ranges::find(shipped, profile) != shipped.end())
        return profile.name;
    return Json::parse(write(profile));
}

Json profileJson(const ModbusProfile& profile) {
    return profileJson(profile, shippedProfiles(), modbusProfileToJson);
}

Json robotJson(const RobotDeviceSpec& robot) {
    const RobotDriver& driver = driverOf(robot);
    Json j =
        deviceJson(robot, driver, driver.link != DriverLink::Program); // on a network, too: files have it
    putDeviceParameters(j, SetupStep::Connection, robot);
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
    putDeviceParameters(j, SetupStep::Use, robot);
    return j;
}

Json thermometerJson(const ThermometerDeviceSpec& thermometer) {
    const ThermometerDriver& driver = driverOf(thermometer);
    Json j = deviceJson(thermometer, driver, driver.link == DriverLink::Serial);
    putDeviceParameters(j, SetupStep::Connection, thermometer);
    if (driver.isModbus)
        j["profile"] = profileJson(thermometer.profile);
    j["channels"] = thermometer.channels;
    putDeviceParameters(j, SetupStep::Use, thermometer);
    return j;
}

Json sourceJson(const HeatSourceDeviceSpec& source) {
    const HeatSourceDriver& driver = driverOf(source);
    if (driver.link == DriverLink::None)
        return {{"driver", source.driver}};
    Json j = deviceJson(source, driver, driver.link == DriverLink::Serial);
    putDeviceParameters(j, SetupStep::Connection, source);
    if (driver.isModbus)
        j["profile"] = profileJson(source.profile);
    if (driver.hasProbe)
        j["probe"] = source.isProbeUsed;
    putDeviceParameters(j, SetupStep::Use, source);
    j["unattended_heat"] = source.mayHeatUnattended;
    return j;
}

Json thermalCameraJson(const ThermalCameraSpec& camera) {
    Json j{{"device", camera.device}};
    j["profile"] = profileJson(camera.profile, shippedThermalProfiles(), thermalProfileToJson);
    putThermalCalibration(j, camera.calibration);
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
    readPart(fields, "thermal_camera", false, [&](const json& part, const std::string& where) {
        readThermalCamera(part, where, failure, out.thermalCamera.emplace());
    });
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
    if (rig.thermalCamera)
        j["thermal_camera"] = thermalCameraJson(*rig.thermalCamera);
    return j;
}

} // namespace bask
