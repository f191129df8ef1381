#pragma once
// Bask's own controller: identifies each object's heat rates on the way, and goes the way whose predicted
// temperatures come to the targets soonest.
//
// Outer loop, per object: the view factor that would close the error in tau_c,
//     F_des = ((T* - T) / tau_c + lambda2 T^4 - lambda3) / (s lambda1), clamped to [0, 1],
// with s the measured source strength. A look-up over the sampled workspace gives poses that have these view
// factors together (no local minimum), and poses that hold the targets for ever (rests). From both it makes
// plans - two stays and a rest - and compares and improves them by what they cost: the time that each object
// is still away from its target, squared, integrated over the heat balance (heating_plan). The best plan's
// first step is taken; at the next sample it is improved again.
//
// Stability. With right rates and a rest that holds the targets, the cost of a plan is that of its first step
// and of the plan that is left after it. What is left is among the next step's plans and improvement never
// makes worse, so the cost V of the plan in use obeys V(k+1) <= V(k) - (what the step cost): it falls until
// every error is zero, and resting is always among the plans, at which each error decays with the object's
// own time constant (the heat balance is a contraction at a constant pose). For the same reason the robot may
// stand still where temperatures and what the pose holds for ever are within kComeToRest_K of the aim, so
// that noise moves nothing. Wrong rates: what they predict wrongly enters the identification as long as
// anything moves; what remains (convection, a draught) is taken up by a slow integral of the prediction's
// error, the drift. It cannot wind up: it sees predictions, not targets.
//
// Targets that no pose holds together: as soon as the identified rates are sure enough, the servo aims at the
// nearest temperatures that one pose does hold (least squares in K over the workspace).

#include "engine/control/controller.h"
#include "engine/control/heating_plan.h"
#include "engine/control/pose_lookup.h"
#include "engine/control/rate_identification.h"
#include "engine/control/velocity_solve.h"

#include <optional>

namespace bask {

class LevelServo final : public Controller {
public:
    LevelServo(const ControllerSettings& settings, ControlModel model);
    ControlOutput step(const Observation& observation, double dt_s) override;
    void setTargets(const std::vector<double>& targets_K) override;
    void setGeometry(std::shared_ptr<const RigGeometry> geometry) override;
    void setGains(const ControllerSettings& settings) override { m_settings = settings; }

private:
    HeatingTask identify(const Observation& observation, const Eigen::VectorXd& F, double dt_s);
    void learnDrift(std::size_t k, const HeatRates& rates, double T_K, double time_s, double dt_s);
    /// The identified rates of object k tell its steady temperatures within kSure_K.
    bool sure(std::size_t k) const;

    PoseQuery level(const HeatingTask& task) const; ///< the outer loop's view factors
    PoseQuery steady(const HeatingTask& task, const std::vector<double>& aim_K) const;
    Eigen::VectorXd steadyAt_K(const HeatingTask& task, const Vector6d& pose) const;
    /// The present pose holds the objects where they are to be: the robot stands still.
    bool rests(const HeatingTask& task);
    void findRests(const HeatingTask& task);
    void judgeTargets(const Eigen::VectorXd& nearest_K);

    std::vector<HeatingPlan> restingPlans(const HeatingTask& task) const;
    std::vector<HeatingPlan> heatingPlans(const HeatingTask& task, const Vector6d& rest) const;
    /// Time at `pose` until the first (or all) of the objects off their aims has come there; `task` becomes
    /// that moment.
    double stayAt(const Vector6d& pose, bool all, HeatingTask& task) const;
    void choosePlan(const HeatingTask& task);
    VelocitySolution follow(const HeatingTask& task, const Vector6d& lastRates, double dt_s);

    ControllerSettings m_settings;
    ControlModel m_model;
    std::optional<PoseLookup> m_lookup;
    Pose m_tableSource = Pose::Identity(); ///< where the source lay when the look-up was made
    std::vector<RateIdentification> m_identification;
    Eigen::VectorXd m_drift_K_s;   ///< N, what the identified rates leave unexplained, slowly
    Eigen::VectorXd m_expected_K;  ///< N, temperatures at this sample as the last one let expect
    std::vector<Vector6d> m_rests; ///< poses that hold the aim
    std::optional<PricedPlan> m_plan;
    std::vector<double> m_aim_K; ///< the targets, or the nearest temperatures that one pose holds
    bool m_compromise = false;   ///< m_aim_K are not the targets
    bool m_resting = false;
    double m_time_s = 0.0;       ///< of the last step
    double m_nextRest_s = 0.0;   ///< when rests are looked for again
    double m_nextSearch_s = 0.0; ///< when other plans are looked for again
};

} // namespace bask
