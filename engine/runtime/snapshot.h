#pragma once
// What the engine sends to the GUI, by value, about 20 times a second; faults and state changes are sent at
// once.

#include "engine/base/message.h"
#include "engine/base/run_state.h"
#include "engine/control/controller_settings.h"
#include "engine/devices/device.h"
#include "engine/drivers/found_units.h"
#include "engine/drivers/serial_ports.h"
#include "engine/model/alarm.h"
#include "engine/model/run_labels.h"
#include "engine/model/trace.h"
#include "engine/runtime/unasked_fall.h"
#include "engine/runtime/zeroing.h"

#include <cstdint>
#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace bask {

class TrafficLog;

bool isRunOn(RunState state); ///< true also in a hold and in the retreat

/// How the source is followed.
struct SourceTracking {
    bool isSeen = false;
    bool isPredicted = false;                 ///< extrapolated from the last sight
    double age_s = 0.0;                       ///< age of the last sight
    double latency_s = 0.0;                   ///< from exposure to pose; 0 if unknown
    double position_m = 0.0, angle_rad = 0.0; ///< two standard deviations; 0 if unknown
};

/// How far an object's sensor is trusted.
enum class SensorTrust {
    Trusted,
    Stale,     ///< no new value, or exactly the same value for longer than its noise allows
    Distrusted ///< its readings did not fit the heat balance, and nobody has confirmed it
};

/// How well the robot's position is known.
enum class PlaceState {
    Sure,
    Unsure, ///< it reports a position that may be wrong: restarted, not homed, homing
    Unknown ///< it does not answer, or has reported nothing new for too long
};

/// The state of a device that is being tried.
struct TriedDevice {
    RigDeviceState state;
    std::vector<double> temperatures_K;  ///< all channels of a thermometer, the source, or least and
                                         ///< largest of a thermal picture; NaN: no value
    std::optional<Vector6d> coordinates; ///< of a robot
};

/// A fault that the simulated rig has now.
struct ActiveFault {
    SimulatedFault fault = SimulatedFault::None;
    std::size_t object = 0; ///< of a fault of one object
    bool operator==(const ActiveFault&) const = default;
};

/// Where a run has the source, and how soon it would be there.
struct SourceWarmUp {
    static constexpr double kWarm_K = 5.0; ///< within this of its set point the source is warm

    double setPoint_K = 0.0; ///< of the run that is on, or else of one that starts now
    /// Until it is warm if it is heated from now on, s; empty: not known.
    std::optional<double> in_s{};
};

/// The next action that the engine takes by itself unless something changes.
struct PendingAction {
    Message action; ///< ActionHold, ActionEndRun, ActionHeatOff or ActionRetreat
    Message cause;  ///< the alarm, or the condition that will become one
    double in_s = 0.0;
};

/// State of the engine at one moment. `newSamples`, `newEvents` and `newNotes` contain everything since the
/// last snapshot, up to EngineWorker::kMaxKept rows of each.
struct Snapshot {
    std::uint64_t sequence = 0;
    RunState state = RunState::Idle;
    std::vector<Message> reasons;         ///< why it is not ready, in a hold or in a fault
    Message remedy;                       ///< what to do now about the reasons; code None: nothing
    std::optional<PendingAction> pending; ///< the next action that the engine takes by itself
    bool canRetreat = false;              ///< the robot answers and can move
    bool isAway = false;                  ///< it is as far off the source as a retreat moves it
    std::vector<Alarm> alarms;            ///< sorted by AlarmLog
    std::vector<ActiveFault> faults;      ///< as the devices of the simulated rig have them
    std::optional<SourceWarmUp> warmUp;   ///< empty without an experiment
    bool simulated = true;
    std::uint64_t loadId = 0; ///< increases with each loaded experiment
    /// of the rig (simulated time if simulated); restarts with each load that is no edit
    double clock_s = 0.0;
    std::uint64_t runId = 0;          ///< increases with each Arm: a new trace begins
    double runTime_s = 0.0;           ///< since Start; 0 before
    TraceSample latest;               ///< newest readings, also outside of a run
    double sampleTime_s = 0.0;        ///< time of the newest readings on the rig's clock
    double sampleAge_s = 0.0;         ///< age of the newest readings
    std::vector<SensorTrust> sensors; ///< for each object
    /// for each object's newest accepted reading; infinite if there is none
    std::vector<double> readingAges_s;
    /// newest plausible value of each sensor, trusted or not; NaN if there is none
    std::vector<double> toldReadings_K;
    /// standard uncertainty of each object's measured temperature, K; NaN if it is not known
    std::vector<double> uncertainties_K;
    std::vector<TraceSample> newSamples;
    std::vector<TraceEvent> newEvents;
    std::vector<TraceNote> newNotes;
    std::string experiment;           ///< its title
    std::vector<std::string> objects; ///< names of its objects
    RunLabels labels;                 ///< who operates now, and what is heated
    std::string recordingPath;        ///< empty if nothing is recorded and the last recording is closed
    std::size_t recordedRows = 0;
    bool isRecordedUntilCold =
        false;                   ///< the run has ended, its time and its recording go on until all is cold
    double loopRate_Hz = 0.0;    ///< control steps per second of real time
    std::uint64_t lateSteps = 0; ///< control steps that were late or lost
    double simulationSpeed = 1.0;
    /// newest valid or typed temperature of the source; empty if there is none
    std::optional<double> source_K;
    /// Age of latest.source_K, which is kept; infinite if there was none yet.
    double sourceAge_s = std::numeric_limits<double>::infinity();
    PlaceState place = PlaceState::Unknown; ///< of the robot
    /// Age of latest.coordinates; infinite if the robot has reported none.
    double placeAge_s = std::numeric_limits<double>::infinity();
    HeatState heat = HeatState::Unknown;      ///< heat of the source, as the device confirms it
    std::optional<UnaskedFall> unaskedFall{}; ///< while the source counts as heating though its heat is off
    bool heatOn = false;   ///< commanded, or not yet confirmed off; says nothing about a source that is lost
    bool isMoving = false; ///< the robot moves by MoveTo, Jog or HomeRobot
    std::optional<SourceTracking> tracking;       ///< empty if the source is not followed
    std::vector<RigDeviceState> devices;          ///< devices of a real rig; empty for a simulated one
    Message robotAlarm;                           ///< why the robot cannot move; code None if it can
    bool isPlaceSure = true;                      ///< whether the position of the robot is sure
    std::optional<double> heatSetPoint_K;         ///< set point now, manual or of the run; empty if off
    bool isSourceManual = false;                  ///< a person heats the source and types its temperature
    std::optional<std::vector<SerialPort>> ports; ///< once, after ListPorts
    std::optional<TriedDevice> tried;
    std::optional<ModbusSearchState> search;   ///< the one that FindUnits began
    std::shared_ptr<const TrafficLog> traffic; ///< of all links to real devices; lives as long as the engine
    std::optional<Zeroing> zeroing;            ///< newest zeroing of the sensors
    Message zeroProblem; ///< why the sensors cannot be zeroed now; code None if they can
    ControllerSettings controller;
    std::vector<double> targets_K;
    Message refusal; ///< the last refused command; code None if there was none since the last snapshot
};

/// Whoever is told of the engine beside the window, on the engine's thread: neither function may wait.
struct EngineWatch {
    std::function<bool()> isWanted; ///< whether anybody wants to know now
    std::function<void(const Snapshot&)> tell;
};

} // namespace bask
