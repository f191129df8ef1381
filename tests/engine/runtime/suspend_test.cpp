// A computer that sleeps while it drives a rig.

#include "engine/base/units.h"
#include "tests/engine/runtime/rig_on_ports.h"

namespace bask {
namespace {

struct SuspendTest : test::RigOnPorts {
    const Alarm* alarm(MessageCode code) const {
        const auto it = std::ranges::find_if(
            engine->last.alarms, [&](const Alarm& a) { return a.isActive && a.message.code == code; });
        return it == engine->last.alarms.end() ? nullptr : &*it;
    }
    bool hasEvent(MessageCode code) const {
        return std::ranges::any_of(engine->events,
                                   [&](const TraceEvent& e) { return e.message.code == code; });
    }
};

} // namespace

TEST(SuspendWatch, TellsWhatTheOtherClockStoodStillFor) {
    ManualClock always, awake;
    SuspendWatch watch(always, awake);
    for (ManualClock* clock : {&always, &awake})
        clock->advance(10.0);
    EXPECT_EQ(watch.slept_s(), 0.0);
    always.advance(0.9); // no sleep is so short, and clocks are read one after the other
    EXPECT_EQ(watch.slept_s(), 0.0);
    always.advance(3599.1);
    EXPECT_NEAR(watch.slept_s(), 3600.0, 1e-9);
    EXPECT_EQ(watch.slept_s(), 0.0) << "once";
}

// Catches a source that was hot for an hour that nobody saw, as if nothing had been.
TEST_F(SuspendTest, WithHeatItIsAFault) {
    ASSERT_NO_FATAL_FAILURE(beginWell());
    engine->send(SetHeat{kelvinFromCelsius(100.0)});
    ASSERT_TRUE(sees([&] { return plate.isOn(); })) << describe(engine->refusal);
    *slept_s = 30.0;
    ASSERT_TRUE(sees([&] { return engine->last.state == RunState::Fault; }));
    ASSERT_TRUE(sees([&] { return alarm(MessageCode::SafetySuspended) != nullptr; }));
    EXPECT_EQ(alarm(MessageCode::SafetySuspended)->message.args.at(0), "30");
    EXPECT_TRUE(hasEvent(MessageCode::EventSuspended));
    EXPECT_TRUE(sees([&] { return !plate.isOn(); }));
}

// Catches a cold rig that stands, and is faulted.
TEST_F(SuspendTest, WithoutHeatOrMotionItIsToldAlone) {
    ASSERT_NO_FATAL_FAILURE(beginWell());
    *slept_s = 30.0;
    ASSERT_TRUE(sees([&] { return hasEvent(MessageCode::EventSuspended); }));
    EXPECT_EQ(engine->last.state, RunState::Ready);
    EXPECT_EQ(alarm(MessageCode::SafetySuspended), nullptr);
}

} // namespace bask
