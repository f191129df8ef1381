#include "widgets/common/reading_trend.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

using namespace bask;

namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

/// A reading a second, rounded to 0.1 K.
ReadingTrend fed(double rate_K_s, int seconds) {
    ReadingTrend trend;
    for (int k = 0; k < seconds; ++k) {
        trend.passTo(k);
        trend.add(k, std::round((300.0 + rate_K_s * k) * 10.0) / 10.0, kNone);
    }
    return trend;
}

} // namespace

// Catches a trend of what does not change, one of too few readings, and one of the wrong sign.
TEST(ReadingTrend, TellsWhatIsBeyondTheSteps) {
    EXPECT_EQ(fed(0.0, 10).told_K_s(), 0.0);
    EXPECT_EQ(fed(0.004, 10).told_K_s(), 0.0) << "a tenth in half a minute";
    EXPECT_NEAR(fed(0.3, 10).told_K_s(), 0.3, 0.01);
    EXPECT_NEAR(fed(-0.3, 10).told_K_s(), -0.3, 0.01);
    EXPECT_NEAR(fed(0.3, 60).slope_K_s(), 0.3, 0.01);
    EXPECT_TRUE(std::isnan(fed(0.3, 2).slope_K_s()));
    EXPECT_EQ(fed(0.3, 2).told_K_s(), 0.0);
    EXPECT_NEAR(fed(0.3, 5).told_K_s(), 0.3, 0.03);
}

// Catches "Cooling" beside a rate of +4.8 K/min, as after a step of a sensor.
TEST(ReadingTrend, TellsNothingAgainstTheRateBesideIt) {
    ReadingTrend trend;
    for (int k = 0; k < 10; ++k) {
        trend.passTo(k);
        trend.add(k, (k < 5 ? 312.0 : 309.0) + 0.1 * k, k == 5 ? -0.2 : 0.12);
    }
    ASSERT_LT(trend.slope_K_s(), -0.1);
    ASSERT_GT(trend.meanRate_K_s(), 0.05);
    EXPECT_EQ(trend.told_K_s(), 0.0);
}

// Catches: "Heating" of the first samples of an object at rest, by the estimate of one of them, or by a few
// readings that step once by 0.1 K.
TEST(ReadingTrend, TheFirstReadingsOfWhatIsAtRestTellNothing) {
    for (int before = 0; before <= 12; ++before) {
        ReadingTrend trend;
        for (int k = 0; k <= 12; ++k) {
            trend.passTo(k);
            trend.add(k, k < before ? 298.0 : 298.1, 2.4 / 60.0);
            EXPECT_EQ(trend.told_K_s(), 0.0) << before << " readings before the step, at " << k << " s";
        }
    }
}

// Catches: a rig that is read every five seconds, of which no word would ever be told.
TEST(ReadingTrend, TwoReadingsFarApartAreEnough) {
    ReadingTrend trend;
    for (int k = 0; k < 4; ++k) {
        trend.passTo(5.0 * k);
        trend.add(5.0 * k, 300.0 + 1.5 * k, kNone);
    }
    EXPECT_NEAR(trend.told_K_s(), 0.3, 1e-9);
}

// Catches readings of a while ago, of another clock, or the same one taken twice.
TEST(ReadingTrend, IsOfTheLastTenSecondsOfOneClock) {
    ReadingTrend trend = fed(0.3, 60);
    for (int k = 60; k < 72; ++k) { // at rest from here on
        trend.passTo(k);
        trend.add(k, 318.0, kNone);
        trend.add(k, 400.0, kNone); // not newer
    }
    EXPECT_EQ(trend.told_K_s(), 0.0);
    trend.passTo(100.0);
    EXPECT_TRUE(std::isnan(trend.slope_K_s()));
    trend = fed(0.3, 60);
    trend.passTo(5.0); // the clock has begun again
    EXPECT_TRUE(std::isnan(trend.slope_K_s()));
}
