#include "engine/base/units.h"
#include "engine/thermal/heat_balance.h"
#include "engine/thermal/natural_convection.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <stdexcept>

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

// Catches a term of the air that one of the functions leaves out, or takes with another sign.
TEST(HeatBalance, WithAirAllFunctionsTellTheSameBalance) {
    const Material painted{"painted", 0.9, 0.9, 904.0, 2700.0, 0.001, 1.0};
    const double room_K = kelvinFromCelsius(25.0);
    for (const Air& air : {Air{}, Air{0.0}, Air{8.0}, Air{200.0}, Air{std::nullopt, true}}) {
        Surroundings surroundings = surroundingsOf(SourceModel::Gray, 473.15, 0.9, room_K);
        surroundings.air = air;
        for (const double length_m : {0.0075, 0.3}) { // laminar and turbulent
            const HeatRates rates = heatRates(painted, surroundings, length_m);
            for (const double F : {0.0, 0.01, 0.3, 1.0}) {
                const double steady_K = rates.steadyTemperature_K(F);
                EXPECT_NEAR(rates.rate_K_s(F, steady_K), 0.0, 1e-9);
                EXPECT_NEAR(rates.steadyViewFactor(steady_K), F, 1e-9);
                double T_K = room_K - 20.0;
                for (int k = 0; k < 2000; ++k)
                    T_K += rates.step_K(F, T_K, 20.0);
                EXPECT_NEAR(T_K, steady_K, 1e-6);
            }
            for (const double T_K : {room_K - 10.0, room_K + 1.0, room_K + 40.0}) {
                constexpr double kStep_K = 1e-3;
                const double slope =
                    (rates.rate_K_s(0.4, T_K - kStep_K) - rates.rate_K_s(0.4, T_K + kStep_K)) /
                    (2.0 * kStep_K);
                EXPECT_NEAR(rates.lossSlope_1_s(T_K) / slope, 1.0, 1e-5);
                EXPECT_NEAR(rates.timeConstant_s(T_K) * slope, 1.0, 1e-5);
                const HeatRates twice = rates.scaled(1.0, 2.0);
                EXPECT_NEAR(twice.rate_K_s(0.0, T_K), 2.0 * rates.rate_K_s(0.0, T_K), 1e-12);
            }
        }
    }
}

// Catches h taken for both faces or for none: W/m2 against the heat capacity.
TEST(HeatBalance, TheAirTakesHTimesTheDifference) {
    const Material painted{"painted", 0.9, 0.9, 904.0, 2700.0, 0.001, 1.0};
    Surroundings surroundings = surroundingsOf(SourceModel::Gray, 473.15, 0.25, 298.15);
    const HeatRates still = heatRates(painted, surroundings);
    surroundings.air.convection_W_m2K = 8.0;
    const HeatRates moving = heatRates(painted, surroundings);
    EXPECT_NEAR((still.rate_K_s(0.3, 318.15) - moving.rate_K_s(0.3, 318.15)) *
                    painted.arealHeatCapacity_J_m2K(),
                8.0 * 20.0, 1e-9);
}

// Catches a wrong power, length or property of the air. By hand, with air of tables at 313 K (k = 0.0272 W/(m
// K), nu = 1.70e-5 m2/s, Pr = 0.706) instead of Sutherland's law.
TEST(NaturalConvection, IsWhatTheCorrelationGivesByHand) {
    const double f = std::pow(1.0 + std::pow(0.322 / 0.706, 0.55), -20.0 / 11.0);
    const auto byHand = [&](double length_m, double difference_K) {
        const double Ra = 9.81 / 313.0 * difference_K * std::pow(length_m, 3) * 0.706 / (1.70e-5 * 1.70e-5);
        return std::max(0.766 * std::pow(Ra * f, 0.2), 0.15 * std::cbrt(Ra * f)) * 0.0272 / length_m;
    };
    const Material material; // its heat capacity does not matter
    for (const double length_m : {0.0075, 0.03, 0.3})
        for (const double difference_K : {2.0, 20.0, 60.0}) {
            Surroundings surroundings = surroundingsOf(SourceModel::Gray, 473.15, 0.25, 298.15);
            surroundings.air.isNatural = true;
            const double h =
                heatRates(material, surroundings, length_m).air.coefficient_1_s(298.15 + difference_K) *
                material.arealHeatCapacity_J_m2K();
            EXPECT_NEAR(h / byHand(length_m, difference_K), 1.0, 0.015) << length_m << " " << difference_K;
        }
    const NaturalConvection small = naturalConvection(0.0075, 298.15);
    EXPECT_NEAR(small.laminar * std::pow(20.0, kLaminarPower), 8.47, 0.01); // a disk of 3 cm: 8 W/(m2 K)
}

// Catches natural convection that is silently nothing, because nobody told how large the plate is.
TEST(NaturalConvection, NeedsTheSizeOfThePlate) {
    Surroundings surroundings = surroundingsOf(SourceModel::Gray, 473.15, 0.25, 298.15);
    surroundings.air.isNatural = true;
    EXPECT_THROW(heatRates({}, surroundings), std::invalid_argument);
    EXPECT_THROW(naturalConvection(0.01, 0.0), std::invalid_argument);
}

} // namespace bask
