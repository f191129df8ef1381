#pragma once
// The safety settings of an experiment: limits that the engine monitors in every state, and faults of the
// simulated rig.

#include "engine/base/units.h"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace bask {

/// An object's limits are absolute, because they are what the object, its paint and its sensor tolerate:
/// limits relative to the target would follow a mistyped target up, and would trip when a target is lowered.
/// If the source's limit is empty, it is a margin above its own set point, for which the plate and its
/// maker's limits are made.
struct SafetySpec {
    double warning_K = kelvinFromCelsius(120.0); ///< for an object without its own limit
    double trip_K = kelvinFromCelsius(150.0);
    std::optional<double> sourceTrip_K{}; ///< if empty, kSourceOver_K above the highest set point
    double stalePeriods = 3.0;            ///< number of periods for which a reading is valid
    double pauseLimit_s = 15.0;           ///< pause after a lost sensor or source; then a retreat
    /// A faster change of a reading is not caused by heat. If empty: three times the rate at which the source
    /// can heat the object, but at least kMinRate_K_s.
    std::optional<double> largestRate_K_s{};
    int jumps = 3; ///< number of such readings in a row that mean a sensor fault
    /// Longest time with exactly the same value, although it must have changed.
    double frozen_s = 30.0;
    double warming_K = 2.0;         ///< expected change after which a missing one is an alarm
    double crossCheck_K = 5.0;      ///< largest difference of sensors in a cold rig
    double sourceHeating_s = 120.0; ///< the source must gain kSourceGain_K in this time while it is too cold
    double sourceBand_K = 10.0;     ///< within this of its set point the source is not too cold
    double sourceUnasked_K = 10.0;  ///< more warming with the heat off is an alarm
    double minDisk_MB = 100.0;      ///< free space for a recording; with less none is started

    static constexpr double kSourceOver_K = 50.0;
    static constexpr double kMinRate_K_s = 2.0; ///< a person touching the object
    static constexpr double kSourceGain_K = 2.0;
    /// So far below a limit an object or the source no longer counts as above it.
    static constexpr double kHysteresis_K = 2.0;
    bool operator==(const SafetySpec&) const = default;
};

/// Faults of the simulated rig, which the alarm table covers.
enum class SimulatedFault {
    None,
    // Faults of one object
    SensorLost,     ///< gives no value
    SensorOpen,     ///< gives no value and reports it
    SensorShort,    ///< gives no value and reports it
    SensorFrozen,   ///< repeats its last value
    SensorJumping,  ///< jumps by 30 K, up and down
    SensorOff,      ///< has come off its object: measures the room
    SensorsSwapped, ///< gives what the sensor of the next object measures, and that one what this one does
    ObjectHot,      ///< is heated by something else, 2 K/s
    // Faults of the rig
    RobotLost,
    RobotAlarm,
    RobotRestarted, ///< stands, and is not sure of its position
    RobotSlow,      ///< reports nothing new, and obeys 5 s late
    SourceLost,
    SourceSilent,     ///< reports no temperature
    SourceNotHeating, ///< accepts commands, and cools
    SourceHeatsAlone, ///< warms by 1 K/s with its heat off
    SourceOverheats,  ///< warms by 2 K/s, at any set point
    SourceLimited,    ///< limits itself to 20 K below its set point, and reports it
    SourceKeepsHeat,  ///< does not obey the command to switch off
    SourceCovered,
    CameraLost
};
inline constexpr int kSimulatedFaults = static_cast<int>(SimulatedFault::CameraLost) + 1;

/// "sensor-lost"; of None "none".
const char* simulatedFaultName(SimulatedFault fault); ///< Returns the name, "sensor-lost"; for None "none".
/// Returns whether it is a fault of one object or its sensor.
bool isOfObject(SimulatedFault fault);

/// A fault that starts at one run time and ends at another.
struct ScriptedFault {
    double time_s = 0.0;
    SimulatedFault fault = SimulatedFault::None;
    std::size_t object = 0;
    std::optional<double> until_s{}; ///< empty: until the end of the run
    bool operator==(const ScriptedFault&) const = default;
};

} // namespace bask
