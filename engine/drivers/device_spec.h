#pragma once
// The devices of a real rig as values: driver, port and settings.

#include "engine/base/named_values.h"
#include "engine/protocols/axis_map.h"
#include "engine/protocols/modbus_profile.h"
#include "engine/protocols/serial_settings.h"

#include <optional>
#include <string>
#include <vector>

namespace bask {

/// Settings of every device.
struct DeviceSpec {
    std::string driver; ///< its key in the driver catalogue, as in files
    std::string port;   ///< path of a serial port, or name of a host
    SerialSettings serial{};
    NamedValues own; ///< parameters that only this driver has
    bool operator==(const DeviceSpec&) const = default;
};

struct RobotDeviceSpec : DeviceSpec {
    RobotDeviceSpec() { driver = "grbl"; }
    std::vector<AxisSpec> axes{
        {'X', 0, false, 0.0}, {'Y', 1, false, 0.0}, {'Z', 2, false, 0.0}, {'A', 3, false, 0.0}};
    /// Whether its position is unsure until it has been homed; if empty, this is so if its controller can
    /// home.
    std::optional<bool> mustHome;
    bool operator==(const RobotDeviceSpec&) const = default;
};

struct ThermometerDeviceSpec : DeviceSpec {
    ThermometerDeviceSpec() { driver = "modbus"; }
    int unit = 1;              ///< Modbus only
    ModbusProfile profile{};   ///< Modbus only
    std::vector<int> channels; ///< of each object with a sensor, counted from 0
    bool operator==(const ThermometerDeviceSpec&) const = default;
};

struct HeatSourceDeviceSpec : DeviceSpec {
    HeatSourceDeviceSpec() { driver = "by_hand"; }
    int unit = 1;             ///< Modbus only
    ModbusProfile profile{};  ///< Modbus only
    double watchdog_s = 30.0; ///< watchdog time of the device, if it has one
    bool isProbeUsed = false; ///< whether the external probe, if it has one, is at the surface
    /// Allowed even without a watchdog, so that it stays hot if the engine dies.
    bool mayHeatUnattended = false;
    bool operator==(const HeatSourceDeviceSpec&) const = default;
};

/// Parameters with a range; the driver catalogue says which of them a driver's devices have.
ParameterTable<SerialSettings> serialParameters();
ParameterTable<ThermometerDeviceSpec> thermometerParameters();
ParameterTable<HeatSourceDeviceSpec> heatSourceParameters();

} // namespace bask
