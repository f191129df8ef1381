#pragma once
// The run's state machine and its loop: sensors in, controller, robot and heat out, every way out through one
// safe state.

#include "engine/base/clock.h"
#include "engine/base/message_code.h"
#include "engine/base/words.h"
#include "engine/control/controller.h"
#include "engine/devices/heat_source.h"
#include "engine/devices/robot.h"
#include "engine/devices/source_tracker.h"
#include "engine/devices/thermometer.h"
#include "engine/model/experiment.h"
#include "engine/runtime/alarm_log.h"
#include "engine/runtime/loop_record.h"
#include "engine/runtime/safety_monitor.h"
#include "engine/runtime/sensor_channels.h"
#include "engine/runtime/snapshot.h"

#include <functional>
#include <memory>
#include <optional>
#include <vector>

namespace bask {

/// The devices of a rig, borrowed for the loop's life.
struct RigDevices {
    Robot& robot;
    Thermometer& thermometer;
    HeatSource& source;
    /// The plant's own temperatures, K, where the rig is simulated; empty function otherwise.
    std::function<std::vector<double>()> truth;
    /// Asked where the experiment's source is tracked; may be null.
    SourceTracker* tracker = nullptr;
    /// Faulted from the start, until a person has looked and reset; and its source is hot with the heat off.
    bool isReal = false;
};

/// Latched until reset: a message, with the condition that it is for.
struct LatchedFault {
    Message message;
    std::string key; ///< of its alarm
    std::optional<SafetyFinding> finding;
};

/// Whether a robot comes nearer to where it was sent.
class Approach {
public:
    void begin(double now_s);
    /// Left: m or rad.
    void add(double now_s, double left, double period_s);
    /// It will not come any nearer.
    bool isStill() const { return m_isStill; }

private:
    double m_nearer_s = 0.0, m_left = 0.0;
    bool m_isStill = false;
};

/// What is known of a real rig, for the loop that has it next.
struct RigKnowledge {
    std::vector<LatchedFault> faults; ///< empty: a person has looked at the rig and reset
    double made_s = 0.0;              ///< when its devices were given to a loop first
    bool hasThermometer = false, hasRobot = false, hasSource = false; ///< has answered, ever
    bool isRetreatRefused = false;         ///< by STOP, or by a robot that does not move
    std::optional<SensorChannels> sensors; ///< with those that are distrusted
    bool wasSourceHeated = false;
};

/// One experiment on one rig. Owner calls tick() every sampling period of the clock. Verbs answer a refusal
/// in words when they do not fit the state. No exception leaves tick(): it becomes a fault with the heat off
/// and the robot standing. One thread.
class ServoLoop {
public:
    ServoLoop(const Experiment& experiment, RigDevices devices, const Clock& clock);
    ~ServoLoop();

    void tick();

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
    /// Why it cannot now; None: it can.
    Message keepsFromRetreat() const;
    /// What it will do by itself next, the soonest.
    std::optional<PendingAction> pending() const;
    /// What a person can do now about the reasons, in this state; None: nothing, or the reasons say it.
    Message remedy() const;
    Result<void> reset();
    Result<void> setTargets(const std::vector<double>& targets_K);
    /// Refused while a run is armed or on, while heat is on, and where the objects are not at ambient.
    Result<void> zeroSensors();
    /// What that would find now.
    Result<Zeroing> findZero() const;
    /// A person says that the sensor is on its object and right: what it tells now is believed, what it told
    /// before is forgotten. Errors: no such object, a sensor that tells nothing plausible.
    Result<void> confirmSensor(std::size_t object);
    SensorTrust sensorTrust(std::size_t object) const;
    double readingAge_s(std::size_t object) const { return m_sensors.age_s(object, m_clock.now_s()); }
    /// Newest plausible value of the sensor, believed or not; NaN: it tells none.
    double toldReading_K(std::size_t object) const { return m_sensors.told_K(object, m_clock.now_s()); }
    const std::optional<Zeroing>& zeroing() const { return m_sensors.zeroing(); }
    RigKnowledge knowledge() const;
    /// Instead of the fault of the start: the loop before had the very same devices.
    void use(const RigKnowledge& known);
    /// Of the same sensors, found before.
    void useZeroing(const Zeroing& zeroing) { m_sensors.use(zeroing); }
    /// An event, while a run is on.
    void reportInfeasible(const Message& reason);
    Result<void> setController(const ControllerSettings& settings);
    /// The end-effector to coordinates within workspace and clearance, fixed axes as they are; while no run
    /// is armed or on. Hold, Arm, STOP and faults end it.
    Result<void> moveTo(const Vector6d& goal);
    bool isMoving() const { return m_goal.has_value() || m_isHoming || m_clock.now_s() < m_jogEnds_s; }
    /// By hand, while no run is armed or on; Jog's and SetHeat's words.
    Result<void> jog(const Vector6d& twist);
    Result<void> home();
    Result<void> clearRobotAlarm();
    Result<void> setHeat(std::optional<double> setPoint_K);
    const Message& robotAlarm() const { return m_robot.alarm; }
    bool isPlaceSure() const { return m_robot.isPlaceSure; }
    PlaceState placeState() const;
    /// Of latest().coordinates, s; infinite while the robot has told none.
    double placeAge_s() const;
    /// Of latest().source_K, s; infinite while the source has told none.
    double sourceAge_s() const;
    std::optional<double> heatSetPoint_K() const;
    /// Whether a robot may be sent from one place to another, with the source where it is known to be now.
    bool mayStep(const Vector6d& from, const Vector6d& to) const {
        return m_geometry->mayStep(from, to, m_experiment.robot);
    }
    /// Refused while a run is armed or on.
    Result<void> setVision(const VisionSpec& vision);
    void addNote(const std::string& text);
    /// Zero velocity and heat off, in whatever state.
    void makeSafe();
    /// Safe state, latched: for failures that the loop does not see itself (the recorder).
    void fault(Message reason);
    /// A run retreats first, then the latched fault: for failures that leave the robot able to move.
    void stopFor(Message reason);
    /// The computer slept for so long: a fault where there was heat or motion.
    void reportSuspended(double slept_s);
    /// Why it cannot be kept awake: an event.
    void reportMaySleep(const std::string& why) { event(MessageCode::EventMaySleep, {why}); }
    /// Free where the recording goes; empty: none is made.
    void setDiskFree_MB(std::optional<double> free_MB) { m_diskFree_MB = free_MB; }
    /// Its row in the record.
    void reportAcknowledged(const Alarm& alarm);
    void reportShelved(const Alarm& alarm, double for_s); ///< 0: it is back
    /// An event, for the record of a simulated fault.
    void reportFault(SimulatedFault simulated, std::size_t object);

    RunState state() const { return m_state; }
    std::vector<Message> reasons() const;
    /// Latched faults and what the safety monitor finds, the gravest first.
    std::vector<AlarmCondition> alarmConditions() const;
    /// A run is on, from Start until it has stopped; or a retreat, with or without one.
    bool running() const;
    bool isArmedOrOn() const; ///< running(), or a run is armed
    /// A run has ended by a fault or STOP: its record and its time go on until the objects are cold and the
    /// heat is off, or a person ends it.
    bool isCooling() const { return m_isCooling; }
    void endCooling() { m_isCooling = false; }
    double runTime_s() const;
    const Experiment& experiment() const { return m_experiment; }
    const TraceSample& latest() const { return m_latest; }
    std::optional<SourceTracking> tracking() const;
    double sampleTime_s() const { return m_sampleTime_s; }
    /// Of the source, its newest reading, or as typed; empty: that is not valid, or it does not answer.
    const std::optional<double>& source_K() const { return m_source_K; }
    bool heatOn() const { return m_devices.source.heating(); }
    HeatState heatState() const { return m_devices.source.heatState(); }
    bool allWithinBand() const;
    /// "settled", "stopped", "emergency-stop" or "fault": of the last run.
    const std::string& outcome() const { return m_outcome; }

    LoopRecord takeRecord();

private:
    void look(); ///< at everything there is
    void readSensors();
    void takeReadings(); ///< from the channels into the latest sample
    void readSourcePose();
    bool facesObjects(const Pose& X_RS) const;
    double environment_K() const; ///< T3, as measured if it was
    void take(Zeroing found);
    void endMove();
    double mostHeat_K() const; ///< that the experiment asks for
    void goOn();               ///< towards the goal of moveTo
    bool isByHand() const;     ///< no run is armed or on, and nothing is latched
    void readRobotAndSource();
    void readViewFactors();
    SafetyObservation observe() const;
    void watch(); ///< finds what is wrong, by the alarm table, and reacts
    void react(const SafetyFinding& finding);
    void noteRefusedRetreat(const Message& problem);
    void tellEnd(const SafetyFinding& finding);
    using Latched = LatchedFault;
    Latched latched(const SafetyFinding& finding) const;
    static Latched latched(Message reason);
    /// By its message as it is now, where that still holds.
    Message newest(const Latched& fault) const;
    static int priorityOf(const Latched& fault);
    bool isSeenOver(const Latched& fault) const;
    std::vector<SafetyFinding> foundOrLatched() const;
    void addFault(Latched fault);
    void holdFor(const SafetyFinding& finding); ///< a run, or a move of the operator's
    Result<void> stopBy(const Message& event);
    void faultWith(Latched reason);
    void stopWith(Latched reason);
    void retreatFor(const SafetyFinding& finding); ///< with or without a run
    void beginRetreat();
    void watchHeatInFault(); ///< an object that is too hot is taken away also then, after a countdown
    const SafetyFinding* hot() const; ///< what is to be retreated from; null: nothing
    bool isAway() const;              ///< from the source, as far as a retreat goes
    void switchHeatOff();
    void control();
    void keepHeating();
    void keepOff(); ///< the heat: an order that was not taken, or a source that is on by itself, gets another
    bool isHeatedByHand() const;
    void backOff(); ///< off the source, which is too near
    void retreat();
    void endRetreat();
    bool isCold() const;
    bool isSourceDark() const; ///< it does not heat the objects
    void noteSettling();
    void noteCompromise(const ControlOutput& output);
    static constexpr double kVelocityPeriods = 1.5; ///< a commanded velocity expires after so many
    void move(const Vector6d& rates);               ///< of the pose coordinates, until the next sample
    void move(const Vector6d& rates, double validFor_s);
    void standStill();
    void endRun(const std::string& outcome);
    void updateReadiness();
    static constexpr double kConnecting_s = 3.0;
    /// A device that has told nothing yet, and still has time to: it is not lost, and nothing can be begun.
    bool isAwaited(bool hasAnswered) const {
        return m_devices.isReal && !hasAnswered && m_clock.now_s() - m_made_s <= kConnecting_s;
    }
    /// Why a device does not answer; None: it does, or is awaited. One that is not there at all is not.
    template <class Answer> Message problemOf(const Answer& answer, bool hasAnswered) const {
        const Message problem = answer ? Message{} : answer.error().message;
        return problem.code != MessageCode::RigIncomplete && isAwaited(hasAnswered) ? Message{} : problem;
    }
    /// Devices that are not set up: nothing is wrong with them, and nothing can be begun.
    std::vector<Message> missing() const;
    bool sourceSeen() const; ///< where its pose is tracked, that was measured lately
    Result<void> requireFreshSensor(std::size_t object) const;
    Result<void> requireFreshSensors() const;
    void trace();
    void event(MessageCode code, std::vector<MessageArg> args = {});
    void command(const std::string& name, const std::string& value = {});
    Error refusal(CommandVerb verb) const;
    /// What a sensor that is not believed tells, and where its object can be, if that is known.
    Message distrust(std::size_t object) const;
    MessageArg objectsOffTarget() const; ///< "circle +1.2 K, hand -0.8 K"

    Experiment m_experiment;
    RigDevices m_devices;
    const Clock& m_clock;
    std::shared_ptr<const RigGeometry> m_geometry; ///< of a real rig a little inside of its limits
    SensorChannels m_sensors;
    std::unique_ptr<Controller> m_controller;

    RunState m_state = RunState::NotReady;
    bool m_runOn = false; ///< from Start to the end of its retreat
    bool m_isCooling = false;
    std::vector<Latched> m_faults;
    SafetyMonitor m_safety;
    Message m_thermometerProblem, m_robotProblem, m_sourceProblem, m_heatOffProblem; ///< None: none
    double m_made_s;
    bool m_hasThermometer = false, m_hasRobot = false, m_hasSource = false; ///< has answered, ever
    RobotState m_robot;                                                     ///< told last
    double m_sourceRead_s = 0.0;                                            ///< its newest valid temperature
    std::optional<double> m_source_K;                                       ///< that, unless it is too old
    std::optional<double> m_asked_K; ///< set point, while the heat is on
    std::optional<double> m_diskFree_MB;
    std::optional<double> m_tick_s; ///< the one before
    double m_sourceSeen_s = -1e300; ///< when it was last seen
    PoseReading m_sourceReading;
    std::optional<Vector6d> m_goal; ///< of moveTo
    Approach m_approach;            ///< to it, or of the retreat
    bool m_heldBySafety = false;
    bool m_retreatRaised = false;        ///< the retreat's way up is done
    std::optional<double> m_retreatAt_s; ///< by itself, out of a fault
    bool m_isRetreatRefused = false;     ///< that one, by STOP
    double m_withinBandSince_s = 0.0;
    std::vector<ObjectKelvin> m_compromise; ///< predicted errors of the compromise aimed at; empty: none
    bool m_compromiseTold = false;
    double m_startTime_s = 0.0;
    double m_sourceStrength = 1.0;
    bool m_isHoming = false; ///< as asked for, also in a fault: it is then not halted
    double m_homingSince_s = 0.0;
    bool m_isHomingSeen = false;        ///< it has begun
    std::optional<double> m_handHeat_K; ///< set point by hand
    double m_jogEnds_s = -1e300;
    Vector6d m_coordinates = Vector6d::Zero();
    Vector6d m_rates = Vector6d::Zero(); ///< of the pose coordinates, commanded last
    TraceSample m_latest;
    double m_sampleTime_s = 0.0;
    std::vector<HeatRates> m_belief; ///< of the controller, after its last step
    std::string m_outcome;
    LoopRecord m_record;
};

} // namespace bask
