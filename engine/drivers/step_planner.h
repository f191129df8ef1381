#pragma once
// Turns a velocity into bounded steps, for robots that take positions. The end of each step is approved
// before it is sent, and if a step turns, its path is approved, too.

#include "engine/protocols/axis_map.h"

#include <functional>
#include <optional>

namespace bask {

/// Returns whether the end-effector may go there: within its workspace and away from the source. Coordinates
/// in R.
using MotionGuard = std::function<bool(const Vector6d& target)>;

/// Positions of the axes, mm and degrees in the map's order.
struct PlannedStep {
    std::vector<double> from;
    std::vector<double> to; ///< rounded to a thousandth; these coordinates were approved
    double time_s = 0.0;    ///< planned duration
};

/// Returns how far `at` is outside of the box between two corners, in the worst axis.
double outside(const std::vector<double>& at, const std::vector<double>& a, const std::vector<double>& b);

class StepPlanner {
public:
    static constexpr double kLongest_s = 0.5;
    static constexpr double kMaxTurn_rad = 0.1; ///< of one step
    /// If a robot is this near to the end of its last step, the next step starts from that end, so that
    /// rounding errors do not add up and a slow velocity is not lost in them. mm, degrees.
    static constexpr double kSlack = 0.1;

    StepPlanner(AxisMap map, MotionGuard guard);

    const AxisMap& map() const { return m_map; }
    /// Sets the wanted twist [v; w] in R, m/s and rad/s, from now for `validFor_s`.
    void setTwist(const Vector6d& twist, double validFor_s, double now_s);
    /// Plans anew from where the robot is, although the last step has not ended: for robots that take
    /// velocities.
    void renew();
    /// Ends the wanted twist.
    void forget();
    /// Returns the step to send now to a robot that is at `at`: towards the end of the wanted twist within
    /// its remaining time, kLongest_s and kMaxTurn_rad, or the part of it that the guard approves. Empty if
    /// none is due or wanted, if it is too short for the axes, or if the guard refuses it (isRefused).
    std::optional<PlannedStep> next(const std::vector<double>& at, double now_s);
    bool isRefused() const { return m_isRefused; }

private:
    std::vector<double> rounded(const Vector6d& coordinates) const;
    /// Returns the largest of a few fractions of `way` that the guard approves; 0 if none.
    double approvedShare(const Vector6d& start, const Vector6d& way) const;
    Vector6d startFrom(const std::vector<double>& at) const;

    AxisMap m_map;
    MotionGuard m_guard;
    Vector6d m_twist = Vector6d::Zero();
    double m_expires_s = 0.0;
    double m_notBefore_s = 0.0;
    std::optional<Vector6d> m_goal; ///< end of the last step, not rounded
    bool m_isRefused = false;
};

} // namespace bask
