#include "engine/thermal/rate_estimator.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <stdexcept>

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

TEST(RateEstimator, NoiseGainIsThatOfTheLeastSquaresWeights) {
    // The weight of each sample is its impulse response; their root sum of squares is the noise gain.
    double sumOfSquares = 0.0;
    for (int k = 0; k < 10; ++k) {
        RateEstimator unit(10, 3);
        for (int i = 0; i < 10; ++i)
            unit.add(i, i == k ? 1.0 : 0.0);
        sumOfSquares += std::pow(unit.estimate()->rate_K_s, 2);
    }
    const double gain = std::sqrt(sumOfSquares);
    std::mt19937 random(7);
    std::normal_distribution<double> noise(0.0, 0.02);
    RateEstimator estimator(10, 3);
    double total = 0.0;
    int count = 0;
    for (int i = 0; i < 20000; ++i) {
        estimator.add(i, 300.0 + noise(random));
        if (const auto estimate = estimator.estimate()) {
            total += std::pow(estimate->rate_K_s, 2);
            ++count;
        }
    }
    EXPECT_NEAR(std::sqrt(total / count), 0.02 * gain, 0.05 * 0.02 * gain);
}

TEST(RateEstimator, RefusesAWindowThatDoesNotDetermineThePolynomial) {
    EXPECT_THROW(RateEstimator(3, 3), std::invalid_argument);
    EXPECT_THROW(RateEstimator(5, 0), std::invalid_argument);
}

} // namespace bask
