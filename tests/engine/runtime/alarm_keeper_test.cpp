// The file of the alarms, between programs that run at the same time and one after another.

#include "engine/base/message_code.h"
#include "engine/experiment/alarm_file.h"
#include "engine/experiment/unrecorded_alarms.h"
#include "engine/runtime/alarm_keeper.h"
#include "tests/support/wait_for.h"

#include <QDir>
#include <QFile>
#include <QTemporaryDir>

#include <gtest/gtest.h>

#include <chrono>
#include <fcntl.h>
#include <tuple>

#include <sys/file.h>
#include <unistd.h>

namespace bask {
namespace {

struct AlarmKeeperTest : testing::Test {
    QTemporaryDir folder;
    std::string path = folder.filePath("alarms.json").toStdString();

    static AlarmKeeper::Before before(AlarmKeeper& keeper) {
        std::optional<AlarmKeeper::Before> out;
        EXPECT_TRUE(test::waitFor([&] { return (out = keeper.takeBefore()).has_value(); }));
        return out.value_or(AlarmKeeper::Before());
    }
    static std::vector<Alarm> alarm(const char* key) {
        return {{1, key, {MessageCode::SafetySensorOpen, {key}}, 1}};
    }
    const std::string unrecorded = unrecordedAlarmFile(path);
    const AlarmKeeper::Now idle{false, "B. Li"};

    /// What the file without a run tells, in short.
    std::string told() const {
        std::string out;
        const auto read = readUnrecordedAlarms(unrecorded);
        for (const UnrecordedChange& each : read.value().changes)
            out += shortly(each);
        return out;
    }
    static std::string shortly(const UnrecordedChange& each) {
        const char* const words[] = {" raised", " over", " seen by "};
        const bool isSeen = each.change == AlarmChange::Acknowledged;
        return each.key + words[static_cast<int>(each.change)] + (isSeen ? each.operatorName : "") + "; ";
    }
    static bool isWritten(const AlarmKeeper& keeper) { return keeper.wait(std::chrono::seconds(60)); }
};

} // namespace

// Catches two programs that write into one file, a second one that is not told, and alarms of a program that
// has ended which nobody sees any more.
TEST_F(AlarmKeeperTest, eachProgramThatRunsHasItsOwnFile) {
    {
        AlarmKeeper first(path);
        EXPECT_EQ(before(first).ownFile, "");
        AlarmKeeper second(path);
        const std::string other = before(second).ownFile;
        EXPECT_EQ(other, folder.filePath("alarms-2.json").toStdString());
        first.keep(alarm("a"), {});
        second.keep(alarm("b"), {});
        ASSERT_TRUE(isWritten(first) && isWritten(second));
        EXPECT_EQ(readAlarms(path).value().at(0).key, "a");
        EXPECT_EQ(readAlarms(other).value().at(0).key, "b");
    }
    AlarmKeeper later(path);
    const auto left = before(later);
    EXPECT_EQ(left.ownFile, "");
    ASSERT_EQ(left.alarms.size(), 2U);
    EXPECT_EQ(left.alarms[0].key, "a");
    EXPECT_EQ(left.alarms[1].key, "b");
    EXPECT_EQ(readAlarms(path).value().size(), 2U) << "a crash now loses none of them";
    EXPECT_FALSE(QFile::exists(folder.filePath("alarms-2.json")));
}

// Catches a damaged file that keeps alarms from being kept, and a folder that cannot be written told again
// and again, or never.
TEST_F(AlarmKeeperTest, aFailureIsToldOnce) {
    QFile file(QString::fromStdString(path));
    ASSERT_TRUE(file.open(QIODevice::WriteOnly) && file.write("{") == 1);
    file.close();
    AlarmKeeper keeper(path);
    EXPECT_TRUE(before(keeper).problem);
    keeper.keep(alarm("a"), {});
    ASSERT_TRUE(isWritten(keeper));
    EXPECT_EQ(readAlarms(path).value().size(), 1U);
    EXPECT_FALSE(keeper.takeFailure());
    ASSERT_TRUE(QDir(folder.path()).removeRecursively());
    for (const bool isTold : {true, false}) {
        keeper.keep(alarm("b"), {});
        ASSERT_TRUE(isWritten(keeper));
        EXPECT_EQ(keeper.takeFailure().has_value(), isTold);
    }
}

// Catches a change that is told twice, or not at all, one of a notice, and an alarm of an earlier program
// that is raised again by a restart.
TEST_F(AlarmKeeperTest, ChangesAreWhatHasCome) {
    const auto changes = [](const std::vector<Alarm>& before, const std::vector<Alarm>& after) {
        std::string out;
        for (const UnrecordedChange& each : alarmChanges(before, after, 20.0, "B. Li"))
            out += shortly(each);
        return out;
    };
    Alarm hot = alarm("hot").front();
    hot.raised_s = 10.0;
    EXPECT_EQ(changes({}, {hot}), "hot raised; ");
    EXPECT_EQ(alarmChanges({}, {hot}, 20.0, "")[0].utc_s, 10.0);
    EXPECT_EQ(changes({hot}, {hot}), "");
    Alarm seen = hot;
    seen.isAcknowledged = true;
    seen.seenBy = "A. Hu";
    EXPECT_EQ(changes({hot}, {seen}), "hot seen by A. Hu; ");
    EXPECT_EQ(changes({seen}, {}), "hot over; ");
    EXPECT_EQ(alarmChanges({seen}, {}, 20.0, "")[0].utc_s, 20.0);
    EXPECT_EQ(alarmChanges({seen}, {}, 20.0, "")[0].raised_s, 10.0);
    Alarm over = hot;
    over.isActive = false;
    EXPECT_EQ(changes({hot}, {over}), "hot over; ");
    EXPECT_EQ(changes({over}, {}), "hot seen by B. Li; ");
    EXPECT_EQ(changes({over}, {hot}), "hot raised; ");
    Alarm before = over;
    before.isFromBefore = true;
    EXPECT_EQ(changes({}, {before}), "");
    before.isActive = true; // as heat that was left
    EXPECT_EQ(changes({}, {before}), "");
    Alarm notice = hot;
    notice.priority = 3;
    EXPECT_EQ(changes({}, {notice}) + changes({notice}, {}), "");
}

// Catches alarms of a recorded run told as alarms without one, those without one lost, and one that is only
// kept from the change after.
TEST_F(AlarmKeeperTest, WhatNoRecordingTellsIsAppended) {
    AlarmKeeper keeper(path);
    before(keeper);
    keeper.keep(alarm("idle"), idle);
    keeper.keep({}, idle);
    keeper.keep(alarm("run"), {true, "B. Li"});
    keeper.keep({}, {true, "B. Li"});
    keeper.keep(alarm("later"), idle);
    ASSERT_TRUE(isWritten(keeper));
    EXPECT_EQ(told(), "idle raised; idle seen by B. Li; idle over; later raised; ");
}

// Catches a full disk that is told at each alarm, or never, and alarms that are lost by it.
TEST_F(AlarmKeeperTest, OnAFullDiskTheChangesWait) {
    AlarmKeeper keeper(path);
    before(keeper);
    const QString file = QString::fromStdString(unrecorded);
    ASSERT_TRUE(QFile::link("/dev/full", file));
    for (const auto& [key, isTold] : {std::tuple("a", true), std::tuple("b", false)}) {
        std::vector<Alarm> one = alarm(key);
        one[0].id = static_cast<unsigned char>(*key);
        keeper.keep(one, idle);
        ASSERT_TRUE(isWritten(keeper));
        EXPECT_EQ(keeper.takeFailure().has_value(), isTold) << key;
    }
    ASSERT_TRUE(QFile::remove(file));
    keeper.keep({}, idle);
    ASSERT_TRUE(isWritten(keeper));
    EXPECT_FALSE(keeper.takeFailure());
    EXPECT_EQ(told(), "a raised; b raised; a seen by B. Li; a over; b seen by B. Li; b over; ");
}

// Catches a caller that waits for the disk, or for another program that writes.
TEST_F(AlarmKeeperTest, KeepingDoesNotWait) {
    AlarmKeeper keeper(path);
    before(keeper);
    const int other = ::open((unrecorded + ".lock").c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0600);
    ASSERT_EQ(::flock(other, LOCK_EX), 0);
    keeper.keep(alarm("a"), idle);
    keeper.keep({}, idle);
    EXPECT_FALSE(keeper.wait(std::chrono::milliseconds(50)));
    EXPECT_FALSE(QFile::exists(QString::fromStdString(unrecorded)));
    ::close(other);
    ASSERT_TRUE(isWritten(keeper));
    EXPECT_EQ(told(), "a raised; a seen by B. Li; a over; ");
}

} // namespace bask
