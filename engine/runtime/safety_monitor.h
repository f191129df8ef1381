#pragma once
// What the engine watches in every state: the alarm table, and the monitor that finds its conditions.

#include "engine/base/message.h"
#include "engine/devices/thermometer.h"
#include "engine/model/experiment.h"
#include "engine/runtime/quiet_watch.h"
#include "engine/runtime/sensor_channels.h"
#include "engine/runtime/source_watch.h"
#include "engine/runtime/warming_watch.h"

#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace bask {

/// What is done, the gravest last. Retreats and halts end in a fault, latched until reset.
enum class SafetyReaction {
    Note,    ///< told
    Hold,    ///< zero velocity; of a run the heat goes on
    Stop,    ///< heat off; a run retreats first, else the robot stays as it is
    Retreat, ///< heat off; the robot takes the objects away also where no run is on
    Halt     ///< heat off, zero velocity: the robot cannot be trusted
};

/// What can be wrong: the lines of the alarm table.
enum class SafetyCondition {
#include "engine/base/condition_names.inc" // made by the build: "RobotLost," ...
};

/// A row of the alarm table, whose columns are explained in engine/base/alarm_table.inc.
struct AlarmEntry {
    SafetyCondition condition;
    const char* key; ///< several conditions of one key are one alarm
    int priority;    ///< as an alarm, 1 the highest
    SafetyReaction reaction;
    bool isOfObject;
    bool isLoss;     ///< of a measured value
    bool isSeenOver; ///< its end can be seen
    double on_s;     ///< it must have been so for this time
    double off_s;    ///< and must be gone for this time
};
const AlarmEntry& alarmEntry(SafetyCondition condition);

/// Of an experiment's sensors.
SensorLimits sensorLimits(const Experiment& experiment);

/// One object's sensor at a tick.
struct ObservedObject {
    bool isKnown = false; ///< has ever given a value, or said that it has none
    bool isLost = false;  ///< nothing valid for too long
    bool isInvalid = false;
    SensorFault fault = SensorFault::None;
    Jump jump;
    double largestRate_K_s = 0.0;
    double age_s = 0.0;                 ///< of the newest valid reading
    std::optional<double> measured_K{}; ///< valid and fresh
    double viewFactor = 0.0;
    double max_K = std::numeric_limits<double>::infinity(); ///< it can be by its heat balance
};

/// What is known at one tick. Messages of code None: no problem.
struct SafetyObservation {
    double now_s = 0.0;
    double sinceTick_s = 0.0; ///< since the tick before; 0: there was none
    std::vector<ObservedObject> objects;
    Message thermometerProblem;
    Message robotProblem; ///< it does not answer
    Message robotAlarm;
    bool isPlaceSure = true;
    double robotAge_s = 0.0; ///< of its state
    Message sourceProblem;   ///< it does not answer
    std::optional<double> source_K{};
    double sourceAge_s = 0.0; ///< since a valid reading
    double sourceStrength = 1.0;
    std::optional<double> asked_K{};    ///< set point, while the heat is asked for
    std::optional<double> readBack_K{}; ///< set point, as the device has it
    bool isManual = false;
    bool isHeatUnwanted = false; ///< a fault or a stop wants it off
    Message heatOffProblem;
    Message guardProblem;          ///< the heater's guard has taken over, or is gone
    bool isSourceSwitched = false; ///< it cools when its heat is off: a real one
    bool hasWatchdog = true;       ///< the source goes off by itself when nothing keeps it on
    bool isSourceDark = true;      ///< it does not heat the objects: cold, or behind its shutter
    bool isSourcePoseLost = false;
    std::optional<double> diskFree_MB{};
};

/// A condition that holds now.
struct SafetyFinding {
    SafetyCondition condition{};
    std::size_t object = 0;
    Message message; ///< with the newest values
};

struct SafetyChanges {
    std::vector<SafetyFinding> raised; ///< the gravest first
    std::vector<SafetyFinding> ended;
};

/// Pure: one observation a tick in, conditions out. Delays and hysteresis are here, reactions are the loop's.
class SafetyMonitor {
public:
    explicit SafetyMonitor(const Experiment& experiment);

    SafetyChanges watch(const SafetyObservation& seen);
    /// The gravest first.
    const std::vector<SafetyFinding>& active() const { return m_active; }
    /// The gravest that forbids a reset; null: none.
    const SafetyFinding* forbidsReset() const;

    /// The gravest that forbids a run to begin or to go on; null: none.
    const SafetyFinding* forbidsResume() const;
    struct Delayed {
        SafetyFinding finding;
        double in_s; ///< until it is found, if it stays so
    };
    /// What is nearly found: half of its delay or more has passed.
    std::vector<Delayed> delayed() const;

    /// A sensor's value, or the source's place, is lost; null: none.
    const SafetyFinding* lost() const;
    bool isLost() const { return lost() != nullptr; }
    /// For longer than the held limit: what comes back and goes again is one loss.
    bool isLostTooLong() const;
    /// Until then, s, while it is lost.
    double lostTooLongIn_s() const;
    /// A sensor that is lost, not the source's place; null: none.
    const SafetyFinding* lostSensor() const;
    /// The run begins or goes on: a new loss gets its own hold.
    void forgetLoss();
    /// What each object absorbs, K/s, as it is estimated; NaN where its place is not known.
    std::vector<double> powers_K_s(const SafetyObservation& seen) const;
    /// It gives the very same value for too long.
    bool isSensorStill(std::size_t object) const;
    /// A person says that the object's sensor is right: what it told before is forgotten.
    void confirmSensor(std::size_t object);
    /// The sensors have been zeroed: the objects are as they have been for long.
    void atRest(const SafetyObservation& seen);
    /// Whether the source's heat was ever on, for the monitor that has the same one next.
    bool wasSourceHeated() const { return m_source.wasHeated(); }
    void useHistory(bool wasSourceHeated) { m_source.use(wasSourceHeated); }
    /// At a reset: what objects and source did before is forgotten.
    void restart();

    static constexpr double kSourceSilent_s = 3.0; ///< or the stale periods, if that is longer
    static constexpr double kRobotSlow_s = 0.8;    ///< or the stale periods

private:
    struct Pending {
        SafetyCondition condition;
        std::size_t object;
        double since_s;
    };
    struct ObjectWatch {
        WarmingWatch warming;
        double lambda1_K_s;
        std::optional<double> frozenAt_K{};
        double frozenSince_s = 0.0;
        QuietWatch quiet{};
    };
    void addObject(std::size_t i, const SafetyObservation& seen);
    void addSensor(std::size_t i, const SafetyObservation& seen);
    double power_K_s(std::size_t i, const SafetyObservation& seen) const; ///< absorbed, as believed
    void addWarming(std::size_t i, const SafetyObservation& seen);
    void addRobot(const SafetyObservation& seen);
    void addSource(const SafetyObservation& seen);
    void addHeating(const SafetyObservation& seen);
    void addUnit(const SafetyObservation& seen);
    void addRig(const SafetyObservation& seen);
    void addCrossCheck(const SafetyObservation& seen);
    void add(SafetyCondition condition, Message message, std::size_t object = 0);
    const SafetyFinding* activeOne(SafetyCondition condition, std::size_t object = 0) const;
    bool isActive(SafetyCondition condition, std::size_t object = 0) const {
        return activeOne(condition, object) != nullptr;
    }
    void raise(const SafetyObservation& seen, SafetyChanges& changes);
    void end(const SafetyObservation& seen, SafetyChanges& changes);
    const std::string& name(std::size_t i) const { return m_experiment.objects[i].name; }

    Experiment m_experiment;
    std::vector<ObjectWatch> m_objects;
    SourceWatch m_source;
    double m_coldAfter_s; ///< without heat all objects are as warm as the room
    double m_lastHeat_s = -1e300;
    double m_now_s = 0.0;
    double m_lostSince_s = 0.0;
    double m_lostLast_s = -1e300;
    std::vector<SafetyFinding> m_present; ///< at this tick
    std::vector<SafetyFinding> m_active;
    std::vector<Pending> m_rising;
    std::vector<Pending> m_ending;
};

} // namespace bask
