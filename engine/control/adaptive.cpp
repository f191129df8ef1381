#include "engine/control/adaptive.h"

#include "engine/control/paper_law.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace bask {

AdaptiveController::AdaptiveController(const ControllerSettings& settings, ControlModel model)
    : m_settings(settings), m_model(std::move(model)) {
    for (const HeatRates& rates : m_model.estimated) {
        const double a1 = 1.0 / rates.lambda1;
        const double a2 = rates.lambda2 / rates.lambda1;
        m_estimates.push_back({a1, a2, a1, a2});
    }
}

double AdaptiveController::lossSlope_K3(std::size_t i, double T_K) const {
    const HeatRates& start = m_model.estimated[i];
    return 4.0 * std::pow(T_K, 3) + start.air.slope_1_s(T_K) / start.lambda2;
}

void AdaptiveController::adapt(Estimate& estimate, double v_K_s, double zeta_K_s, double lossRate_K4_s,
                               double dt_s) const {
    if (std::abs(zeta_K_s) < kZetaDeadZone_K_s)
        return;
    const AdaptiveGains& gains = m_settings.adaptive;
    const auto within = [](double value, double start) {
        return std::clamp(value, start / kEstimateRange, start * kEstimateRange);
    };
    estimate.a1 = within(estimate.a1 + dt_s * gains.gamma1 * gains.mu * v_K_s * zeta_K_s, estimate.start1);
    estimate.a2 = within(estimate.a2 - dt_s * gains.gamma2 * zeta_K_s * lossRate_K4_s, estimate.start2);
}

ControlOutput AdaptiveController::step(const Observation& observation, double dt_s) {
    const auto N = m_estimates.size();
    if (observation.objects.size() != N)
        throw std::invalid_argument("AdaptiveController: wrong number of objects");
    const AdaptiveGains& gains = m_settings.adaptive;
    Eigen::VectorXd wanted(static_cast<Eigen::Index>(N));
    std::vector<double> zeta(N);
    Eigen::VectorXd lossRates_K4_s = -neighbourGainRates_K4_s(*m_model.geometry, observation);
    for (std::size_t i = 0; i < N; ++i) {
        const auto [T, v] = observation.objects[i];
        const Estimate& estimate = m_estimates[i];
        zeta[i] = v + gains.mu * (T - m_model.targets_K[i]);
        const auto row = static_cast<Eigen::Index>(i);
        lossRates_K4_s[row] += lossSlope_K3(i, T) * v;
        wanted[row] = -gains.mu * estimate.a1 * v - gains.K * zeta[i] + estimate.a2 * lossRates_K4_s[row];
    }
    const ViewFactors seen = m_model.geometry->viewFactors(observation.coordinates);
    ControlOutput out = followWanted(*m_model.geometry, m_settings, observation, dt_s,
                                     seen.dF * observation.sourceStrength, wanted);
    leaveDark(*m_model.geometry, observation, seen, m_model.targets_K, dt_s, out);
    for (std::size_t i = 0; i < N; ++i) {
        if (!out.limits.any())
            adapt(m_estimates[i], observation.objects[i].rate_K_s, zeta[i],
                  lossRates_K4_s[static_cast<Eigen::Index>(i)], dt_s);
        const HeatRates& start = m_model.estimated[i];
        HeatRates rates;
        rates.lambda1 = 1.0 / m_estimates[i].a1;
        rates.lambda2 = m_estimates[i].a2 * rates.lambda1;
        rates.lambda3 = rates.lambda2 * start.lambda3 / start.lambda2;
        rates.air = start.air.scaled(rates.lambda2 / start.lambda2);
        out.estimate.push_back(rates);
    }
    return out;
}

} // namespace bask
