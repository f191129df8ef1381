#pragma once
// What the GUI asks of the engine: small values, queued.

#include "engine/calibration/board.h"
#include "engine/control/controller_settings.h"
#include "engine/devices/device.h"
#include "engine/model/experiment.h"

#include <cstddef>
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
/// Takes the objects away from the source and switches the heat off, in every state in which the robot
/// answers (Snapshot::canRetreat); does not clear a fault. Ends a run as Stop does.
struct Retreat {};
struct Reset {}; ///< clears a latched fault or stop; never restarts
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
/// Puts an alarm aside for a time, 60 s to kLongest_s, of priority 1 to kLongestGrave_s; refused without a
/// reason, and for one that follows from another. Nothing that the engine does changes.
struct ShelveAlarm {
    static constexpr double kLongest_s = 8.0 * 3600.0;
    static constexpr double kLongestGrave_s = 1800.0;
    std::uint64_t id = 0;
    double for_s = 600.0;
    std::string reason;
};
/// Back at once.
struct UnshelveAlarm {
    std::uint64_t id = 0;
};
/// Ends the recording that goes on after a run, until everything is cold; refused while a run is armed or on.
struct EndRecording {};

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
/// A person has looked: the sensor is on its object and right, what it reads now is believed. Refused where
/// it gives no plausible value.
struct ConfirmSensor {
    std::size_t object = 0;
};
/// Answered by Snapshot::ports.
struct ListPorts {};
/// One device alone, apart from the rig in use: answered by Snapshot::tried until another one, or one without
/// a device, is tried. Its port must not be in use.
struct TryDevice {
    RigSpec rig; ///< with one device
};

/// Another device that answers in the place of the one that is remembered is the one from now on; the robot's
/// place is not sure then. Refused while a run is armed or on, and while heat is on.
struct AcceptDevice {
    DeviceRole role = DeviceRole::Robot;
};

using Command =
    std::variant<LoadExperiment, Arm, Disarm, Start, Hold, Resume, Stop, EmergencyStop, Reset, Retreat,
                 EndRecording, SetTargets, ReportInfeasible, SetController, AddNote, SetSimulationSpeed,
                 SimulateFault, AcknowledgeAlarm, AcknowledgeAll, ShelveAlarm, UnshelveAlarm, SetVision,
                 WatchCamera, ChooseCamera, MoveTo, Jog, HomeRobot, ClearRobotAlarm, SetHeat,
                 TypeSourceTemperature, ZeroSensors, ConfirmSensor, ListPorts, TryDevice, AcceptDevice>;

} // namespace bask
