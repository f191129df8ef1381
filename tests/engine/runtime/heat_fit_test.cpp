// All constants that explain an object's readings: none that is right is lost, and what is left tells.

#include "engine/runtime/heat_fit.h"

#include <gtest/gtest.h>

namespace bask {
namespace {

constexpr LossRange kLosses{0.0005, 0.03};

HeatSpan span(double energy_K, double loss_K_s) {
    return {energy_K, energy_K, loss_K_s, loss_K_s};
}

} // namespace

// Catches a corner that is cut off with the truth in it, or knowledge that does not grow.
TEST(HeatFit, KeepsTheTruthAndNarrows) {
    constexpr double k = 3.64, a = 0.008;
    HeatFit fit(kLosses);
    const HeatSpan asked = span(10.0, 500.0);
    const double truth_K = k * 10.0 - a * 500.0;
    double width_K = 1e9;
    for (const auto& [energy_K, loss_K_s] :
         {std::pair(5.0, 10.0), std::pair(8.0, 400.0), std::pair(0.0, 900.0), std::pair(3.0, 2000.0)}) {
        fit.learn(span(energy_K, loss_K_s), k * energy_K - a * loss_K_s, 0.3);
        ASSERT_FALSE(fit.isEmpty());
        const HeatFit::Change change = fit.expected(asked);
        EXPECT_LE(change.min_K, truth_K + 1e-9);
        EXPECT_GE(change.max_K, truth_K - 1e-9);
        EXPECT_LE(change.max_K - change.min_K, width_K + 1e-9);
        width_K = change.max_K - change.min_K;
    }
    EXPECT_LT(width_K, 2.0);
}

// Catches constants out of what may be that are made up to explain readings.
TEST(HeatFit, IsEmptyWhenNothingExplainsWhatIsSeen) {
    HeatFit fit(kLosses);
    fit.learn(span(10.0, 0.0), 0.0, 0.5); // heated, and not warmer: k would be 0.05
    EXPECT_TRUE(fit.isEmpty());
}

} // namespace bask
