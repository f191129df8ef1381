#include "engine/thermal/contact_uncertainty.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <random>
#include <stdexcept>

namespace bask {
namespace {

/// Readings of a ramp with noise, rounded to a step where there is one.
ReadingScatter scatterOf(double slope_K, double noise_K, double step_K, int count = 60) {
    std::mt19937_64 random(7);
    std::normal_distribution<double> normal(0.0, 1.0);
    ReadingScatter out;
    for (int k = 0; k < count; ++k) {
        const double T_K = 300.03 + slope_K * k + noise_K * normal(random);
        out.add(step_K > 0.0 ? step_K * std::round(T_K / step_K) : T_K);
    }
    return out;
}

} // namespace

// Catches a ramp that is taken for noise, and noise that is told too large or too small.
TEST(ReadingScatter, IsTheNoiseAndNotTheRamp) {
    EXPECT_NEAR(scatterOf(0.0, 0.02, 0.0).deviation_K().value(), 0.02, 0.006);
    EXPECT_NEAR(scatterOf(0.5, 0.02, 0.0).deviation_K().value(), 0.02, 0.006);
    EXPECT_NEAR(scatterOf(0.5, 0.0, 0.0).deviation_K().value(), 0.0, 1e-9);
    EXPECT_EQ(scatterOf(0.0, 0.0, 0.1).deviation_K().value(), 0.0);
}

TEST(ReadingScatter, FindsTheStepAndNeedsSomeReadings) {
    EXPECT_NEAR(scatterOf(0.03, 0.02, 0.1).step_K(), 0.1, 1e-9);
    EXPECT_LT(scatterOf(0.03, 0.02, 0.0).step_K(), 0.01);
    EXPECT_EQ(scatterOf(0.0, 0.0, 0.1).step_K(), 0.0) << "it never changed";
    EXPECT_FALSE(scatterOf(0.0, 0.02, 0.1, 9).deviation_K());
    ReadingScatter gap = scatterOf(0.0, 0.0, 0.1);
    gap.add(std::numeric_limits<double>::quiet_NaN());
    EXPECT_FALSE(gap.deviation_K());
}

// Catches what changed where nothing was read taken for noise.
TEST(ReadingScatter, AChangeInAGapIsNoNoise) {
    for (const bool isTold : {false, true}) {
        ReadingScatter scatter = scatterOf(0.0, 0.02, 0.1);
        const double step_K = scatter.step_K();
        if (isTold)
            scatter.gap();
        else
            scatter.add(std::numeric_limits<double>::quiet_NaN());
        for (int k = 0; k < 60; ++k)
            scatter.add(320.0);
        EXPECT_EQ(scatter.deviation_K().value(), 0.0);
        EXPECT_EQ(scatter.step_K(), step_K) << "it is the sensor's";
    }
}

// Catches a part that is forgotten, and one that a mean of many readings would do away with.
TEST(ContactUncertaintyOfASensor, IsTheRootOfTheSumOfItsParts) {
    const std::array offsets_K{0.2, -0.3, 0.1};
    const ReadingScatter scatter = scatterOf(0.03, 0.02, 0.1);
    const auto u = contactUncertainty(offsets_K, 10, scatter);
    ASSERT_TRUE(u);
    EXPECT_NEAR(u->room_K, std::sqrt((0.04 + 0.09 + 0.01) / 2.0) / std::sqrt(3.0), 1e-12);
    EXPECT_NEAR(u->resolution_K, 0.1 / std::sqrt(12.0), 1e-9);
    EXPECT_NEAR(u->noise_K, scatter.deviation_K().value(), 1e-15);
    EXPECT_NEAR(u->zeroing_K * u->zeroing_K,
                u->resolution_K * u->resolution_K + u->noise_K * u->noise_K / 10.0, 1e-12);
    EXPECT_NEAR(std::pow(u->ofReading_K(), 2),
                std::pow(u->room_K, 2) + std::pow(u->zeroing_K, 2) + std::pow(u->resolution_K, 2) +
                    std::pow(u->noise_K, 2),
                1e-12);
    EXPECT_LT(u->ofMean_K(60), u->ofReading_K());
    EXPECT_GT(u->ofMean_K(1000000), std::hypot(u->room_K, u->resolution_K));
}

// Catches two sensors that agree by chance and are believed to a hundredth.
TEST(ContactUncertaintyOfASensor, SensorsThatAgreeAreNotBetterThanTheirClass) {
    const ReadingScatter scatter = scatterOf(0.0, 0.02, 0.0);
    const std::array two{0.001, -0.001};
    EXPECT_NEAR(contactUncertainty(two, 10, scatter)->room_K, kClassB_K / std::sqrt(2.0), 1e-12);
    EXPECT_NEAR(contactUncertainty(std::span(two).first(1), 10, scatter)->room_K, kClassB_K, 1e-12);
    EXPECT_FALSE(contactUncertainty(two, 10, ReadingScatter()));
    EXPECT_THROW((void)contactUncertainty({}, 10, scatter), std::invalid_argument);
    EXPECT_THROW((void)contactUncertainty(two, 0, scatter), std::invalid_argument);
}

// Catches an uncertainty that is not one: of many zeroed sets of sensors with steps and noise, two thirds of
// the readings have to be within one, and nearly all within two.
TEST(ContactUncertaintyOfASensor, CoversWhatZeroedSensorsTell) {
    constexpr int kSets = 2000, kSensors = 3, kWindow = 10;
    std::mt19937_64 random(11);
    std::normal_distribution<double> noise(0.0, 0.02);
    std::uniform_real_distribution<double> offset(-0.43, 0.43), temperature(298.0, 299.0);
    int within = 0, withinTwice = 0;
    const auto rounded = [](double T_K) { return 0.1 * std::round(10.0 * T_K); };
    for (int set = 0; set < kSets; ++set) {
        const double room_K = temperature(random), warm_K = room_K + 15.0 + temperature(random) - 298.0;
        std::array<double, kSensors> error_K{}, mean_K{}, offsets_K{};
        double common_K = 0.0;
        for (int i = 0; i < kSensors; ++i) {
            error_K[i] = offset(random);
            for (int k = 0; k < kWindow; ++k)
                mean_K[i] += rounded(room_K + error_K[i] + noise(random)) / kWindow;
            common_K += mean_K[i] / kSensors;
        }
        for (int i = 0; i < kSensors; ++i)
            offsets_K[i] = common_K - mean_K[i];
        ReadingScatter scatter;
        double told_K = 0.0;
        for (int k = 0; k < 70; ++k) {
            told_K =
                rounded(warm_K + std::min(0.02 * (k - 10), 0.0) + error_K[0] + noise(random)) + offsets_K[0];
            scatter.add(told_K);
        }
        const double u_K = contactUncertainty(offsets_K, kWindow, scatter)->ofReading_K();
        within += std::abs(told_K - warm_K) < u_K ? 1 : 0;
        withinTwice += std::abs(told_K - warm_K) < 2.0 * u_K ? 1 : 0;
    }
    EXPECT_GT(within, 0.6 * kSets);
    EXPECT_LT(within, 0.85 * kSets) << "it would be told too large";
    EXPECT_GT(withinTwice, 0.94 * kSets);
}

} // namespace bask
