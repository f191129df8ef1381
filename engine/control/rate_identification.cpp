#include "engine/control/rate_identification.h"

#include "engine/control/bounded_least_squares.h"

#include <Eigen/LU>

#include <algorithm>
#include <cmath>

namespace bask {

RateIdentification::RateIdentification(const HeatRates& start)
    : m_start(start), m_timeConstant_s(start.timeConstant_s(start.steadyTemperature_K(0.0))),
      m_information(Eigen::Matrix2d::Identity() / (kPrior * kPrior)) {}

double RateIdentification::cooling_K4(double T_K) const {
    return std::pow(T_K, 4) - m_start.lambda3 / m_start.lambda2 + m_start.air.rate_K_s(T_K) / m_start.lambda2;
}

double RateIdentification::add(double time_s, double temperature_K, double F, double sourceStrength,
                               double neighbours_K4) {
    const double window_s = std::max(kWindow_s, kWindow * m_timeConstant_s);
    double forgetting = kForgetting;
    const double heating = F * sourceStrength;
    const double cooling = cooling_K4(temperature_K) - neighbours_K4;
    if (!std::isfinite(temperature_K) || !std::isfinite(heating) || !std::isfinite(cooling))
        return 0.0;
    // After a pause a single trapezoid would have to represent all changes.
    const auto count = m_samples.size();
    if (count >= 2) {
        const double usual_s = m_samples[count - 1].time_s - m_samples[count - 2].time_s;
        if (time_s - m_samples.back().time_s > std::max(window_s, 3.0 * usual_s))
            m_samples.clear();
    }
    Sample sample{time_s, temperature_K, 0.0, 0.0};
    if (!m_samples.empty()) {
        const Sample& last = m_samples.back();
        const double dt_s = time_s - last.time_s;
        if (!(dt_s > 0.0))
            return 0.0;
        forgetting = std::max(kForgetting, std::exp(-dt_s / (kMemory * m_timeConstant_s)));
        sample.heating = last.heating + 0.5 * dt_s * (m_lastF + heating);
        sample.cooling = last.cooling + 0.5 * dt_s * (m_lastCooling_K4 + cooling);
    }
    m_lastF = heating;
    m_lastCooling_K4 = cooling;
    m_samples.push_back(sample);
    while (m_samples.size() > 3 && time_s - m_samples[1].time_s >= window_s)
        m_samples.pop_front();
    return m_samples.size() >= 3 ? update(m_samples.front(), m_samples.back(), forgetting) : 0.0;
}

double RateIdentification::update(const Sample& from, const Sample& to, double forgetting) {
    const Eigen::Vector2d phi(m_start.lambda1 * (to.heating - from.heating),
                              -m_start.lambda2 * (to.cooling - from.cooling));
    const double change_K = to.temperature_K - from.temperature_K;
    const double surprise = change_K - phi.sum();
    const double guessed = phi.dot(m_information.inverse() * phi) / (kNoise_K * kNoise_K);
    const double missed_K = (change_K - phi.dot(m_relative)) / std::sqrt(1.0 + guessed);
    const Eigen::Matrix2d prior = Eigen::Matrix2d::Identity() / (kPrior * kPrior);
    m_information =
        prior + forgetting * (m_information - prior) + phi * phi.transpose() / (kNoise_K * kNoise_K);
    m_vector = forgetting * m_vector + phi * surprise / (kNoise_K * kNoise_K);
    Eigen::MatrixXd G(4, 2);
    G << 1.0, 0.0, 0.0, 1.0, -1.0, 0.0, 0.0, -1.0;
    const Eigen::Vector4d h(1.0 / kRange - 1.0, 1.0 / kRange - 1.0, 1.0 - kRange, 1.0 - kRange);
    m_relative = Eigen::Vector2d::Ones() + solveBounded(m_information, m_vector, G, h).y;
    return missed_K;
}

HeatRates RateIdentification::rates() const {
    HeatRates rates;
    rates.lambda1 = m_start.lambda1 * m_relative[0];
    rates.lambda2 = m_start.lambda2 * m_relative[1];
    rates.lambda3 = rates.lambda2 * m_start.lambda3 / m_start.lambda2;
    rates.air = m_start.air.scaled(m_relative[1]);
    return rates;
}

double RateIdentification::steadyViewFactorDeviation(double T_K) const {
    const double F = rates().steadyViewFactor(T_K);
    const Eigen::Vector2d slope(-F / m_relative[0], F / m_relative[1]); // F ~ lambda2 / lambda1
    return std::sqrt(slope.dot(m_information.inverse() * slope));
}

} // namespace bask
