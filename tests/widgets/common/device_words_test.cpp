// Devices in words, and the channels that follow their objects.

#include "widgets/common/device_words.h"

#include "engine/base/message_code.h"
#include "tests/widgets/rig/rig_bench.h"

#include <gtest/gtest.h>

namespace bask {
namespace {

std::vector<ObjectSpec> named(const std::vector<std::string>& names) {
    std::vector<ObjectSpec> objects(names.size());
    for (std::size_t i = 0; i < names.size(); ++i)
        objects[i].name = names[i];
    return objects;
}

std::vector<int> kept(const std::vector<std::string>& before, const std::vector<std::string>& after,
                      std::vector<int> channels) {
    keepChannels(named(before), named(after), channels);
    return channels;
}

} // namespace

// Catches an object that reads its neighbour's sensor after the one before it was removed.
TEST(DeviceWords, AChannelStaysWithItsObject) {
    EXPECT_EQ(kept({"a", "b", "c"}, {"b", "c"}, {4, 2, 0}), (std::vector{2, 0}));
    EXPECT_EQ(kept({"a", "b"}, {"a", "new", "b"}, {0, 2}), (std::vector{0, 1, 2}));
    EXPECT_EQ(kept({"a", "b"}, {"a", "renamed"}, {3, 1}), (std::vector{3, 1}));
    EXPECT_EQ(kept({"a"}, {"x", "y"}, {0}), (std::vector{0, 1})); // all new
}

// Catches a rig of another experiment that gives two objects one channel.
TEST(DeviceWords, ChannelsAreMadeToFit) {
    EXPECT_EQ(channelsFor({}, 3), (std::vector{0, 1, 2}));
    EXPECT_EQ(channelsFor({1}, 3), (std::vector{1, 0, 2}));
    EXPECT_EQ(channelsFor({5, 4, 3}, 2), (std::vector{5, 4}));
}

// Catches an age that is told in the wrong unit, and one of a device that never answered.
TEST(DeviceWords, AgesHaveAReadableUnit) {
    EXPECT_EQ(ageText(0.0124), "12 ms");
    EXPECT_EQ(ageText(0.9999), "1.0 s");
    EXPECT_EQ(ageText(3.21), "3.2 s");
    EXPECT_EQ(ageText(125.0), "2:05");
    EXPECT_EQ(ageText(1e300), "");
}

// Catches a heat that is told as off while the source heats, and as known where the device does not answer.
TEST(DeviceWords, HeatIsToldAsItIsKnown) {
    Alarm alarm;
    alarm.message = {MessageCode::SafetySourceHeatsUnasked, {"11", "20", "10"}};
    Snapshot snapshot;
    snapshot.alarms = {alarm};
    snapshot.heat = HeatState::Off;
    EXPECT_EQ(shownHeat(snapshot), ShownHeat::Unasked);
    EXPECT_EQ(heatPriority(ShownHeat::Unasked), 1);
    snapshot.unaskedFall = UnaskedFall{1.5, 10.0};
    EXPECT_EQ(shownHeat(snapshot), ShownHeat::Unasked) << "it may swing";
    snapshot.unaskedFall->fallen_K = 3.0;
    EXPECT_EQ(shownHeat(snapshot), ShownHeat::Off) << "it cools, while its alarm still stands";
    snapshot.unaskedFall.reset();
    EXPECT_EQ(shownHeat(snapshot, false), ShownHeat::Unknown) << "the engine does not answer";
    snapshot.heat = HeatState::Unknown;
    EXPECT_EQ(shownHeat(snapshot), ShownHeat::Unknown);
    snapshot.heat = HeatState::On;
    EXPECT_EQ(shownHeat(snapshot), ShownHeat::On);
    snapshot.heat = HeatState::Off;
    snapshot.alarms.front().message.code = MessageCode::SafetySourceNotCooling;
    EXPECT_EQ(shownHeat(snapshot), ShownHeat::Off);
    EXPECT_EQ(heatPriority(ShownHeat::Off), 0);
    snapshot.isSourceManual = true;
    EXPECT_EQ(shownHeat(snapshot), ShownHeat::ByHand);
}

// Catches a device that is taken off together with another one.
TEST(DeviceWords, OneDeviceIsTakenOffAlone) {
    const RigSpec rig = test::realRig();
    for (const DeviceRole role : {DeviceRole::Robot, DeviceRole::Thermometer, DeviceRole::HeatSource}) {
        const RigSpec without = withoutDevice(rig, role);
        EXPECT_FALSE(hasDevice(without, role));
        EXPECT_EQ(withDevice(without, role, rig), rig);
    }
}

} // namespace bask
