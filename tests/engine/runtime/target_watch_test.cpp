// An object that goes away from its target while its run goes on.

#include "engine/runtime/target_watch.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

namespace bask {
namespace {

/// When it is first told, s; a large number if never. One reading a second.
double told_s(const std::function<double(double time_s)>& error_K, double until_s = 600.0) {
    TargetWatch watch;
    for (double t = 0.0; t < until_s; t += 1.0) {
        watch.add(t, error_K(t));
        if (watch.leaving())
            return t;
    }
    return 1e9;
}

} // namespace

// Catches an object that leaves its target by 3 K a minute without a word, above or below it.
TEST(TargetWatch, TellsOneThatGoesAway) {
    for (const double sign : {1.0, -1.0}) {
        EXPECT_NEAR(told_s([&](double t) { return sign * 0.1 * t; }), 70.0, 1.0);
        EXPECT_NEAR(told_s([&](double t) { return sign * 0.05 * t; }), 110.0, 11.0) << "5 K";
    }
    TargetWatch watch;
    for (double t = 0.0; t <= 100.0; t += 1.0)
        watch.add(t, -0.1 * t);
    ASSERT_TRUE(watch.leaving());
    EXPECT_NEAR(watch.leaving()->error_K, -9.5, 0.2);
    EXPECT_EQ(watch.leaving()->for_s, 90.0);
    for (double t = 101.0; t <= 125.0; t += 1.0)
        watch.add(t, -9.0);
    EXPECT_FALSE(watch.leaving()) << "it goes no farther";
}

// Catches an alarm of an object that is on its way, overshoots, rests away from its target, or is made to
// wait for a moment; and one of noise and sensor steps.
TEST(TargetWatch, SaysNothingOfTheRest) {
    EXPECT_GT(told_s([](double t) { return -30.0 * std::exp(-t / 80.0); }), 1e8);
    EXPECT_GT(told_s([](double t) { return t < 100.0 ? -30.0 + 0.33 * t : 4.0 * std::sin(0.05 * t); }), 1e8);
    EXPECT_GT(told_s([](double t) { return -9.0 - 0.1 * std::round(2.0 * std::sin(t)); }), 1e8);
    EXPECT_GT(told_s([](double t) { return -std::min(8.0, 0.2 * t); }), 1e8) << "for 40 s";
    EXPECT_GT(told_s([](double t) { return 6.0 - 0.1 * t; }, 125.0), 1e8) << "through its target";
}

} // namespace bask
