#pragma once
// A path of the end-effector for the next minutes and the predicted temperatures; the level servo chooses
// between such plans.

#include "engine/control/rig_geometry.h"
#include "engine/thermal/heat_balance.h"

#include <array>
#include <vector>

namespace bask {

/// A pose and how long the robot stays there, s.
struct Stay {
    Vector6d pose = Vector6d::Zero();
    double time_s = 0.0;
};

/// Straight moves at the robot's limits to each stay in turn, then to the final rest, where it remains.
struct HeatingPlan {
    std::array<Stay, 2> stays;
    Vector6d rest = Vector6d::Zero();

    /// Removes time_s from the first stay. If that stay is over, it is removed and `next` is appended.
    void spend(double time_s, const Stay& next);
    /// Moves every pose with a source that has moved by `motion` in R, as far as the robot can.
    void move(const Pose& motion, const RobotLimits& limits);
};

/// A pose that has moved with a source that has moved by `motion` in R, as far as the robot can.
Vector6d movedWithin(const Vector6d& pose, const Pose& motion, const RobotLimits& limits);

/// The present state of the objects and their aims.
struct HeatingTask {
    Vector6d from = Vector6d::Zero(); ///< the end-effector's coordinates
    std::vector<HeatRates> rates;     ///< N, lambda1 at the source's present strength
    Eigen::VectorXd temperature_K;    ///< N
    Eigen::VectorXd aim_K;            ///< N
};

struct PricedPlan {
    HeatingPlan plan;
    double cost = 0.0; ///< s3
};

/// The cost of plans: for each object the time by which it is away from its aim, squared and integrated from
/// now to infinity under the heat balance, plus a small cost of travel. For a cold object this is the time to
/// heat it with F = 1, of which large errors count as a root; too hot costs more, and rises steeply. Keeps
/// references to geometry and task.
class PlanCost {
public:
    PlanCost(const RigGeometry& geometry, const HeatingTask& task);

    /// Returns residuals whose squares add up to the cost, s sqrt(s).
    Eigen::VectorXd residuals(const HeatingPlan& plan) const;
    double of(const HeatingPlan& plan) const { return residuals(plan).squaredNorm(); }
    /// Optimises stays and times from `plan` (Levenberg-Marquardt) inside workspace and clearance; never
    /// worse than `plan`.
    PricedPlan improve(const HeatingPlan& plan, int iterations) const;

private:
    class Walk;
    struct Places;
    Eigen::VectorXd residuals(const HeatingPlan& plan, const Places* known, Places* seen) const;

    const RigGeometry& m_geometry;
    const HeatingTask& m_task;
    double m_travel_s = 0.0;    ///< root of the cost of a second of travel
    double m_hot_s_K = 0.0;     ///< cost of a kelvin too hot
    Eigen::VectorXd m_cold_s_K; ///< N, time to heat by a kelvin at F = 1
};

} // namespace bask
