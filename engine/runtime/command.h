#pragma once
// What the GUI asks of the engine: small values, queued.

#include "engine/calibration/board.h"
#include "engine/control/controller_settings.h"
#include "engine/session/experiment.h"

#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace bask {

struct LoadExperiment {
    Experiment experiment;
}; ///< refused while a run is on
struct Arm {
    std::string recordingPath;
}; ///< zeroes the sensors if that was not done, fills the estimator, opens the recording
struct Disarm {};
struct Start {
    bool acceptInfeasible = false;
};
struct Hold {}; ///< zero velocity, controller state kept
struct Resume {};
struct Stop {};          ///< ends the run: retreat, heat off
struct EmergencyStop {}; ///< zero velocity and heat off now, latched
struct Reset {};         ///< clears a latched fault or stop; never restarts
struct SetTargets {
    std::vector<double> targets_K;
};
/// Why the targets of a run that is on cannot be held, found out by whoever set them: an event of the run.
struct ReportInfeasible {
    Message reason;
};
struct SetController {
    ControllerSettings settings;
};
struct AddNote {
    std::string text;
};
struct SetSimulationSpeed {
    double factor = 1.0;
}; ///< simulated s/s, 1..20; 1 in a hold, fewer where the camera that follows the source is behind
/// Instead of the one before; None ends it.
struct SimulateFault {
    SimulatedFault fault = SimulatedFault::None;
    std::size_t object = 0;
};

/// By its number in the snapshot: seen by a person.
struct AcknowledgeAlarm {
    std::uint64_t id = 0;
};
struct AcknowledgeAll {};

/// Markers and calibrations: refused while a run is on.
struct SetVision {
    VisionSpec vision;
};
/// Live pictures with what is in them, for the window. A simulated rig holds the board before its camera; in
/// a run there is none, and none is looked for.
struct WatchCamera {
    bool show = false;
    std::optional<Board> board;
};
/// The camera that is watched: a device, file, folder or address as VideoCamera has it; empty: the simulated
/// one, which also follows the source. Refused while a run is on.
struct ChooseCamera {
    std::string name;
};
/// End-effector to these coordinates in R, while no run is on; Hold ends it where it is.
struct MoveTo {
    Vector6d coordinates = Vector6d::Zero();
};

/// Moves the robot while it is held: the end-effector's twist in R axes (m/s, rad/s), within its limits,
/// workspace and clearance; ends kJog_s after the last of them. While no run is armed or on.
struct Jog {
    static constexpr double kJog_s = 0.5;
    Vector6d twist = Vector6d::Zero();
};
/// Finds its place by its switches: it moves. While no run is armed or on.
struct HomeRobot {};
/// After a person has seen to it; never moves. Also confirms that the robot is where it says.
struct ClearRobotAlarm {};
/// By hand, while no run is armed or on and no sensor is lost: heats towards this until it is switched off.
/// Empty: off, in every state; a run is stopped.
struct SetHeat {
    std::optional<double> setPoint_K;
};
/// Of a heat source that a person keeps hot, as measured by that person.
struct TypeSourceTemperature {
    double temperature_K = 0.0;
};
/// Against each other, at ambient: kept while thermometer and number of objects stay. Refused while a run is
/// armed or on, while heat is on, and where the objects are not at ambient.
struct ZeroSensors {};
/// Answered by Snapshot::ports.
struct ListPorts {};
/// One device alone, apart from the rig in use: answered by Snapshot::tried until another one, or one without
/// a device, is tried. Its port must not be in use.
struct TryDevice {
    RigSpec rig; ///< with one device
};

using Command = std::variant<LoadExperiment, Arm, Disarm, Start, Hold, Resume, Stop, EmergencyStop, Reset,
                             SetTargets, ReportInfeasible, SetController, AddNote, SetSimulationSpeed,
                             SimulateFault, AcknowledgeAlarm, AcknowledgeAll, SetVision, WatchCamera,
                             ChooseCamera, MoveTo, Jog, HomeRobot, ClearRobotAlarm, SetHeat,
                             TypeSourceTemperature, ZeroSensors, ListPorts, TryDevice>;

} // namespace bask
