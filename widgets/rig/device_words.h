#pragma once
// A rig's devices by role: words for them, and the parts of a RigSpec that belong to one.

#include "engine/drivers/driver_catalogue.h"
#include "engine/model/experiment.h"
#include "engine/runtime/snapshot.h"

#include <QString>

#include <array>

namespace bask {

/// Its newest reading; NaN while that is not valid, or the source does not answer.
double sourceTemperature_K(const Snapshot& snapshot);

/// "182.3 °C" as it is now; the last one with its age, "182.3 °C, 12 s old", where nothing newer is known; a
/// dash without any.
QString sourceReadingText(const Snapshot& snapshot, TemperatureUnit unit);

inline constexpr std::array kDeviceRoles{DeviceRole::Robot, DeviceRole::Thermometer, DeviceRole::HeatSource,
                                         DeviceRole::Camera};

const char* roleName(DeviceRole role); ///< "robot", for object names
QString roleWord(DeviceRole role);     ///< "Robot"
QString linkWord(LinkState state);     ///< "Live"

QString driverWord(const DriverFacts& driver); ///< "Grbl or grblHAL (G-code)"

bool hasDevice(const RigSpec& rig, DeviceRole role);
QString driverText(const RigSpec& rig, DeviceRole role); ///< "Grbl or grblHAL"; empty without the device
QString portText(const RigSpec& rig, DeviceRole role);   ///< empty without one, or by hand
RigSpec withoutDevice(RigSpec rig, DeviceRole role);
/// `rig` with the device of this role as `other` has it.
RigSpec withDevice(RigSpec rig, DeviceRole role, const RigSpec& other);

/// "12 ms", "3.2 s", "2:05"; empty: it never answered.
QString ageText(double age_s);

/// Objects came or went: each that stays, by its name, keeps its channel, new ones have the lowest that are
/// free. With as many as before nothing changes.
void keepChannels(const std::vector<ObjectSpec>& before, const std::vector<ObjectSpec>& after,
                  std::vector<int>& channels);

/// For so many objects: those there are, then the lowest that are free.
std::vector<int> channelsFor(std::vector<int> channels, std::size_t objects);

} // namespace bask
