#pragma once
// The power that an object absorbs, as sensors see it that lag behind it.

#include <array>
#include <cmath>
#include <cstddef>

namespace bask {

class LaggedPower {
public:
    static constexpr std::array<double, 7> kLags_s{0.0, 1.0, 2.0, 3.5, 5.0, 8.0, 15.0}; ///< lags of sensors
    using Energies = std::array<double, kLags_s.size()>; ///< K; one for each lag

    void begin(double power_K_s) { m_power_K_s.fill(power_K_s); }
    /// Advances to a power, K/s, that is reached within dt_s; adds the energies absorbed meanwhile.
    void advance(double dt_s, double power_K_s, Energies& energy_K) {
        for (std::size_t k = 0; k < kLags_s.size(); ++k) {
            const double before_K_s = m_power_K_s[k];
            m_power_K_s[k] +=
                (power_K_s - before_K_s) * (kLags_s[k] > 0.0 ? -std::expm1(-dt_s / kLags_s[k]) : 1.0);
            energy_K[k] += 0.5 * (before_K_s + m_power_K_s[k]) * dt_s;
        }
    }
    double now_K_s() const { return m_power_K_s.front(); } ///< without a lag

private:
    Energies m_power_K_s{};
};

} // namespace bask
