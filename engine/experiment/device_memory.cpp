#include "engine/experiment/device_memory.h"

#include "engine/base/json_fields.h"
#include "engine/base/plain_text.h"
#include "engine/drivers/driver_catalogue.h"
#include "engine/experiment/text_file.h"

#include <nlohmann/json.hpp>

namespace bask {
namespace {

using nlohmann::json;

constexpr int kMemoryVersion = 1;
constexpr std::uintmax_t kMaxMemoryBytes = 1U << 20;

/// "thermometer modbus /dev/ttyUSB0 unit 17"
template <class Spec> std::string keyOfUnit(const char* role, const Spec& spec) {
    const std::string key = std::string(role) + ' ' + spec.driver + ' ' + spec.port;
    return driverOf(spec).isModbus ? key + " unit " + std::to_string(spec.unit) : key;
}

void readDevice(const json& j, const std::string& path, Failure& failure, DeviceMemory& out) {
    std::string key;
    KnownDevice device;
    Fields fields(j, path, failure);
    fields.read("device", key, true);
    fields.read("port_id", device.portId);
    fields.read("signature", device.signature);
    fields.close();
    out[key] = device;
}

} // namespace

std::string memoryKey(const RobotDeviceSpec& robot) {
    return "robot " + robot.driver + ' ' + robot.port;
}

std::string memoryKey(const ThermometerDeviceSpec& thermometer) {
    return keyOfUnit("thermometer", thermometer);
}

std::string memoryKey(const HeatSourceDeviceSpec& source) {
    return keyOfUnit("source", source);
}

Result<DeviceMemory> readDeviceMemory(const std::string& path) {
    const auto text = readTextFile(path, kMaxMemoryBytes);
    if (!text && text.error().code() == MessageCode::FileNotFound)
        return DeviceMemory();
    if (!text)
        return text.error();
    return readJsonText<DeviceMemory>(*text, path, [](const json& j, Failure& failure, DeviceMemory& memory) {
        Fields root(j, {}, failure);
        readHeader(root, "bask-devices", kMemoryVersion);
        readEach(root, "devices", true, [&](const json& entry, const std::string& where) {
            readDevice(entry, where, failure, memory);
        });
        root.close();
    });
}

Result<void> writeDeviceMemory(const DeviceMemory& memory, const std::string& path) {
    nlohmann::ordered_json j{{"format", "bask-devices"},
                             {"version", kMemoryVersion},
                             {"devices", nlohmann::ordered_json::array()}};
    for (const auto& [key, device] : memory)
        j["devices"].push_back(
            {{"device", key}, {"port_id", device.portId}, {"signature", device.signature}});
    return writeTextFile(path, j.dump(1, ' ', false, json::error_handler_t::replace) + '\n');
}

} // namespace bask
