#pragma once
// Random experiments for the study of alarms: healthy ones, and ones with a fault.

#include "engine/model/experiment.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace bask {

/// What the study draws.
enum class AlarmDraw {
    Healthy, ///< everything at random within the range without alarms
    Faulty,  ///< the same with one fault at a random time and object; each fault in turn
    Paper    ///< the experiments unchanged: every seed, with its own controller and with the level servo
};

/// An operator's action at a time of the run.
struct AlarmAction {
    enum class Kind { SetTargets, Hold, Resume, Stop };
    double time_s = 0.0; ///< since the first Start
    Kind kind = Kind::SetTargets;
    std::vector<double> targets_K{}; ///< for SetTargets; for Stop those of the next run, empty: none
};

struct AlarmCase {
    Experiment experiment;
    std::vector<AlarmAction> actions; ///< in order of time
    ScriptedFault fault;              ///< None: healthy
    double offLag_s = 0.0;            ///< of a sensor that comes off, see SimulatedThermometer::setOffLag
    double duration_s = 0.0;
};

/// Ranges of the drawn experiments.
inline constexpr double kAlarmRun_s = 1800.0;
inline constexpr double kAlarmEstimateFactor = 4.0; ///< estimated rates are wrong by up to this factor
inline constexpr double kAlarmConvection_W_m2K = 15.0;
inline constexpr double kAlarmLag_s = 5.0;
inline constexpr double kAlarmOffLag_s = 15.0; ///< of sensors in still air
inline constexpr double kAlarmMinRise_K = 5.0; ///< smallest distance of a target above the room's temperature
inline constexpr double kAlarmMaxTarget_K = 363.15;
/// Emittances that the camera believes are wrong by up to this, twice their standard uncertainty.
inline constexpr double kAlarmEmittance = 0.02;

/// Faults that a run can have whose objects are read so, in the order in which they are drawn: those of
/// sensors where there are any, swapped ones where the thermal camera tells them.
std::vector<SimulatedFault> alarmFaults(ReadBy readBy);

/// Returns how often a laboratory meets a fault, times in 1,000 h of runs. This is our estimate, because
/// nobody has counted at such rigs. Loose and broken wires of sensors and hands in front of a marker are the
/// most frequent; a relay that sticks is rare.
double alarmFaultFrequency(SimulatedFault fault);

/// Returns draw number `index` (from 0), which depends only on the other arguments. Shapes, mountings,
/// workspace and the source's shape are taken from one of the `rigs` (for Paper the whole experiment). All
/// objects are read by `readBy`; with Both a healthy run is the same as with Contact, but for its second
/// opinion, with Camera it begins and ends where the camera reads all objects. Throws std::invalid_argument
/// for rigs without poses that keep the objects warm, or without the two objects whose sensors are swapped.
AlarmCase drawAlarmCase(const std::vector<Experiment>& rigs, AlarmDraw draw, ReadBy readBy,
                        std::uint64_t seed, int index);

} // namespace bask
