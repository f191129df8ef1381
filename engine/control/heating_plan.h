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

/// Residuals of a plan, K sqrt(s), whose squares add up to its cost: integral of the squared temperature
/// errors (too hot weighs more than too cold) from now on for ever under the heat balance, and a small price
/// on travel.
Eigen::VectorXd planResiduals(const RigGeometry& geometry, const HeatingTask& task, const HeatingPlan& plan);

/// Levenberg-Marquardt on stays and times from `plan`, inside workspace and clearance; never worse than
/// `plan`. `cost` is that of `plan` on entry, of the result on return.
HeatingPlan improvePlan(const RigGeometry& geometry, const HeatingTask& task, const HeatingPlan& plan,
                        int iterations, double& cost);

} // namespace bask
