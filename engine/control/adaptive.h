#pragma once
// The paper's adaptive controller: knows only the geometry, and estimates a1 = 1/lambda1 and a2 =
// lambda2/lambda1 during the run.

#include "engine/control/controller.h"

namespace bask {

/// With zeta = v + mu dtau:  u = J+ (-mu a1 v - K zeta + 4 T a2 v),  da1/dt = gamma1 mu v zeta,  da2/dt = -4
/// gamma2 v zeta T^3. If the experiment says what the air takes, its slope keeps the proportion to lambda2 of
/// the start, so 4 T^3 becomes 4 T^3 + h'(T) / lambda2 in both places and the law stays linear in a2.
/// Estimates stay within a factor kEstimateRange of their start; adaptation pauses while the command is
/// limited or |zeta| is within noise. Source: paper, section IV-B.
class AdaptiveController final : public Controller {
public:
    static constexpr double kEstimateRange = 20.0;
    static constexpr double kZetaDeadZone_K_s = 0.005;

    AdaptiveController(const ControllerSettings& settings, ControlModel model);
    ControlOutput step(const Observation& observation, double dt_s) override;
    void setTargets(const std::vector<double>& targets_K) override { m_model.targets_K = targets_K; }
    void setGeometry(std::shared_ptr<const RigGeometry> geometry) override {
        m_model.geometry = std::move(geometry);
    }
    void setGains(const ControllerSettings& settings) override { m_settings = settings; }

private:
    struct Estimate {
        double a1 = 0.0; ///< s/K
        double a2 = 0.0; ///< 1/K4
        double start1 = 0.0;
        double start2 = 0.0;
    };
    /// Returns the slope of the losses over lambda2, K3.
    double lossSlope_K3(std::size_t i, double T_K) const;
    /// `lossRate_K4_s`: derivative of the losses over lambda2 by time.
    void adapt(Estimate& estimate, double v_K_s, double zeta_K_s, double lossRate_K4_s, double dt_s) const;

    ControllerSettings m_settings;
    ControlModel m_model;
    std::vector<Estimate> m_estimates;
};

} // namespace bask
