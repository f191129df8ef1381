// The file of the alarms that came while nothing was recorded.

#include "engine/base/message_code.h"
#include "engine/experiment/unrecorded_alarms.h"

#include <gtest/gtest.h>

#include <QFile>
#include <QTemporaryDir>

#include <filesystem>
#include <fstream>

namespace bask {
namespace {

struct UnrecordedAlarmsTest : testing::Test {
    QTemporaryDir folder;
    std::string path = unrecordedAlarmFile(folder.filePath("alarms.json").toStdString());

    static UnrecordedChange raised(int number) {
        const double utc_s = 1.8e9 + number / 3.0;
        return {AlarmChange::Raised,
                utc_s,
                utc_s,
                "SafetyObjectHot/hand",
                {MessageCode::SafetyObjectHot, {"hand", std::to_string(number), "90"}},
                1,
                true,
                "A. Hu"};
    }
    /// About 0.7 MB of them, from the number on.
    static std::vector<UnrecordedChange> many(int first) {
        std::vector<UnrecordedChange> out;
        out.reserve(3000);
        for (int k = 0; k < 3000; ++k)
            out.push_back(raised(first + k));
        return out;
    }
    void write(const std::string& text) const { std::ofstream(path, std::ios::app) << text; }
};

} // namespace

// Catches a field that is not kept, a line that replaces those before, and a time that is rounded, by which
// nobody finds the alarm that is over.
TEST_F(UnrecordedAlarmsTest, WhatIsAppendedIsRead) {
    EXPECT_EQ(path, folder.filePath("alarms-without-run.jsonl").toStdString());
    EXPECT_TRUE(readUnrecordedAlarms(path).value().changes.empty()) << "no file";
    UnrecordedChange over = raised(1);
    over.change = AlarmChange::Over;
    over.utc_s += 12.3;
    UnrecordedChange seen = raised(1);
    seen.change = AlarmChange::Acknowledged;
    seen.isLive = false;
    seen.operatorName = "胡 \"B\"\n";
    ASSERT_TRUE(appendUnrecordedAlarms({raised(1), over}, path));
    ASSERT_TRUE(appendUnrecordedAlarms({seen}, path));
    const auto read = readUnrecordedAlarms(path);
    ASSERT_TRUE(read);
    EXPECT_EQ(read->changes, (std::vector{raised(1), over, seen}));
    EXPECT_EQ(read->damaged, 0U);
}

// Catches a damaged line that takes others with it, one that is taken for an alarm, and a line cut short by a
// crash that takes the next one.
TEST_F(UnrecordedAlarmsTest, DamagedLinesAreSkippedAndCounted) {
    ASSERT_TRUE(appendUnrecordedAlarms({raised(1)}, path));
    const std::string before = R"({"utc_s":1,"raised_s":1,"priority":1,"key":"k","event":)";
    write(
        "{}\n\n[[[\n" + before + R"("later","message":"SafetyObjectHot"})" + '\n' + before +
        R"("over","message":"Nonsense"})" + '\n' +
        R"({"utc_s":1e300,"raised_s":1,"priority":1,"key":"k","event":"over","message":"SafetyObjectHot"})" +
        '\n' + before);
    ASSERT_TRUE(appendUnrecordedAlarms({raised(2)}, path));
    const auto read = readUnrecordedAlarms(path);
    ASSERT_TRUE(read);
    EXPECT_EQ(read->changes, (std::vector{raised(1), raised(2)}));
    EXPECT_EQ(read->damaged, 6U);
}

// Catches a file that grows for ever, one that loses the newest, and a half line where it was cut.
TEST_F(UnrecordedAlarmsTest, TheOlderHalfIsDropped) {
    ASSERT_TRUE(appendUnrecordedAlarms(many(0), path));
    EXPECT_EQ(readUnrecordedAlarms(path).value().changes.size(), 3000U);
    ASSERT_TRUE(appendUnrecordedAlarms(many(3000), path));
    for (int k = 6000; k < 6100; ++k)
        ASSERT_TRUE(appendUnrecordedAlarms({raised(k)}, path));
    EXPECT_LE(std::filesystem::file_size(path), kMaxUnrecordedBytes);
    const auto read = readUnrecordedAlarms(path);
    ASSERT_TRUE(read);
    EXPECT_EQ(read->damaged, 0U);
    EXPECT_EQ(read->changes.back(), raised(6099));
    EXPECT_GT(read->changes.size(), 2000U);
    for (std::size_t k = 1; k < read->changes.size(); ++k)
        ASSERT_GT(read->changes[k].utc_s, read->changes[k - 1].utc_s);
}

// Catches a file of any size that fills the memory, or that is never written again.
TEST_F(UnrecordedAlarmsTest, OfAHugeFileTheNewestAreRead) {
    for (int k = 0; k < 4; ++k)
        write(std::string(1 << 20, 'x') + '\n');
    EXPECT_EQ(readUnrecordedAlarms(path).value().changes.size(), 0U);
    ASSERT_TRUE(appendUnrecordedAlarms({raised(1)}, path));
    EXPECT_LE(std::filesystem::file_size(path), kMaxUnrecordedBytes);
    EXPECT_EQ(readUnrecordedAlarms(path).value().changes, std::vector{raised(1)});
}

// Catches a full disk that nobody is told of, and what is no file read as one.
TEST_F(UnrecordedAlarmsTest, AFullDiskIsAnError) {
    ASSERT_TRUE(QFile::link("/dev/full", QString::fromStdString(path)));
    const auto written = appendUnrecordedAlarms({raised(1)}, path);
    ASSERT_FALSE(written);
    EXPECT_EQ(written.error().code(), MessageCode::FileUnwritable);
    EXPECT_EQ(written.error().where, path);
    ASSERT_FALSE(readUnrecordedAlarms(path));
    EXPECT_FALSE(appendUnrecordedAlarms({raised(1)}, "/nowhere/alarms-without-run.jsonl"));
}

} // namespace bask
