#pragma once
// A real rig: its devices, and whether they fit together.

#include "engine/base/result.h"
#include "engine/drivers/device_spec.h"
#include "engine/model/thermal_camera_spec.h"

#include <array>
#include <optional>
#include <string>

namespace bask {

/// A rig cannot be run without a robot, a source, and what its objects are read by.
struct RigSpec {
    std::string name;
    std::optional<RobotDeviceSpec> robot;
    std::optional<ThermometerDeviceSpec> thermometer;
    std::optional<HeatSourceDeviceSpec> source;
    std::string camera; ///< as in VideoCamera; empty: none
    std::optional<ThermalCameraSpec> thermalCamera;
    bool operator==(const RigSpec&) const = default;
};

/// Returns the largest origin of an axis that moves this coordinate, in either direction, m or rad.
constexpr double maxAxisOrigin(int coordinate) {
    return coordinate < 3 ? 5.0 : 6.2831853071795862;
}

/// Returns whether a person heats the source; nothing can be switched by the program.
bool isManualSource(const HeatSourceDeviceSpec& source);

/// Returns whether the thermometer is on the heater's line, so that it must use the heater's guard.
bool hasOneLine(const RigSpec& rig);

/// Checks a rig for this number of objects with sensors on them and these free coordinates: ranges, an axis
/// for every free coordinate, a channel for every sensor, a source that switches off if the engine dies or is
/// allowed to stay hot, and no port used twice except by Modbus devices on one line. The error's `where` is a
/// path inside the rig: "thermometer.channels[1]".
Result<void> checkRig(const RigSpec& rig, std::size_t sensors, const std::array<bool, 6>& freeCoordinates);

} // namespace bask
