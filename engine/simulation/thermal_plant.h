#pragma once
// True temperatures of the simulated objects: radiation as modelled, and convection that no controller knows.

#include "engine/thermal/heat_balance.h"

#include <vector>

namespace bask {

/// One lumped object.
struct PlantObject {
    Material material;
    double temperature_K = 298.15;
};

/// Integrates dT/dt = lambda1 F - lambda2 T^4 + lambda3 - h (T - T3) / C, with the rates of heatRates() and
/// C = m c / A, by Runge-Kutta 4.
class ThermalPlant {
public:
    ThermalPlant(std::vector<PlantObject> objects, SourceModel model, double environment_K,
                 double convection_W_m2K);

    /// Advances by dt_s, in as many steps as the thinnest object needs, with constant view factors F and net
    /// source power J (W/m2).
    void advance(double dt_s, const std::vector<double>& F, double netSourcePower_W_m2);
    /// Warms an object by something other than the source.
    void warm(std::size_t i, double by_K) { m_objects[i].temperature_K += by_K; }
    double temperature_K(std::size_t i) const { return m_objects[i].temperature_K; }
    std::size_t size() const { return m_objects.size(); }

private:
    std::vector<PlantObject> m_objects;
    SourceModel m_model;
    double m_environment_K;
    double m_convection_W_m2K;
};

} // namespace bask
