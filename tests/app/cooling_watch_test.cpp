// What a live run waits for when it is over.

#include "app/commands/cooling_watch.h"
#include "engine/base/units.h"

#include <gtest/gtest.h>

#include <cmath>

namespace bask {
namespace {

/// From a temperature with a rate; how long it was watched, at most 60 s.
double watchedFor_s(double from_degC, double rate_K_s) {
    CoolingWatch watch(kelvinFromCelsius(25.0));
    Snapshot snapshot;
    snapshot.state = RunState::Stopped;
    snapshot.sourceAge_s = 0.1;
    for (; snapshot.clock_s < 60.0; snapshot.clock_s += 0.1) {
        snapshot.source_K = kelvinFromCelsius(from_degC + rate_K_s * snapshot.clock_s);
        if (watch.isOver(snapshot))
            break;
    }
    return snapshot.clock_s;
}

} // namespace

// Catches a run that was stopped while the plate was still cool, and left it heating by a relay that sticks.
TEST(CoolingWatchTest, APlateThatGrowsWarmerIsWatchedAlsoWhileItIsCool) {
    EXPECT_GE(watchedFor_s(45.0, 0.5), 59.0);
    EXPECT_NEAR(watchedFor_s(45.0, 0.0), 10.0, 0.5);
    EXPECT_LE(watchedFor_s(45.0, -0.2), 14.0);
}

// Catches a hot plate that is believed to be off since it says so.
TEST(CoolingWatchTest, AHotPlateIsWatchedUntilItCools) {
    EXPECT_GE(watchedFor_s(200.0, 0.0), 59.0);
    EXPECT_GE(watchedFor_s(200.0, 0.5), 59.0);
    EXPECT_NEAR(watchedFor_s(200.0, -1.0), 5.0, 0.5);
}

// Catches a wait without an end for a source that tells nothing, and one that takes silence for cold at once.
TEST(CoolingWatchTest, ASilentSourceIsWaitedForSomeTime) {
    CoolingWatch watch(kelvinFromCelsius(25.0));
    Snapshot snapshot;
    snapshot.state = RunState::Fault;
    snapshot.sourceAge_s = 5.0;
    EXPECT_FALSE(watch.isOver(snapshot));
    snapshot.sourceAge_s = 11.0;
    EXPECT_TRUE(watch.isOver(snapshot));
    snapshot.pending = PendingAction{};
    EXPECT_FALSE(watch.isOver(snapshot)) << "a retreat is announced";
}

} // namespace bask
