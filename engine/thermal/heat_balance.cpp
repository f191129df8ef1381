#include "engine/thermal/heat_balance.h"

#include "engine/base/units.h"

#include <cmath>

namespace bask {

double netSourcePower_W_m2(SourceModel model, double sourceTemperature_K, double sourceEmittance,
                           double environment_K) {
    const double source = std::pow(sourceTemperature_K, 4);
    const double environment = std::pow(environment_K, 4);
    return model == SourceModel::Gray ? kStefanBoltzmann * sourceEmittance * (source - environment)
                                      : kStefanBoltzmann * (sourceEmittance * source - environment);
}

Surroundings surroundingsOf(SourceModel model, double sourceTemperature_K, double sourceEmittance,
                            double environment_K) {
    return {model, netSourcePower_W_m2(model, sourceTemperature_K, sourceEmittance, environment_K),
            environment_K};
}

double HeatRates::rate_K_s(double F, double T_K) const {
    return lambda1 * F - lambda2 * std::pow(T_K, 4) + lambda3;
}

double HeatRates::steadyTemperature_K(double F) const {
    return std::pow((lambda1 * F + lambda3) / lambda2, 0.25);
}

double HeatRates::steadyViewFactor(double T_K) const {
    return (lambda2 * std::pow(T_K, 4) - lambda3) / lambda1;
}

double HeatRates::timeConstant_s(double T_K) const {
    return 1.0 / (4.0 * lambda2 * std::pow(T_K, 3));
}

double environmentShare(SourceModel model, const Material& material) {
    return model == SourceModel::Gray ? 1.0 : material.absorptance / material.emittance;
}

HeatRates heatRates(const Material& material, const Surroundings& surroundings) {
    const double capacity = material.arealHeatCapacity_J_m2K();
    const double fromEnvironment = environmentShare(surroundings.model, material) * material.emittance;
    HeatRates rates;
    rates.lambda1 = material.absorptance * surroundings.netSourcePower_W_m2 / capacity;
    rates.lambda2 = material.emittance * kStefanBoltzmann / capacity;
    rates.lambda3 = fromEnvironment * kStefanBoltzmann * std::pow(surroundings.environment_K, 4) / capacity;
    return rates;
}

} // namespace bask
