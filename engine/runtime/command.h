#pragma once
// Commands of the GUI to the engine: small values, queued.

#include "engine/calibration/board.h"
#include "engine/control/controller_settings.h"
#include "engine/devices/device.h"
#include "engine/drivers/found_units.h"
#include "engine/model/experiment.h"
#include "engine/model/predicted_run.h"
#include "engine/model/run_labels.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace bask {

struct LoadExperiment {
    Experiment experiment;
    /// Whether it is an edit of the one that is loaded: a simulated rig then stays as warm as it is.
    bool isEdit = false;
}; ///< refused while a run is armed or on
struct Arm {
    std::string recordingPath;
    bool mayReplace = false; ///< an earlier recording of that name; else it is refused
}; ///< zeroes the sensors if they are not zeroed; starts the recording, unless the path is empty
struct Disarm {};
struct Start {
    bool acceptInfeasible = false;
};
struct Hold {}; ///< zero velocity; the controller keeps its state, the heat stays on
struct Resume {};
struct Stop {};          ///< ends the run: retreat, heat off
struct EmergencyStop {}; ///< zero velocity and heat off at once, latched
/// Moves the objects away from the source and switches the heat off, in every state in which the robot can
/// move (Snapshot::canRetreat). Does not clear a fault. Ends a run as Stop does.
struct Retreat {};
struct Reset {}; ///< clears a latched fault or emergency stop; never starts a run
struct SetTargets {
    std::vector<double> targets_K;
};
/// Reports why the targets of the current run cannot be held, as found by the code that set them: an event of
/// the run.
struct ReportInfeasible {
    Message reason;
};
struct SetController {
    ControllerSettings settings;
};
struct AddNote {
    std::string text;
};
/// Says who operates from now on, and what the next run heats. Commands, notes and acknowledgements are
/// recorded with their operator. While a run is armed or on, another sample or batch is refused.
struct SetLabels {
    RunLabels labels;
};
struct SetSimulationSpeed {
    double factor = 1.0;
}; ///< simulated s/s, 1..20; 1 in a hold, less if the camera that follows the source is late
/// Replaces all simulated faults; None ends them. With isOn false it ends this one, and the others stay.
struct SimulateFault {
    SimulatedFault fault = SimulatedFault::None;
    std::size_t object = 0;
    bool isOn = true;
};

/// Acknowledges the alarm with this number in the snapshot.
struct AcknowledgeAlarm {
    std::uint64_t id = 0;
};
struct AcknowledgeAll {};
/// Shelves an alarm for 60 s to kLongest_s, one of priority 1 for at most kLongestGrave_s. Refused without a
/// reason, and for an alarm that is a consequence of another one. Does not change what the engine does.
struct ShelveAlarm {
    static constexpr double kLongest_s = 8.0 * 3600.0;
    static constexpr double kLongestGrave_s = 1800.0;
    std::uint64_t id = 0;
    double for_s = 600.0;
    std::string reason;
};
/// Ends the shelving of an alarm at once.
struct UnshelveAlarm {
    std::uint64_t id = 0;
};
/// Ends the recording that continues after a run until everything is cold. Refused while a run is armed or
/// on.
struct EndRecording {};

/// Sets markers and calibrations. Refused while a run is armed or on.
struct SetVision {
    VisionSpec vision;
};
/// Shows live pictures with what was found in them. A simulated rig holds the board in front of its camera;
/// while a run is armed or on there is no board, and none is searched for.
struct WatchCamera {
    bool show = false;
    std::optional<Board> board;
};
/// Shows the pictures of the rig's thermal camera. The board is as in WatchCamera, but the pictures' receiver
/// searches for it.
struct WatchThermalCamera {
    bool show = false;
    std::optional<Board> board{};
};
/// Selects the camera that is watched: a device, file, folder or address as VideoCamera takes it. An empty
/// name selects the simulated one, which also follows the source. Refused while a run is armed or on.
struct ChooseCamera {
    std::string name;
};
/// Moves the end-effector to these coordinates in R while no run is armed or on; Hold stops the move.
struct MoveTo {
    Vector6d coordinates = Vector6d::Zero();
};

/// Moves the robot while a button is pressed: the end-effector's twist in R axes (m/s, rad/s), within its
/// limits, workspace and clearance. Ends kJog_s after the last command. Only while no run is armed or on.
struct Jog {
    static constexpr double kJog_s = 0.5;
    Vector6d twist = Vector6d::Zero();
};
/// Homes the robot with its switches: it moves. Refused while a run is armed or on.
struct HomeRobot {};
/// Clears the robot's alarm after a person has removed its cause; never moves the robot. Also confirms that
/// the reported position is right.
struct ClearRobotAlarm {};
/// Manual heating to this set point until it is switched off, while no run is armed or on and no sensor is
/// lost. Empty: heat off, in every state; this stops a run.
struct SetHeat {
    std::optional<double> setPoint_K;
};
/// Temperature of a manually controlled heat source, as a person has measured it.
struct TypeSourceTemperature {
    double temperature_K = 0.0;
};
/// Zeroes the sensors against each other at ambient temperature. The result stays valid while the thermometer
/// and the number of objects stay the same. Refused while a run is armed or on, while heat is on, and if the
/// objects are not at ambient temperature.
struct ZeroSensors {};
/// A person confirms that the sensor is on its object and correct: its current reading is trusted. Refused if
/// it gives no plausible value.
struct ConfirmSensor {
    std::size_t object = 0;
};
/// Asks for the serial ports; answered by Snapshot::ports.
struct ListPorts {};
/// Tries one device, separately from the rig in use. Answered by Snapshot::tried until another device is
/// tried, or this command is sent without a device. The port must not be in use.
struct TryDevice {
    RigSpec rig; ///< with this one device
};

/// Looks for Modbus units at a port, and for the profiles that fit; it only reads. Answered by
/// Snapshot::search until another search begins, or this command is sent without one. Refused while a run is
/// armed or on, the heat is on or the robot moves; ended by what begins one of these. No device of the rig
/// may have the port.
struct FindUnits {
    std::optional<ModbusSearchSpec> spec;
    int number = 0; ///< that its answers have
};
/// Sends up to LoggedLink::kMaxByHand bytes of a person to a device, as they are: Bask does not know what
/// they do. Its driver has the link back 3 s later. Refused while a run is armed or on, the heat is on or the
/// robot moves, and if the link is not open.
struct SendByHand {
    std::string link; ///< its name, one of TrafficLog::openLinks()
    std::string bytes;
};

/// Accepts the device that answers in the place of the remembered one. After that the position of the robot
/// is unsure. Refused while a run is armed or on, and while heat is on.
struct AcceptDevice {
    DeviceRole role = DeviceRole::Robot;
};

/// A person has looked at a program and allows Bask to start it, until it changes. It is kept for this
/// computer, or only for as long as this engine runs.
struct ConfirmProgram {
    std::string command;
    std::string hash; ///< as programFiles() makes it
    bool isKept = true;
};

/// Keeps the prediction of the run that is on with its recording; without one nothing is done.
struct KeepPrediction {
    std::uint64_t runId = 0; ///< Snapshot::runId
    std::shared_ptr<const PredictedRun> run;
};

using Command =
    std::variant<LoadExperiment, Arm, Disarm, Start, Hold, Resume, Stop, EmergencyStop, Reset, Retreat,
                 EndRecording, SetTargets, ReportInfeasible, SetController, AddNote, SetLabels,
                 SetSimulationSpeed, SimulateFault, AcknowledgeAlarm, AcknowledgeAll, ShelveAlarm,
                 UnshelveAlarm, SetVision, WatchCamera, WatchThermalCamera, ChooseCamera, MoveTo, Jog,
                 HomeRobot, ClearRobotAlarm, SetHeat, TypeSourceTemperature, ZeroSensors, ConfirmSensor,
                 ListPorts, TryDevice, FindUnits, SendByHand, AcceptDevice, ConfirmProgram, KeepPrediction>;

} // namespace bask
