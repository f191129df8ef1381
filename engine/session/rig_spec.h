#pragma once
// The devices of a real rig: which driver, on which port, with what settings.

#include "engine/base/result.h"
#include "engine/protocols/axis_map.h"
#include "engine/protocols/modbus_profile.h"
#include "engine/protocols/serial_settings.h"

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace bask {

enum class RobotDriver { Grbl, Dobot };

struct RobotDeviceSpec {
    RobotDriver driver = RobotDriver::Grbl;
    std::string port; ///< a serial port's path, or a host name of a Dobot
    SerialSettings serial{};
    std::vector<AxisSpec> axes{
        {'X', 0, false, 0.0}, {'Y', 1, false, 0.0}, {'Z', 2, false, 0.0}, {'A', 3, false, 0.0}};
    /// Its place is not sure before it has been homed; empty: if its controller can home.
    std::optional<bool> mustHome;
    bool operator==(const RobotDeviceSpec&) const = default;
};

enum class ThermometerDriver { Modbus, Stream };

struct ThermometerDeviceSpec {
    ThermometerDriver driver = ThermometerDriver::Modbus;
    std::string port;
    SerialSettings serial{};
    int unit = 1;              ///< Modbus
    ModbusProfile profile{};   ///< Modbus
    std::vector<int> channels; ///< of each object, counted from 0
    bool operator==(const ThermometerDeviceSpec&) const = default;
};

enum class HeatSourceDriver { ByHand, Namur, Modbus };

struct HeatSourceDeviceSpec {
    HeatSourceDriver driver = HeatSourceDriver::ByHand;
    std::string port;
    SerialSettings serial{};
    int unit = 1;
    ModbusProfile profile{};
    double watchdog_s = 30.0;       ///< of the device, where it has one
    bool isProbeUsed = false;       ///< Namur: its external probe is at the surface
    bool mayHeatUnattended = false; ///< also without a watchdog, so that it stays hot when the engine dies
    bool operator==(const HeatSourceDeviceSpec&) const = default;
};

/// As the devices of a driver leave the factory, mostly.
SerialSettings usualSerial(RobotDriver driver);
SerialSettings usualSerial(ThermometerDriver driver);
SerialSettings usualSerial(HeatSourceDriver driver);

/// A rig without one of the first three cannot be run.
struct RigSpec {
    std::string name;
    std::optional<RobotDeviceSpec> robot;
    std::optional<ThermometerDeviceSpec> thermometer;
    std::optional<HeatSourceDeviceSpec> source;
    std::string camera; ///< as VideoCamera has it; empty: none
    bool operator==(const RigSpec&) const = default;
};

/// The thermometer is on the heater's line, and so goes through its guard.
bool hasOneLine(const RigSpec& rig);

/// For so many objects and these free coordinates: ranges, every free coordinate driven by an axis, a channel
/// an object, a source that goes off when the engine dies or may stay hot, no port used twice but by Modbus
/// devices on one line. The error's `where` begins inside the rig: "thermometer.channels[1]".
Result<void> checkRig(const RigSpec& rig, std::size_t objects, const std::array<bool, 6>& freeCoordinates);

} // namespace bask
