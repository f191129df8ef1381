#pragma once
// What the engine watches in every state: the monitor that detects the conditions of the alarm table.

#include "engine/base/alarm_entry.h"
#include "engine/base/message.h"
#include "engine/devices/robot.h"
#include "engine/devices/thermometer.h"
#include "engine/model/experiment.h"
#include "engine/radiation/neighbours.h"
#include "engine/runtime/assignment_watch.h"
#include "engine/runtime/frozen_watch.h"
#include "engine/runtime/quiet_watch.h"
#include "engine/runtime/second_opinion.h"
#include "engine/runtime/sensor_channels.h"
#include "engine/runtime/source_watch.h"
#include "engine/runtime/target_watch.h"
#include "engine/runtime/warming_watch.h"
#include "engine/thermal/heat_balance.h"

#include <limits>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace bask {

/// Returns the limits for an experiment's sensors.
SensorLimits sensorLimits(const Experiment& experiment);

/// The state of one object's sensor at a tick.
struct ObservedObject {
    bool isKnown = false; ///< has ever given a value, valid or not
    bool isLost = false;  ///< no valid reading for too long
    bool isInvalid = false;
    SensorFault fault = SensorFault::None;
    Message reason; ///< why it is invalid, if its device says so
    Jump jump;
    double largestRate_K_s = 0.0;
    double age_s = 0.0;                 ///< of the newest valid reading
    std::optional<double> measured_K{}; ///< valid and fresh
    double target_K = 0.0;
    double uncertainty_K = 0.0; ///< standard uncertainty, if the thermal camera alone reads it
    double viewFactor = 0.0;
    std::optional<CameraOpinion> opinion{}; ///< if it is read by a sensor and by the thermal camera
    Message unchecked{};                    ///< why the thermal camera cannot check its sensor, if it should
    /// highest temperature that the heat balance allows
    double max_K = std::numeric_limits<double>::infinity();
};

/// What is known at one tick. A message with code None means no problem.
struct SafetyObservation {
    double now_s = 0.0;
    double sinceTick_s = 0.0; ///< since the previous tick; 0 if there was none
    std::vector<ObservedObject> objects;
    Message thermometerProblem;
    Message cameraProblem; ///< of the thermal camera
    Message robotProblem;  ///< why it does not answer
    Message robotAlarm;
    bool isPlaceSure = true;
    std::optional<RobotLag> robotLag{}; ///< behind the experiment's largest speed
    double longestRetreat_m = 0.0;      ///< way off the source from the nearest place in the workspace
    double robotAge_s = 0.0;            ///< age of its state
    Message sourceProblem;              ///< why it does not answer
    std::optional<double> source_K{};
    double sourceAge_s = 0.0; ///< age of the last valid reading
    double sourceStrength = 1.0;
    std::optional<double> asked_K{};    ///< commanded set point; empty if no heat is commanded
    std::optional<double> readBack_K{}; ///< set point as read back from the device
    bool isManual = false;
    bool isControlled = false;   ///< a controller moves all objects towards targets that it can reach
    bool isHeatUnwanted = false; ///< heat must be off because of a fault or a stop
    Message heatOffProblem;
    Message guardProblem;          ///< why the heater's guard has taken over or is gone
    bool isSourceSwitched = false; ///< a real source: it cools when its heat is off
    bool hasWatchdog = true;       ///< the source switches off by itself unless it is kept on
    bool isSourceDark = true; ///< it does not heat the objects: no heat is commanded, and a real one is cool
    bool isSourcePoseLost = false;
    std::optional<double> diskFree_MB{};
};

/// A condition that is present now.
struct SafetyFinding {
    SafetyCondition condition{};
    std::size_t object = 0;
    Message message; ///< message with the newest values
};

struct SafetyChanges {
    std::vector<SafetyFinding> raised; ///< the most serious first
    std::vector<SafetyFinding> ended;
};

/// Pure: takes one observation for each tick and returns changes of conditions. It applies delays and
/// hysteresis; the loop carries out the reactions.
class SafetyMonitor {
public:
    explicit SafetyMonitor(const Experiment& experiment);

    SafetyChanges watch(const SafetyObservation& seen);
    /// Active conditions, the most serious first.
    const std::vector<SafetyFinding>& active() const { return m_active; }
    /// Returns the most serious condition that forbids a reset; null if there is none.
    const SafetyFinding* forbidsReset() const;

    /// Returns the most serious condition of an object that is too warm, or that something else heats; null
    /// if there is none. No run is armed then.
    const SafetyFinding* forbidsArm() const;
    /// Returns the most serious condition that forbids a run to begin or continue; null if there is none.
    const SafetyFinding* forbidsResume() const;
    struct Delayed {
        SafetyFinding finding;
        double in_s; ///< time until it becomes active if it stays present
    };
    /// Returns the conditions that will soon be active: half of the delay or more has passed.
    std::vector<Delayed> delayed() const;

    /// Whether the source is far above its set point and does not cool.
    bool isSourceOver() const { return isActive(SafetyCondition::SourceOver); }
    /// Returns the active loss of a sensor's value or of the source's pose; null if there is none.
    const SafetyFinding* lost() const;
    bool isLost() const { return lost() != nullptr; }
    /// Whether a loss has lasted longer than the pause limit. Losses with short gaps between them count as
    /// one.
    bool isLostTooLong() const;
    /// Time until isLostTooLong(), s; only valid while isLost().
    double lostTooLongIn_s() const;
    /// Returns the active loss of a sensor, not of the source's pose; null if there is none.
    const SafetyFinding* lostSensor() const;
    /// Call when a run begins or continues: a new loss then gets its full pause limit.
    void forgetLoss();
    /// Returns the estimated power that each object absorbs, K/s; NaN if the object's position is not known.
    std::vector<double> powers_K_s(const SafetyObservation& seen) const;
    /// Returns whether the sensor has given exactly the same value for too long.
    bool isSensorStill(std::size_t object) const;
    /// A person confirms that the object's sensor is correct: its earlier readings are forgotten.
    void confirmSensor(std::size_t object);
    /// Returns the object whose sensor is swapped with that of `object`, by the thermal camera, because both
    /// jumped to what the other had read, or because each follows the other's heat; empty: none.
    std::optional<std::size_t> swappedWith(std::size_t object) const;
    /// Call when the sensors have been zeroed: the objects are at rest at the room's temperature.
    void atRest(const SafetyObservation& seen);
    /// Whether the source's heat was ever on, and by how much it warms with its heat off, K (0 if it does
    /// not); for the next monitor of the same source.
    bool wasSourceHeated() const { return m_source.wasHeated(); }
    double unaskedWarming_K() const;
    std::optional<UnaskedFall> unaskedFall() const { return m_source.unaskedFall(); }
    void useHistory(bool wasSourceHeated, double unaskedWarming_K) {
        m_source.use(wasSourceHeated, unaskedWarming_K);
    }
    /// Call at a reset: forgets what objects and source did before.
    void restart();

    static constexpr double kSourceSilent_s = 3.0; ///< or the stale periods, if they are longer
    static constexpr double kRobotSlow_s = 0.8;    ///< or the stale periods, if they are longer

private:
    struct Pending {
        SafetyCondition condition;
        std::size_t object;
        double since_s;
    };
    struct ObjectWatch {
        WarmingWatch warming;
        FrozenWatch frozen;
        HeatRates rates; ///< as estimated
        std::optional<double> frozenAt_K{};
        double frozenSince_s = 0.0;
        QuietWatch quiet{};
        TargetWatch target{};
        double target_K = 0.0; ///< that is watched
        double unusable_s =
            -std::numeric_limits<double>::infinity();  ///< its face was, for the camera, at last
        std::optional<std::size_t> swappedWith{};      ///< as its jump tells
        std::optional<std::size_t> seemsSwappedWith{}; ///< as the heat of both tells, or the camera
    };
    void addObject(std::size_t i, const SafetyObservation& seen);
    void noteSwaps(const SafetyObservation& seen);
    bool seemSwapped(std::size_t i, std::size_t j) const;
    void addSensor(std::size_t i, const SafetyObservation& seen);
    bool isFrozen(std::size_t i) const;
    double power_K_s(std::size_t i, const SafetyObservation& seen) const; ///< absorbed power, as estimated
    void addWarming(std::size_t i, const SafetyObservation& seen);
    void addTarget(std::size_t i, const SafetyObservation& seen);
    Message notFollowing(std::size_t i, const Unfollowed& found) const;
    std::optional<std::size_t> deviatingOtherwise(std::size_t i, const Unfollowed& found) const;
    void addOpinion(std::size_t i, const SafetyObservation& seen);
    void addRobot(const SafetyObservation& seen);
    void addSource(const SafetyObservation& seen);
    void addHeating(const SafetyObservation& seen);
    void addUnit(const SafetyObservation& seen);
    void addRig(const SafetyObservation& seen);
    void addCrossCheck(const SafetyObservation& seen);
    void add(SafetyCondition condition, Message message, std::size_t object = 0);
    /// Adds an alarm again, with its words, if it is active.
    void keepActive(SafetyCondition condition, std::size_t object = 0);
    const SafetyFinding* activeOne(SafetyCondition condition, std::size_t object = 0) const;
    bool isActive(SafetyCondition condition, std::size_t object = 0) const {
        return activeOne(condition, object) != nullptr;
    }
    void raise(const SafetyObservation& seen, SafetyChanges& changes);
    void end(const SafetyObservation& seen, SafetyChanges& changes);
    const std::string& name(std::size_t i) const { return m_experiment.objects[i].name; }

    Experiment m_experiment;
    std::vector<ObjectWatch> m_objects;
    std::map<std::pair<std::size_t, std::size_t>, double> m_seemSwapped_s; ///< pairs, since when
    SecondOpinion m_opinion;
    AssignmentWatch m_assignment;
    SourceWatch m_source;
    Neighbours m_neighbours;
    double m_coldAfter_s; ///< after this time without heat all objects are at the room's temperature
    double m_lastHeat_s = -1e300;
    double m_asked_K = 0.0, m_askedFrom_s = 0.0; ///< set point, and since when it is about this
    double m_now_s = 0.0;
    double m_lostSince_s = 0.0;
    double m_lostLast_s = -1e300;
    std::vector<SafetyFinding> m_present; ///< conditions at this tick, before delays
    std::vector<SafetyFinding> m_active;
    std::vector<Pending> m_rising;
    std::vector<Pending> m_ending;
};

} // namespace bask
