#pragma once
// A real rig: its devices, and what of them fits together.

#include "engine/base/result.h"
#include "engine/drivers/device_spec.h"

#include <array>
#include <optional>
#include <string>

namespace bask {

/// A rig without one of the first three cannot be run.
struct RigSpec {
    std::string name;
    std::optional<RobotDeviceSpec> robot;
    std::optional<ThermometerDeviceSpec> thermometer;
    std::optional<HeatSourceDeviceSpec> source;
    std::string camera; ///< as VideoCamera has it; empty: none
    bool operator==(const RigSpec&) const = default;
};

/// A person keeps it hot, and nothing can be switched from here.
bool isKeptByHand(const HeatSourceDeviceSpec& source);

/// The thermometer is on the heater's line, and so goes through its guard.
bool hasOneLine(const RigSpec& rig);

/// For so many objects and these free coordinates: ranges, every free coordinate driven by an axis, a channel
/// an object, a source that goes off when the engine dies or may stay hot, no port used twice but by Modbus
/// devices on one line. The error's `where` begins inside the rig: "thermometer.channels[1]".
Result<void> checkRig(const RigSpec& rig, std::size_t objects, const std::array<bool, 6>& freeCoordinates);

} // namespace bask
