#include "engine/runtime/sensor_channels.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>
#include <vector>

namespace bask {
namespace {

SensorChannels filled(std::vector<double> values_K, SensorLimits limits = {}) {
    SensorChannels channels(values_K.size(), SamplingSpec(), std::move(limits));
    for (int t = 0; t < 10; ++t) {
        std::vector<Reading> readings;
        for (const double value_K : values_K)
            readings.push_back({static_cast<double>(t), value_K, true});
        channels.add(readings);
    }
    return channels;
}

} // namespace

TEST(SensorChannels, ZeroingMakesAllAgreeAtTheirMean) {
    SensorChannels channels = filled({298.0, 298.4, 298.5});
    channels.use(channels.findZero(298.15).value());
    for (std::size_t i = 0; i < 3; ++i) {
        EXPECT_NEAR(channels.measured_K(i), 298.3, 1e-9);
        EXPECT_NEAR(channels.estimate(i)->temperature_K, 298.3, 1e-9);
    }
    EXPECT_NEAR(channels.zeroing()->environment_K, 298.3, 1e-9);
    EXPECT_NEAR(channels.zeroing()->offsets_K[0], 0.3, 1e-9);
}

// Catches an uncertainty of sensors that were not zeroed, and one that a device tells and nobody takes.
TEST(SensorChannels, TheUncertaintyIsThatOfTheZeroingOrWhatTheDeviceTells) {
    SensorChannels channels = filled({298.0, 298.4, 298.5});
    EXPECT_TRUE(std::isnan(channels.uncertainty_K(0)));
    channels.use(channels.findZero(298.15).value());
    const double spread_K = std::sqrt((0.3 * 0.3 + 0.1 * 0.1 + 0.2 * 0.2) / 2.0);
    EXPECT_NEAR(channels.uncertainty_K(0), spread_K / std::sqrt(3.0), 1e-9) << "no noise, no step was seen";
    Reading told{10.0, 298.0, true};
    told.standardUncertainty_K = 0.05;
    channels.add({told, {10.0, 298.4, true}, {10.0, 298.5, true}});
    EXPECT_EQ(channels.uncertainty_K(0), 0.05);
    EXPECT_GT(channels.uncertainty_K(1), 0.1);
}

// Catches a confirmed sensor whose jump is taken for noise.
TEST(SensorChannels, AConfirmedJumpIsNoNoise) {
    SensorLimits limits;
    limits.largestRates_K_s = {1.0, 1.0};
    for (const bool isConfirmed : {false, true}) {
        SensorChannels channels = filled({298.0, 298.4}, limits);
        channels.use(channels.findZero(298.15).value());
        const double before_K = channels.uncertainty_K(0);
        const auto addFrom = [&](double from_s, double value_K) {
            for (double t = from_s; t < from_s + 12.0; t += 1.0)
                channels.add({{t, value_K, true}, {t, 298.4, true}});
        };
        channels.add({{10.0, isConfirmed ? 318.0 : 298.0, true}, {10.0, 298.4, true}});
        if (isConfirmed) {
            ASSERT_TRUE(channels.confirm(0, 10.0));
        }
        addFrom(isConfirmed ? 11.0 : 30.0, 318.0); // or it was missing for 20 s
        EXPECT_NEAR(channels.uncertainty_K(0), before_K, 1e-9) << isConfirmed;
    }
}

// Catches offsets that pile up, and those of other sensors.
TEST(SensorChannels, ZeroedAgainItFindsTheSame) {
    SensorChannels channels = filled({298.0, 298.4, 298.5});
    const Zeroing first = channels.findZero(298.15).value();
    channels.use(first);
    EXPECT_EQ(channels.findZero(298.15).value(), first);
    SensorChannels fresh(3, SamplingSpec());
    fresh.use(first); // before the first reading
    fresh.add({{0.0, 298.0, true}, {0.0, 298.4, true}, {0.0, 298.5, true}});
    EXPECT_NEAR(fresh.measured_K(0), 298.3, 1e-9);
    SensorChannels two = filled({298.0, 298.4});
    EXPECT_THROW(two.use(first), std::invalid_argument);
}

TEST(SensorChannels, DoesNotZeroOnWarmObjectsOrABadSensor) {
    EXPECT_FALSE(filled({312.0, 312.0}).findZero(298.15)); // still warm from the last run
    EXPECT_FALSE(filled({298.0, 304.0}).findZero(298.15)); // one is not at ambient
    SensorChannels half(1, SamplingSpec());
    half.add({{0.0, 298.0, true}});
    EXPECT_FALSE(half.findZero(298.15));
}

TEST(SensorChannels, BadReadingsNeverEnterAndAreTold) {
    SensorChannels channels = filled({300.0});
    for (const Reading& bad :
         {Reading{10.0, 300.0, false}, Reading{10.0, std::numeric_limits<double>::quiet_NaN(), true},
          Reading{10.0, 26.0, true} /* -247 degC: a dead interface */, Reading{10.0, 1300.0, true}}) {
        channels.add({bad});
        EXPECT_TRUE(channels.lastInvalid(0));
        EXPECT_TRUE(channels.fresh(0, 12.0)); // the last good one is three periods old: a dropout
        EXPECT_FALSE(channels.fresh(0, 12.5));
        EXPECT_EQ(channels.measured_K(0), 300.0);
    }
    channels.add({{11.0, 300.5, true}});
    EXPECT_TRUE(channels.fresh(0, 11.0));
}

TEST(SensorChannels, ARepeatedReadingGrowsStaleAfterThreePeriods) {
    SensorChannels channels = filled({300.0});
    for (double now_s = 10.0; now_s < 14.0; now_s += 1.0)
        channels.add({{9.0, 300.0, true}}); // the device repeats its last answer
    EXPECT_TRUE(channels.fresh(0, 12.0));
    EXPECT_FALSE(channels.fresh(0, 12.5));
    EXPECT_NEAR(channels.age_s(0, 12.5), 3.5, 1e-9);
}

} // namespace bask
