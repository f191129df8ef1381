#pragma once
// Heat rates of one object whose sensor may lag behind it: one identification for each of some lags, and the
// one that explains the readings best.

#include "engine/control/rate_identification.h"

#include <array>
#include <cstddef>
#include <vector>

namespace bask {

/// A sensor of first order with lag L reads the heat balance through the same filter, so the balance of the
/// readings holds with the filtered heating. The lag is the one whose predictions of the readings are best.
class LaggedIdentification {
public:
    explicit LaggedIdentification(const HeatRates& start);

    /// As RateIdentification::add.
    void add(double time_s, double temperature_K, double F, double sourceStrength, double neighbours_K4);
    HeatRates rates() const { return m_lags[m_best].identification.rates(); }
    double steadyViewFactorDeviation(double T_K) const {
        return m_lags[m_best].identification.steadyViewFactorDeviation(T_K);
    }
    double lag_s() const { return kLags_s[m_best]; }
    /// Returns the view factor as the sensor will see it after F has been there for dt_s.
    double seenViewFactor(double F, double dt_s) const;

private:
    static constexpr std::array<double, 6> kLags_s{0.0, 0.7, 1.5, 2.5, 4.0, 6.0};
    struct Lag {
        RateIdentification identification;
        double seen = 0.0;    ///< filtered heating
        double miss_K2 = 0.0; ///< mean of the squared errors of the predictions, the last ones count more
    };
    std::vector<Lag> m_lags;
    std::size_t m_best = 0;
    double m_heating = 0.0;  ///< at the last sample, as are the next two
    double m_strength = 1.0; ///< of the source
    double m_last_s = 0.0;
    int m_count = 0; ///< of samples
};

} // namespace bask
