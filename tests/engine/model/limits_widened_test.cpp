#include "engine/base/message_code.h"
#include "engine/base/units.h"
#include "engine/model/limits_widened.h"

#include <gtest/gtest.h>

#include <functional>
#include <string>

namespace bask {
namespace {

struct Edit {
    std::string name;
    std::function<void(Experiment&)> apply; ///< allows more
};

Experiment oneObject() {
    Experiment e;
    e.objects.emplace_back().name = "hand";
    e.objects[0].warning_K = 350.0;
    e.objects[0].trip_K = 360.0;
    e.safety.sourceTrip_K = 520.0;
    e.safety.largestRate_K_s = 3.0;
    e.robot.maxAcceleration_m_s2 = 0.1;
    e.robot.maxAngularAcceleration_rad_s2 = 0.1;
    e.rig.emplace().source.emplace().driver = "namur";
    return e;
}

std::vector<Edit> raises() {
    std::vector<Edit> out{
        {"max speed", [](Experiment& e) { e.robot.maxSpeed_m_s *= 1.01; }},
        {"max rotation", [](Experiment& e) { e.robot.maxRotation_rad_s *= 1.01; }},
        {"acceleration", [](Experiment& e) { e.robot.maxAcceleration_m_s2 *= 1.01; }},
        {"no acceleration limit", [](Experiment& e) { e.robot.maxAcceleration_m_s2 = 0.0; }},
        {"angular acceleration", [](Experiment& e) { e.robot.maxAngularAcceleration_rad_s2 *= 1.01; }},
        {"clearance", [](Experiment& e) { e.robot.clearance_m -= 1e-6; }},
        {"free axis", [](Experiment& e) { e.robot.free[5] = true; }},
        {"own warning", [](Experiment& e) { e.objects[0].warning_K = 351.0; }},
        {"no own warning", [](Experiment& e) { e.objects[0].warning_K.reset(); }},
        {"own trip", [](Experiment& e) { e.objects[0].trip_K = 361.0; }},
        {"source trip", [](Experiment& e) { e.safety.sourceTrip_K = 521.0; }},
        {"automatic source trip", [](Experiment& e) { e.safety.sourceTrip_K.reset(); }}, // 523.15 K
        {"warning", [](Experiment& e) { e.safety.warning_K += 1.0; }},
        {"trip", [](Experiment& e) { e.safety.trip_K += 1.0; }},
        {"stale periods", [](Experiment& e) { e.safety.stalePeriods += 0.5; }},
        {"held limit", [](Experiment& e) { e.safety.pauseLimit_s += 1.0; }},
        {"largest rate", [](Experiment& e) { e.safety.largestRate_K_s = 3.1; }},
        {"automatic rate", [](Experiment& e) { e.safety.largestRate_K_s.reset(); }},
        {"jumps", [](Experiment& e) { e.safety.jumps += 1; }},
        {"frozen", [](Experiment& e) { e.safety.frozen_s += 1.0; }},
        {"warming", [](Experiment& e) { e.safety.warming_K += 0.1; }},
        {"cross check", [](Experiment& e) { e.safety.crossCheck_K += 0.1; }},
        {"source heating", [](Experiment& e) { e.safety.sourceHeating_s += 1.0; }},
        {"source band", [](Experiment& e) { e.safety.sourceBand_K += 1.0; }},
        {"source unasked", [](Experiment& e) { e.safety.sourceUnasked_K += 1.0; }},
        {"watchdog", [](Experiment& e) { e.rig->source->watchdog_s = 1500.0; }},
        {"least disk", [](Experiment& e) { e.safety.minDisk_MB -= 1.0; }},
    };
    for (int k = 0; k < 4; ++k) {
        out.push_back({"lower " + std::to_string(k), [k](Experiment& e) { e.robot.lower[k] -= 1e-3; }});
        out.push_back({"upper " + std::to_string(k), [k](Experiment& e) { e.robot.upper[k] += 1e-3; }});
    }
    return out;
}

} // namespace

// Catches a limit that can be raised on a real rig unasked.
TEST(LimitsWidened, EveryRaiseIsTold) {
    for (const Edit& raise : raises()) {
        Experiment more = oneObject();
        raise.apply(more);
        EXPECT_TRUE(widensLimits(oneObject(), more)) << raise.name;
    }
}

// Catches questions on the way down, where the answer would be a habit soon.
TEST(LimitsWidened, LoweringIsNot) {
    EXPECT_FALSE(widensLimits(oneObject(), oneObject()));
    for (const Edit& raise : raises()) {
        Experiment more = oneObject();
        raise.apply(more);
        const bool isUnknown = raise.name == "automatic rate"; // 3 K/s may be more than the automatic one
        EXPECT_EQ(widensLimits(more, oneObject()), isUnknown) << raise.name;
    }
    Experiment automatic = oneObject();
    automatic.safety.largestRate_K_s.reset();
    Experiment slow = oneObject();
    slow.safety.largestRate_K_s = 2.0; // as the least automatic one
    EXPECT_FALSE(widensLimits(automatic, slow));
}

TEST(LimitsWidened, WhatIsNoLimitIsNoMatter) {
    Experiment other = oneObject();
    other.objects[0].target_K += 5.0;
    other.objects.emplace_back().name = "new";
    other.robot.lower[5] -= 1.0;        // not free
    other.source.temperature_K += 10.0; // its trip limit stays
    EXPECT_FALSE(widensLimits(oneObject(), other));
    Experiment automatic = oneObject();
    automatic.safety.sourceTrip_K.reset();
    Experiment hotter = automatic;
    hotter.source.temperature_K += 10.0; // takes its trip limit along
    EXPECT_TRUE(widensLimits(automatic, hotter));
}

// Catches a file whose limits nobody set on this rig, taken over since there is nothing to compare it with.
TEST(LimitsWidened, AreToldInWordsAndAgainstTheUsual) {
    Experiment usual;
    usual.objects.emplace_back().name = "hand";
    usual.rig.emplace().source.emplace();
    usual.robot.upper[0] += 0.1; // the rig's own
    EXPECT_TRUE(widenedFromUsual(usual).empty());
    EXPECT_EQ(limitsLoosened({}), Message{});
    Experiment more = usual;
    more.objects[0].trip_K = kelvinFromCelsius(180.0);
    more.rig->source->mayHeatUnattended = true;
    const auto widened = widenedFromUsual(more);
    ASSERT_EQ(widened.size(), 2U);
    EXPECT_EQ(describe(widened[0]), "trip limit of \"hand\": 180 °C instead of 150 °C");
    EXPECT_EQ(describe(widened[1]), "heat without a watchdog: allowed instead of not allowed");
    EXPECT_NE(describe(limitsLoosened(widened)).find("180"), std::string::npos);
    EXPECT_EQ(widenedLimits(usual, more), widened);
    Experiment renamed = usual; // a limit does not come in under another name
    renamed.objects[0].name = "foot";
    renamed.objects[0].trip_K = kelvinFromCelsius(151.0);
    EXPECT_EQ(widenedLimits(usual, renamed).size(), 1U);
}

// Catches a heater whose watchdog a file makes wider, unasked: it stays hot so long when the computer dies.
TEST(LimitsWidened, ADevicesOwnLimitsAreComparedWithTheDeviceBefore) {
    Experiment now;
    now.objects.emplace_back().name = "hand";
    now.rig.emplace().source.emplace().driver = "namur";
    now.rig->source->watchdog_s = 100.0;
    Experiment next = now;
    next.rig->source->watchdog_s = 1500.0;
    const auto widened = widenedLimits(now, next);
    ASSERT_EQ(widened.size(), 1U);
    EXPECT_EQ(describe(widened[0]), "Watchdog: 1500 s instead of 100 s");
    EXPECT_EQ(describe(widenedFromUsual(next).at(0)), "Watchdog: 1500 s instead of 30 s");
    next.rig->source->watchdog_s = 90.0;
    EXPECT_FALSE(widensLimits(now, next));
    next.rig->source->driver = "modbus"; // another device, whose profile has a watchdog
    next.rig->source->profile.watchdog.emplace();
    EXPECT_FALSE(widensLimits(now, next));
    next.rig->source->watchdog_s = 101.0;
    EXPECT_TRUE(widensLimits(now, next));
    now.rig->source->driver = "by_hand"; // which has none: the usual one counts
    EXPECT_TRUE(widensLimits(now, next));
    next.rig->source->watchdog_s = 30.0;
    EXPECT_FALSE(widensLimits(now, next));
    now.rig->source.reset();
    EXPECT_FALSE(widensLimits(now, next));
    next.rig->source->watchdog_s = 31.0;
    EXPECT_TRUE(widensLimits(now, next));
}

// Catches a question that comes in English words and kelvins for whoever reads another language and scale.
TEST(LimitsWidened, AreSentencesWhoseValuesKeepTheirKind) {
    Experiment more = oneObject();
    more.objects[0].warning_K = 351.0;
    more.safety.crossCheck_K += 5.0;
    more.safety.largestRate_K_s = 3.5;
    more.robot.upper[0] += 0.05;
    more.robot.free[5] = true;
    const auto widened = widenedLimits(oneObject(), more);
    ASSERT_EQ(widened.size(), 5U);
    const auto kindOf = [&](std::size_t i, std::size_t arg) {
        return widened[i].args.at(arg).kind(argKind(widened[i].code, arg));
    };
    EXPECT_EQ(widened[0].args[0].sentences().at(0), (Message{MessageCode::LimitOfWarning, {"hand"}}));
    EXPECT_EQ(kindOf(0, 1), ArgKind::Temperature);
    EXPECT_EQ(kindOf(1, 0), ArgKind::Label);
    EXPECT_EQ(kindOf(1, 1), ArgKind::Difference);
    EXPECT_EQ(widened[2].args[1].sentences().at(0).code, MessageCode::RateOfChange);
    EXPECT_EQ(widened[3].args[0].sentences().at(0), (Message{MessageCode::LimitHighest, {"x"}}));
    EXPECT_EQ(kindOf(3, 1), ArgKind::Number);
    EXPECT_EQ(widened[4].args[0].sentences().at(0), (Message{MessageCode::LimitAxis, {"theta z"}}));
    EXPECT_EQ(kindOf(4, 2), ArgKind::Label);
    std::string told;
    for (const Message& each : widened)
        told += describe(each) + '\n';
    EXPECT_EQ(told, "warning limit of \"hand\": 77.85 °C instead of 76.85 °C\n"
                    "Sensors apart when cold: 10 K instead of 5 K\n"
                    "Fastest plausible change: 3.5 K/s instead of 3 K/s\n"
                    "highest x: 25 cm instead of 20 cm\n"
                    "axis theta z: free instead of fixed\n");
}

// Catches a workspace that is widened on the simulated rig, where nobody asks, and then is the real robot's.
TEST(LimitsWidened, AWorkspaceIsComparedWithTheRealRigThatWasThere) {
    Experiment real;
    real.objects.emplace_back().name = "hand";
    real.rig.emplace();
    Experiment simulated = real;
    simulated.rig.reset();
    simulated.robot.upper[0] += 0.1;
    Experiment next = simulated;
    next.rig = real.rig;
    EXPECT_TRUE(widenedOnRealRig(simulated, next).empty());
    const auto widened = widenedOnRealRig(simulated, next, real.robot);
    ASSERT_EQ(widened.size(), 1U);
    EXPECT_NE(describe(widened[0]).find("highest x"), std::string::npos) << describe(widened[0]);
    EXPECT_TRUE(widenedOnRealRig(simulated, real, real.robot).empty());
}

// Does not compile with a new field: it needs its line in safetyParameters(), and its test above.
TEST(LimitsWidened, KnowsEveryFieldOfSafety) {
    const auto [warning, trip, sourceTrip, stale, pause, rate, jumps, frozen, warming, apart, heating, band,
                unasked, disk] = SafetySpec();
    EXPECT_LT(warning, trip);
    EXPECT_TRUE(!sourceTrip && !rate && jumps > 0);
    for (const double value : {stale, pause, frozen, warming, apart, heating, band, unasked, disk})
        EXPECT_GT(value, 0.0);
}

} // namespace bask
