#pragma once
// A robot that carries the objects: its position, and a velocity that expires by itself.

#include "engine/base/pose.h"
#include "engine/base/result.h"

#include <limits>
#include <optional>
#include <string>

namespace bask {

/// State at one time.
struct RobotState {
    double time_s = 0.0;                     ///< time of the reading, on the engine's clock
    Vector6d coordinates = Vector6d::Zero(); ///< end-effector in R, m and rad
    bool moving = false;
    /// False if the controller may not know its own position: restarted, stopped in motion, not homed.
    bool isPlaceSure = true;
    Message alarm = {}; ///< what prevents it from moving until a person has checked it; None if nothing does
};

/// How far a robot falls behind a speed, because of what its controller is set to.
struct RobotLag {
    std::string setting;    ///< the one that holds it up most: "$120=10"
    double planned_s = 0.0; ///< of one of its steps
    double taken_s = 0.0;
    double mean_m_s = 0.0; ///< its speed on a long way
};

/// How far a robot goes by its own account: the end-effector's coordinates in R, m and rad; infinite where it
/// does not tell.
struct RobotReach {
    Vector6d lower = Vector6d::Constant(-std::numeric_limits<double>::infinity());
    Vector6d upper = Vector6d::Constant(std::numeric_limits<double>::infinity());
};

/// Use it only on the engine thread. A call returns an Error if the link is down; the robot then stands
/// still.
class Robot {
public:
    virtual ~Robot() = default;
    virtual Result<RobotState> state() = 0;
    /// Sets the end-effector twist [v; w], R axes, m/s and rad/s. It ends by itself after validFor_s, so the
    /// robot stops if the engine dies.
    virtual Result<void> setTwist(const Vector6d& twist, double validFor_s) = 0;
    /// While it retreats with the objects from the heat, an unsure position does not prevent it from moving.
    virtual void setRetreating(bool isRetreating) { (void)isRetreating; }
    /// Sets the largest speed and rotation for any command, if its controller supports this.
    virtual void limitSpeed(double max_m_s, double max_rad_s) { (void)max_m_s, (void)max_rad_s; }
    /// Returns how it falls behind a speed and a rotation that are commanded for validFor_s each time. Empty
    /// if it follows well enough, or if its controller does not tell.
    virtual std::optional<RobotLag> lagAt(double speed_m_s, double rotation_rad_s, double validFor_s) const {
        (void)speed_m_s, (void)rotation_rad_s, (void)validFor_s;
        return std::nullopt;
    }
    virtual RobotReach reach() const { return {}; }
    /// Sets zero velocity at once.
    virtual Result<void> halt() = 0;
    /// Finds its position again by its switches; moves. Refused if it cannot.
    virtual Result<void> home() = 0;
    /// Clears an alarm or a pause of its controller after a person has checked it; never moves.
    virtual Result<void> clearAlarm() = 0;
};

} // namespace bask
