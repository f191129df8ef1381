#pragma once
// Bask's own controller: identifies each object's heat rates during the run, and takes the path whose
// predicted temperatures reach the targets soonest.
//
// Outer loop, for each object: the view factor that would correct the error in tau_c,
//     F_des = ((T* - T) / tau_c + lambda2 T^4 - lambda3 + h' (T - T3)) / (s lambda1), clamped to [0, 1],
// with s the measured source strength and h' that of the air where the experiment states it. A look-up over
// the sampled workspace gives poses that have these view factors together (no local minimum), and poses at
// which the targets are steady (rests). From both it makes plans - two stays and a rest - and compares and
// improves them by their cost: the time by which each object is away from its target, squared, integrated
// over the heat balance (heating_plan). The first step of the best plan is taken; at the next sample it is
// improved again.
//
// Stability. If the rates are correct and a rest has the targets as steady temperatures, the cost of a plan
// is the cost of its first step plus that of the plan that remains after it. The remaining plan is one of the
// next step's plans, and improvement never makes it worse, so the cost V of the plan in use satisfies V(k+1)
// <= V(k) - (cost of the step): it decreases until every error is zero. Resting is always one of the plans;
// then each error decays with the object's own time constant (the heat balance is a contraction at a constant
// pose). For the same reason the robot may hold a rest, that is go there straight and stand, as soon as
// every temperature is near its aim and stays so on the way: then no plan is made, and noise moves nothing.
// If the rates are wrong, their prediction errors enter the identification as long as anything moves; the
// remainder (convection, a draught) is compensated by a slow integral of the prediction error, the drift. It
// cannot wind up, because it depends on predictions, not on targets.
//
// If no pose has all targets as steady temperatures, the servo aims at the nearest ones that a pose does have
// (least squares in K over the workspace), as soon as the identified rates are certain enough.

#include "engine/control/controller.h"
#include "engine/control/heating_plan.h"
#include "engine/control/lagged_identification.h"
#include "engine/control/pose_lookup.h"
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
    /// Returns the reading of object k, its noise reduced by what the last step predicted, and learns the
    /// drift from their difference. A reading that rates still guessed predicted is returned as it is.
    double observe(std::size_t k, const HeatRates& rates, const Observation& observation, double dt_s);
    /// Returns whether the identified rates of object k determine its steady temperatures within kSure_K.
    bool sure(std::size_t k) const;
    bool allSure() const;

    PoseQuery level(const HeatingTask& task) const; ///< the outer loop's view factors
    PoseQuery steady(const HeatingTask& task, const std::vector<double>& aim_K) const;
    Eigen::VectorXd steadyAt_K(const HeatingTask& task, const Eigen::VectorXd& F) const;
    /// Farthest present temperature from its aim.
    static double farthest_K(const HeatingTask& task);
    /// Farthest steady temperature of a pose from its aim.
    double missedAt_K(const HeatingTask& task, const Vector6d& pose) const;
    /// Objects farther from their aim than this are still moved there by plans.
    double farthestHold_K() const;
    /// Returns whether every temperature stays near its aim on the straight way to a rest.
    bool arrivesNear(const HeatingTask& task, const Vector6d& rest) const;
    /// Takes up or gives up a rest to go to and stand at.
    void chooseHold(const HeatingTask& task);
    void correctHold(const HeatingTask& task);
    void findRests(const HeatingTask& task);
    void judgeTargets(const Eigen::VectorXd& nearest_K);

    std::vector<HeatingPlan> restingPlans(const HeatingTask& task) const;
    std::vector<HeatingPlan> heatingPlans(const HeatingTask& task, const Vector6d& rest) const;
    /// Returns a stay at `pose` until the first (or all) of the objects away from their aims has reached it;
    /// advances `task` to that time.
    double stayAt(const Vector6d& pose, bool all, HeatingTask& task) const;
    void choosePlan(const HeatingTask& task);
    VelocitySolution follow(const HeatingTask& task, const Vector6d& lastRates, double dt_s);

    ControllerSettings m_settings;
    ControlModel m_model;
    std::optional<PoseLookup> m_lookup;
    Pose m_tableSource = Pose::Identity(); ///< pose of the source when the look-up was made
    double m_tableSource_K = 0.0;          ///< its temperature, if it is uneven
    std::vector<LaggedIdentification> m_identification;
    Eigen::VectorXd m_read_K;    ///< N, present readings
    Eigen::VectorXd m_drift_K_s; ///< N, slow rate that the identified rates do not explain
    /// N, what the neighbours heat now beyond what they will at their aims
    Eigen::VectorXd m_early_K_s;
    Eigen::VectorXd m_expected_K;  ///< N, temperatures predicted for this sample by the last one
    std::vector<Vector6d> m_rests; ///< poses at which the aim is steady
    std::optional<PricedPlan> m_plan;
    std::vector<double> m_aim_K;    ///< the targets, or the nearest temperatures that one pose has
    bool m_compromise = false;      ///< whether m_aim_K differs from the targets
    double m_unavoidable_K = 0.0;   ///< by which the best pose misses the aim; 0 while rates are not sure
    std::optional<Vector6d> m_hold; ///< the rest that the robot is at, or goes to
    double m_nearSince_s = 0.0;     ///< since when every temperature may be held
    Eigen::VectorXd m_heldOff_K;    ///< N, distances from the aim when the rest was taken
    double m_missedSince_s = 0.0;   ///< since when the steady temperatures of the hold miss the aim
    double m_time_s = 0.0;          ///< of the last step
    double m_nextRest_s = 0.0;      ///< time of the next search for rests
    double m_nextSearch_s = 0.0;    ///< time of the next search for other plans
};

} // namespace bask
