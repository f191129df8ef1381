#include "engine/thermal/heat_balance.h"

#include "engine/base/units.h"
#include "engine/thermal/natural_convection.h"

#include <algorithm>
#include <cmath>

namespace bask {
namespace {

AirLoss airLoss(const Air& air, double length_m, double environment_K, double capacity_J_m2K) {
    AirLoss loss;
    if (!air.isKnown())
        return loss;
    loss.air_K = environment_K;
    loss.constant_1_s = air.convection_W_m2K.value_or(0.0) / capacity_J_m2K;
    if (air.isNatural) {
        const NaturalConvection natural = naturalConvection(length_m, environment_K);
        loss.laminar = natural.laminar / capacity_J_m2K;
        loss.turbulent = natural.turbulent / capacity_J_m2K;
    }
    return loss;
}

} // namespace

double netSourcePower_W_m2(SourceModel model, double sourceTemperature_K, double sourceEmittance,
                           double environment_K) {
    const double source = std::pow(sourceTemperature_K, 4);
    const double environment = std::pow(environment_K, 4);
    return model == SourceModel::Gray ? kStefanBoltzmann * sourceEmittance * (source - environment)
                                      : kStefanBoltzmann * (sourceEmittance * source - environment);
}

Surroundings surroundingsOf(SourceModel model, double sourceTemperature_K, double sourceEmittance,
                            double environment_K) {
    return {model,
            netSourcePower_W_m2(model, sourceTemperature_K, sourceEmittance, environment_K),
            environment_K,
            {}};
}

double AirLoss::coefficient_1_s(double T_K) const {
    if (laminar == 0.0 && turbulent == 0.0)
        return constant_1_s;
    const double difference_K = std::abs(T_K - air_K);
    return constant_1_s +
           std::max(laminar * std::pow(difference_K, kLaminarPower), turbulent * std::cbrt(difference_K));
}

double AirLoss::rate_K_s(double T_K) const {
    return coefficient_1_s(T_K) * (T_K - air_K);
}

double AirLoss::slope_1_s(double T_K) const {
    if (laminar == 0.0 && turbulent == 0.0)
        return constant_1_s;
    const double difference_K = std::abs(T_K - air_K);
    const double slow = laminar * std::pow(difference_K, kLaminarPower);
    const double fast = turbulent * std::cbrt(difference_K);
    return constant_1_s + (slow > fast ? (1.0 + kLaminarPower) * slow : (1.0 + 1.0 / 3.0) * fast);
}

AirLoss AirLoss::scaled(double factor) const {
    return {factor * constant_1_s, factor * laminar, factor * turbulent, air_K};
}

double HeatRates::rate_K_s(double F, double T_K) const {
    return lambda1 * F - lambda2 * std::pow(T_K, 4) + lambda3 - air.rate_K_s(T_K);
}

double HeatRates::step_K(double F, double T_K, double dt_s) const {
    const double T3 = T_K * T_K * T_K;
    const double rate = lambda1 * F - lambda2 * T3 * T_K + lambda3;
    const double halfSlope = 2.0 * dt_s * lambda2 * T3; // of the losses, times the step
    if (air.isZero())
        return dt_s * rate / (1.0 + halfSlope);
    return dt_s * (rate - air.rate_K_s(T_K)) / (1.0 + halfSlope + 0.5 * dt_s * air.slope_1_s(T_K));
}

double HeatRates::steadyTemperature_K(double F) const {
    constexpr double kExact_K = 1e-9;
    constexpr int kSteps = 60;
    const double radiating_K = std::pow((lambda1 * F + lambda3) / lambda2, 0.25);
    if (air.isZero() || !(std::abs(radiating_K - air.air_K) > 0.0))
        return radiating_K;
    // The air draws the object from where it would radiate to its own temperature, and not beyond.
    double low_K = std::min(radiating_K, air.air_K), high_K = std::max(radiating_K, air.air_K);
    double T_K = radiating_K;
    for (int k = 0; k < kSteps; ++k) {
        const double rate = rate_K_s(F, T_K);
        (rate > 0.0 ? low_K : high_K) = T_K;
        double next_K = T_K + rate / lossSlope_1_s(T_K);
        if (!(next_K >= low_K && next_K <= high_K))
            next_K = 0.5 * (low_K + high_K);
        const bool isExact = std::abs(next_K - T_K) < kExact_K;
        T_K = next_K;
        if (isExact)
            break;
    }
    return T_K;
}

double HeatRates::steadyViewFactor(double T_K) const {
    return (lambda2 * std::pow(T_K, 4) - lambda3 + air.rate_K_s(T_K)) / lambda1;
}

double HeatRates::lossSlope_1_s(double T_K) const {
    return 4.0 * lambda2 * std::pow(T_K, 3) + air.slope_1_s(T_K);
}

double HeatRates::timeConstant_s(double T_K) const {
    return 1.0 / lossSlope_1_s(T_K);
}

HeatRates HeatRates::inWarmerRoom(double gain_K4) const {
    return {lambda1, lambda2, lambda3 + lambda2 * gain_K4, air};
}

HeatRates HeatRates::scaled(double heating, double losses) const {
    return {lambda1 * heating, lambda2 * losses, lambda3 * losses, air.scaled(losses)};
}

double environmentShare(SourceModel model, const Material& material) {
    return model == SourceModel::Gray ? 1.0 : material.absorptance / material.emittance;
}

HeatRates heatRates(const Material& material, const Surroundings& surroundings, double length_m) {
    const double capacity = material.arealHeatCapacity_J_m2K();
    const double fromEnvironment = environmentShare(surroundings.model, material) * material.emittance;
    HeatRates rates;
    rates.lambda1 = material.absorptance * surroundings.netSourcePower_W_m2 / capacity;
    rates.lambda2 = material.emittance * kStefanBoltzmann / capacity;
    rates.lambda3 = fromEnvironment * kStefanBoltzmann * std::pow(surroundings.environment_K, 4) / capacity;
    rates.air = airLoss(surroundings.air, length_m, surroundings.environment_K, capacity);
    return rates;
}

} // namespace bask
