// Whether a value that stays is told from the noise that the sensor has shown.

#include "engine/runtime/quiet_watch.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace bask {
namespace {

double stepped(double value_K, double step_K) {
    return std::round(value_K / step_K) * step_K;
}

} // namespace

// Catches a sensor that stops, with noise of several steps, and is told late.
TEST(QuietWatch, FindsANoisySensorThatStopsWithinAFewReadings) {
    for (const double noise_K : {0.02, 0.1, 0.3}) {
        QuietWatch watch;
        std::mt19937_64 random(3);
        std::normal_distribution<double> noise(0.0, noise_K);
        double value_K = 0.0;
        int t = 0;
        for (; t < 200; ++t) {
            watch.add(t, value_K = stepped(300.0 + noise(random), 0.01));
            ASSERT_EQ(watch.quietFor_s(), 0.0) << noise_K << ' ' << t;
        }
        for (; watch.quietFor_s() == 0.0 && t < 400; ++t)
            watch.add(t, value_K);
        EXPECT_LE(t, 200 + 25) << noise_K;
        watch.add(t, value_K + 0.01);
        EXPECT_EQ(watch.quietFor_s(), 0.0);
    }
}

// Catches a sensor without noise that is told when its object comes to rest after a ramp, or lies between two
// steps, and wrong readings that are taken for noise.
TEST(QuietWatch, IsSilentAboutSensorsWithoutNoise) {
    std::mt19937_64 random(4);
    std::uniform_real_distribution<double> slope(-0.1, 0.1), share;
    for (int run = 0; run < 300; ++run) {
        const double step_K = run % 3 == 0 ? 0.01 : run % 3 == 1 ? 0.1 : 0.5;
        std::normal_distribution<double> noise(0.0, 0.2 * share(random) * step_K);
        QuietWatch watch;
        double T = 300.0 + share(random), slope_K = 0.0;
        for (int t = 0; t < 1500; ++t) {
            if (t % 300 == 0)
                slope_K = t % 600 == 0 ? slope(random) : 0.0;
            T += slope_K;
            const double wrong_K = share(random) < 0.002 ? 15.0 * step_K : 0.0;
            watch.add(t, stepped(T + noise(random), step_K) + wrong_K);
            ASSERT_EQ(watch.quietFor_s(), 0.0) << run << ' ' << t;
        }
    }
}

// Catches a device that measures less often than it is asked.
TEST(QuietWatch, KnowsADeviceThatRepeatsItsReadings) {
    QuietWatch watch;
    std::mt19937_64 random(5);
    std::normal_distribution<double> noise(0.0, 0.1);
    double value_K = 0.0;
    for (int t = 0; t < 3000; ++t) {
        if (t % 3 == 0)
            value_K = stepped(300.0 + noise(random), 0.01);
        watch.add(0.1 * t, value_K);
        ASSERT_EQ(watch.quietFor_s(), 0.0) << t;
    }
    int t = 3000;
    for (; watch.quietFor_s() == 0.0 && t < 4000; ++t)
        watch.add(0.1 * t, value_K);
    EXPECT_LE(t, 3000 + 45);
}

} // namespace bask
