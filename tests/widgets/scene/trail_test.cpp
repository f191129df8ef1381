#include "widgets/scene/trail.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace bask {
namespace {

// Catches a trail that drops the pose where the objects are now.
TEST(Trail, TheNewestPointIsAlwaysThere) {
    Trail trail;
    EXPECT_TRUE(trail.empty());
    trail.append({{0.0, 0.0, 0.1}, 300.0});
    trail.append({{0.0, 0.0, 0.1 + 0.1 * Trail::kTolerance_m}, 300.0});
    EXPECT_EQ(trail.kept().size(), 1U);
    EXPECT_DOUBLE_EQ(trail.newest().p_RO.z(), 0.1 + 0.1 * Trail::kTolerance_m);
}

// Catches decimation by distance alone: standing still while heating must change the colour.
TEST(Trail, ATemperatureChangeAtRestIsKept) {
    Trail trail;
    for (int i = 0; i <= 100; ++i)
        trail.append({{0.0, 0.0, 0.1}, 300.0 + 0.1 * i});
    EXPECT_GE(trail.kept().size(), 30U);
    EXPECT_LE(trail.kept().size(), 50U);
}

// Catches a trail that grows with the run, and thinning that loses the shape: the kept points follow the
// circle.
TEST(Trail, ThirtyThousandSamplesStaySmallAndTrue) {
    Trail trail;
    for (int i = 0; i < 30000; ++i) {
        const double angle = 0.01 * i;
        trail.append({{0.2 * std::cos(angle), 0.2 * std::sin(angle), 0.3 - 1e-5 * i}, 300.0 + 0.001 * i});
    }
    EXPECT_LE(trail.kept().size(), Trail::kMaxPoints);
    ASSERT_GE(trail.kept().size(), 1000U);
    for (std::size_t i = 1; i < trail.kept().size(); ++i)
        EXPECT_LT((trail.kept()[i].p_RO - trail.kept()[i - 1].p_RO).norm(), 0.04);
    EXPECT_NEAR(trail.kept().front().p_RO.z(), 0.3, 1e-12);
}

// Catches an endless thinning when tolerances cannot tell points apart any more.
TEST(Trail, JumpsBetweenTwoPlacesStayBounded) {
    Trail trail;
    for (int i = 0; i < 30000; ++i)
        trail.append({{i % 2 == 0 ? -10.0 : 10.0, 0.0, 0.1}, 300.0});
    EXPECT_LE(trail.kept().size(), Trail::kMaxPoints);
    trail.clear();
    for (int i = 0; i < 30000; ++i)
        trail.append({{0.0, 0.0, 0.1}, i % 2 == 0 ? 300.0 : std::numeric_limits<double>::quiet_NaN()});
    EXPECT_LE(trail.kept().size(), Trail::kMaxPoints);
}

// Catches a gap in the readings that is painted over with the last colour, and one that adds a point a
// sample.
TEST(Trail, AnUnknownTemperatureIsOnePoint) {
    Trail trail;
    const double unknown = std::numeric_limits<double>::quiet_NaN();
    for (const double t_K : {300.0, unknown, unknown, unknown, 300.0})
        trail.append({{0.0, 0.0, 0.1}, t_K});
    ASSERT_EQ(trail.kept().size(), 3U);
    EXPECT_TRUE(std::isnan(trail.kept()[1].temperature_K));
    trail.append({{unknown, 0.0, 0.1}, 300.0});
    EXPECT_EQ(trail.kept().size(), 3U);
}

} // namespace
} // namespace bask
