#include "engine/runtime/heat_bounds.h"

#include "engine/base/units.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace bask {

LossRange lossRange(const HeatRates& estimated, double emittance, double environment_K) {
    // radiation of an object 100 K above room temperature, relative to the linear law
    constexpr double kHot = 1.6;
    constexpr double kHot_K = 100.0;
    const double radiation_1_s = 1.0 / estimated.withoutAir().timeConstant_s(environment_K);
    const double capacity_J_m2K = emittance * kStefanBoltzmann / estimated.lambda2;
    const double convection_1_s =
        std::max(kBorneConvection_W_m2K / capacity_J_m2K, estimated.air.slope_1_s(environment_K + kHot_K));
    return {radiation_1_s / kBorneFactor, kBorneFactor * (kHot * radiation_1_s + convection_1_s)};
}

HeatBounds::HeatBounds(LossRange losses, double environment_K)
    : m_losses(losses), m_environment_K(environment_K), m_min_K(-std::numeric_limits<double>::infinity()),
      m_max_K(-m_min_K) {}

void HeatBounds::set(double temperature_K) {
    m_min_K = m_max_K = temperature_K;
}

void HeatBounds::advance(double dt_s, double minPower_K_s, double maxPower_K_s) {
    if (std::isnan(minPower_K_s) || std::isnan(maxPower_K_s)) {
        *this = HeatBounds(m_losses, m_environment_K);
        return;
    }
    const auto go = [&](double& T_K, double power, double room_K, double loss_1_s) {
        T_K += (room_K + power / loss_1_s - T_K) * -std::expm1(-loss_1_s * dt_s);
    };
    const double warm_K = m_environment_K + kRoom_K, cold_K = m_environment_K - kRoom_K;
    if (std::isfinite(m_max_K))
        go(m_max_K, kBorneFactor * maxPower_K_s, warm_K,
           m_max_K > warm_K ? m_losses.min_1_s : m_losses.max_1_s);
    if (std::isfinite(m_min_K))
        go(m_min_K, minPower_K_s / kBorneFactor, cold_K,
           m_min_K > cold_K ? m_losses.max_1_s : m_losses.min_1_s);
}

} // namespace bask
