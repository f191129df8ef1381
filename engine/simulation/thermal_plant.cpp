#include "engine/simulation/thermal_plant.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace bask {

ThermalPlant::ThermalPlant(std::vector<PlantObject> objects, SourceModel model, double environment_K,
                           const Air& air)
    : m_objects(std::move(objects)), m_model(model), m_environment_K(environment_K), m_air(air) {}

void ThermalPlant::advance(double dt_s, const std::vector<double>& F, double netSourcePower_W_m2) {
    if (F.size() != m_objects.size())
        throw std::invalid_argument("ThermalPlant: one view factor an object");
    for (std::size_t i = 0; i < m_objects.size(); ++i) {
        PlantObject& object = m_objects[i];
        const HeatRates rates = heatRates(
            object.material, {m_model, netSourcePower_W_m2, m_environment_K, m_air}, object.length_m);
        const auto rate = [&](double T_K) { return rates.rate_K_s(F[i], T_K); };
        // Thin objects are stiff: the step stays well under their time constant at the hottest they can be.
        const double hottest_K = std::max(object.temperature_K, rates.withoutAir().steadyTemperature_K(1.0));
        const double stiffness = rates.lossSlope_1_s(hottest_K);
        const int steps = std::clamp(static_cast<int>(std::ceil(2.0 * dt_s * stiffness)), 1, 20000);
        const double h_s = dt_s / steps;
        for (int k = 0; k < steps; ++k) {
            const double T = object.temperature_K;
            const double k1 = rate(T);
            const double k2 = rate(T + 0.5 * h_s * k1);
            const double k3 = rate(T + 0.5 * h_s * k2);
            const double k4 = rate(T + h_s * k3);
            object.temperature_K = T + h_s * (k1 + 2.0 * k2 + 2.0 * k3 + k4) / 6.0;
        }
    }
}

} // namespace bask
