// What the pages say of a rig whose engine does not answer.

#include "app/silent_engine.h"

#include <gtest/gtest.h>

namespace bask {

// Catches a window that goes on calling a reading good, a place sure or heat off that nobody knows any more.
TEST(SilentEngine, NothingIsKnownThatOnlyTheEngineKnows) {
    Snapshot last;
    last.state = RunState::Running;
    last.source_K = last.latest.source_K = 500.0;
    last.sourceAge_s = 0.1;
    last.heat = HeatState::Off;
    last.place = PlaceState::Sure;
    last.placeAge_s = 0.2;
    last.isMoving = last.canRetreat = true;
    last.pending = PendingAction{};
    last.latest.objects.resize(2);
    last.sensors = {SensorTrust::Trusted, SensorTrust::Distrusted};
    last.readingAges_s = {0.1, 30.0};
    last.newSamples.resize(3);
    last.newEvents.resize(1);
    const Snapshot now = withoutAnswer(last, 10.0);
    EXPECT_EQ(now.heat, HeatState::Unknown);
    EXPECT_EQ(now.place, PlaceState::Unknown);
    EXPECT_DOUBLE_EQ(now.placeAge_s, 10.2);
    EXPECT_DOUBLE_EQ(now.sourceAge_s, 10.1);
    EXPECT_FALSE(now.source_K || now.pending || now.isMoving || now.canRetreat);
    EXPECT_EQ(now.latest.source_K, 500.0) << "kept, with its age";
    EXPECT_EQ(now.sensors, (std::vector{SensorTrust::Stale, SensorTrust::Distrusted}));
    EXPECT_EQ(now.readingAges_s, (std::vector{10.1, 40.0}));
    EXPECT_TRUE(now.newSamples.empty() && now.newEvents.empty()) << "or they would be drawn twice";
}

} // namespace bask
