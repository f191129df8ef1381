#pragma once
// Bask's own controller: asks each object for a view factor instead of an acceleration, and goes to the pose
// that has it.
//
// The heat balance has relative degree one in F. Outer loop, per object:
//     v_des = (T* - T) / tau_c + integral,     F_des = (v_des + lambda2 (T^4 - T3^4)) / (s lambda1), clamped
//     to [0, 1]
// with s the measured source strength (tau_c is lengthened for slow objects, so that noise does not throw
// F_des from bound to bound). Inner step: the pose whose view factors are F_des, by a look-up over the
// sampled workspace, refined with the exact gradient under the robot's limits; of several the one whose
// errors of F, summed over the way there and a while at it, are least.
//
// Stability: with F = F_des and right rates the error obeys de/dt = -e / tau_c. Rates that are wrong by
// factors a = lambda1/lambda1^, b = lambda2/lambda2^ give de/dt = -a e / tau_c + d with a slowly varying d =
// (b - a) lambda2^ (T^4 - T3^4): still a contraction for every a > 0, with the offset d tau_c / a, which
// identification and, near the target, the integral take away. Under a clamp F_des is at the bound, the error
// shrinks at the physical rate, and the integral stands still.
//
// Targets that no pose holds together: as soon as the identified rates are sure enough, the servo aims at the
// nearest temperatures that one pose does hold (least squares in K over the workspace), instead of wandering
// between poses.

#include "engine/control/controller.h"
#include "engine/control/pose_lookup.h"
#include "engine/control/rate_identification.h"

#include <optional>

namespace bask {

class LevelServo final : public Controller {
public:
    LevelServo(const ControllerSettings& settings, ControlModel model);
    ControlOutput step(const Observation& observation, double dt_s) override;
    void setTargets(const std::vector<double>& targets_K) override;
    void setGeometry(std::shared_ptr<const RigGeometry> geometry) override {
        m_model.geometry = std::move(geometry);
        m_lookup.reset();
    }
    void setGains(const ControllerSettings& settings) override { m_settings = settings; }

private:
    PoseQuery query(const Observation& observation, double dt_s);
    std::vector<Vector6d> candidates(const PoseQuery& query, int count) const;
    double cost(const PoseQuery& query, const Vector6d& goal) const;
    Vector6d choosePose(const PoseQuery& query) const;
    void updateAim(const Observation& observation);

    ControllerSettings m_settings;
    ControlModel m_model;
    std::optional<PoseLookup> m_lookup;
    std::vector<RateIdentification> m_identification;
    std::vector<double> m_integral_K_s; ///< N, wanted rate from the integral action
    Eigen::VectorXd m_unmet;            ///< N, F_des - F of the pose chosen last
    double m_unmetTime_s = 0.0;         ///< how long that has been more than a trifle
    std::optional<Vector6d> m_goal;
    std::vector<double> m_aim_K; ///< the targets, or the nearest temperatures that one pose holds
    bool m_compromise = false;   ///< m_aim_K are not the targets
    double m_nextAim_s = 0.0;    ///< when the aim is looked at again
};

} // namespace bask
