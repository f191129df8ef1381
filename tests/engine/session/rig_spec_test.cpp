// What a rig may not be: heat that nothing switches off.

#include "engine/session/rig_spec.h"

#include "engine/base/message_code.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace bask {
namespace {

const ModbusProfile& profileOf(const std::string& name) {
    return *std::ranges::find(shippedProfiles(), name, &ModbusProfile::name);
}

RigSpec rigWith(const ModbusProfile& profile) {
    RigSpec rig;
    rig.source.emplace().driver = HeatSourceDriver::Modbus;
    rig.source->port = "/dev/ttyPLATE";
    rig.source->profile = profile;
    return rig;
}

Error refusal(const RigSpec& rig) {
    const auto fit = checkRig(rig, 0, {});
    return fit ? Error(MessageCode::None, "") : fit.error();
}

} // namespace

// Promise: an engine that dies leaves no heat on, unless somebody has said that it may.
TEST(RigSpec, ASourceWithoutWatchdogMustBeAllowed) {
    for (const char* name : {"eurotherm-2400", "watlow-ez-zone"}) {
        RigSpec rig = rigWith(profileOf(name));
        EXPECT_EQ(refusal(rig).code(), MessageCode::SourceUnwatched) << name;
        EXPECT_EQ(refusal(rig).where, "source.profile");
        EXPECT_NE(describe(refusal(rig)).find("\"unattended_heat\": true"), std::string::npos);
        rig.source->mayHeatUnattended = true;
        EXPECT_EQ(refusal(rig).code(), MessageCode::None) << name;
    }
    EXPECT_EQ(refusal(rigWith(profileOf("pixsys-drr245"))).code(), MessageCode::None);
    RigSpec byHand;
    byHand.source.emplace();
    EXPECT_EQ(refusal(byHand).code(), MessageCode::None) << "a person is there";
}

// Catches a time that the register cannot hold, found only when the session begins; or one rounded to none.
TEST(RigSpec, TheWatchdogsTimeMustFitItsRegister) {
    RigSpec rig = rigWith(profileOf("pixsys-drr245")); // milliseconds in 16 bits
    rig.source->watchdog_s = 65.5;
    EXPECT_EQ(refusal(rig).code(), MessageCode::None);
    for (const double time_s : {66.0, 1500.0}) {
        rig.source->watchdog_s = time_s;
        EXPECT_EQ(refusal(rig).code(), MessageCode::ValueOutOfRange);
        EXPECT_EQ(refusal(rig).where, "source.watchdog_s");
    }
    rig.source->profile.watchdogUnit_s = 60.0;
    rig.source->watchdog_s = 120.0;
    EXPECT_EQ(refusal(rig).code(), MessageCode::None);
    for (const double time_s : {20.0, 30.0, 90.0}) {
        rig.source->watchdog_s = time_s;
        EXPECT_EQ(refusal(rig).code(), MessageCode::ValueOutOfRange) << time_s;
    }
}

} // namespace bask
