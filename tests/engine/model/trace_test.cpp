#include "engine/model/trace.h"

#include <gtest/gtest.h>

#include <limits>

namespace bask {
namespace {

/// One sample a second with the errors given, K.
std::vector<TraceSample> run(const std::vector<double>& errors_K, bool truth = true) {
    std::vector<TraceSample> samples;
    for (const double error_K : errors_K) {
        ObjectSample object;
        object.target_K = 313.15;
        const double T_K = object.target_K + error_K;
        object.true_K = truth ? T_K : std::numeric_limits<double>::quiet_NaN();
        object.estimated_K = truth ? 1000.0 : T_K;
        TraceSample sample;
        sample.time_s = static_cast<double>(samples.size());
        sample.objects.push_back(object);
        samples.push_back(sample);
    }
    return samples;
}

TEST(SettlingTime, IsTheLastEntryIntoTheBand) {
    EXPECT_EQ(settlingTime_s(run({-5, 0, 2, -0.4, 0.3, 0.1}), 0), 3.0);
}

TEST(SettlingTime, IsEmptyWhenOutsideAtTheEnd) {
    EXPECT_FALSE(settlingTime_s(run({-5, 0, 0, 0, 0.6}), 0));
}

TEST(SettlingTime, IsTheFirstSampleWhenNeverOutside) {
    EXPECT_EQ(settlingTime_s(run({0.1, 0, 0}), 0), 0.0);
}

TEST(SettlingTime, JudgesTheEstimateWhereThereIsNoTruth) {
    EXPECT_EQ(settlingTime_s(run({-5, 0.2, 0.2}, false), 0), 1.0);
}

TEST(SettlingTime, TakesTheBandGiven) {
    EXPECT_EQ(settlingTime_s(run({-5, 0.9, 0.2}), 0, 1.0), 1.0);
}

TEST(SettlingTime, AnUnknownTemperatureIsOutside) {
    auto samples = run({0, 0, 0}, false);
    samples[1].objects[0].estimated_K = std::numeric_limits<double>::quiet_NaN();
    EXPECT_EQ(settlingTime_s(samples, 0), 2.0);
}

TEST(SettlingTime, AnEmptyRunOrAnUnknownObjectNeverSettles) {
    EXPECT_FALSE(settlingTime_s({}, 0));
    EXPECT_FALSE(settlingTime_s(run({0, 0}), 1));
}

TEST(SettlingTime, FollowsAChangedTarget) {
    auto samples = run({0, 0, 0, 0});
    samples[0].objects[0].target_K = 330.0;
    EXPECT_EQ(settlingTime_s(samples, 0), 1.0);
}

} // namespace
} // namespace bask
