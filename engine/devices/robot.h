#pragma once
// A robot that carries the objects: where it is, and a velocity that expires by itself.

#include "engine/base/pose.h"
#include "engine/base/result.h"

namespace bask {

/// State at one moment.
struct RobotState {
    double time_s = 0.0;                     ///< of the reading, on the engine's clock
    Vector6d coordinates = Vector6d::Zero(); ///< end-effector in R, m and rad
    bool moving = false;
    /// False where the controller may not know its own place: restarted, stopped in motion, not homed.
    bool isPlaceSure = true;
    Message alarm = {}; ///< what keeps it from moving until somebody has seen to it; None: nothing
};

/// Used on the engine thread only. A call that finds the link down answers an Error and leaves the robot
/// standing.
class Robot {
public:
    virtual ~Robot() = default;
    virtual Result<RobotState> state() = 0;
    /// End-effector twist [v; w], R axes, m/s and rad/s. It ends by itself after validFor_s: an engine that
    /// dies stops the robot.
    virtual Result<void> setTwist(const Vector6d& twist, double validFor_s) = 0;
    /// While it takes the objects away from the heat a place that is not sure does not keep it from moving.
    virtual void setRetreating(bool isRetreating) { (void)isRetreating; }
    /// The quickest that it may move and turn, whatever it is asked, where its controller can be told so.
    virtual void limitSpeed(double max_m_s, double max_rad_s) { (void)max_m_s, (void)max_rad_s; }
    /// Zero velocity now.
    virtual Result<void> halt() = 0;
    /// Finds its place anew by its switches; moves. Refused where it cannot.
    virtual Result<void> home() = 0;
    /// Clears an alarm or a hold of its controller after a person has seen to it; never moves.
    virtual Result<void> clearAlarm() = 0;
};

} // namespace bask
