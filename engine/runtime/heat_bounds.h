#pragma once
// How wrong the estimate of an object's heat balance may be, and between which temperatures an object is by
// now, from a reading that was right and the heat since then.

#include "engine/thermal/heat_balance.h"

namespace bask {

/// What watches bear: heating and losses by radiation wrong within this factor, and moving air besides.
inline constexpr double kBorneFactor = 4.0;
inline constexpr double kBorneConvection_W_m2K = 15.0;

/// Between which an object loses heat, 1/s, times its temperature over the room's.
struct LossRange {
    double min_1_s = 0.0;
    double max_1_s = 0.0;
};
/// By the estimated rates and the emittance that belongs to them, for objects up to 100 K over the room.
LossRange lossRange(const HeatRates& estimated, double emittance, double environment_K);

/// Integrates the fastest and the slowest that the heat balance allows, dT/dt = k p - a (T - T3): p the
/// absorbed power as it is estimated, k within [1/kBorneFactor, kBorneFactor], a within the losses.
class HeatBounds {
public:
    static constexpr double kRoom_K = 2.0; ///< the room may be so much colder or warmer than it is said to be

    /// Tells nothing until set().
    HeatBounds(LossRange losses, double environment_K);

    /// A reading that is believed.
    void set(double temperature_K);
    /// Under an absorbed power between these, K/s; of one that is not known (NaN) nothing is told any more.
    void advance(double dt_s, double minPower_K_s, double maxPower_K_s);

    double min_K() const { return m_min_K; }
    double max_K() const { return m_max_K; }
    /// Of a reading with this much scatter.
    bool contain(double temperature_K, double scatter_K) const {
        return temperature_K >= m_min_K - scatter_K && temperature_K <= m_max_K + scatter_K;
    }

private:
    LossRange m_losses;
    double m_environment_K;
    double m_min_K, m_max_K;
};

} // namespace bask
