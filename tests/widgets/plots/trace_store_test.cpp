#include "widgets/plots/trace_store.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace bask;

namespace {

TraceSample sampleAt(double time_s, double measured_K, double target_K, bool valid = true) {
    TraceSample sample;
    sample.time_s = time_s;
    ObjectSample object;
    object.measured_K = measured_K;
    object.target_K = target_K;
    object.valid = valid;
    sample.objects = {object};
    sample.twist << 0.003, 0.004, 0, 0, 0, 0.05;
    return sample;
}

} // namespace

TEST(TraceStore, InvalidReadingsAreNotNumbers) {
    TraceStore columns;
    columns.reset(1);
    columns.append(
        {sampleAt(1, 300, 313, true), sampleAt(2, 0, 313, false), sampleAt(3, INFINITY, 313, true)});
    EXPECT_DOUBLE_EQ(columns.value(Quantity::Temperature, 0, 0), 300.0);
    EXPECT_DOUBLE_EQ(columns.value(Quantity::Error, 0, 0), -13.0);
    for (std::size_t row : {1u, 2u}) {
        EXPECT_TRUE(std::isnan(columns.value(Quantity::Temperature, 0, row)));
        EXPECT_TRUE(std::isnan(columns.value(Quantity::Error, 0, row)));
    }
    EXPECT_DOUBLE_EQ(columns.value(Quantity::Speed, 0, 0), 0.005);
    EXPECT_DOUBLE_EQ(columns.value(Quantity::Speed, 1, 0), 0.05);
}

// Catches samples delivered twice, and objects the experiment does not have.
TEST(TraceStore, TimeGrowsAndObjectsMayBeMissing) {
    TraceStore columns;
    columns.reset(2);
    EXPECT_EQ(columns.append({sampleAt(1, 300, 313), sampleAt(1, 301, 313), sampleAt(0.5, 301, 313)}), 0u);
    EXPECT_EQ(columns.rows(), 1u);
    EXPECT_TRUE(std::isnan(columns.value(Quantity::Temperature, 1, 0)));
    EXPECT_EQ(columns.append({sampleAt(2, 300, 320)}), 1u);
    ASSERT_EQ(columns.targetSteps(0).size(), 2u);
    EXPECT_EQ(columns.targetSteps(0)[1], std::pair(2.0, 320.0));
    EXPECT_TRUE(columns.targetSteps(1).empty());
}

// Catches a cursor that reads the sample after a moment of which a replay shows the one before.
TEST(TraceStore, ARowIsTheNewestUntilThen) {
    TraceStore columns;
    columns.reset(1);
    EXPECT_EQ(columns.rowAt(3.0), 0u);
    columns.append({sampleAt(1, 300, 313), sampleAt(2, 300, 313), sampleAt(4, 300, 313)});
    EXPECT_EQ(columns.rowAt(-5.0), 0u);
    EXPECT_EQ(columns.rowAt(2.9), 1u);
    EXPECT_EQ(columns.rowAt(3.9), 1u);
    EXPECT_EQ(columns.rowAt(4.0 - 1e-9), 2u) << "the same moment";
    EXPECT_EQ(columns.rowAt(4.0), 2u);
    EXPECT_EQ(columns.rowAt(99.0), 2u);
}

namespace {

/// A day at 10 Hz would take a while: the same at a few hundred thousand samples, with one spike near the
/// start.
constexpr int kMany = 300'000;
constexpr int kSpike = 12'345;

TraceSample manyAt(int k) {
    return sampleAt(0.1 * k, k == kSpike ? 400.0 : 300.0 + 5.0 * std::sin(1e-4 * k), 313.0);
}

double max(const TraceStore::Line& line) {
    double out = -1.0;
    for (const double value : line.values)
        out = std::fmax(out, value);
    return out;
}

} // namespace

// Catches memory that grows with a run that goes on, extremes that are not drawn, and lines with more points
// than pixels can show.
TEST(TraceStore, ARunThatGoesOnStaysSmallAndKeepsItsExtremes) {
    TraceStore columns;
    columns.reset(1);
    for (int k = 0; k < kMany; ++k)
        columns.append({manyAt(k)});
    EXPECT_LE(columns.rows(), TraceStore::kMaxRows * 5 / 4);
    EXPECT_EQ(columns.lastTime_s(), 0.1 * (kMany - 1));
    EXPECT_EQ(columns.value(Quantity::Temperature, 0, columns.rows() - 1),
              manyAt(kMany - 1).objects[0].measured_K);
    int reads = 0;
    const auto whole = columns.line(Quantity::Temperature, 0, 0.0, columns.lastTime_s(), 700, reads);
    EXPECT_NEAR(max(whole), 400.0, 1e-4);
    EXPECT_LE(whole.values.size(), 1400u);
    EXPECT_NEAR(whole.times_s.front(), 0.0, 1e-9);
    EXPECT_NEAR(whole.times_s.back(), columns.lastTime_s(), 1e-9);
    const auto around =
        columns.line(Quantity::Temperature, 0, 0.1 * kSpike - 60.0, 0.1 * kSpike + 60.0, 700, reads);
    EXPECT_NEAR(max(around), 400.0, 1e-4) << "older than the rows that are kept";
    const auto newest =
        columns.line(Quantity::Temperature, 0, columns.lastTime_s() - 60.0, columns.lastTime_s(), 700, reads);
    EXPECT_GE(newest.values.size(), 600u) << "sample by sample";
    for (std::size_t k = 1; k < newest.times_s.size(); ++k)
        ASSERT_GT(newest.times_s[k], newest.times_s[k - 1]);
    // Over the border between what is kept and what is not.
    const double border_s = columns.time_s(0);
    const auto both = columns.line(Quantity::Temperature, 0, border_s - 20.0, border_s + 20.0, 700, reads);
    EXPECT_LT(both.times_s.front(), border_s - 20.0);
    EXPECT_GT(both.times_s.back(), border_s + 20.0);
    for (std::size_t k = 1; k < both.times_s.size(); ++k)
        ASSERT_GE(both.times_s[k], both.times_s[k - 1]);
}

// Catches a falling line drawn as a saw.
TEST(TraceStore, AFallingLineFalls) {
    TraceStore columns;
    columns.reset(1);
    for (int k = 0; k < 16'000; ++k)
        columns.append({sampleAt(k, 400.0 - 0.001 * k, 313.0)});
    int reads = 0;
    const auto line = columns.line(Quantity::Temperature, 0, 0.0, 16'000.0, 200, reads);
    ASSERT_GT(line.values.size(), 100u);
    for (std::size_t k = 3; k < line.values.size(); ++k)
        EXPECT_LE(line.values[k], line.values[k - 1]) << k;
}

// Catches a view between samples and overview that draws far more points than pixels, or loses what is
// narrower than one, or lets the picture flicker when it is moved.
TEST(TraceStore, SamplesDenserThanPixelsAreDrawnByTheirExtremes) {
    TraceStore columns;
    columns.reset(1);
    columns.keepAll();
    std::vector<TraceSample> samples;
    for (int k = 0; k < 20'000; ++k)
        samples.push_back(sampleAt(0.1 * k,
                                   k == 7777   ? 400.0
                                   : k == 8888 ? 250.0
                                               : 300.0 + 0.1 * (k % 3),
                                   313.0, k < 9000 || k >= 9100));
    columns.append(samples);
    int reads = 0;
    const auto line = columns.line(Quantity::Temperature, 0, 500.0, 1100.0, 700, reads); // 6000 samples
    EXPECT_LE(line.values.size(), 2U * 720U);
    EXPECT_GE(line.values.size(), 1200U) << "finer than the overview's 375 stretches";
    EXPECT_EQ(max(line), 400.0);
    EXPECT_EQ(*std::ranges::min_element(line.values, {}, [](double v) { return std::isnan(v) ? 1e9 : v; }),
              250.0);
    EXPECT_GT(std::ranges::count_if(line.values, [](double v) { return std::isnan(v); }), 10) << "the gap";
    for (std::size_t k = 1; k < line.times_s.size(); ++k)
        ASSERT_GE(line.times_s[k], line.times_s[k - 1]);
    // Moved by less than a stretch: the same samples go together.
    const auto moved = columns.line(Quantity::Temperature, 0, 500.5, 1100.5, 700, reads);
    EXPECT_EQ(moved.times_s, line.times_s);
}
