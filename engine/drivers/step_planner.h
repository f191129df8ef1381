#pragma once
// A velocity as bounded steps, for robots that take positions: each step's end is approved before it is sent,
// and of one that turns its way, too.

#include "engine/protocols/axis_map.h"

#include <functional>
#include <optional>

namespace bask {

/// True where the end-effector may go: within its workspace and clear of the source. Coordinates in R.
using MotionGuard = std::function<bool(const Vector6d& target)>;

/// Positions of the axes, mm and degrees in the map's order.
struct PlannedStep {
    std::vector<double> from;
    std::vector<double> to; ///< rounded to a thousandth; its coordinates were approved
    double time_s = 0.0;    ///< that it should take
};

/// How far `at` is outside of the box between two corners, in the worst axis.
double outside(const std::vector<double>& at, const std::vector<double>& a, const std::vector<double>& b);

class StepPlanner {
public:
    static constexpr double kLongest_s = 0.5;
    static constexpr double kMaxTurn_rad = 0.1; ///< of one step
    /// A robot this near to where its last step should have ended goes on from there, so that roundings do
    /// not add up and a slow velocity is not lost in them. mm, degrees.
    static constexpr double kSlack = 0.1;

    StepPlanner(AxisMap map, MotionGuard guard);

    const AxisMap& map() const { return m_map; }
    /// Twist [v; w] in R, m/s and rad/s, wanted from now on for `validFor_s`.
    void setTwist(const Vector6d& twist, double validFor_s, double now_s);
    /// Nothing is wanted any more.
    void forget();
    /// The step to send now to a robot that stands at `at`: towards where the wanted twist leads within what
    /// is left of its time, kLongest_s and kMaxTurn_rad, or the part of it that the guard approves. Empty:
    /// none is due, none is wanted, it is too short for the axes, or the guard refuses it (isRefused).
    std::optional<PlannedStep> next(const std::vector<double>& at, double now_s);
    bool isRefused() const { return m_isRefused; }

private:
    std::vector<double> rounded(const Vector6d& coordinates) const;
    /// The largest of a few shares of `way` that the guard approves; 0: none.
    double approvedShare(const Vector6d& start, const Vector6d& way) const;
    Vector6d startFrom(const std::vector<double>& at) const;

    AxisMap m_map;
    MotionGuard m_guard;
    Vector6d m_twist = Vector6d::Zero();
    double m_expires_s = 0.0;
    double m_notBefore_s = 0.0;
    std::optional<Vector6d> m_goal; ///< of the last step, not rounded
    bool m_isRefused = false;
};

} // namespace bask
