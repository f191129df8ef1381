#pragma once
// A way of the end-effector for the next minutes and the temperatures that it would give: what the level
// servo chooses between.

#include "engine/control/rig_geometry.h"
#include "engine/thermal/heat_balance.h"

#include <array>
#include <vector>

namespace bask {

/// Time at a pose, s.
struct Stay {
    Vector6d pose = Vector6d::Zero();
    double time_s = 0.0;
};

/// Straight ways at the robot's limits to each stay in turn, then to the rest, for ever.
struct HeatingPlan {
    std::array<Stay, 2> stays;
    Vector6d rest = Vector6d::Zero();

    /// Takes time_s from the first stay; one that is over makes room for `next` at the end.
    void spend(double time_s, const Stay& next);
    /// Takes every pose along with a source that has moved by `motion` in R, as far as the robot can.
    void move(const Pose& motion, const RobotLimits& limits);
};

/// Present state of the objects, and what they are to come to.
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

/// What plans cost: for each object the time that it is still away from its aim, squared and integrated from
/// now on for ever under the heat balance, and a small price on travel. Cold, that is the time to heat it
/// with F = 1, of which large errors count as a root; too hot counts for more, and steeply. Refers to
/// geometry and task.
class PlanCost {
public:
    PlanCost(const RigGeometry& geometry, const HeatingTask& task);

    /// Residuals whose squares add up to the cost, s sqrt(s).
    Eigen::VectorXd residuals(const HeatingPlan& plan) const;
    double of(const HeatingPlan& plan) const { return residuals(plan).squaredNorm(); }
    /// Levenberg-Marquardt on stays and times from `plan`, inside workspace and clearance; never worse than
    /// `plan`.
    PricedPlan improve(const HeatingPlan& plan, int iterations) const;

private:
    class Walk;
    struct Places;
    Eigen::VectorXd residuals(const HeatingPlan& plan, const Places* known, Places* seen) const;

    const RigGeometry& m_geometry;
    const HeatingTask& m_task;
    double m_hot_s_K = 0.0;     ///< what a kelvin too hot counts as
    Eigen::VectorXd m_cold_s_K; ///< N, time to heat by a kelvin at F = 1
};

} // namespace bask
