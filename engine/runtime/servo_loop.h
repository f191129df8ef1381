#pragma once
// The state machine and the control loop of a run: reads the sensors, runs the controller, commands robot and
// heat; every exit goes through one safe state. Verbs are in servo_loop.cpp, a sampling period is in
// servo_tick.cpp, reactions to alarms are in servo_reactions.cpp.

#include "engine/base/clock.h"
#include "engine/base/message_code.h"
#include "engine/base/words.h"
#include "engine/model/experiment.h"
#include "engine/runtime/heat_orders.h"
#include "engine/runtime/latched_faults.h"
#include "engine/runtime/loop_record.h"
#include "engine/runtime/retreat_motion.h"
#include "engine/runtime/rig_readings.h"
#include "engine/runtime/robot_motion.h"
#include "engine/runtime/run_control.h"
#include "engine/runtime/safety_monitor.h"
#include "engine/runtime/snapshot.h"

#include <optional>
#include <vector>

namespace bask {

/// What is known about a real rig, for the next loop that uses it.
struct RigKnowledge {
    std::vector<LatchedFault> faults; ///< empty if a person has looked at the rig and reset
    RigAnswers answers;
    bool isRetreatRefused = false; ///< because of STOP, or of a robot that does not move
    SensorChannels sensors;        ///< including which ones are distrusted
    bool wasSourceHeated = false;
    double unaskedWarming_K = 0.0; ///< of a source that heats although its heat is off
};

/// What the record waits for after a run that has not ended as meant.
enum class RecordEnd {
    ObjectsAndSourceCold, ///< after a fault or STOP, the source as well: no hotter than a hand bears
    ObjectsCold           ///< the objects alone, where somebody waits for the record's end
};

/// One experiment on one rig. The owner calls tick() once in every sampling period of the clock. A verb that
/// does not fit the state is refused with a message. No exception leaves tick(): it becomes a fault with the
/// heat off and the robot at a standstill. One thread.
class ServoLoop {
public:
    ServoLoop(const Experiment& experiment, RigDevices devices, const Clock& clock);
    ~ServoLoop();
    ServoLoop(const ServoLoop&) = delete; // its parts refer to one another
    ServoLoop& operator=(const ServoLoop&) = delete;

    void tick();

    // The run.

    Result<void> mayArm() const;
    Result<void> arm();
    Result<void> disarm();
    /// Starts the run. `acceptInfeasible` is recorded: checking here whether the targets can be held would
    /// take too long, so the caller asks jointVerdict() first.
    Result<void> start(bool acceptInfeasible);
    Result<void> hold();
    Result<void> resume();
    Result<void> stop();
    void emergencyStop();
    /// Switches the heat off and moves the objects away, in every state; a run is stopped as by stop().
    /// Refused if the robot does not answer or cannot move. Does not clear a fault.
    Result<void> retreatNow();
    Result<void> reset();
    Result<void> setTargets(const std::vector<double>& targets_K);
    Result<void> setController(const ControllerSettings& settings);

    // For an operator, while no run is armed or on.

    /// Moves the end-effector to coordinates within workspace and clearance; fixed axes keep their values.
    /// Hold, Arm, STOP and faults end the move.
    Result<void> moveTo(const Vector6d& goal);
    Result<void> jog(const Vector6d& twist);
    /// Homes the robot, also in a fault.
    Result<void> home();
    Result<void> clearRobotAlarm();
    /// Sets the manual heat; empty means off. Off stops a run, and is never refused.
    Result<void> setHeat(std::optional<double> setPoint_K);
    /// Refused while heat is on, and if the objects are not at ambient temperature.
    Result<void> zeroSensors();
    /// Returns the zeroing that zeroSensors() would find now.
    Result<Zeroing> findZero() const;
    Result<void> setVision(const VisionSpec& vision);
    /// A person confirms that the sensor is on its object and correct; allowed in every state. Its current
    /// reading is trusted, its earlier ones are forgotten. Errors: no such object, or a sensor without a
    /// plausible reading.
    Result<void> confirmSensor(std::size_t object);

    // Reports from outside the loop.

    /// Enters the safe state with a latched fault: for failures that the loop does not detect itself.
    void fault(Message reason);
    /// A run retreats first and then ends in a latched fault: for failures after which the robot can still
    /// move.
    void stopFor(Message reason);
    /// Zero velocity and heat off, in every state.
    void makeSafe();
    /// Reports that the computer was suspended for this time: a fault if there was heat or motion.
    void reportSuspended(double slept_s);
    /// Reports why the computer cannot be kept awake: an event.
    void reportByHand(const std::string& link, const std::string& what) {
        event(MessageCode::EventSentByHand, {link, what});
    }
    void reportMaySleep(const std::string& why) { event(MessageCode::EventMaySleep, {why}); }
    /// Adds an event while a run is on and does not stop.
    void reportInfeasible(const Message& reason);
    /// Free disk space of the recording; empty if nothing is recorded.
    void setDiskFree_MB(std::optional<double> free_MB) { m_diskFree_MB = free_MB; }
    /// Adds its row to the record.
    void reportAcknowledged(const Alarm& alarm);
    void reportShelved(const Alarm& alarm, double for_s); ///< 0: the shelving has ended
    /// Adds an event about a simulated fault.
    void reportFault(SimulatedFault simulated, std::size_t object);
    void reportFaultEnded(SimulatedFault simulated);
    /// Record what a person has asked of others, with the operator, while a run is recorded.
    void reportFaultAsked(SimulatedFault simulated, std::size_t object, bool isOn);
    void reportSpeedAsked(double factor);
    void reportSourceTyped(double temperature_K);
    void addNote(const std::string& text);
    /// Says whose the commands, notes and acknowledgements are from now on.
    void setOperator(const std::string& name);

    // For handing over from one loop to the next on the same rig.

    RigKnowledge knowledge() const;
    /// Replaces the start-up fault: the previous loop had the same devices.
    void use(const RigKnowledge& known);
    /// Uses a zeroing found earlier with the same sensors.
    void useZeroing(const Zeroing& zeroing) { m_readings.sensors().use(zeroing); }

    /// Goes on with the readings of an earlier loop with the same sensors, sampling and clock.
    void useReadings(const SensorChannels& before) { m_readings.sensors().useReadings(before); }
    void restSensor(std::size_t object, const std::vector<Reading>& readings) {
        m_readings.sensors().rest(object, readings);
    }

    // State.

    RunState state() const { return m_state; }
    /// A run is on, from Start until it has stopped; or a retreat is on, with or without a run.
    bool running() const;
    bool isArmedOrOn() const; ///< running(), or a run is armed
    /// A run has ended by a fault or STOP, or its heat is not confirmed off. Record and time continue until
    /// the heat is off and the objects are cold, after a fault or STOP the source as well (unless a person
    /// heats it, or setRecordEnd() says otherwise), a person ends the recording or heats by hand, or 6 h
    /// after the run. What is not known is not cold.
    bool isCooling() const { return m_isCooling; }
    void endCooling() { m_isCooling = false; }
    /// Whether what happens now belongs to a run.
    bool isRecorded() const { return isArmedOrOn() || m_isCooling; }
    bool areObjectsCold() const; ///< and nothing heats them, whatever the source is
    void setRecordEnd(RecordEnd end) { m_recordEnd = end; }
    double runTime_s() const;
    /// Outcome of the last run: "settled", "stopped", "emergency-stop" or "fault".
    const std::string& outcome() const { return m_outcome; }
    /// Why it is not ready, in a hold, or in a fault.
    std::vector<Message> reasons() const;
    /// What a person can do now about the reasons, in this state; code None if there is nothing, or the
    /// reasons say it.
    Message remedy() const;
    /// The next action that it will take by itself; empty if there is none.
    std::optional<PendingAction> pending() const;
    /// Why it cannot retreat now; code None if it can.
    Message keepsFromRetreat() const;
    /// Whether the end-effector is known to be as far off the source as a retreat moves it; never where no
    /// free axis leads away.
    bool isAway() const {
        return m_readings.robot().isPlaceSure && m_retreat.longest_m() > 0.0 && m_retreat.isAway();
    }
    /// Latched faults, then what the safety monitor finds, then a compromise.
    std::vector<AlarmCondition> alarmConditions() const;
    SensorTrust sensorTrust(std::size_t object) const;
    /// Set point of the run, or manual set point; empty if off.
    std::optional<double> heatSetPoint_K() const;
    /// Of a source that heats though its heat is off; empty if none does.
    std::optional<UnaskedFall> unaskedFall() const { return m_safety.unaskedFall(); }
    const Experiment& experiment() const { return m_experiment; }
    const TraceSample& latest() const { return m_latest; }
    const RigReadings& readings() const { return m_readings; }
    const RobotMotion& motion() const { return m_motion; }
    const HeatOrders& heat() const { return m_heat; }
    LoopRecord takeRecord();

private:
    // servo_tick.cpp
    void look(); ///< reads all devices
    void control();
    void retreat();
    void noteSettling();
    void trace();
    void traceFrame();
    void noteShutter();
    void watchCooling();
    bool isSourceCold() const;
    void updateReadiness();

    // servo_reactions.cpp
    void watch(); ///< detects the conditions of the alarm table and reacts
    SafetyObservation observe() const;
    std::optional<CameraOpinion> opinion(std::size_t object) const;
    void react(const SafetyFinding& finding);
    void tellEnd(const SafetyFinding& finding);
    void watchLoss();
    void watchHeatInFault();          ///< retreats also in a fault if something is too hot, after a countdown
    const SafetyFinding* hot() const; ///< the condition that demands a retreat; null if there is none
    void refusedByRobot(const Message& reason);
    void noteRefusedRetreat(const Message& problem);
    void addFault(LatchedFault fault);
    LatchedFault latched(const SafetyFinding& finding) const { return latchedFault(finding, m_experiment); }
    void holdFor(const SafetyFinding& finding); ///< pauses a run, or ends an operator's move
    void faultWith(LatchedFault reason);
    void stopWith(LatchedFault reason);
    void retreatFor(const SafetyFinding& finding); ///< retreats with or without a run

    // servo_loop.cpp
    Result<void> stopBy(const Message& event);
    void beginRetreat();
    void endRun(const std::string& outcome);
    bool isManual() const; ///< no run is armed or on, and no fault
    bool isHeatedManually() const;
    void keepHeating();
    void take(Zeroing found);
    Result<void> requireFreshReadings() const;
    void event(MessageCode code, std::vector<MessageArg> args = {});
    void event(const Message& message) { event(message.code, message.args); }
    void command(const std::string& name, const std::string& value = {});
    Error refusal(CommandVerb verb) const;

    Experiment m_experiment;
    const Result<void> m_mounting; ///< of checkMounting(): an edit of the objects makes another loop
    RigDevices m_devices;
    const Clock& m_clock;
    TraceSample m_latest; ///< written by the members below
    RigReadings m_readings;
    RobotMotion m_motion;
    HeatOrders m_heat;
    RetreatMotion m_retreat;
    RunControl m_control;
    SafetyMonitor m_safety;
    LatchedFaults m_faults;

    RunState m_state = RunState::NotReady;
    bool m_runOn = false; ///< true from Start to the end of the retreat
    bool m_isCooling = false;
    double m_ended_s = 0.0; ///< time of the last run's end
    RecordEnd m_recordEnd = RecordEnd::ObjectsAndSourceCold;
    bool m_pausedBySafety = false;
    std::optional<double> m_diskFree_MB;
    std::optional<double> m_tick_s;    ///< time of the previous tick
    std::optional<double> m_frame_s;   ///< time of the last recorded thermal picture
    std::optional<double> m_shutter_s; ///< when the thermal camera's shutter was last seen to open
    std::string m_outcome;
    std::string m_operator;
    LoopRecord m_record;
};

} // namespace bask
