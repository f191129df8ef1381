// The rows of the alarm table, as engine and recordings read them.

#include "engine/base/alarm_entry.h"
#include "engine/base/message_code.h"

#include <gtest/gtest.h>

#include <set>
#include <string_view>

namespace bask {

// Catches a condition that is given another one's row.
TEST(AlarmEntries, StandInTheOrderOfTheirConditions) {
    ASSERT_FALSE(alarmEntries().empty());
    int number = 0;
    for (const AlarmEntry& entry : alarmEntries()) {
        EXPECT_EQ(static_cast<int>(entry.condition), number++) << entry.key;
        EXPECT_EQ(&alarmEntry(entry.condition), &entry);
    }
}

// Catches a priority that is told otherwise than it is listed, and two rows of one sentence: a recording has
// sentences, by which its rows are found.
TEST(AlarmEntries, AreFoundByTheirSentences) {
    std::set<MessageCode> codes;
    for (const AlarmEntry& entry : alarmEntries()) {
        if (entry.code == MessageCode::None)
            continue;
        EXPECT_TRUE(codes.insert(entry.code).second) << messageName(entry.code);
        EXPECT_EQ(entry.priority, alarmPriority(entry.code)) << messageName(entry.code);
        EXPECT_FALSE(std::string_view(entry.key).empty()) << messageName(entry.code);
    }
    EXPECT_GT(codes.size(), 20U);
}

// Catches columns that change places, and traits that are read by other numbers than they are written by.
TEST(AlarmEntries, HaveTheirTraitsAndDelays) {
    const AlarmEntry& hot = alarmEntry(SafetyCondition::ObjectHot);
    EXPECT_EQ(hot.code, MessageCode::SafetyObjectHot);
    EXPECT_EQ(hot.reaction, SafetyReaction::Retreat);
    EXPECT_TRUE(hot.isOfObject && hot.isSeenOver);
    EXPECT_FALSE(hot.isLoss);
    EXPECT_EQ(hot.on_s, 0.0);
    EXPECT_EQ(hot.off_s, 1.0);
    const AlarmEntry& frozen = alarmEntry(SafetyCondition::SensorFrozen);
    EXPECT_TRUE(frozen.isOfObject && frozen.isLoss && frozen.isSeenOver);
    EXPECT_FALSE(alarmEntry(SafetyCondition::NotWarming).isSeenOver);
    EXPECT_STREQ(alarmEntry(SafetyCondition::SensorOpen).key, "SensorLost");
    EXPECT_EQ(alarmEntry(SafetyCondition::RobotLost).code, MessageCode::None)
        << "the robot has its own words";
    EXPECT_FALSE(alarmEntry(SafetyCondition::DiskLow).isOfObject);
}

} // namespace bask
