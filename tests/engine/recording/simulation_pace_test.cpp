#include "engine/recording/simulation_pace.h"

#include <gtest/gtest.h>

namespace bask {
namespace {

SessionRecord simulatedIn57s() {
    SessionRecord facts;
    facts.simulated = true;
    facts.created = "2026-11-29T22:08:19Z";
    facts.finished = "2026-11-29T22:09:16Z";
    return facts;
}

} // namespace

// Catches a run in real time that is called fast, and a fast one that is not.
TEST(SimulationPaceOfARun, IsThatOfTheClockOnlyWhereTheRunIsLonger) {
    const SessionRecord facts = simulatedIn57s();
    const auto fast = simulationPace(facts, 532.0);
    ASSERT_TRUE(fast);
    EXPECT_DOUBLE_EQ(fast->run_s, 532.0);
    EXPECT_DOUBLE_EQ(fast->clock_s, 57.0);
    EXPECT_EQ(paceText(*fast), "532 s of the simulated rig in 57 s by the clock");
    EXPECT_EQ(paceText({86400.06, 3600.0}), "86400.1 s of the simulated rig in 3600 s by the clock");
    EXPECT_FALSE(simulationPace(facts, 58.9)) << "the clock's ends are whole seconds";
    EXPECT_FALSE(simulationPace(facts, 0.0));
}

TEST(SimulationPaceOfARun, NeedsASimulationAndBothEnds) {
    SessionRecord facts = simulatedIn57s();
    facts.simulated = false;
    EXPECT_FALSE(simulationPace(facts, 532.0));
    facts = simulatedIn57s();
    facts.finished.clear(); // interrupted
    EXPECT_FALSE(simulationPace(facts, 532.0));
    facts.finished = "2026-11-29T22:08:00Z"; // the clock was set
    EXPECT_FALSE(simulationPace(facts, 532.0));
    facts.finished = "yesterday";
    EXPECT_FALSE(simulationPace(facts, 532.0));
}

} // namespace bask
