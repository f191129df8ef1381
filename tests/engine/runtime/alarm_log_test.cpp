// Alarms: condition and acknowledgement apart, repeats, the first of many, and over a restart.

#include "engine/base/message_code.h"
#include "engine/experiment/alarm_file.h"
#include "engine/runtime/alarm_log.h"

#include <QDir>
#include <QFile>
#include <QTemporaryDir>

#include <gtest/gtest.h>

#include <algorithm>

namespace bask {
namespace {

AlarmCondition open(const std::string& object) {
    return {"SafetySensorOpen:" + object, {MessageCode::SafetySensorOpen, {object}}, 1};
}
AlarmCondition warm(const std::string& object) {
    return {"SafetyObjectWarm:" + object, {MessageCode::SafetyObjectWarm, {object, "121", "120"}}, 2};
}

} // namespace

// Catches an alarm that vanishes before anybody has seen it, or one that can never be got rid of.
TEST(AlarmLog, AnAlarmStaysUntilItIsOverAndSeen) {
    AlarmLog log;
    EXPECT_TRUE(log.update(1.0, {open("a")}));
    EXPECT_FALSE(log.update(2.0, {open("a")}));
    EXPECT_TRUE(log.update(3.0, {})); // over, not seen
    ASSERT_EQ(log.alarms().size(), 1U);
    EXPECT_FALSE(log.alarms()[0].isActive);
    EXPECT_EQ(log.alarms()[0].raised_s, 1.0);
    EXPECT_EQ(log.alarms()[0].cleared_s, 3.0);
    EXPECT_TRUE(log.acknowledge(log.alarms()[0].id));
    EXPECT_TRUE(log.alarms().empty());

    log.update(4.0, {open("a")});
    EXPECT_TRUE(log.acknowledge(log.alarms()[0].id));
    EXPECT_FALSE(log.acknowledge(log.alarms()[0].id));
    ASSERT_EQ(log.alarms().size(), 1U); // seen, not over
    log.update(5.0, {});
    EXPECT_TRUE(log.alarms().empty());
    EXPECT_FALSE(log.acknowledgeAll());
}

// Catches "at 150.2" in the list while the object is at 195, and a disk that is written to with each reading.
TEST(AlarmLog, TheValueFollowsWhileItIsActive) {
    AlarmLog log;
    AlarmCondition hot = warm("a");
    EXPECT_TRUE(log.update(1.0, {hot}));
    hot.message.args[1] = "195";
    EXPECT_FALSE(log.update(2.0, {hot}));
    EXPECT_EQ(log.alarms()[0].message, hot.message);
    EXPECT_EQ(log.alarms()[0].raised_s, 1.0);
    log.update(3.0, {});
    EXPECT_EQ(log.alarms()[0].message, hot.message) << "the last value that was told";
}

// Catches a grave condition that hides behind a cause that was seen long before.
TEST(AlarmLog, WhatFollowsLateFromACauseThatWasSeenIsNew) {
    AlarmLog log;
    const AlarmCondition cause = open("a");
    AlarmCondition soon = open("b"), late = open("c"), note = warm("d");
    soon.cause = late.cause = note.cause = cause.key;
    log.update(1.0, {cause});
    log.acknowledgeAll();
    log.update(5.0, {cause, soon});
    EXPECT_TRUE(std::ranges::all_of(log.alarms(), &Alarm::isAcknowledged)) << "of one fault";
    log.update(100.0, {cause, soon, late, note});
    for (const Alarm& alarm : log.alarms())
        EXPECT_EQ(alarm.isAcknowledged, alarm.key != late.key) << alarm.key;
}

// Catches a grave alarm that is seen by nobody since its cause was shelved, at once, late, or raised anew;
// one that a row of another silences; and a row whose Shelve is refused.
TEST(AlarmLog, WhoShelvedACauseHasNotSeenWhatComesOfIt) {
    const AlarmCondition cause = open("a");
    AlarmCondition grave = open("b"), note = warm("d");
    grave.cause = note.cause = cause.key;
    const auto alarm = [](const AlarmLog& log, const AlarmCondition& of) {
        const auto found = std::ranges::find(log.alarms(), of.key, &Alarm::key);
        return found == log.alarms().end() ? Alarm() : *found;
    };
    for (const double later_s : {3.0, 100.0}) {
        AlarmLog log;
        log.update(1.0, {cause});
        ASSERT_TRUE(log.shelve(log.alarms()[0].id, 1.0, 1800.0, "known"));
        if (later_s > 10.0) { // the cause comes again
            log.update(50.0, {});
            log.update(later_s - 1.0, {cause});
        }
        log.update(later_s, {cause, grave, note});
        EXPECT_FALSE(alarm(log, grave).isAcknowledged) << later_s;
        EXPECT_EQ(alarm(log, grave).cause, "") << "by itself";
        EXPECT_TRUE(alarm(log, note).isAcknowledged);
        EXPECT_EQ(log.alarms()[0].key, grave.key) << "on top";
        EXPECT_TRUE(log.acknowledge(alarm(log, grave).id));
        log.update(later_s + 1.0, {cause, grave, note});
        EXPECT_EQ(alarm(log, grave).cause, "");
        log.update(2000.0, {cause, grave, note}); // the shelf is over
        EXPECT_FALSE(alarm(log, cause).isAcknowledged);
        EXPECT_EQ(alarm(log, grave).cause, cause.key);
    }
    AlarmLog log;
    log.update(1.0, {cause});
    log.acknowledgeAll();
    log.update(100.0, {cause, grave});
    EXPECT_FALSE(alarm(log, grave).isAcknowledged);
    ASSERT_TRUE(log.shelve(alarm(log, cause).id, 101.0, 600.0, "known"));
    EXPECT_FALSE(alarm(log, grave).isAcknowledged) << "it has a row of its own";
    EXPECT_TRUE(log.shelve(alarm(log, grave).id, 102.0, 600.0, "known, too"));
    AlarmLog under;
    under.update(1.0, {cause, grave});
    EXPECT_FALSE(under.shelve(alarm(under, grave).id, 2.0, 600.0, "known")) << "it goes with its cause";
    ASSERT_TRUE(under.shelve(alarm(under, cause).id, 2.0, 600.0, "known"));
    under.update(3.0, {cause, grave});
    EXPECT_TRUE(alarm(under, grave).isAcknowledged) << "put aside with its cause";
}

// Catches a chattering contact that floods the list, and one that is not told anew after it was seen.
TEST(AlarmLog, RepeatsAreCountedAndAnAcknowledgedAlarmThatComesAgainIsNew) {
    AlarmLog log;
    for (int i = 0; i < 5; ++i) {
        log.update(10.0 * i, {open("a")});
        log.update(10.0 * i + 1.0, {});
    }
    ASSERT_EQ(log.alarms().size(), 1U);
    EXPECT_EQ(log.alarms()[0].count, 5);
    EXPECT_EQ(log.alarms()[0].raised_s, 40.0);
    EXPECT_TRUE(log.acknowledgeAll());
    log.update(100.0, {open("a")});
    EXPECT_EQ(log.alarms()[0].count, 1);
    EXPECT_FALSE(log.alarms()[0].isAcknowledged);
}

// Catches a list without its likely cause, or sorted so that the graver is below.
TEST(AlarmLog, TheFirstIsMarkedAndTheGravestUnseenIsOnTop) {
    AlarmLog log;
    log.update(1.0, {warm("a")});
    EXPECT_FALSE(log.alarms()[0].isFirst) << "of one";
    log.update(2.0, {open("b"), warm("a")});
    ASSERT_EQ(log.alarms().size(), 2U);
    EXPECT_EQ(log.alarms()[0].key, "SafetySensorOpen:b");
    EXPECT_FALSE(log.alarms()[0].isFirst);
    EXPECT_TRUE(log.alarms()[1].isFirst);
    log.acknowledge(log.alarms()[0].id);
    EXPECT_EQ(log.alarms()[0].key, "SafetyObjectWarm:a");
    log.update(3.0, {});
    log.update(4.0, {open("c")}); // another story
    EXPECT_TRUE(std::ranges::none_of(log.alarms(), &Alarm::isFirst)) << "of one again";
    log.update(5.0, {open("c"), warm("d")});
    for (const Alarm& alarm : log.alarms())
        EXPECT_EQ(alarm.isFirst, alarm.key == "SafetySensorOpen:c");
}

// Catches an alarm of long ago, or of the other rig, that is called the likely cause of a new one.
TEST(AlarmLog, NoneIsFirstOfWhatComesLongAfterItOrAtTheOtherRig) {
    AlarmLog late;
    late.update(1.0, {warm("a")});
    late.update(4000.0, {warm("a"), open("b")});
    EXPECT_TRUE(std::ranges::none_of(late.alarms(), &Alarm::isFirst));

    AlarmLog other;
    other.use(true);
    const AlarmCondition left{"HeatLeftUnknown", {MessageCode::HeatLeftUnknown, {}}, 1};
    other.update(1.0, {left}); // stays active over the simulated rig
    other.use(false);
    other.update(2.0, {open("b")});
    ASSERT_EQ(other.alarms().size(), 2U);
    EXPECT_TRUE(std::ranges::none_of(other.alarms(), &Alarm::isFirst));
}

// Catches alarms that a crash takes along, that come back as if they held, or a file half written.
TEST(AlarmLog, AlarmsOutliveARestart) {
    const QTemporaryDir folder;
    const std::string path = folder.filePath("alarms.json").toStdString();
    EXPECT_TRUE(readAlarms(path).value().empty());
    AlarmLog log;
    log.update(1.0, {open("a"), warm("b")});
    log.update(2.0, {open("a")});
    ASSERT_TRUE(writeAlarms(log.alarms(), path));
    EXPECT_EQ(QDir(folder.path()).entryList(QDir::Files).size(), 1);
    const auto read = readAlarms(path);
    ASSERT_TRUE(read) << describe(read.error());
    AlarmLog after;
    after.addFromBefore(*read);
    ASSERT_EQ(after.alarms().size(), 2U);
    EXPECT_EQ(after.alarms()[0].message, open("a").message);
    EXPECT_TRUE(after.alarms()[0].isFromBefore);
    EXPECT_FALSE(after.alarms()[0].isActive);
    EXPECT_FALSE(after.alarms()[1].isFromBefore);
    after.update(10.0, {open("a")}); // and it is there again
    EXPECT_TRUE(after.alarms()[0].isActive);
    EXPECT_FALSE(after.alarms()[0].isFromBefore);
    EXPECT_EQ(after.alarms()[0].count, 2);
}

// Catches one lost link that is ten alarms, each to be acknowledged.
TEST(AlarmLog, WhatFollowsFromACauseStandsUnderItAndIsSeenWithIt) {
    const AlarmCondition link{"ThermometerLost", {MessageCode::LinkLost, {"/dev/x", "gone"}}, 1};
    const auto under = [](const std::string& object) {
        AlarmCondition condition = open(object);
        condition.cause = "ThermometerLost";
        return condition;
    };
    AlarmLog log;
    log.update(1.0, {open("a")}); // before anybody knows of the link
    log.update(2.0, {under("a"), under("b"), link});
    ASSERT_EQ(log.alarms().size(), 3U);
    EXPECT_EQ(log.alarms()[0].key, "ThermometerLost");
    EXPECT_EQ(log.alarms()[1].cause, "ThermometerLost");
    EXPECT_EQ(log.alarms()[2].cause, "ThermometerLost");
    EXPECT_TRUE(log.acknowledge(log.alarms()[0].id));
    EXPECT_TRUE(std::ranges::all_of(log.alarms(), &Alarm::isAcknowledged));
    log.update(3.0, {under("a"), under("b"), under("c"), link});
    EXPECT_TRUE(std::ranges::all_of(log.alarms(), &Alarm::isAcknowledged)) << "the cause has been seen";
    log.update(4.0, {open("b")}); // the link is back, one sensor is not
    ASSERT_EQ(log.alarms().size(), 1U);
    EXPECT_EQ(log.alarms()[0].cause, "");
}

// Catches a shelf without a reason or an end, one that hides a grave alarm for long, and an alarm that never
// comes back from it.
TEST(AlarmLog, AShelvedAlarmComesBackByItself) {
    AlarmLog log;
    log.update(1.0, {open("a"), warm("b")});
    const std::uint64_t grave = log.alarms()[0].id, other = log.alarms()[1].id;
    EXPECT_FALSE(log.shelve(grave, 1.0, 600.0, " "));
    EXPECT_FALSE(log.shelve(grave, 1.0, 1801.0, "wire ordered"));
    EXPECT_FALSE(log.shelve(99, 1.0, 600.0, "wire ordered"));
    ASSERT_TRUE(log.shelve(grave, 1.0, 600.0, "wire ordered"));
    ASSERT_TRUE(log.shelve(other, 1.0, 3600.0, "known"));
    EXPECT_TRUE(log.alarms()[0].isAcknowledged && log.alarms()[1].isAcknowledged);
    log.update(100.0, {});
    EXPECT_EQ(log.alarms().size(), 2U) << "listed, though over";
    log.update(200.0, {open("a")});
    EXPECT_TRUE(log.alarms()[0].isAcknowledged) << "still shelved";
    log.update(601.0, {open("a")});
    ASSERT_EQ(log.alarms()[0].id, grave);
    EXPECT_FALSE(log.alarms()[0].isAcknowledged);
    EXPECT_EQ(log.alarms()[0].shelvedUntil_s, 0.0);
    EXPECT_EQ(log.alarms()[0].shelfReason, "");
    EXPECT_TRUE(log.unshelve(other));
    EXPECT_FALSE(log.unshelve(other));
    EXPECT_EQ(log.alarms().size(), 1U) << "over long ago";
}

// Catches an alarm of the plate in the lab that comes back over a simulated run, and one that is lost there.
TEST(AlarmLog, EachKindOfRigHasItsOwn) {
    const QTemporaryDir folder;
    const std::string path = folder.filePath("alarms.json").toStdString();
    AlarmLog log;
    log.update(1.0, {warm("simulated")});
    log.use(true);
    EXPECT_TRUE(log.alarms().empty());
    log.update(2.0, {open("real")});
    log.use(true);
    ASSERT_EQ(log.alarms().size(), 1U);
    EXPECT_TRUE(log.alarms()[0].isActive);
    ASSERT_TRUE(writeAlarms(log.all(), path));
    AlarmLog after;
    after.addFromBefore(readAlarms(path).value());
    for (AlarmLog* one : {&log, &after}) {
        one->use(false);
        ASSERT_EQ(one->alarms().size(), 1U);
        EXPECT_EQ(one->alarms()[0].key, warm("simulated").key);
        EXPECT_TRUE(one->alarms()[0].isFromBefore && !one->alarms()[0].isActive);
        one->use(true);
        ASSERT_EQ(one->alarms().size(), 1U);
        EXPECT_EQ(one->alarms()[0].key, open("real").key);
        EXPECT_TRUE(one->alarms()[0].isFromBefore && !one->alarms()[0].isActive);
    }
}

// Catches heat that may still be on, and is seen no more since the simulated rig was chosen, or Bask was
// started anew.
TEST(AlarmLog, HeatThatWasLeftStaysOverTheSimulatedRig) {
    const QTemporaryDir folder;
    const std::string path = folder.filePath("alarms.json").toStdString();
    const Message left{MessageCode::HeatLeftUnknown, {"/dev/ttyUSB0"}};
    const AlarmCondition condition{messageName(left.code), left, 1};
    AlarmLog log;
    log.use(true);
    log.update(1.0, {condition, open("real")});
    ASSERT_TRUE(writeAlarms(log.all(), path));
    AlarmLog after;
    after.addFromBefore(readAlarms(path).value());
    log.use(false);
    for (AlarmLog* one : {&log, &after}) {
        one->update(2.0, {warm("simulated")});
        ASSERT_EQ(one->alarms().size(), 2U);
        const Alarm& first = one->alarms()[0];
        EXPECT_EQ(first.message, left);
        EXPECT_TRUE(first.isActive && first.isLive && !first.isAcknowledged);
        ASSERT_TRUE(one->acknowledge(first.id));
        ASSERT_EQ(one->alarms().size(), 1U);
        EXPECT_EQ(one->alarms()[0].key, warm("simulated").key);
    }
    AlarmLog again;
    again.addFromBefore(readAlarms(path).value());
    again.use(true); // its rig is watched
    again.update(3.0, {});
    const auto alarm = std::ranges::find(again.alarms(), left, &Alarm::message);
    ASSERT_NE(alarm, again.alarms().end());
    EXPECT_FALSE(alarm->isActive);
}

// Catches a program that does not start, or believes nonsense, since its alarms are damaged.
TEST(AlarmLog, ADamagedFileIsRefusedInWords) {
    const QTemporaryDir folder;
    const QString path = folder.filePath("alarms.json");
    for (const QByteArray text : {"", "{", "[]", "{\"format\":\"bask-alarms\",\"version\":2,\"alarms\":[]}",
                                  "{\"format\":\"other\",\"version\":1,\"alarms\":[]}",
                                  "{\"format\":\"bask-alarms\",\"version\":1,\"alarms\":{}}",
                                  "{\"format\":\"bask-alarms\",\"version\":1,\"alarms\":[{\"key\":3}]}"}) {
        QFile file(path);
        ASSERT_TRUE(file.open(QIODevice::WriteOnly | QIODevice::Truncate));
        file.write(text);
        file.close();
        const auto read = readAlarms(path.toStdString());
        ASSERT_FALSE(read) << text.constData();
        EXPECT_NE(describe(read.error()).find("alarms.json"), std::string::npos);
    }
    EXPECT_FALSE(writeAlarms({}, "/nowhere/alarms.json"));
}

} // namespace bask
