#pragma once
// How wrong the estimate of an object's heat balance may be, and the range in which the object's temperature
// must be now, from a correct reading and the heat since then.

#include "engine/thermal/heat_balance.h"

namespace bask {

/// Model errors that the checks tolerate: heating and radiation losses wrong by up to this factor, plus
/// convection.
inline constexpr double kBorneFactor = 4.0;
inline constexpr double kBorneConvection_W_m2K = 15.0;

/// Range of an object's heat loss coefficient, 1/s: the cooling rate per temperature difference to the room.
struct LossRange {
    double min_1_s = 0.0;
    double max_1_s = 0.0;
};
/// Returns the loss range for the estimated rates and the emittance that belongs to them, for objects up to
/// 100 K above room temperature. Air that is assumed widens it upwards where it takes more than
/// kBorneConvection_W_m2K, and never lifts the lower end: there may be less.
LossRange lossRange(const HeatRates& estimated, double emittance, double environment_K);

/// Integrates the upper and lower limits that the heat balance allows, dT/dt = k p - a (T - T3): p is the
/// absorbed power as estimated, k is within [1/kBorneFactor, kBorneFactor], a is within the loss range.
class HeatBounds {
public:
    static constexpr double kRoom_K = 2.0; ///< the room may be colder or warmer than stated by this

    /// The bounds are infinite until set().
    HeatBounds(LossRange losses, double environment_K);

    /// Sets both bounds to a trusted reading.
    void set(double temperature_K);
    /// Advances the bounds for an absorbed power between these, K/s. With an unknown power (NaN) they become
    /// infinite until the next set().
    void advance(double dt_s, double minPower_K_s, double maxPower_K_s);

    double min_K() const { return m_min_K; }
    double max_K() const { return m_max_K; }
    /// Returns whether a reading with this scatter is within the bounds.
    bool contain(double temperature_K, double scatter_K) const {
        return temperature_K >= m_min_K - scatter_K && temperature_K <= m_max_K + scatter_K;
    }

private:
    LossRange m_losses;
    double m_environment_K;
    double m_min_K, m_max_K;
};

} // namespace bask
