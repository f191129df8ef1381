#pragma once
// A rig's devices by role: words for them, and the parts of a RigSpec that belong to one.

#include "engine/drivers/driver_catalogue.h"
#include "engine/model/experiment.h"
#include "engine/runtime/snapshot.h"

#include <QString>

#include <array>

namespace bask {

/// Returns whether a message tells that the robot's place is not sure: homing is the remedy.
bool isAboutPlace(MessageCode code);
/// Returns whether the engine homes the robot now.
bool allowsHome(const Snapshot& snapshot);
/// Returns what a reason about the place says once that is sure again and its fault is still latched; empty
/// before.
QString placeSureAgainText(const Snapshot& snapshot);

/// Returns the source's newest reading; NaN if it is not valid, or the source does not answer.
double sourceTemperature_K(const Snapshot& snapshot);

/// Returns "182.3 °C" if it is current; otherwise the last one with its age, "182.3 °C, 12 s old"; a dash if
/// there was none.
QString sourceReadingText(const Snapshot& snapshot, TemperatureUnit unit);

inline constexpr std::array kDeviceRoles{DeviceRole::Robot, DeviceRole::Thermometer, DeviceRole::HeatSource,
                                         DeviceRole::Camera, DeviceRole::ThermalCamera};

/// What is known of the source's heat.
enum class ShownHeat {
    Off,
    On,
    Unknown, ///< the device does not confirm it, or the engine does not answer
    Unasked, ///< the device says that it is off, and the source warms all the same
    ByHand   ///< a person heats the source and types its temperature
};

ShownHeat shownHeat(const Snapshot& snapshot, bool isAnswering = true);
QString heatWord(ShownHeat heat); ///< "heat on", "heats though off"
/// Returns the priority of the alarm whose mark and colour it has; 0 for none.
int heatPriority(ShownHeat heat);
QString rigWord(bool isSimulated); ///< "SIMULATED", "LIVE"

const char* roleName(DeviceRole role); ///< "robot", for object names
QString roleWord(DeviceRole role);     ///< "Robot"
QString linkWord(LinkState state);     ///< "Live"

QString driverWord(const DriverFacts& driver); ///< "Grbl or grblHAL (G-code)"

bool hasDevice(const RigSpec& rig, DeviceRole role);
/// returns "Grbl or grblHAL"; empty without the device
QString driverText(const RigSpec& rig, DeviceRole role);
QString portText(const RigSpec& rig, DeviceRole role); ///< empty without a port, or for a manual device
RigSpec withoutDevice(RigSpec rig, DeviceRole role);
/// Returns `rig` with the device of this role taken from `other`.
RigSpec withDevice(RigSpec rig, DeviceRole role, const RigSpec& other);

/// Returns "12 ms", "3.2 s", "2:05"; empty if it never answered.
QString ageText(double age_s);

/// Returns the names of the objects with a sensor on them: each has a channel.
std::vector<std::string> withSensors(const std::vector<ObjectSpec>& objects);

/// Adapts the channels to added or removed sensors: an object with the same name keeps its channel, new ones
/// get the lowest free ones. If the number is the same, nothing changes.
void keepChannels(const std::vector<ObjectSpec>& before, const std::vector<ObjectSpec>& after,
                  std::vector<int>& channels);

/// Returns channels for this number of sensors: the existing ones, then the lowest free ones.
std::vector<int> channelsFor(std::vector<int> channels, std::size_t sensors);

} // namespace bask
