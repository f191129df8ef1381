#pragma once
// True temperatures of the simulated objects: radiation and convection as modelled.

#include "engine/radiation/neighbours.h"
#include "engine/thermal/heat_balance.h"

#include <vector>

namespace bask {

/// One lumped object.
struct PlantObject {
    Material material;
    double temperature_K = 298.15;
    double length_m = 0.0; ///< area over perimeter; only used for natural convection
};

/// Integrates the heat balance of heatRates() by Runge-Kutta 4, with the air that there is (not: that is
/// assumed), and with what the objects exchange with one another.
class ThermalPlant {
public:
    ThermalPlant(std::vector<PlantObject> objects, SourceModel model, double environment_K, const Air& air,
                 Neighbours neighbours = {});

    /// Advances by dt_s, in as many steps as the thinnest object needs, with constant view factors F (without
    /// what neighbours reflect) and net source power J (W/m2).
    void advance(double dt_s, const std::vector<double>& F, double netSourcePower_W_m2);
    /// Warms an object by something other than the source.
    void warm(std::size_t i, double by_K) { m_objects[i].temperature_K += by_K; }
    double temperature_K(std::size_t i) const { return m_objects[i].temperature_K; }
    std::size_t size() const { return m_objects.size(); }

private:
    void advanceAlone(double dt_s, std::size_t i, double F, const HeatRates& rates);
    void advanceTogether(double dt_s, const Eigen::VectorXd& F, const std::vector<HeatRates>& rates);
    int stepsFor(double dt_s, std::size_t i, double F, const HeatRates& rates) const;

    std::vector<PlantObject> m_objects;
    SourceModel m_model;
    double m_environment_K;
    Air m_air;
    Neighbours m_neighbours;
};

} // namespace bask
