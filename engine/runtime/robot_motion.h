#pragma once
// The commands to the robot: velocities that expire, an operator's moves, homing.

#include "engine/runtime/approach.h"
#include "engine/runtime/rig_readings.h"

#include <functional>
#include <optional>

namespace bask {

/// Borrows its arguments for its lifetime. One thread. Its owner decides when a move may begin.
class RobotMotion {
public:
    /// Called with the reason when the robot refuses a velocity.
    using Refused = std::function<void(const Message& reason)>;

    /// Writes the commanded twist into `sample`.
    RobotMotion(const Experiment& experiment, const RigDevices& devices, const RigReadings& readings,
                const Clock& clock, TraceSample& sample, Refused refused);

    /// Sets the velocities of the pose coordinates until the next sample.
    void move(const Vector6d& rates);
    void move(const Vector6d& rates, double validFor_s);
    /// Moves away from the source if it is too near.
    void backOff();
    void standStill();
    /// Last commanded rates of the pose coordinates.
    const Vector6d& rates() const { return m_rates; }

    /// Moves the end-effector to coordinates within workspace and clearance; fixed axes keep their values.
    Result<void> moveTo(const Vector6d& goal);
    Result<void> jog(const Vector6d& twist);
    Result<void> home();
    Result<void> clearAlarm();
    /// Returns how the robot falls behind the experiment's largest speed; empty if it follows, or is not
    /// known.
    std::optional<RobotLag> lag() const;
    /// Refuses a workspace that is larger than what the robot says that it reaches: a retreat would end
    /// there.
    Result<void> checkReach() const;
    /// Continues towards the goal of moveTo(). Returns why the robot does not come nearer; code None if it
    /// does.
    Message goOn();
    /// Ends moveTo() and jog(), not homing.
    void endMove();
    /// Ends moveTo(), jog() and homing.
    void breakOff();
    /// Forgets the goal of moveTo(); the last velocity stays commanded.
    void forgetGoal() { m_goal.reset(); }
    /// Whether a moveTo(), jog() or home() is in progress.
    bool isMoving() const { return m_goal || m_isHoming || m_clock.now_s() < m_jogEnds_s; }
    bool isHoming() const { return m_isHoming; }
    void forgetHoming() { m_isHoming = false; }

    /// Updates from the robot's last state whether it is still homing.
    void watch();
    PlaceState placeState() const;
    /// Age of the robot's coordinates, s; infinite if it has not reported any.
    double placeAge_s() const;

private:
    const Experiment& m_experiment;
    const RigDevices& m_devices;
    const RigReadings& m_readings;
    const Clock& m_clock;
    TraceSample& m_sample;
    Refused m_refused;
    Vector6d m_rates = Vector6d::Zero();
    std::optional<Vector6d> m_goal;
    Approach m_approach;
    double m_jogEnds_s = -1e300;
    bool m_isHoming = false;     ///< homing was commanded, also in a fault; the robot is then not halted
    bool m_isHomingSeen = false; ///< homing has begun
    double m_homingSince_s = 0.0;
};

} // namespace bask
