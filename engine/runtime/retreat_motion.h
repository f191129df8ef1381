#pragma once
// The motion away from the heat: first off the source's plane, then level. Also announces a retreat out of a
// fault.

#include "engine/runtime/robot_motion.h"

#include <optional>

namespace bask {

/// Borrows its arguments for its lifetime. One thread. Its owner decides when a retreat may begin.
class RetreatMotion {
public:
    enum class Step {
        UnderWay,
        There,
        Stuck ///< the robot does not come nearer to its goal
    };

    RetreatMotion(const Experiment& experiment, const RigDevices& devices, const RigReadings& readings,
                  RobotMotion& motion, const Clock& clock, TraceSample& sample);

    void begin();
    void end();
    /// Continues the retreat for one sampling period.
    Step step();
    /// Remaining distance at the last step, m.
    double left_m() const { return m_left_m; }
    /// Returns whether the end-effector is as far off the source as a retreat moves it.
    bool isAway() const;
    /// Returns the longest way off the source within the workspace, m.
    double longest_m() const;

    /// Announces a retreat while it is wanted, and cancels it otherwise. Returns whether it is due.
    bool announce(bool isWanted);
    /// Time on the clock when the announced retreat begins; empty if none is announced.
    const std::optional<double>& announced_s() const { return m_at_s; }
    void callOff() { m_at_s.reset(); }

    /// Whether no retreat begins by itself, because of STOP or of a robot that does not move.
    bool isRefused() const { return m_isRefused; }
    void setRefused(bool isRefused) { m_isRefused = isRefused; }

private:
    const Experiment& m_experiment;
    const RigDevices& m_devices;
    const RigReadings& m_readings;
    RobotMotion& m_motion;
    const Clock& m_clock;
    TraceSample& m_sample;
    Approach m_approach;
    bool m_isRaised = false; ///< the motion off the source's plane is done
    double m_left_m = 0.0;
    std::optional<double> m_at_s;
    bool m_isRefused = false;
};

} // namespace bask
