#include "widgets/plots/trace_columns.h"

#include <gtest/gtest.h>

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

TEST(TraceColumns, InvalidReadingsAreNotNumbers) {
    TraceColumns columns;
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
TEST(TraceColumns, TimeGrowsAndObjectsMayBeMissing) {
    TraceColumns columns;
    columns.reset(2);
    EXPECT_EQ(columns.append({sampleAt(1, 300, 313), sampleAt(1, 301, 313), sampleAt(0.5, 301, 313)}), 0u);
    EXPECT_EQ(columns.rows(), 1u);
    EXPECT_TRUE(std::isnan(columns.value(Quantity::Temperature, 1, 0)));
    EXPECT_EQ(columns.append({sampleAt(2, 300, 320)}), 1u);
    ASSERT_EQ(columns.targetSteps(0).size(), 2u);
    EXPECT_EQ(columns.targetSteps(0)[1], std::pair(2.0, 320.0));
    EXPECT_TRUE(columns.targetSteps(1).empty());
}

TEST(TraceColumns, NearestRow) {
    TraceColumns columns;
    columns.reset(1);
    EXPECT_EQ(columns.nearestRow(3.0), 0u);
    columns.append({sampleAt(1, 300, 313), sampleAt(2, 300, 313), sampleAt(4, 300, 313)});
    EXPECT_EQ(columns.nearestRow(-5.0), 0u);
    EXPECT_EQ(columns.nearestRow(2.9), 1u);
    EXPECT_EQ(columns.nearestRow(3.1), 2u);
    EXPECT_EQ(columns.nearestRow(99.0), 2u);
}
