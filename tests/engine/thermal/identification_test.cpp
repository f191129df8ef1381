#include "engine/base/message_code.h"
#include "engine/thermal/identification.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <random>

namespace bask {
namespace {

constexpr double kT3 = 298.15;
const HeatRates kTrue{0.235, 2.1e-11, 2.1e-11 * 298.15 * 298.15 * 298.15 * 298.15};

using ViewFactorAt = std::function<double(double)>;

/// Up to the source, back, and up again: a run that settles and changes its target.
double moving(double t) {
    return t < 80.0 ? 0.9 : t < 160.0 ? 0.25 : t < 230.0 ? 0.6 : 0.3;
}

/// Rows every period_s of an object that follows the balance, without errors.
std::vector<HeatSample> exactRecord(const HeatRates& rates, double convection_1_s, const ViewFactorAt& F,
                                    double duration_s = 300.0, double period_s = 1.0, double T_K = kT3) {
    std::vector<HeatSample> record;
    constexpr int kSteps = 20;
    for (int k = 0; k * period_s <= duration_s; ++k) {
        record.push_back({k * period_s, T_K, F(k * period_s), 1.0, true});
        for (int i = 0; i < kSteps; ++i) {
            const double h = period_s / kSteps;
            // The recorded F is joined by straight lines.
            const double F0 = F(k * period_s), F1 = F((k + 1) * period_s);
            const double Fi = F0 + (F1 - F0) * (i + 0.5) / kSteps;
            const auto v = [&](double T) { return rates.rate_K_s(Fi, T) - convection_1_s * (T - kT3); };
            T_K += h * v(T_K + 0.5 * h * v(T_K));
        }
    }
    return record;
}

std::vector<HeatSample> measured(std::vector<HeatSample> record, double noise_K, double resolution_K,
                                 unsigned seed) {
    std::mt19937 random(seed);
    std::normal_distribution<double> noise(0.0, noise_K);
    for (HeatSample& sample : record) {
        sample.temperature_K += noise(random);
        if (resolution_K > 0.0)
            sample.temperature_K = std::round(sample.temperature_K / resolution_K) * resolution_K;
    }
    return record;
}

bool within(const Estimate& estimate, double value, double deviations) {
    return std::abs(estimate.value - value) <= deviations * estimate.standardError;
}

/// Scatter of many identifications against the standard errors that they state.
struct MonteCarlo {
    static constexpr int kRuns = 400;
    double scatter1 = 0.0, stated1 = 0.0, scatter2 = 0.0, stated2 = 0.0;
    double mean1 = 0.0, mean2 = 0.0;
    int outside1 = 0, outside2 = 0; ///< of three standard errors

    MonteCarlo(double noise_K, double resolution_K, const IdentificationOptions& options = {}) {
        const auto exact = exactRecord(kTrue, 0.0, moving);
        std::vector<IdentifiedRates> runs;
        for (unsigned seed = 0; seed < kRuns; ++seed) {
            runs.push_back(identifyRates(measured(exact, noise_K, resolution_K, seed), options));
            EXPECT_TRUE(runs.back().usable()) << describe(runs.back().reason);
        }
        for (const IdentifiedRates& run : runs) {
            mean1 += run.lambda1.value / kRuns;
            mean2 += run.lambda2.value / kRuns;
            stated1 += run.lambda1.standardError / kRuns;
            stated2 += run.lambda2.standardError / kRuns;
            outside1 += within(run.lambda1, kTrue.lambda1, 3.0) ? 0 : 1;
            outside2 += within(run.lambda2, kTrue.lambda2, 3.0) ? 0 : 1;
        }
        for (const IdentifiedRates& run : runs) {
            scatter1 += std::pow(run.lambda1.value - mean1, 2) / (kRuns - 1);
            scatter2 += std::pow(run.lambda2.value - mean2, 2) / (kRuns - 1);
        }
        scatter1 = std::sqrt(scatter1);
        scatter2 = std::sqrt(scatter2);
    }
};

} // namespace

// Catches: a wrong sign, factor or unit in any column, and a verdict against good data.
TEST(Identification, ExactDataGiveTheExactRates) {
    for (const bool freeAmbient : {false, true}) {
        for (const bool convection : {false, true}) {
            IdentificationOptions options;
            options.freeAmbient = freeAmbient;
            options.convection = convection;
            const double loss = convection ? 0.004 : 0.0;
            const auto record = exactRecord(
                kTrue, loss, [](double t) { return 0.5 + 0.4 * std::sin(0.05 * t); }, 400.0, 0.1);
            const IdentifiedRates rates = identifyRates(record, options);
            ASSERT_TRUE(rates.usable()) << describe(rates.reason);
            EXPECT_NEAR(rates.lambda1.value / kTrue.lambda1, 1.0, 1e-4);
            EXPECT_NEAR(rates.lambda2.value / kTrue.lambda2, 1.0, 1e-3);
            EXPECT_NEAR(rates.lambda3.value / kTrue.lambda3, 1.0, 1e-3);
            EXPECT_EQ(std::isnan(rates.convection.value), !convection);
            if (convection) {
                EXPECT_NEAR(rates.convection.value / loss, 1.0, 2e-3);
            }
            EXPECT_EQ(rates.outliers, 0);
        }
    }
}

// Catches: a source that cools or warms taken for a change of the object.
TEST(Identification, TheSourcesStrengthScalesTheHeating) {
    auto record = exactRecord(kTrue, 0.0, [](double t) { return 0.3 + 0.002 * t; });
    for (HeatSample& sample : record) {
        sample.sourceStrength = 2.0 - sample.time_s / 300.0;
        sample.viewFactor /= sample.sourceStrength;
    }
    const IdentifiedRates rates = identifyRates(record, {});
    ASSERT_TRUE(rates.usable());
    EXPECT_NEAR(rates.lambda1.value / kTrue.lambda1, 1.0, 1e-3);
}

// Catches: standard errors that overlapping or correlated differences make too small.
TEST(Identification, StandardErrorsMatchTheScatterOfManyRuns) {
    const MonteCarlo runs(0.03, 0.0);
    EXPECT_NEAR(runs.stated1 / runs.scatter1, 1.0, 0.3);
    EXPECT_NEAR(runs.stated2 / runs.scatter2, 1.0, 0.3);
    EXPECT_LT(std::abs(runs.mean1 - kTrue.lambda1), 0.5 * runs.scatter1);
    EXPECT_LT(std::abs(runs.mean2 - kTrue.lambda2), 0.5 * runs.scatter2);
    EXPECT_LE(runs.outside1, MonteCarlo::kRuns / 100);
    EXPECT_LE(runs.outside2, MonteCarlo::kRuns / 100);
}

// Catches: a fit that takes the steps of a PT100 of 0.1 K for heat.
TEST(Identification, ReadingsRoundedToATenthWillDo) {
    const MonteCarlo runs(0.02, 0.1);
    EXPECT_GT(runs.stated1 / runs.scatter1, 0.7);
    EXPECT_GT(runs.stated2 / runs.scatter2, 0.7);
    EXPECT_NEAR(runs.mean1 / kTrue.lambda1, 1.0, 0.01);
    EXPECT_NEAR(runs.mean2 / kTrue.lambda2, 1.0, 0.02);
    EXPECT_LE(runs.outside1, MonteCarlo::kRuns / 50);
    EXPECT_LE(runs.outside2, MonteCarlo::kRuns / 50);
}

// Catches: integrals that jump over missing readings, or windows that go on across a long gap.
TEST(Identification, MissingReadingsAreBridgedOrEndAWindow) {
    auto record = measured(exactRecord(kTrue, 0.0, moving), 0.02, 0.0, 3);
    std::mt19937 random(5);
    for (HeatSample& sample : record) {
        sample.valid = random() % 4 != 0 && !(sample.time_s > 90.0 && sample.time_s < 130.0);
        if (!sample.valid)
            sample.temperature_K = sample.time_s < 200.0 ? std::nan("") : 0.0;
    }
    record[250].viewFactor = std::nan(""); // the robot's link was lost for a moment
    const IdentifiedRates rates = identifyRates(record, {});
    ASSERT_TRUE(rates.usable()) << describe(rates.reason);
    EXPECT_EQ(rates.outliers, 0);
    EXPECT_LT(rates.readings, 210);
    EXPECT_TRUE(within(rates.lambda1, kTrue.lambda1, 3.0));
    EXPECT_TRUE(within(rates.lambda2, kTrue.lambda2, 3.0));
    EXPECT_LT(rates.lambda1.standardError / kTrue.lambda1, 0.02);
}

// Catches: a trapezoid of T^4 across seconds in which a fast object went its own way.
TEST(Identification, AFastObjectsGapsAreNotBridged) {
    const HeatRates fast{40.0 * kTrue.lambda1, 40.0 * kTrue.lambda2, 40.0 * kTrue.lambda3};
    const auto F = [](double t) { return 0.5 + 0.4 * std::sin(0.2 * t); };
    auto record = exactRecord(fast, 0.0, F, 300.0, 0.25);
    for (HeatSample& sample : record)
        sample.valid = std::fmod(sample.time_s, 9.0) < 3.6;
    const IdentifiedRates rates = identifyRates(record, {});
    ASSERT_TRUE(rates.usable()) << describe(rates.reason);
    EXPECT_NEAR(rates.lambda1.value / fast.lambda1, 1.0, 2e-3);
    EXPECT_NEAR(rates.lambda2.value / fast.lambda2, 1.0, 2e-3);
}

// Catches: one bad reading, near or absurd, that bends the rates.
TEST(Identification, ABadReadingIsLeftOut) {
    const auto clean = measured(exactRecord(kTrue, 0.0, moving), 0.02, 0.1, 4);
    const IdentifiedRates expected = identifyRates(clean, {});
    for (const double bad_K : {-30.0, 2.0, 40.0, 1e5}) {
        auto record = clean;
        record[40].temperature_K += bad_K;
        record[41].temperature_K += 0.5 * bad_K;
        record[170].temperature_K -= 3.0;
        const IdentifiedRates rates = identifyRates(record, {});
        ASSERT_TRUE(rates.usable()) << bad_K << ": " << describe(rates.reason);
        EXPECT_EQ(rates.outliers, 3) << bad_K;
        EXPECT_NEAR(rates.lambda1.value, expected.lambda1.value, expected.lambda1.standardError) << bad_K;
        EXPECT_NEAR(rates.lambda2.value, expected.lambda2.value, expected.lambda2.standardError) << bad_K;
    }
}

// Catches: convection booked as radiation. The two differ by the curvature of T^4 alone, so that takes a
// strong source, long records and wide temperatures.
TEST(Identification, ConvectionIsToldFromRadiation) {
    HeatRates strong = kTrue;
    strong.lambda1 *= 6.0;
    constexpr double kLoss_1_s = 0.003;
    const auto F = [](double t) { return 0.05 + 0.9 * std::abs(std::sin(0.006 * t)); };
    const auto record = measured(exactRecord(strong, kLoss_1_s, F, 1800.0), 0.02, 0.1, 6);
    IdentificationOptions options;
    options.convection = true;
    const IdentifiedRates rates = identifyRates(record, options);
    ASSERT_TRUE(rates.usable()) << describe(rates.reason);
    EXPECT_TRUE(within(rates.lambda1, strong.lambda1, 3.0));
    EXPECT_TRUE(within(rates.lambda2, strong.lambda2, 3.0));
    EXPECT_TRUE(within(rates.convection, kLoss_1_s, 3.0));
    EXPECT_LT(rates.convection.standardError, kLoss_1_s / 10.0);
    // Left out of the fit, it is taken for radiation.
    options.convection = false;
    EXPECT_GT(identifyRates(record, options).lambda2.value, 1.2 * strong.lambda2);
}

// Catches: "no convection" refused, or found where there is none.
TEST(Identification, NoConvectionIsFoundWithinItsError) {
    IdentificationOptions options;
    options.convection = true;
    const auto record = measured(exactRecord(kTrue, 0.0, moving, 1200.0), 0.01, 0.0, 8);
    const IdentifiedRates rates = identifyRates(record, options);
    EXPECT_TRUE(within(rates.convection, 0.0, 3.0)) << rates.convection.value;
}

// Catches: lambda3 tied to a T3 that is not the record's, and the free one not found.
TEST(Identification, AFreeAmbientFindsTheRoom) {
    IdentificationOptions options;
    options.freeAmbient = true;
    options.environment_K = kT3 + 5.0;
    const auto record = measured(exactRecord(kTrue, 0.0, moving, 600.0), 0.01, 0.0, 9);
    const IdentifiedRates rates = identifyRates(record, options);
    ASSERT_TRUE(rates.usable()) << describe(rates.reason);
    EXPECT_TRUE(within(rates.lambda3, kTrue.lambda3, 3.0));
    EXPECT_NEAR(std::pow(rates.lambda3.value / rates.lambda2.value, 0.25), kT3, 0.5);
}

// Catches: a T3 known to half a kelvin that gives rates known to a part in a thousand.
TEST(Identification, TheErrorOfTheRoomIsPassedOn) {
    const auto record = measured(exactRecord(kTrue, 0.0, moving), 0.02, 0.0, 10);
    IdentificationOptions options;
    options.environment_K = kT3 + 0.5;
    const double sure = identifyRates(record, options).lambda2.standardError;
    options.environmentDeviation_K = 0.5;
    const IdentifiedRates rates = identifyRates(record, options);
    EXPECT_GT(rates.lambda2.standardError, 2.0 * sure);
    EXPECT_TRUE(within(rates.lambda2, kTrue.lambda2, 2.0));
}

// Catches: numbers where the data say nothing.
TEST(Identification, RefusesWhatTheDataCannotTell) {
    const auto reason = [](const std::vector<HeatSample>& record, const IdentificationOptions& options = {}) {
        const IdentifiedRates rates = identifyRates(record, options);
        EXPECT_GE(describe(rates.reason).size(), rates.usable() ? 0U : 20U);
        return rates.reason.code;
    };
    EXPECT_EQ(reason({}), MessageCode::IdentificationTooShort);
    EXPECT_EQ(reason({{0.0, kT3, 0.5, 1.0, true}}), MessageCode::IdentificationTooShort);
    EXPECT_EQ(reason(exactRecord(kTrue, 0.0, moving, 25.0)), MessageCode::IdentificationTooShort);
    const auto hidden = [](double) { return 0.0; };
    const auto still = [](double) { return 0.4; };
    EXPECT_EQ(reason(measured(exactRecord(kTrue, 0.0, hidden, 300.0, 1.0, kT3 + 20.0), 0.02, 0.1, 1)),
              MessageCode::IdentificationUnheated);
    // At rest in one place, with and without noise; in two places close to each other.
    const double rest_K = kTrue.steadyTemperature_K(0.4);
    EXPECT_EQ(reason(exactRecord(kTrue, 0.0, still, 300.0, 1.0, rest_K)), MessageCode::IdentificationStill);
    for (unsigned seed = 0; seed < 50; ++seed)
        EXPECT_EQ(reason(measured(exactRecord(kTrue, 0.0, still, 300.0, 1.0, rest_K), 0.02, 0.1, seed)),
                  MessageCode::IdentificationStill)
            << seed;
    // Heating at one view factor, the room's share free: s F and the constant are one column.
    IdentificationOptions free;
    free.freeAmbient = true;
    EXPECT_EQ(reason(exactRecord(kTrue, 0.0, still), free), MessageCode::IdentificationStill);
    // It moves, but so little or so noisily that the errors are greater than a quarter.
    const auto restless = [](double t) { return 0.4 + 0.03 * std::sin(0.2 * t); };
    EXPECT_EQ(reason(measured(exactRecord(kTrue, 0.0, restless, 200.0, 1.0, rest_K), 0.5, 0.0, 2)),
              MessageCode::IdentificationUncertain);
}

// Catches: a rate below zero that is clipped or passed on in silence.
TEST(Identification, ARateBelowZeroIsTold) {
    auto record = exactRecord(kTrue, 0.0, moving);
    for (HeatSample& sample : record)
        sample.temperature_K = 2.0 * kT3 - sample.temperature_K; // a sensor wired the wrong way round
    const IdentifiedRates rates = identifyRates(measured(record, 0.02, 0.0, 11), {});
    EXPECT_FALSE(rates.usable());
    EXPECT_EQ(rates.reason.code, MessageCode::IdentificationNegative);
    EXPECT_LT(rates.lambda1.value, 0.0);
}

} // namespace bask
