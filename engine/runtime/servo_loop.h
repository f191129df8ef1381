#pragma once
// The run's state machine and its loop: sensors in, controller, robot and heat out, every way out through one
// safe state. Verbs are in servo_loop.cpp, a sampling period in servo_tick.cpp, what is done about alarms in
// servo_reactions.cpp.

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

/// What is known of a real rig, for the loop that has it next.
struct RigKnowledge {
    std::vector<LatchedFault> faults; ///< empty: a person has looked at the rig and reset
    RigAnswers answers;
    bool isRetreatRefused = false; ///< by STOP, or by a robot that does not move
    SensorChannels sensors;        ///< with those that are distrusted
    bool wasSourceHeated = false;
};

/// One experiment on one rig. Owner calls tick() every sampling period of the clock. Verbs answer a refusal
/// in words when they do not fit the state. No exception leaves tick(): it becomes a fault with the heat off
/// and the robot standing. One thread.
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
    /// `acceptInfeasible` is recorded: whether the targets can be held takes too long to be found out here,
    /// so who starts a run asks jointVerdict() before.
    Result<void> start(bool acceptInfeasible);
    Result<void> hold();
    Result<void> resume();
    Result<void> stop();
    void emergencyStop();
    /// Heat off, and the robot takes the objects away, in every state; of a run as stop(). Refused where the
    /// robot does not answer or cannot move. Clears no fault.
    Result<void> retreatNow();
    Result<void> reset();
    Result<void> setTargets(const std::vector<double>& targets_K);
    Result<void> setController(const ControllerSettings& settings);

    // By an operator, while no run is armed or on.

    /// Sends the end-effector to coordinates within workspace and clearance, fixed axes as they are. Hold,
    /// Arm, STOP and faults end it.
    Result<void> moveTo(const Vector6d& goal);
    Result<void> jog(const Vector6d& twist);
    /// Also in a fault.
    Result<void> home();
    Result<void> clearRobotAlarm();
    /// Empty: off, which is never refused.
    Result<void> setHeat(std::optional<double> setPoint_K);
    /// Refused while heat is on, and where the objects are not at ambient.
    Result<void> zeroSensors();
    /// What that would find now.
    Result<Zeroing> findZero() const;
    Result<void> setVision(const VisionSpec& vision);
    /// In every state. A person says that the sensor is on its object and right: what it tells now is
    /// believed, what it told before is forgotten. Errors: no such object, a sensor that tells nothing
    /// plausible.
    Result<void> confirmSensor(std::size_t object);

    // What others have seen.

    /// Safe state, latched: for failures that the loop does not see itself (the recorder).
    void fault(Message reason);
    /// A run retreats first, then the latched fault: for failures that leave the robot able to move.
    void stopFor(Message reason);
    /// Zero velocity and heat off, in whatever state.
    void makeSafe();
    /// The computer slept for so long: a fault where there was heat or motion.
    void reportSuspended(double slept_s);
    /// Why it cannot be kept awake: an event.
    void reportMaySleep(const std::string& why) { event(MessageCode::EventMaySleep, {why}); }
    /// An event, while a run is on.
    void reportInfeasible(const Message& reason);
    /// Free where the recording goes; empty: none is made.
    void setDiskFree_MB(std::optional<double> free_MB) { m_diskFree_MB = free_MB; }
    /// Its row in the record.
    void reportAcknowledged(const Alarm& alarm);
    void reportShelved(const Alarm& alarm, double for_s); ///< 0: it is back
    /// An event, for the record of a simulated fault.
    void reportFault(SimulatedFault simulated, std::size_t object);
    void addNote(const std::string& text);

    // From one loop to the next on the same rig.

    RigKnowledge knowledge() const;
    /// Instead of the fault of the start: the loop before had the very same devices.
    void use(const RigKnowledge& known);
    /// Of the same sensors, found before.
    void useZeroing(const Zeroing& zeroing) { m_readings.sensors().use(zeroing); }

    // What is so.

    RunState state() const { return m_state; }
    /// A run is on, from Start until it has stopped; or a retreat, with or without one.
    bool running() const;
    bool isArmedOrOn() const; ///< running(), or a run is armed
    /// A run has ended by a fault or STOP: its record and its time go on until the objects are cold and the
    /// heat is off, or a person ends it.
    bool isCooling() const { return m_isCooling; }
    void endCooling() { m_isCooling = false; }
    double runTime_s() const;
    /// "settled", "stopped", "emergency-stop" or "fault": of the last run.
    const std::string& outcome() const { return m_outcome; }
    /// Why it is not ready, holds or is in a fault.
    std::vector<Message> reasons() const;
    /// What a person can do now about the reasons, in this state; None: nothing, or the reasons say it.
    Message remedy() const;
    /// What it will do by itself next, the soonest.
    std::optional<PendingAction> pending() const;
    /// Why it cannot retreat now; None: it can.
    Message keepsFromRetreat() const;
    /// Latched faults and what the safety monitor finds, the gravest first.
    std::vector<AlarmCondition> alarmConditions() const;
    SensorTrust sensorTrust(std::size_t object) const;
    /// Of the run, or of the operator; empty: off.
    std::optional<double> heatSetPoint_K() const;
    const Experiment& experiment() const { return m_experiment; }
    const TraceSample& latest() const { return m_latest; }
    const RigReadings& readings() const { return m_readings; }
    const RobotMotion& motion() const { return m_motion; }
    const HeatOrders& heat() const { return m_heat; }
    LoopRecord takeRecord();

private:
    // servo_tick.cpp
    void look(); ///< at everything there is
    void control();
    void retreat();
    void noteSettling();
    void trace();
    bool isCold() const;
    void updateReadiness();

    // servo_reactions.cpp
    void watch(); ///< finds what is wrong, by the alarm table, and reacts
    SafetyObservation observe() const;
    void react(const SafetyFinding& finding);
    void tellEnd(const SafetyFinding& finding);
    void watchLoss();
    void watchHeatInFault(); ///< an object that is too hot is taken away also then, after a countdown
    const SafetyFinding* hot() const; ///< what is to be retreated from; null: nothing
    void refusedByRobot(const Message& reason);
    void noteRefusedRetreat(const Message& problem);
    void addFault(LatchedFault fault);
    LatchedFault latched(const SafetyFinding& finding) const { return latchedFault(finding, m_experiment); }
    void holdFor(const SafetyFinding& finding); ///< a run, or a move of the operator's
    void faultWith(LatchedFault reason);
    void stopWith(LatchedFault reason);
    void retreatFor(const SafetyFinding& finding); ///< with or without a run

    // servo_loop.cpp
    Result<void> stopBy(const Message& event);
    void beginRetreat();
    void endRun(const std::string& outcome);
    bool isManual() const; ///< no run is armed or on, and nothing is latched
    bool isHeatedManually() const;
    void keepHeating();
    void take(Zeroing found);
    Result<void> requireFreshReadings() const;
    void event(MessageCode code, std::vector<MessageArg> args = {});
    void event(const Message& message) { event(message.code, message.args); }
    void command(const std::string& name, const std::string& value = {});
    Error refusal(CommandVerb verb) const;

    Experiment m_experiment;
    RigDevices m_devices;
    const Clock& m_clock;
    TraceSample m_latest; ///< its parts are written by those below
    RigReadings m_readings;
    RobotMotion m_motion;
    HeatOrders m_heat;
    RetreatMotion m_retreat;
    RunControl m_control;
    SafetyMonitor m_safety;
    LatchedFaults m_faults;

    RunState m_state = RunState::NotReady;
    bool m_runOn = false; ///< from Start to the end of its retreat
    bool m_isCooling = false;
    bool m_pausedBySafety = false;
    std::optional<double> m_diskFree_MB;
    std::optional<double> m_tick_s; ///< the one before
    std::string m_outcome;
    LoopRecord m_record;
};

} // namespace bask
