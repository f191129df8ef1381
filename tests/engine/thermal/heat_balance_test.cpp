#include "engine/base/units.h"
#include "engine/thermal/heat_balance.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace bask {
namespace {

HeatRates standardRates(SourceModel model, double environment_degC) {
    const double T3 = kelvinFromCelsius(environment_degC);
    const Material painted{"painted", 0.9, 0.9, 904.0, 2700.0, 0.001, 1.0};
    return heatRates(painted, surroundingsOf(model, kelvinFromCelsius(200.0), 0.25, T3));
}

double viewFactorFor(SourceModel model, double environment_degC, double target_degC) {
    return standardRates(model, environment_degC).steadyViewFactor(kelvinFromCelsius(target_degC));
}

} // namespace

TEST(HeatBalance, PaperSourceNeedsTheViewFactorsOfItsFeasibilitySection) {
    EXPECT_NEAR(viewFactorFor(SourceModel::Paper, 25.0, 30.0), 0.1175, 5e-5);
    EXPECT_NEAR(viewFactorFor(SourceModel::Paper, 25.0, 40.0), 0.3705, 5e-5);
    EXPECT_NEAR(viewFactorFor(SourceModel::Paper, 25.0, 50.0), 0.6488, 1e-4);
    EXPECT_NEAR(viewFactorFor(SourceModel::Paper, 23.0, 40.0), 0.40, 5e-3);
}

TEST(HeatBalance, CeilingsOfBothSourceModels) {
    EXPECT_NEAR(celsiusFromKelvin(standardRates(SourceModel::Paper, 25.0).steadyTemperature_K(1.0)), 61.4,
                0.05);
    EXPECT_NEAR(celsiusFromKelvin(standardRates(SourceModel::Gray, 25.0).steadyTemperature_K(1.0)), 95.4,
                0.05);
    EXPECT_NEAR(celsiusFromKelvin(standardRates(SourceModel::Gray, 25.0).steadyTemperature_K(0.0)), 25.0,
                1e-9);
}

// Catches the absorptance for the source's light taken for the room's radiation, too.
TEST(HeatBalance, NoMaterialSettlesAboveTheRoomWithoutASource) {
    std::mt19937_64 random(1);
    std::uniform_real_distribution<double> share(0.02, 1.0), room_K(250.0, 330.0);
    for (int k = 0; k < 1000; ++k) {
        const Material material{"", share(random), share(random), 900.0, 2700.0, 0.001, 1.0};
        const double T1 = kelvinFromCelsius(300.0), eps1 = share(random), T3 = room_K(random);
        const HeatRates rates = heatRates(material, surroundingsOf(SourceModel::Gray, T1, eps1, T3));
        EXPECT_NEAR(rates.steadyTemperature_K(0.0), T3, 1e-9);
        const double source_K4 =
            material.absorptance / material.emittance * eps1 * (std::pow(T1, 4) - std::pow(T3, 4));
        EXPECT_NEAR(rates.steadyTemperature_K(1.0), std::pow(std::pow(T3, 4) + source_K4, 0.25), 1e-9);
    }
}

TEST(HeatBalance, ThePapersModelTakesTheAbsorptanceForTheRoomToo) {
    const Material material{"", 0.7, 0.9, 900.0, 2700.0, 0.001, 1.0};
    const double T3 = kelvinFromCelsius(25.0);
    const auto rates = [&](SourceModel model) {
        return heatRates(material, surroundingsOf(model, kelvinFromCelsius(200.0), 0.25, T3));
    };
    EXPECT_NEAR(celsiusFromKelvin(rates(SourceModel::Paper).steadyTemperature_K(0.0)), 44.3, 0.05);
    EXPECT_NEAR(celsiusFromKelvin(rates(SourceModel::Gray).steadyTemperature_K(0.0)), 25.0, 1e-9);
}

TEST(HeatBalance, ArealHeatCapacitiesOfTheStandardObjects) {
    EXPECT_NEAR((Material{"", 0.9, 0.9, 904.0, 2700.0, 0.001, 1.0}.arealHeatCapacity_J_m2K()), 2440.0, 1.0);
    EXPECT_NEAR((Material{"", 0.9, 0.9, 1800.0, 1240.0, 0.001, 0.3}.arealHeatCapacity_J_m2K()), 670.0, 1.0);
    EXPECT_NEAR((Material{"", 0.9, 0.9, 1800.0, 1240.0, 0.001, 0.5}.arealHeatCapacity_J_m2K()), 1116.0, 1.0);
}

TEST(HeatBalance, BareAluminiumIsAsSlowAsThePaperSays) {
    const double T3 = kelvinFromCelsius(25.0);
    const Material bare{"bare", 0.04, 0.04, 900.0, 2700.0, 0.003, 1.0};
    const HeatRates rates =
        heatRates(bare, surroundingsOf(SourceModel::Paper, kelvinFromCelsius(200.0), 0.25, T3));
    EXPECT_NEAR(rates.lambda1, 1.5e-3, 1e-4);
    EXPECT_NEAR(rates.timeConstant_s(kelvinFromCelsius(25.0)) / 3600.0, 8.0, 0.9);
}

TEST(HeatBalance, SteadyTemperatureAndViewFactorAreInverse) {
    const HeatRates rates = standardRates(SourceModel::Gray, 25.0);
    for (double F = 0.0; F <= 1.0; F += 0.05) {
        const double T = rates.steadyTemperature_K(F);
        EXPECT_NEAR(rates.steadyViewFactor(T), F, 1e-12);
        EXPECT_NEAR(rates.rate_K_s(F, T), 0.0, 1e-12);
    }
}

TEST(HeatBalance, AWeakGraySurfaceHeatsWhereThePapersModelCools) {
    // Under 148 degC the paper's source "cools" its surroundings, because its reflection is left out.
    const double T1 = kelvinFromCelsius(140.0);
    const double T3 = kelvinFromCelsius(25.0);
    EXPECT_LT(netSourcePower_W_m2(SourceModel::Paper, T1, 0.25, T3), 0.0);
    EXPECT_GT(netSourcePower_W_m2(SourceModel::Gray, T1, 0.25, T3), 0.0);
}

} // namespace bask
