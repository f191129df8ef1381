#include "engine/runtime/lateness.h"

#include <gtest/gtest.h>

namespace bask {
namespace {

// Catches a share that counts one step too many or too few, and steps later than the histogram's end.
TEST(Lateness, QuantilesAndTheWorst) {
    Lateness lateness;
    EXPECT_EQ(lateness.quantile_s(0.5), 0.0);
    for (int i = 0; i < 999; ++i)
        lateness.add(i < 500 ? 0.00105 : 0.00405);
    lateness.add(2.0);
    EXPECT_EQ(lateness.count(), 1000U);
    EXPECT_NEAR(lateness.quantile_s(0.5), 0.0011, 1e-9);
    EXPECT_NEAR(lateness.quantile_s(0.501), 0.0041, 1e-9);
    EXPECT_NEAR(lateness.quantile_s(0.999), 0.0041, 1e-9);
    EXPECT_EQ(lateness.worst_s(), 2.0);
    EXPECT_EQ(lateness.quantile_s(1.0), 2.0);
}

} // namespace
} // namespace bask
