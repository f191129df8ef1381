#pragma once
// Experiments drawn at random for the study of alarms: healthy ones, and ones with a fault.

#include "engine/model/experiment.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace bask {

/// What the study draws.
enum class AlarmDraw {
    Healthy, ///< everything at random within what the watches must bear
    Faulty,  ///< the same with one fault at a random time and object; each fault in turn
    Paper    ///< the experiments as they are: every seed, by its controller and by the level servo
};

/// What an operator does at a time of the run.
struct AlarmAction {
    enum class Kind { SetTargets, Hold, Resume, Stop };
    double time_s = 0.0; ///< since the first Start
    Kind kind = Kind::SetTargets;
    std::vector<double> targets_K{}; ///< of SetTargets; of Stop those of the run that follows, empty: none
};

struct AlarmCase {
    Experiment experiment;
    std::vector<AlarmAction> actions; ///< by time
    ScriptedFault fault;              ///< None: healthy
    double offLag_s = 0.0;            ///< of a sensor that comes off, see SimulatedThermometer::setOffLag
    double duration_s = 0.0;
};

/// What the drawn experiments are within.
inline constexpr double kAlarmRun_s = 1800.0;
inline constexpr double kAlarmBelief = 4.0; ///< believed rates are wrong within this factor
inline constexpr double kAlarmConvection_W_m2K = 15.0;
inline constexpr double kAlarmLag_s = 5.0;
inline constexpr double kAlarmOffLag_s = 15.0; ///< of sensors in still air
inline constexpr double kAlarmMinRise_K = 5.0; ///< of a target over the room
inline constexpr double kAlarmMaxTarget_K = 363.15;

/// Faults that a run can have, in the order in which they are drawn.
const std::vector<SimulatedFault>& alarmFaults();

/// How often a laboratory meets a fault, times in 1,000 h of runs: an estimate of ours, since nobody has
/// counted at such rigs. Loose and broken wires of sensors and hands before a marker lead; a relay that
/// sticks is rare.
double alarmFaultFrequency(SimulatedFault fault);

/// Draw number `index` (from 0), of seed and index alone. `rigs`: shapes, mountings, workspace and source's
/// shape are taken from one of them (of Paper the whole experiment). Throws std::invalid_argument on rigs
/// without poses that hold the objects warm.
AlarmCase drawAlarmCase(const std::vector<Experiment>& rigs, AlarmDraw draw, std::uint64_t seed, int index);

} // namespace bask
