#include "engine/thermography/band_radiance.h"

#include "tests/engine/thermography/radiometry_reference.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace bask {
namespace {

/// Integral of x^3 / (e^x - 1) from x to infinity, as a series (Chang and Rhee 1984).
double planckTail(double x) {
    double sum = 0.0;
    for (int n = 1; n < 4000; ++n) {
        const double term = std::exp(-n * x) * (x * x * x / n + 3.0 * x * x / (n * n) +
                                                6.0 * x / std::pow(n, 3.0) + 6.0 / std::pow(n, 4.0));
        sum += term;
        if (term < 1e-17 * sum)
            break;
    }
    return sum;
}

/// The band's radiance by the fraction function.
double seriesRadiance(double from_m, double to_m, double T_K) {
    constexpr double h = 6.62607015e-34, c = 299792458.0, k = 1.380649e-23;
    const auto x = [&](double wavelength_m) { return h * c / (k * T_K * wavelength_m); };
    return 2.0 * std::pow(k * T_K, 4.0) / (h * h * h * c * c) * (planckTail(x(to_m)) - planckTail(x(from_m)));
}

} // namespace

// Catches: a constant, a band's end, a piece of the table that is wrong. Another route: the series.
TEST(BandRadiance, meetsTheSeriesOfThePlanckFraction) {
    for (double T_K = kMinBand_K; T_K <= kMaxBand_K; T_K *= 1.0007)
        EXPECT_NEAR(thermalBand().radiance(T_K) / seriesRadiance(8e-6, 14e-6, T_K), 1.0, 1e-10) << T_K;
}

// Catches the same for curves, and a derivative that is not of what is told. Another route: tanh-sinh sums.
TEST(BandRadiance, meetsAnIndependentIntegral) {
    int checked = 0;
    for (const auto& value : test::radiometryReference()["values"]) {
        const BandRadiance& band = test::referenceBand(value["curve"].get<std::string>());
        const double T_K = value["T_K"].get<double>();
        SCOPED_TRACE(value.dump());
        EXPECT_NEAR(band.radiance(T_K) / value["radiance"].get<double>(), 1.0, 1e-10);
        EXPECT_NEAR(band.derivative(T_K) / value["derivative"].get<double>(), 1.0, 1e-9);
        EXPECT_NEAR(band.temperature(value["radiance"].get<double>()) / T_K, 1.0, 1e-10);
        ++checked;
    }
    EXPECT_EQ(checked, 24);
}

// Catches: an inverse that is not one between its nodes, and a derivative that is not one.
TEST(BandRadiance, isInvertedEverywhere) {
    const BandRadiance narrow(3e-6, 5e-6);
    for (const BandRadiance* band : {&thermalBand(), &narrow, &test::referenceBand("bolometer")})
        for (double T_K = 101.0; T_K < 2990.0; T_K *= 1.0013) {
            EXPECT_NEAR(band->temperature(band->radiance(T_K)) / T_K, 1.0, 1e-10) << T_K;
            const double step = 1e-4 * T_K;
            const double slope = (8.0 * (band->radiance(T_K + step) - band->radiance(T_K - step)) -
                                  (band->radiance(T_K + 2.0 * step) - band->radiance(T_K - 2.0 * step))) /
                                 (12.0 * step);
            EXPECT_NEAR(band->derivative(T_K) / slope, 1.0, 1e-8) << T_K;
        }
}

// Catches: a tabulated flat response that is another band than the flat one.
TEST(BandRadiance, ofAFlatCurveIsTheFlatOne) {
    const BandRadiance curve({{8e-6, 2.0}, {9e-6, 2.0}, {13.1e-6, 2.0}, {14e-6, 2.0}});
    for (const double T_K : {150.0, 300.0, 600.0, 2000.0})
        EXPECT_NEAR(curve.radiance(T_K) / thermalBand().radiance(T_K), 2.0, 1e-10);
}

// Catches: numbers made up beyond the table.
TEST(BandRadiance, refusesWhatIsOutOfItsRange) {
    const BandRadiance& band = thermalBand();
    for (const double T_K : {99.9, 3000.1, 0.0, -1.0, std::numeric_limits<double>::quiet_NaN(),
                             std::numeric_limits<double>::infinity()}) {
        EXPECT_THROW(band.radiance(T_K), std::invalid_argument) << T_K;
        EXPECT_THROW(band.derivative(T_K), std::invalid_argument) << T_K;
    }
    EXPECT_NEAR(band.temperature(band.radiance(kMinBand_K)), kMinBand_K, 1e-9);
    EXPECT_NEAR(band.temperature(band.radiance(kMaxBand_K)), kMaxBand_K, 1e-8);
    for (const double L : {0.0, -1.0, 0.99 * band.radiance(kMinBand_K), 1.01 * band.radiance(kMaxBand_K),
                           std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()})
        EXPECT_TRUE(std::isnan(band.temperature(L))) << L;
}

TEST(BandRadiance, refusesCurvesThatAreNone) {
    const std::vector<std::vector<BandResponse>> refused{
        {},
        {{8e-6, 1.0}},
        {{14e-6, 1.0}, {8e-6, 1.0}},
        {{8e-6, 1.0}, {8e-6, 1.0}},
        {{8e-6, 0.0}, {14e-6, 0.0}},
        {{8e-6, -1.0}, {14e-6, 1.0}},
        {{8e-6, std::numeric_limits<double>::quiet_NaN()}, {14e-6, 1.0}},
        {{8.0, 1.0}, {14.0, 1.0}}};
    for (const auto& curve : refused)
        EXPECT_THROW(BandRadiance{curve}, std::invalid_argument);
}

} // namespace bask
