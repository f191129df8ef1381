#pragma once
// Which devices this computer has met at its ports, so that another one that is plugged in there is told.

#include "engine/base/result.h"
#include "engine/model/rig_spec.h"

#include <map>
#include <string>

namespace bask {

/// What a device is known by.
struct KnownDevice {
    std::string portId;    ///< the port's own name, by its adapter; empty: it has none
    std::string signature; ///< as the device tells; empty: it tells nothing
    bool operator==(const KnownDevice&) const = default;
};

/// By what a rig says of them: "robot grbl /dev/ttyUSB0".
using DeviceMemory = std::map<std::string, KnownDevice>;

std::string memoryKey(const RobotDeviceSpec& robot);
std::string memoryKey(const ThermometerDeviceSpec& thermometer);
std::string memoryKey(const HeatSourceDeviceSpec& source);

/// "format": "bask-devices", "version": 1. A file that is not there is an empty memory.
Result<DeviceMemory> readDeviceMemory(const std::string& path);
/// Whole or not at all.
Result<void> writeDeviceMemory(const DeviceMemory& memory, const std::string& path);

} // namespace bask
