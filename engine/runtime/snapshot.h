#pragma once
// What the engine tells the GUI, by value, about 20 times a second; faults and state changes at once.

#include "engine/base/message.h"
#include "engine/base/run_state.h"
#include "engine/control/controller_settings.h"
#include "engine/devices/device.h"
#include "engine/drivers/serial_ports.h"
#include "engine/model/alarm.h"
#include "engine/model/trace.h"
#include "engine/runtime/zeroing.h"

#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace bask {

bool isRunOn(RunState state); ///< also held, and in its retreat

/// How the source is followed.
struct SourceTracking {
    bool isSeen = false;
    bool isPredicted = false;                 ///< carried on from what was seen last
    double age_s = 0.0;                       ///< of what was seen last
    double latency_s = 0.0;                   ///< from the light caught to the pose known; 0: not told
    double position_m = 0.0, angle_rad = 0.0; ///< two standard deviations; 0: not told
};

/// How far an object's sensor is believed.
enum class SensorTrust {
    Trusted,
    Stale,     ///< it gives no new value, or the very same one for longer than its noise lets it
    Distrusted ///< it left what the heat can do, and nobody has confirmed it
};

/// What is known of where the robot is.
enum class PlaceState {
    Sure,
    Unsure, ///< it says where it is, and may be wrong: restarted, not homed, homing
    Unknown ///< it does not answer, or has told nothing new for too long
};

/// What a device says that is tried.
struct TriedDevice {
    RigDeviceState state;
    std::vector<double> temperatures_K; ///< of all channels of a thermometer, or of the source; NaN: no value
    std::optional<Vector6d> coordinates; ///< of a robot
};

/// What the engine will do by itself unless something changes.
struct PendingAction {
    Message action; ///< ActionHold, ActionEndRun, ActionHeatOff or ActionRetreat
    Message cause;  ///< the alarm, or what will be one
    double in_s = 0.0;
};

/// State of the engine at one moment. `newSamples` and `newEvents` are everything since the last snapshot:
/// none is dropped.
struct Snapshot {
    std::uint64_t sequence = 0;
    RunState state = RunState::Idle;
    std::vector<Message> reasons; ///< why not ready, holding or faulted, each a sentence with its remedy
    Message remedy;               ///< what to do now, in this state, about the reasons; None: nothing
    std::optional<PendingAction> pending; ///< the next thing that the engine does by itself
    bool canRetreat = false;              ///< the robot answers and can move
    std::vector<Alarm> alarms;            ///< as AlarmLog sorts them
    bool simulated = true;
    std::uint64_t loadId = 0;           ///< grows with each experiment that is loaded
    double clock_s = 0.0;               ///< of the rig, simulated where that is; another one after each load
    std::uint64_t runId = 0;            ///< grows with each Arm: a new trace begins
    double runTime_s = 0.0;             ///< since Start; 0 before
    TraceSample latest;                 ///< newest readings, also outside a run
    double sampleTime_s = 0.0;          ///< of the newest readings, by the rig's clock
    double sampleAge_s = 0.0;           ///< of them
    std::vector<SensorTrust> sensors;   ///< of each object
    std::vector<double> readingAges_s;  ///< of each object's newest believed reading; infinite: there is none
    std::vector<double> toldReadings_K; ///< newest plausible value of each sensor, believed or not; NaN: none
    std::vector<TraceSample> newSamples;
    std::vector<TraceEvent> newEvents;
    std::vector<TraceNote> newNotes;
    std::string recordingPath; ///< empty: nothing recorded, and the last recording is closed
    std::size_t recordedRows = 0;
    double loopRate_Hz = 0.0;    ///< control steps a wall second
    std::uint64_t lateSteps = 0; ///< steps that began more than half a period late
    double simulationSpeed = 1.0;
    std::optional<double> source_K; ///< its newest valid reading, or as typed; empty: none
    /// Of latest.source_K, which is kept; infinite: there was none yet.
    double sourceAge_s = std::numeric_limits<double>::infinity();
    PlaceState place = PlaceState::Unknown; ///< of the robot
    /// Of latest.coordinates; infinite: it has told none.
    double placeAge_s = std::numeric_limits<double>::infinity();
    HeatState heat = HeatState::Unknown; ///< of the source, as the device confirms it
    bool heatOn = false;   ///< wanted, or not yet seen to be off; says nothing of a source that is lost
    bool isMoving = false; ///< the robot, by MoveTo
    std::optional<SourceTracking> tracking;       ///< empty: the source is not followed
    std::vector<RigDeviceState> devices;          ///< of a real rig; a simulated one has none
    Message robotAlarm;                           ///< what keeps the robot from moving; None: nothing
    bool isPlaceSure = true;                      ///< of the robot
    std::optional<double> heatSetPoint_K;         ///< asked for now, by hand or by the run; empty: off
    bool isSourceManual = false;                  ///< a person keeps it hot and types its temperature
    std::optional<std::vector<SerialPort>> ports; ///< once, after ListPorts
    std::optional<TriedDevice> tried;
    std::optional<Zeroing> zeroing; ///< of the sensors, newest
    Message zeroProblem;            ///< why they cannot be zeroed now; None: they can
    ControllerSettings controller;
    std::vector<double> targets_K;
    Message refusal; ///< last command refused, code None if none since the last snapshot
};

} // namespace bask
