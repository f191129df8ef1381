#include "widgets/common/alarm_groups.h"

#include "engine/base/message_code.h"

#include <gtest/gtest.h>

namespace bask {
namespace {

Alarm alarmOf(std::uint64_t id, const std::string& key, const std::string& cause = {}) {
    Alarm alarm;
    alarm.id = id;
    alarm.key = key;
    alarm.cause = cause;
    return alarm;
}

std::vector<std::uint64_t> idsOf(const std::vector<Alarm>& alarms) {
    std::vector<std::uint64_t> ids;
    for (const Alarm& alarm : alarms)
        ids.push_back(alarm.id);
    return ids;
}

} // namespace

// Catches: one lost link counted as ten alarms, and a consequence of a consequence that stands by itself.
TEST(AlarmGroups, WhatFollowsIsUnderItsCause) {
    const AlarmGroups groups = groupAlarms({alarmOf(4, "third", "second"), alarmOf(1, "first"),
                                            alarmOf(2, "second", "first"), alarmOf(3, "other")});
    ASSERT_EQ(groups.present.size(), 2U);
    EXPECT_EQ(groups.present[0].alarm.id, 1U);
    EXPECT_EQ(idsOf(groups.present[0].consequences), (std::vector<std::uint64_t>{4, 2}));
    EXPECT_EQ(groups.present[1].alarm.id, 3U);
    EXPECT_TRUE(groups.shelved.empty());
}

// Catches: red words of an alarm that is over for as long as a slighter one that followed from it is there.
TEST(AlarmGroups, WhatIsLeftOfACauseStandsByItself) {
    Alarm trip = alarmOf(1, "trip"), warning = alarmOf(2, "warning", "trip"), end = alarmOf(3, "end", "trip");
    warning.priority = 2;
    end.isActive = false;
    EXPECT_EQ(groupAlarms({trip, warning, end}).present.size(), 1U);
    trip.isActive = false;
    AlarmGroups groups = groupAlarms({trip, warning, end});
    ASSERT_EQ(groups.present.size(), 2U);
    EXPECT_EQ(groups.present[0].alarm.id, 2U);
    EXPECT_EQ(gravest(groups)->alarm.priority, 2);
    EXPECT_EQ(idsOf(groups.present[1].consequences), (std::vector<std::uint64_t>{3}));
    EXPECT_FALSE(groups.present[1].isActive());
    trip.shelvedUntil_s = 1e9;
    trip.isAcknowledged = true;
    EXPECT_EQ(groupAlarms({trip, warning, end}).present.size(), 1U) << "nobody has seen it";
    warning.isAcknowledged = true;
    groups = groupAlarms({trip, warning, end});
    EXPECT_TRUE(groups.present.empty()) << "put aside with its cause";
}

// Catches: an alarm that nobody has seen under one that calls nobody, and a grave one under a lesser.
TEST(AlarmGroups, WhatNobodyHasSeenIsUnderNothingThatWasSeen) {
    Alarm cause = alarmOf(1, "cause"), follows = alarmOf(2, "follows", "cause");
    EXPECT_EQ(groupAlarms({cause, follows}).present.size(), 1U);
    cause.isAcknowledged = true;
    AlarmGroups groups = groupAlarms({cause, follows});
    ASSERT_EQ(groups.present.size(), 2U);
    EXPECT_FALSE(groups.present[0].isCalling());
    EXPECT_TRUE(groups.present[1].isCalling());
    follows.isAcknowledged = true;
    EXPECT_EQ(groupAlarms({cause, follows}).present.size(), 1U);
    follows.shelvedUntil_s = 1e9;
    groups = groupAlarms({cause, follows});
    ASSERT_EQ(groups.shelved.size(), 1U) << "with those that can be taken back";
    EXPECT_EQ(groups.shelved[0].alarm.id, 2U);
    Alarm lesser = alarmOf(3, "lesser"), grave = alarmOf(4, "grave", "lesser");
    lesser.priority = 2;
    EXPECT_EQ(groupAlarms({lesser, grave}).present.size(), 2U);
    grave.priority = 2;
    EXPECT_EQ(groupAlarms({lesser, grave}).present.size(), 1U);
}

// Catches: a state, a line before a run and the alarm of the same event with different priorities.
TEST(AlarmGroups, AReasonHasThePriorityOfItsAlarm) {
    Alarm lost = alarmOf(1, "SensorLost:hand");
    lost.priority = 3;
    lost.message = {MessageCode::ReasonSensorInvalid, {"hand"}};
    const Message place{MessageCode::RobotPlaceUnsure, {}}, none{MessageCode::RemedyReset, {}};
    EXPECT_EQ(reasonPriority(lost.message, {lost}), 3);
    EXPECT_EQ(reasonPriority(place, {lost}), 2) << "of its words";
    EXPECT_EQ(reasonPriority(none, {lost}), 0);
    EXPECT_EQ(gravestPriority({lost.message, none}, {lost}), 3);
    EXPECT_EQ(gravestPriority({lost.message, place}, {lost}), 2);
    EXPECT_EQ(gravestPriority({none}, {lost}), 0);
}

// Catches: a consequence that nobody sees once its cause has left the list, and causes that name each other.
TEST(AlarmGroups, NoneIsLost) {
    const AlarmGroups orphan = groupAlarms({alarmOf(2, "second", "first")});
    ASSERT_EQ(orphan.present.size(), 1U);
    EXPECT_EQ(orphan.present[0].alarm.id, 2U);
    const AlarmGroups circle = groupAlarms({alarmOf(1, "a", "b"), alarmOf(2, "b", "a")});
    EXPECT_EQ(circle.present.size(), 2U);
    const AlarmGroups itself = groupAlarms({alarmOf(1, "a", "a")});
    EXPECT_EQ(itself.present.size(), 1U);
}

// Catches: an alarm that is over in front of one that still is so, and a shelved one among those that call.
TEST(AlarmGroups, WhatStillIsSoComesFirstAndTheShelvedApart) {
    Alarm over = alarmOf(1, "a");
    over.isActive = false;
    Alarm shelved = alarmOf(2, "b");
    shelved.shelvedUntil_s = 1e9;
    shelved.isAcknowledged = true;
    Alarm along = alarmOf(4, "d", "b");
    along.isAcknowledged = true;
    const AlarmGroups groups = groupAlarms({over, shelved, alarmOf(3, "c"), along});
    ASSERT_EQ(groups.present.size(), 2U);
    EXPECT_EQ(groups.present[0].alarm.id, 3U);
    EXPECT_EQ(groups.present[1].alarm.id, 1U);
    ASSERT_EQ(groups.shelved.size(), 1U);
    EXPECT_EQ(groups.shelved[0].alarm.id, 2U);
    EXPECT_EQ(idsOf(groups.shelved[0].consequences), (std::vector<std::uint64_t>{4}));
    over.cause.clear();
    Alarm alive = alarmOf(5, "e", "a");
    EXPECT_TRUE(groupAlarms({over, alive}).present[0].isActive()) << "something of it still is so";
}

// Catches: an alarm of little weight, or a later one, before the gravest that still is so.
TEST(AlarmGroups, TheGravestIsActiveThenByPriorityThenTheFirst) {
    Alarm over = alarmOf(1, "a"), slight = alarmOf(2, "b"), later = alarmOf(3, "c"), first = alarmOf(4, "d");
    over.isActive = false;
    slight.priority = 3;
    later.raised_s = 20.0;
    first.raised_s = 10.0;
    first.isAcknowledged = true;
    const AlarmGroups groups = groupAlarms({over, slight, later, first});
    ASSERT_NE(gravest(groups), nullptr);
    EXPECT_EQ(gravest(groups)->alarm.id, 4U);
    EXPECT_EQ(gravest(groupAlarms({})), nullptr);
}

} // namespace bask
