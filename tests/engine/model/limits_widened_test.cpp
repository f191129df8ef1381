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
