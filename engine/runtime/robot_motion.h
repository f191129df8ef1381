#pragma once
// What the robot is told: velocities that expire, an operator's moves, homing.

#include "engine/runtime/approach.h"
#include "engine/runtime/rig_readings.h"

#include <functional>
#include <optional>

namespace bask {

/// Borrows its arguments for its life. One thread. When a move may begin is for its owner to say.
class RobotMotion {
public:
    /// Called, with the reason, when the robot does not take a velocity.
    using Refused = std::function<void(const Message& reason)>;

    /// Writes the commanded twist into `sample`.
    RobotMotion(const Experiment& experiment, const RigDevices& devices, const RigReadings& readings,
                const Clock& clock, TraceSample& sample, Refused refused);

    /// Velocities of the pose coordinates, until the next sample.
    void move(const Vector6d& rates);
    void move(const Vector6d& rates, double validFor_s);
    /// Moves off the source, which is too near.
    void backOff();
    void standStill();
    /// Rates commanded last.
    const Vector6d& rates() const { return m_rates; }

    /// Sends the end-effector to coordinates within workspace and clearance; fixed axes stay as they are.
    Result<void> moveTo(const Vector6d& goal);
    Result<void> jog(const Vector6d& twist);
    Result<void> home();
    Result<void> clearAlarm();
    /// Goes on towards the goal of moveTo(). Returns why it does not come nearer; of code None if it does.
    Message goOn();
    /// Ends moveTo() and jog(), not homing.
    void endMove();
    /// Ends moveTo(), jog() and homing.
    void breakOff();
    /// Forgets where moveTo() was going; the last velocity stands.
    void forgetGoal() { m_goal.reset(); }
    /// By moveTo(), jog() or home().
    bool isMoving() const { return m_goal || m_isHoming || m_clock.now_s() < m_jogEnds_s; }
    bool isHoming() const { return m_isHoming; }
    void forgetHoming() { m_isHoming = false; }

    /// Takes what the robot has told: whether it is still homing.
    void watch();
    PlaceState placeState() const;
    /// Age of the robot's coordinates, s; infinite while it has told none.
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
    bool m_isHoming = false;     ///< as asked for, also in a fault: it is then not halted
    bool m_isHomingSeen = false; ///< it has begun
    double m_homingSince_s = 0.0;
};

} // namespace bask
