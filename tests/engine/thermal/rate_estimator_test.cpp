#include "engine/thermal/rate_estimator.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numeric>
#include <random>
#include <stdexcept>
#include <vector>

namespace bask {

TEST(RateEstimator, IsExactForItsOwnOrderAtIrregularTimesHoursLater) {
    RateEstimator estimator(10, 3);
    const double start_s = 20000.0; // raw cubes of such times would lose every digit
    const auto T = [&](double t) {
        return 300.0 + 0.7 * (t - start_s) - 0.03 * std::pow(t - start_s, 2) +
               0.002 * std::pow(t - start_s, 3);
    };
    double t = start_s;
    for (int i = 0; i < 14; ++i) {
        t += i % 3 == 0 ? 0.7 : 1.1;
        ASSERT_TRUE(estimator.add(t, T(t)));
    }
    const auto estimate = estimator.estimate();
    ASSERT_TRUE(estimate);
    const double x = t - start_s;
    EXPECT_NEAR(estimate->temperature_K, T(t), 1e-7);
    EXPECT_NEAR(estimate->rate_K_s, 0.7 - 0.06 * x + 0.006 * x * x, 1e-7);
}

TEST(RateEstimator, SaysNothingUntilItsWindowIsFull) {
    RateEstimator estimator(10, 3);
    for (int i = 0; i < 9; ++i) {
        EXPECT_FALSE(estimator.estimate());
        estimator.add(i, 300.0);
    }
    EXPECT_FALSE(estimator.full());
    estimator.add(9, 300.0);
    EXPECT_TRUE(estimator.estimate());
}

TEST(RateEstimator, RefusesWhatIsNotANumberOrNotNew) {
    RateEstimator estimator(4, 1);
    EXPECT_TRUE(estimator.add(1.0, 300.0));
    EXPECT_FALSE(estimator.add(2.0, std::numeric_limits<double>::quiet_NaN()));
    EXPECT_FALSE(estimator.add(std::numeric_limits<double>::infinity(), 300.0));
    EXPECT_FALSE(estimator.add(1.0, 301.0));
    EXPECT_FALSE(estimator.add(0.5, 301.0));
    EXPECT_EQ(estimator.count(), 1);
}

TEST(RateEstimator, NoiseGainIsTheClosedFormForEvenTimes) {
    const double dt = 0.7;
    for (const double n : {6.0, 10.0, 25.0}) {
        std::vector<double> times;
        for (int i = 0; i < static_cast<int>(n); ++i)
            times.push_back(1000.0 + dt * i);
        const double n2 = n * n;
        const NoiseGain line = noiseGain(times, 1);
        EXPECT_NEAR(std::pow(line.value, 2), (4 * n - 2) / (n * (n + 1)), 1e-9);
        EXPECT_NEAR(std::pow(dt * line.slope_1_s, 2), 12 / (n * (n2 - 1)), 1e-9);
        const NoiseGain cubic = noiseGain(times, 3);
        EXPECT_NEAR(std::pow(cubic.value, 2),
                    8 * (2 * n - 1) * (n2 - n + 3) / (n * (n + 1) * (n + 2) * (n + 3)), 1e-9);
        EXPECT_NEAR(std::pow(dt * cubic.slope_1_s, 2),
                    200 * (6 * n2 * n2 - 27 * n2 * n + 42 * n2 - 30 * n + 11) /
                        (n * (n2 - 1) * (n2 - 4) * (n2 - 9)),
                    1e-9);
    }
}

TEST(RateEstimator, NoiseGainIsThatOfSimulatedNoiseAtIrregularTimes) {
    const struct { int window, order; } cases[] = {{5, 1}, {10, 3}, {20, 3}, {30, 5}};
    for (const auto& [window, order] : cases) {
        std::vector<double> times;
        for (int i = 0; i < window; ++i)
            times.push_back(3600.0 + i + 0.3 * std::sin(2.0 * i)); // jitter
        const NoiseGain gain = noiseGain(times, order);
        std::mt19937 random(7);
        std::normal_distribution<double> noise(0.0, 0.03);
        double value = 0.0, slope = 0.0;
        constexpr int kRuns = 20000;
        for (int run = 0; run < kRuns; ++run) {
            RateEstimator estimator(window, order);
            for (const double t : times)
                estimator.add(t, 300.0 + noise(random));
            const auto estimate = estimator.estimate();
            value += std::pow(estimate->temperature_K - 300.0, 2);
            slope += std::pow(estimate->rate_K_s, 2);
        }
        EXPECT_NEAR(std::sqrt(value / kRuns), 0.03 * gain.value, 0.02 * 0.03 * gain.value) << window;
        EXPECT_NEAR(std::sqrt(slope / kRuns), 0.03 * gain.slope_1_s, 0.02 * 0.03 * gain.slope_1_s) << window;
    }
}

// The figures that the header states.
TEST(RateEstimator, NoiseGainOfTheDefaultIsAsStated) {
    std::vector<double> times(10);
    std::iota(times.begin(), times.end(), 0.0);
    EXPECT_NEAR(noiseGain(times, 3).value, 0.91, 0.005);
    EXPECT_NEAR(noiseGain(times, 3).slope_1_s, 0.92, 0.005);
    EXPECT_NEAR(noiseGain(times, 2).slope_1_s, 0.41, 0.005);
    times.resize(20);
    std::iota(times.begin(), times.end(), 0.0);
    EXPECT_NEAR(noiseGain(times, 3).slope_1_s, 0.35, 0.005);
}

// One wrong reading anywhere in the window does not move the estimate beyond what a missing reading would.
TEST(RateEstimator, OneOutlierIsLeftOutWhereverItIs) {
    std::mt19937 random(31);
    std::normal_distribution<double> noise(0.0, 0.02);
    const auto rounded = [](double T_K) { return 0.1 * std::round(10.0 * T_K); };
    for (const double size_K : {-40.0, -3.0, 1.5, 100.0})
        for (int at = 0; at < 10; ++at) {
            RateEstimator estimator(10, 3);
            for (int i = 0; i < 10; ++i) {
                const double T_K = 310.0 + 0.1 * i - 0.002 * i * i + noise(random);
                estimator.add(i + 0.2 * std::sin(i), rounded(T_K) + (i == at ? size_K : 0.0));
            }
            const auto estimate = estimator.estimate();
            ASSERT_TRUE(estimate->leftOut) << size_K << " at " << at;
            EXPECT_EQ(*estimate->leftOut, at);
            EXPECT_NEAR(estimate->temperature_K, 310.0 + 0.9 - 0.002 * 81, 0.35) << size_K << " at " << at;
            EXPECT_NEAR(estimate->rate_K_s, 0.1 - 0.036, 0.25) << size_K << " at " << at;
        }
}

// At rest, rounded readings are mostly all the same: the smallest step must not look like an outlier. And
// with any amount of noise the test costs next to nothing.
TEST(RateEstimator, HonestNoiseIsHardlyEverLeftOut) {
    const struct {
        double noise_K, step_K;
        int max; ///< of 20000
    } cases[] = {{0.0, 0.1, 0}, {0.02, 0.1, 0}, {0.05, 0.1, 2}, {0.02, 0.0, 0}, {0.3, 0.0, 300}};
    for (const auto& [noise_K, step_K, max] : cases) {
        std::mt19937 random(13);
        std::normal_distribution<double> normal;
        RateEstimator estimator(10, 3);
        int leftOut = 0;
        for (int i = 0; i < 20000; ++i) {
            double T_K = 300.0 + 0.3 * std::sin(0.01 * i) + noise_K * normal(random);
            if (step_K > 0.0)
                T_K = step_K * std::round(T_K / step_K);
            estimator.add(i, T_K);
            if (const auto estimate = estimator.estimate())
                leftOut += estimate->leftOut ? 1 : 0;
        }
        EXPECT_LE(leftOut, max) << noise_K << " " << step_K;
    }
}

// The heat comes on: readings leave their straight line with a kink, which a cubic cannot follow.
TEST(RateEstimator, TheOnsetOfARampIsKept) {
    std::mt19937 random(3);
    std::normal_distribution<double> noise(0.0, 0.02);
    std::uniform_real_distribution<double> phase(0.0, 1.0);
    for (const double slope_K_s : {0.05, 0.1, 0.2, 0.3, 0.4, -0.3})
        for (int run = 0; run < 300; ++run) {
            RateEstimator estimator(10, 3);
            const double onset_s = 15.0 + phase(random);
            const double start_K = 298.0 + phase(random);
            for (int i = 0; i < 40; ++i) {
                const double T_K = start_K + slope_K_s * std::max(0.0, i - onset_s) + noise(random);
                estimator.add(i, 0.1 * std::round(10.0 * T_K));
                const auto estimate = estimator.estimate();
                ASSERT_FALSE(estimate && estimate->leftOut)
                    << slope_K_s << " K/s, " << i - onset_s << " s after it";
            }
        }
}

// A foil that starts fast, readings that come when they like or not at all: the first reading of the ramp,
// the newest, is never thrown away, for the estimate would be late by it, by 0.7 K at 0.8 K/s.
TEST(RateEstimator, TheFirstReadingOfAFastRampIsBelieved) {
    std::mt19937 random(9);
    std::normal_distribution<double> noise(0.0, 0.02);
    std::uniform_real_distribution<double> phase(0.0, 1.0);
    for (const double slope_K_s : {0.5, 0.8, -0.8, 1.0})
        for (int run = 0; run < 300; ++run) {
            RateEstimator estimator(10, 3);
            const double onset_s = 20.0 + phase(random);
            for (int i = 0; i < 40; ++i) {
                if (phase(random) < 0.1)
                    continue;
                const double time_s = i + 0.3 * (2.0 * phase(random) - 1.0);
                const double true_K = 298.0 + slope_K_s * std::max(0.0, time_s - onset_s);
                estimator.add(time_s, 0.1 * std::round(10.0 * (true_K + noise(random))));
                if (const auto estimate = estimator.estimate()) {
                    ASSERT_NE(estimate->leftOut, 9)
                        << slope_K_s << " K/s, " << time_s - onset_s << " s after";
                    ASSERT_NEAR(estimate->temperature_K, true_K, 0.5);
                }
            }
        }
}

// A step that would pass for an outlier is believed as soon as a second reading confirms it.
TEST(RateEstimator, AJumpIsBelievedAtItsSecondSample) {
    RateEstimator estimator(10, 3);
    for (int i = 0; i < 14; ++i)
        estimator.add(i, 300.0);
    estimator.add(14, 302.0);
    EXPECT_EQ(estimator.estimate()->leftOut, 9);
    estimator.add(15, 304.0);
    EXPECT_FALSE(estimator.estimate()->leftOut);
    EXPECT_GT(estimator.estimate()->rate_K_s, 1.0);
}

TEST(RateEstimator, AWindowTooShortToTellKeepsAll) {
    RateEstimator estimator(6, 3); // two more than coefficients
    for (int i = 0; i < 6; ++i)
        estimator.add(i, i == 2 ? 350.0 : 300.0);
    EXPECT_FALSE(estimator.estimate()->leftOut);
}

TEST(RateEstimator, RefusesAWindowThatDoesNotDetermineThePolynomial) {
    EXPECT_THROW(RateEstimator(3, 3), std::invalid_argument);
    EXPECT_THROW(RateEstimator(5, 0), std::invalid_argument);
    EXPECT_THROW((void)noiseGain({0.0, 1.0}, 2), std::invalid_argument);
}

} // namespace bask
