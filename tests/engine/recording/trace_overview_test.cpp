#include "engine/recording/trace_overview.h"

#include "tests/engine/recording/recording.h"

#include <gtest/gtest.h>

#include <cmath>

namespace bask {
namespace {

using test::madeUpSample;
using test::twoDisks;

/// As TraceOverview should have it, from all samples.
Extremes bruteForce(const std::vector<TraceSample>& samples, Quantity quantity, std::size_t series,
                    std::size_t from, std::size_t count) {
    Extremes out;
    for (std::size_t k = from; k < std::min(from + count, samples.size()); ++k)
        out.include(static_cast<float>(plottedValue(samples[k], quantity, series)));
    return out;
}

bool same(const Extremes& a, const Extremes& b) {
    const auto equal = [](float x, float y) { return x == y || (std::isnan(x) && std::isnan(y)); };
    return equal(a.min, b.min) && equal(a.max, b.max);
}

std::vector<TraceSample> samples(int count) {
    std::vector<TraceSample> out;
    for (int k = 0; k < count; ++k)
        out.push_back(madeUpSample(twoDisks(), k));
    return out;
}

void expectExtremes(const TraceOverview& overview, const std::vector<TraceSample>& all) {
    const std::size_t each = overview.samplesPerStretch();
    ASSERT_EQ(overview.samples(), all.size());
    ASSERT_EQ(overview.stretches(), (all.size() + each - 1) / each);
    for (std::size_t k = 0; k < overview.stretches(); ++k) {
        EXPECT_EQ(overview.from_s(k), all[k * each].time_s);
        EXPECT_EQ(overview.to_s(k), all[std::min((k + 1) * each, all.size()) - 1].time_s);
        for (const Quantity q : {Quantity::Temperature, Quantity::Error, Quantity::ViewFactor, Quantity::Rate,
                                 Quantity::Speed, Quantity::Strength})
            for (std::size_t i = 0; i < 2; ++i)
                EXPECT_TRUE(same(overview.extremes(q, i, k), bruteForce(all, q, i, k * each, each)))
                    << static_cast<int>(q) << ' ' << i << ' ' << k;
    }
}

} // namespace

// Catches a spike of one sample that the picture of a day does not show.
TEST(TraceOverview, HasTheExtremesOfEveryStretch) {
    const auto all = samples(1000);
    TraceOverview overview(2);
    for (const TraceSample& sample : all)
        overview.add(sample);
    expectExtremes(overview, all);
    EXPECT_TRUE(overview.hasValues(Quantity::Strength));
    EXPECT_EQ(overview.stretchAt(-1.0), 0u);
    EXPECT_EQ(overview.stretchAt(overview.from_s(7)), 7u);
    EXPECT_EQ(overview.stretchAt(1e9), overview.stretches() - 1);
}

// Catches memory that grows with the run, and extremes lost where stretches are joined.
TEST(TraceOverview, GrowsCoarserNotLarger) {
    const auto all = samples(1000);
    for (const std::size_t max : {8u, 7u}) {
        TraceOverview overview(2, max);
        for (const TraceSample& sample : all)
            overview.add(sample);
        EXPECT_LE(overview.stretches(), max);
        EXPECT_GT(overview.samplesPerStretch(), TraceOverview::kStretch);
        expectExtremes(overview, all);
    }
}

// Catches a file's bytes that are not what was written, and such that are too few.
TEST(TraceOverview, BytesReadBack) {
    const auto all = samples(5 * 16);
    TraceOverview written(2), read(2);
    for (const TraceSample& sample : all)
        written.add(sample);
    EXPECT_FALSE(read.addBytes(written.bytes().substr(1)));
    EXPECT_EQ(read.samples(), 0u);
    ASSERT_TRUE(read.addBytes(written.bytes()));
    expectExtremes(read, all);
    read.add(madeUpSample(twoDisks(), 80));
    EXPECT_FALSE(read.addBytes(written.bytes())) << "after a stretch that is not full";
}

TEST(TraceOverview, InvalidReadingsHaveNoValue) {
    TraceSample sample = madeUpSample(twoDisks(), 20);
    sample.objects[0].valid = false;
    EXPECT_TRUE(std::isnan(plottedValue(sample, Quantity::Temperature, 0)));
    EXPECT_TRUE(std::isnan(plottedValue(sample, Quantity::Error, 0)));
    EXPECT_TRUE(std::isnan(plottedValue(sample, Quantity::Rate, 0)));
    EXPECT_FALSE(std::isnan(plottedValue(sample, Quantity::ViewFactor, 0)));
    EXPECT_TRUE(std::isnan(plottedValue(sample, Quantity::Temperature, 5))) << "no such object";
    EXPECT_EQ(seriesCount(Quantity::Speed, 5), 2u);
    EXPECT_EQ(seriesCount(Quantity::Error, 5), 5u);
}

} // namespace bask
