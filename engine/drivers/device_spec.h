#pragma once
// The devices of a real rig as values: which driver, on which port, with what settings.

#include "engine/base/named_values.h"
#include "engine/protocols/axis_map.h"
#include "engine/protocols/modbus_profile.h"
#include "engine/protocols/serial_settings.h"

#include <optional>
#include <string>
#include <vector>

namespace bask {

/// What every device has.
struct DeviceSpec {
    std::string driver; ///< its key in the catalogue of drivers, as in files
    std::string port;   ///< a serial port's path, or a host's name
    SerialSettings serial{};
    NamedValues own; ///< of the parameters that the driver alone has
    bool operator==(const DeviceSpec&) const = default;
};

struct RobotDeviceSpec : DeviceSpec {
    RobotDeviceSpec() { driver = "grbl"; }
    std::vector<AxisSpec> axes{
        {'X', 0, false, 0.0}, {'Y', 1, false, 0.0}, {'Z', 2, false, 0.0}, {'A', 3, false, 0.0}};
    /// Its place is not sure before it has been homed; empty: if its controller can home.
    std::optional<bool> mustHome;
    bool operator==(const RobotDeviceSpec&) const = default;
};

struct ThermometerDeviceSpec : DeviceSpec {
    ThermometerDeviceSpec() { driver = "modbus"; }
    int unit = 1;              ///< Modbus
    ModbusProfile profile{};   ///< Modbus
    std::vector<int> channels; ///< of each object, counted from 0
    bool operator==(const ThermometerDeviceSpec&) const = default;
};

struct HeatSourceDeviceSpec : DeviceSpec {
    HeatSourceDeviceSpec() { driver = "by_hand"; }
    int unit = 1;                   ///< Modbus
    ModbusProfile profile{};        ///< Modbus
    double watchdog_s = 30.0;       ///< of the device, where it has one
    bool isProbeUsed = false;       ///< its external probe, where it has one, is at the surface
    bool mayHeatUnattended = false; ///< also without a watchdog, so that it stays hot when the engine dies
    bool operator==(const HeatSourceDeviceSpec&) const = default;
};

/// What has a range; which of them a driver's devices have is in the catalogue of drivers.
ParameterTable<SerialSettings> serialParameters();
ParameterTable<ThermometerDeviceSpec> thermometerParameters();
ParameterTable<HeatSourceDeviceSpec> heatSourceParameters();

} // namespace bask
