#pragma once
// Bask's own controller.

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
    PoseQuery level(const HeatingTask& task) const;
    PoseQuery steady(const HeatingTask& task, const std::vector<double>& aim_K) const;
    void findRest(const HeatingTask& task, double time_s);
    bool sure() const;
    void choosePlan(const HeatingTask& task);
    std::vector<HeatingPlan> proposals(const HeatingTask& task) const;
    VelocitySolution follow(const HeatingTask& task, const Vector6d& lastRates, double dt_s);

    ControllerSettings m_settings;
    ControlModel m_model;
    std::optional<PoseLookup> m_lookup;
    Pose m_tableSource = Pose::Identity(); ///< where the source lay when the look-up was made
    std::vector<RateIdentification> m_identification;
    Eigen::VectorXd m_drift_K_s;   ///< N, what the identified rates leave unexplained, slowly
    Eigen::VectorXd m_expected_K;  ///< N, temperatures at this sample as the last one let expect
    std::vector<Vector6d> m_rests; ///< poses that hold the aim
    std::optional<HeatingPlan> m_plan;
    std::vector<double> m_aim_K; ///< the targets, or the nearest temperatures that one pose holds
    bool m_compromise = false;   ///< m_aim_K are not the targets
    double m_nextRest_s = 0.0;   ///< when rests are looked for again
    double m_cost = 0.0;
    double m_time_s = 0.0;
    double m_nextSearch_s = 0.0; ///< when other plans are looked for again
};

} // namespace bask
