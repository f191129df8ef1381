#include "engine/simulation/thermal_plant.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace bask {
namespace {

/// One step of Runge-Kutta 4; State: double or an Eigen vector.
template <class State, class Rate> void stepState(State& T, double h_s, Rate&& rate) {
    const State k1 = rate(T);
    const State k2 = rate(State(T + 0.5 * h_s * k1));
    const State k3 = rate(State(T + 0.5 * h_s * k2));
    const State k4 = rate(State(T + h_s * k3));
    T = T + h_s * (k1 + 2.0 * k2 + 2.0 * k3 + k4) / 6.0;
}

} // namespace

ThermalPlant::ThermalPlant(std::vector<PlantObject> objects, SourceModel model, double environment_K,
                           const Air& air, Neighbours neighbours)
    : m_objects(std::move(objects)), m_model(model), m_environment_K(environment_K), m_air(air),
      m_neighbours(std::move(neighbours)) {}

void ThermalPlant::advance(double dt_s, const std::vector<double>& F, double netSourcePower_W_m2) {
    if (F.size() != m_objects.size())
        throw std::invalid_argument("ThermalPlant: one view factor an object");
    const Surroundings surroundings{m_model, netSourcePower_W_m2, m_environment_K, m_air};
    std::vector<HeatRates> rates;
    for (const PlantObject& object : m_objects)
        rates.push_back(heatRates(object.material, surroundings, object.length_m));
    if (m_neighbours.exchange())
        return advanceTogether(
            dt_s, Eigen::Map<const Eigen::VectorXd>(F.data(), static_cast<Eigen::Index>(F.size())), rates);
    for (std::size_t i = 0; i < m_objects.size(); ++i)
        advanceAlone(dt_s, i, F[i], rates[i]);
}

int ThermalPlant::stepsFor(double dt_s, std::size_t i, double F, const HeatRates& rates) const {
    // Thin objects are stiff: the step stays well under their time constant at the hottest they can be.
    const double hottest_K =
        std::max(m_objects[i].temperature_K, rates.withoutAir().steadyTemperature_K(std::max(F, 1.0)));
    const double stiffness = rates.lossSlope_1_s(hottest_K);
    return std::clamp(static_cast<int>(std::ceil(2.0 * dt_s * stiffness)), 1, 20000);
}

void ThermalPlant::advanceAlone(double dt_s, std::size_t i, double F, const HeatRates& rates) {
    const int steps = stepsFor(dt_s, i, F, rates);
    for (int k = 0; k < steps; ++k)
        stepState(m_objects[i].temperature_K, dt_s / steps,
                  [&](double T_K) { return rates.rate_K_s(F, T_K); });
}

void ThermalPlant::advanceTogether(double dt_s, const Eigen::VectorXd& F,
                                   const std::vector<HeatRates>& rates) {
    const Eigen::VectorXd received = m_neighbours.withReflections(F);
    Eigen::VectorXd T_K(F.size());
    int steps = 1;
    for (std::size_t i = 0; i < m_objects.size(); ++i) {
        T_K[static_cast<Eigen::Index>(i)] = m_objects[i].temperature_K;
        steps = std::max(steps, stepsFor(dt_s, i, received[static_cast<Eigen::Index>(i)], rates[i]));
    }
    Eigen::VectorXd rest_K4(F.size());
    for (Eigen::Index i = 0; i < F.size(); ++i)
        rest_K4[i] = rates[static_cast<std::size_t>(i)].rest_K4();
    const auto rate = [&](const Eigen::VectorXd& now_K) {
        const Eigen::VectorXd gains_K4 =
            m_neighbours.gains_K4(now_K.array().square().square().matrix() - rest_K4);
        Eigen::VectorXd out(now_K.size());
        for (Eigen::Index i = 0; i < out.size(); ++i)
            out[i] =
                rates[static_cast<std::size_t>(i)].inWarmerRoom(gains_K4[i]).rate_K_s(received[i], now_K[i]);
        return out;
    };
    for (int k = 0; k < steps; ++k)
        stepState(T_K, dt_s / steps, rate);
    for (std::size_t i = 0; i < m_objects.size(); ++i)
        m_objects[i].temperature_K = T_K[static_cast<Eigen::Index>(i)];
}

} // namespace bask
