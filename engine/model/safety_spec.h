#pragma once
// What an experiment says of its own safety: limits that the engine watches in every state, and faults that
// the simulated rig is to have.

#include "engine/base/units.h"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace bask {

/// An object's limits are absolute, since they are what it, its paint and its sensor bear: limits that
/// followed the target would follow a mistyped one up, and would trip when a target is lowered. The source's
/// limit, left out, lies over its own set point: that one is what its maker's limits and the plate are for.
struct SafetySpec {
    double warning_K = kelvinFromCelsius(120.0); ///< of an object without one of its own
    double trip_K = kelvinFromCelsius(150.0);
    std::optional<double> sourceTrip_K{}; ///< empty: kSourceOver_K above its highest set point
    double stalePeriods = 3.0;            ///< a reading is used for so many periods
    double heldLimit_s = 15.0;            ///< a lost sensor or source holds so long, then retreat
    /// Faster changes of a reading are no heat; empty: three times what the source can do to the object,
    /// kMinRate_K_s at least.
    std::optional<double> largestRate_K_s{};
    int jumps = 3;                  ///< readings in a row that are too fast: a sensor fault
    double frozen_s = 30.0;         ///< the very same value for so long, though it must have changed
    double warming_K = 2.0;         ///< change that must have come before none is an alarm
    double crossCheck_K = 5.0;      ///< sensors that far apart in a rig that is cold
    double sourceHeating_s = 120.0; ///< the source gains kSourceGain_K in this time while it is too cold
    double sourceBand_K = 10.0;     ///< and is not too cold within this of its set point
    double sourceUnasked_K = 10.0;  ///< more warming with its heat off is an alarm
    double leastDisk_MB = 100.0;    ///< free where a recording goes; below it none is begun

    static constexpr double kSourceOver_K = 50.0;
    static constexpr double kMinRate_K_s = 2.0; ///< a hand on the object
    static constexpr double kSourceGain_K = 2.0;
    bool operator==(const SafetySpec&) const = default;
};

/// What the simulated rig can be made to do: what the alarm table is about.
enum class SimulatedFault {
    None,
    // Of one object
    SensorLost,    ///< gives no value
    SensorOpen,    ///< and says so
    SensorShort,   ///< and says so
    SensorFrozen,  ///< gives its last value
    SensorJumping, ///< by 30 K, to and fro
    SensorOff,     ///< came off its object: reads the room
    ObjectHot,     ///< heated by something else, 2 K/s
    // Of the rig
    RobotLost,
    RobotAlarm,
    RobotRestarted, ///< stands, and is not sure of its place
    RobotSlow,      ///< tells nothing new, and obeys 5 s late
    SourceLost,
    SourceSilent,     ///< tells no temperature
    SourceNotHeating, ///< takes orders, and cools
    SourceHeatsAlone, ///< 1 K/s with its heat off
    SourceOverheats,  ///< 2 K/s, whatever its set point
    SourceLimited,    ///< to 20 K below its set point, and says so
    SourceKeepsHeat,  ///< takes no order to switch off
    SourceCovered,
    CameraLost
};
inline constexpr int kSimulatedFaults = static_cast<int>(SimulatedFault::CameraLost) + 1;

/// "sensor-lost"; of None "none".
const char* simulatedFaultName(SimulatedFault fault);
/// That of one object's sensor or of the object itself.
bool isOfObject(SimulatedFault fault);

/// Raised at a run time, and over again.
struct ScriptedFault {
    double time_s = 0.0;
    SimulatedFault fault = SimulatedFault::None;
    std::size_t object = 0;
    std::optional<double> until_s{}; ///< empty: to the end
    bool operator==(const ScriptedFault&) const = default;
};

} // namespace bask
