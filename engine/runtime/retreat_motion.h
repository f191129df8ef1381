#pragma once
// The way from the heat: off the source's plane first, then level; and the announced one out of a fault.

#include "engine/runtime/robot_motion.h"

#include <optional>

namespace bask {

/// Borrows its arguments for its life. One thread. When a retreat may begin is for its owner to say.
class RetreatMotion {
public:
    enum class Step {
        UnderWay,
        There,
        Stuck ///< the robot does not come nearer
    };

    RetreatMotion(const Experiment& experiment, const RigDevices& devices, const RigReadings& readings,
                  RobotMotion& motion, const Clock& clock, TraceSample& sample);

    void begin();
    void end();
    /// Moves on for a sampling period.
    Step step();
    /// What is left of the way at the last step, m.
    double left_m() const { return m_left_m; }
    /// The end-effector is off the source, as far as a retreat goes.
    bool isAway() const;

    /// Announces a retreat while it is wanted. Returns whether it is due.
    bool announce(bool isWanted);
    /// The announced one begins then, on the clock; empty: none is.
    const std::optional<double>& announced_s() const { return m_at_s; }
    void callOff() { m_at_s.reset(); }

    /// By STOP, or by a robot that does not move: none begins by itself.
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
    bool m_isRaised = false; ///< the way up is done
    double m_left_m = 0.0;
    std::optional<double> m_at_s;
    bool m_isRefused = false;
};

} // namespace bask
