#pragma once
// Which devices this computer has found at its ports, to detect when a different one is plugged in.

#include "engine/base/result.h"
#include "engine/model/rig_spec.h"

#include <map>
#include <string>

namespace bask {

/// The identity of a device.
struct KnownDevice {
    std::string portId;    ///< name of the port given by its adapter; empty: it has none
    std::string signature; ///< as the device reports it; empty: it reports nothing
    bool operator==(const KnownDevice&) const = default;
};

/// Devices by their description in a rig: "robot grbl /dev/ttyUSB0".
using DeviceMemory = std::map<std::string, KnownDevice>;

std::string memoryKey(const RobotDeviceSpec& robot);
std::string memoryKey(const ThermometerDeviceSpec& thermometer);
std::string memoryKey(const HeatSourceDeviceSpec& source);

/// Reads "format": "bask-devices", "version": 1. A missing file is an empty memory.
Result<DeviceMemory> readDeviceMemory(const std::string& path);
/// Writes the whole memory or leaves the old file.
Result<void> writeDeviceMemory(const DeviceMemory& memory, const std::string& path);

} // namespace bask
