// The file of the alarms, between programs that run at the same time and one after another.

#include "engine/base/message_code.h"
#include "engine/experiment/alarm_file.h"
#include "engine/runtime/alarm_keeper.h"
#include "tests/support/wait_for.h"

#include <QDir>
#include <QFile>
#include <QTemporaryDir>

#include <gtest/gtest.h>

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
        first.keep(alarm("a"));
        second.keep(alarm("b"));
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
    keeper.keep(alarm("a"));
    ASSERT_TRUE(isWritten(keeper));
    EXPECT_EQ(readAlarms(path).value().size(), 1U);
    EXPECT_FALSE(keeper.takeFailure());
    ASSERT_TRUE(QDir(folder.path()).removeRecursively());
    for (const bool isTold : {true, false}) {
        keeper.keep(alarm("b"));
        ASSERT_TRUE(isWritten(keeper));
        EXPECT_EQ(keeper.takeFailure().has_value(), isTold);
    }
}

} // namespace bask
