#include "engine/control/lagged_identification.h"

#include <algorithm>
#include <cmath>

namespace bask {
namespace {

constexpr double kForgottenMiss = 0.02; ///< share of a new error in the mean
constexpr double kClearlyBetter = 0.6;  ///< of the mean squared error, for another lag to be taken
constexpr double kFloor_K = 0.02;       ///< smaller differences of the errors tell nothing of the lag
constexpr int kMinPredictions = 20;

/// What a first-order lag makes of an input that goes from `before` to `now` on a line over dt_s.
double lagged(double seen, double before, double now, double lag_s, double dt_s) {
    if (lag_s <= 0.0)
        return now;
    if (dt_s <= 0.0)
        return seen;
    const double kept = std::exp(-dt_s / lag_s);
    const double ofBefore = (1.0 - kept) * lag_s / dt_s - kept;
    return kept * seen + ofBefore * before + (1.0 - kept - ofBefore) * now;
}

} // namespace

LaggedIdentification::LaggedIdentification(const HeatRates& start)
    : m_lags(kLags_s.size(), Lag{RateIdentification(start)}) {}

void LaggedIdentification::add(double time_s, double temperature_K, double F, double sourceStrength,
                               double neighbours_K4) {
    const double heating = F * sourceStrength;
    if (!std::isfinite(heating) || !std::isfinite(temperature_K))
        return;
    const double dt_s = time_s - m_last_s;
    m_last_s = time_s;
    m_strength = sourceStrength;
    for (std::size_t k = 0; k < m_lags.size(); ++k) {
        Lag& lag = m_lags[k];
        lag.seen = m_count > 0 ? lagged(lag.seen, m_heating, heating, kLags_s[k], dt_s) : heating;
        const double miss_K = lag.identification.add(time_s, temperature_K, lag.seen, 1.0, neighbours_K4);
        lag.miss_K2 += kForgottenMiss * (miss_K * miss_K - lag.miss_K2);
    }
    m_heating = heating;
    if (++m_count < kMinPredictions)
        return;
    const auto best =
        static_cast<std::size_t>(std::ranges::min_element(m_lags, {}, &Lag::miss_K2) - m_lags.begin());
    if (m_lags[m_best].miss_K2 - m_lags[best].miss_K2 > kFloor_K * kFloor_K &&
        m_lags[best].miss_K2 < kClearlyBetter * m_lags[m_best].miss_K2)
        m_best = best;
}

double LaggedIdentification::seenViewFactor(double F, double dt_s) const {
    return lagged(m_lags[m_best].seen / m_strength, F, F, lag_s(), dt_s);
}

} // namespace bask
