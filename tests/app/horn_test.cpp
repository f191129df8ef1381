#include "app/horn.h"
#include "app/settings_store.h"
#include "engine/base/message_code.h"
#include "tests/support/wait_for.h"

#include <gtest/gtest.h>

namespace bask::test {
namespace {

Alarm calling(int priority) {
    Alarm alarm;
    alarm.id = 1;
    alarm.key = "a";
    alarm.priority = priority;
    return alarm;
}

struct Heard {
    Horn horn;
    int times = 0;
    Heard() {
        horn.setSound([this] { ++times; });
    }
    void tell(const std::vector<Alarm>& alarms, bool simulated = false) {
        Snapshot snapshot;
        snapshot.simulated = simulated;
        snapshot.alarms = alarms;
        horn.apply(snapshot);
    }
};

} // namespace

// Catches: a horn that is silent beside a real rig, or goes on after everybody has seen it.
TEST(Horn, SoundsUntilTheAlarmIsAcknowledged) {
    Heard heard;
    heard.tell({});
    EXPECT_EQ(heard.times, 0);
    heard.tell({calling(1)});
    EXPECT_EQ(heard.times, 1) << "at once";
    for (int i = 0; i < 5; ++i)
        heard.tell({calling(1)}); // 20 times a second
    EXPECT_EQ(heard.times, 1);
    EXPECT_TRUE(waitFor([&] { return heard.times == 2; }, 10 * Horn::kGrave_ms));
    Alarm seen = calling(1);
    seen.isAcknowledged = true;
    heard.tell({seen});
    EXPECT_FALSE(heard.horn.isSounding());
}

// Catches: a horn for what is over, put aside, only to be noted, or was seen with its cause.
TEST(Horn, IsSilentForWhatDoesNotCall) {
    Alarm over = calling(1), shelved = calling(1), cause = calling(1), follows = calling(1);
    over.isActive = false;
    shelved.shelvedUntil_s = 1e12;
    cause.isAcknowledged = true;
    follows.key = "b";
    follows.cause = "a";
    follows.isAcknowledged = true;
    Alarm notice = calling(3);
    notice.message.code = MessageCode::SafetyLoopLate;
    for (const std::vector<Alarm>& alarms : {std::vector{over}, {shelved}, {notice}, {cause, follows}}) {
        Heard heard;
        heard.tell(alarms);
        EXPECT_EQ(heard.times, 0);
        EXPECT_FALSE(heard.horn.isSounding());
    }
    follows.isAcknowledged = false; // it came later
    Heard heard;
    heard.tell({cause, follows});
    EXPECT_TRUE(heard.horn.isSounding());
}

// Catches: a run that ended beside a person who looked elsewhere, or a bell without an end for what has time.
TEST(Horn, OfPriorityThreeSoundsOnce) {
    Heard heard;
    for (int i = 0; i < 5; ++i)
        heard.tell({calling(3)});
    EXPECT_EQ(heard.times, 1);
    EXPECT_FALSE(heard.horn.isSounding());
    Alarm again = calling(3);
    again.count = 2;
    heard.tell({again});
    EXPECT_EQ(heard.times, 2);
}

// Catches: a horn that people switch off because it sounds at every trial on the simulated rig.
TEST(Horn, ByDefaultOnlyOnARealRig) {
    EXPECT_EQ(SettingsStore().hornMode(), HornMode::RealRig);
    Heard heard;
    heard.tell({calling(1)}, true);
    EXPECT_EQ(heard.times, 0);
    heard.horn.setMode(HornMode::Always);
    EXPECT_EQ(heard.times, 1);
    heard.horn.setMode(HornMode::Off);
    EXPECT_FALSE(heard.horn.isSounding());
    heard.tell({calling(1)});
    EXPECT_EQ(heard.times, 1);
    SettingsStore().setHornMode(HornMode::Always);
    EXPECT_EQ(SettingsStore().hornMode(), HornMode::Always);
    SettingsStore().setHornMode(HornMode::RealRig);
}

// Catches: an engine that hangs beside a hot plate without a sound.
TEST(Horn, AnEngineThatDoesNotAnswerIsHeard) {
    Heard heard;
    heard.tell({});
    heard.horn.setAnswering(false);
    EXPECT_EQ(heard.times, 1);
    heard.horn.setAnswering(true);
    EXPECT_FALSE(heard.horn.isSounding());
}

} // namespace bask::test
