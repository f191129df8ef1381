#pragma once
// All drivers of real devices: keys in files, names, links and parameters, and how each is made. Files,
// checks, forms and the rig use this list.

#include "engine/devices/device.h"
#include "engine/drivers/device_spec.h"

#include <functional>
#include <stdexcept>
#include <vector>

namespace bask {

class AxisMap;
class DriverLinks;
class HeatSource;
class Robot;
class Thermometer;
template <class Role> struct MadeDevice;

enum class DriverLink {
    None,    ///< nothing is connected: a person operates it
    Serial,  ///< the port is a path, with the settings of the line
    Network, ///< the port is a host's name or address
    Program  ///< the port is the command line of a program that talks to the device
};

/// The step of a form in which a parameter is asked for.
enum class SetupStep { Connection, Use };

/// A parameter of a driver's devices, and where their spec stores it.
template <class Spec> struct DeviceParameter {
    const ParameterFacts* facts;
    SetupStep step;
    bool isWhole;
    std::function<double(const Spec&)> get;
    std::function<void(Spec&, double)> set;
    std::function<bool(const Spec&)> applies = [](const Spec&) { return true; };
};

/// Facts about a driver that do not need its device.
struct DriverFacts {
    const char* key = "";  ///< in files: "stream"
    const char* name = ""; ///< English, translation context "bask::Device"
    DriverLink link = DriverLink::Serial;
    SerialSettings serial{}; ///< usual factory settings of its devices
    /// Whether its devices have a unit and a profile, and share a line with others of this kind.
    bool isModbus = false;
};

/// Returns the key of its devices' port in files.
inline const char* portKey(const DriverFacts& driver) {
    return driver.link == DriverLink::Program ? "command" : "port";
}

struct RobotDriver : DriverFacts {
    std::vector<DeviceParameter<RobotDeviceSpec>> parameters;
    std::vector<AxisSpec> usualAxes;
    bool canHome = false; ///< if true, the spec may say whether it must be homed
    /// `mayGo` approves each position before the robot is sent there.
    MadeDevice<Robot> (*make)(DriverLinks& links, const RobotDeviceSpec& spec, const AxisMap& axes,
                              std::function<bool(const Vector6d&)> mayGo) = nullptr;
};

struct ThermometerDriver : DriverFacts {
    std::vector<DeviceParameter<ThermometerDeviceSpec>> parameters;
    int maxChannels = 64; ///< if no profile gives the number
    /// Makes the device with one channel for each object, or with all channels of the device if the spec
    /// lists none.
    MadeDevice<Thermometer> (*make)(DriverLinks& links, const ThermometerDeviceSpec& spec) = nullptr;
};

struct HeatSourceDriver : DriverFacts {
    std::vector<DeviceParameter<HeatSourceDeviceSpec>> parameters;
    bool hasProbe = false; ///< whether it has an external probe, which may be at the surface
    /// Makes the device. A heater on a serial line also provides the program that switches it off.
    MadeDevice<HeatSource> (*make)(DriverLinks& links, const HeatSourceDeviceSpec& spec) = nullptr;
};

/// Return the drivers in the order in which they are offered.
const std::vector<RobotDriver>& robotDrivers();
const std::vector<ThermometerDriver>& thermometerDrivers();
const std::vector<HeatSourceDriver>& heatSourceDrivers();
/// Returns the drivers of a role; a camera has none.
std::vector<const DriverFacts*> driversOf(DeviceRole role);

/// Return the driver of a spec. Throw std::invalid_argument for a key that is not in the catalogue.
const RobotDriver& driverOf(const RobotDeviceSpec& spec);
const ThermometerDriver& driverOf(const ThermometerDeviceSpec& spec);
const HeatSourceDriver& driverOf(const HeatSourceDeviceSpec& spec);

/// Returns the line with that name in a table of values that the spec has.
template <class Spec>
DeviceParameter<Spec> deviceParameter(ParameterTable<Spec> table, const std::string& name, SetupStep step) {
    for (const Parameter<Spec>& p : table)
        if (p.name == name)
            return {&p, step, p.isWhole(), [&p](const Spec& spec) { return p.get(spec).value(); },
                    [&p](Spec& spec, double si) { p.set(spec, si); }};
    throw std::invalid_argument("a parameter that is not in the table: " + name);
}

/// Returns the lines of a driver's own table; `settingsFrom` converts the spec's `own` back to its struct.
template <class Spec, class Settings>
std::vector<DeviceParameter<Spec>> ownParameters(ParameterTable<Settings> table, SetupStep step) {
    std::vector<DeviceParameter<Spec>> out;
    for (const Parameter<Settings>& p : table)
        out.push_back({&p, step, p.isWhole(),
                       [&p](const Spec& spec) {
                           const auto it = spec.own.find(keyOf(p));
                           return it == spec.own.end() ? p.get(Settings()).value() : it->second;
                       },
                       [&p](Spec& spec, double si) { spec.own[keyOf(p)] = si; }});
    return out;
}

} // namespace bask
