#include "engine/recording/staged_files.h"

#include "engine/base/message_code.h"

#include <gtest/gtest.h>

#include <QDir>
#include <QFile>
#include <QTemporaryDir>

namespace bask {
namespace {

QStringList everythingIn(const QString& folder) {
    return QDir(folder).entryList(QDir::AllEntries | QDir::Hidden | QDir::NoDotAndDotDot, QDir::Name);
}

TEST(StagedFiles, ComeTogetherOrNotAtAll) {
    const QTemporaryDir folder;
    const QString place = folder.filePath("a/b");
    {
        auto files = StagedFiles::into(place.toStdString());
        ASSERT_TRUE(files) << describe(files.error());
        ASSERT_TRUE(files->write("one.txt", "1"));
        ASSERT_TRUE(files->write("deep/two.txt", "2"));
        EXPECT_FALSE(QFile::exists(place + "/one.txt"));
    }
    EXPECT_FALSE(QDir(place).exists()) << "a folder made for nothing goes";
    auto files = StagedFiles::into(place.toStdString());
    ASSERT_TRUE(files->write("one.txt", "1"));
    ASSERT_TRUE(files->write("deep/two.txt", "2"));
    const auto paths = files->commit();
    ASSERT_TRUE(paths) << describe(paths.error());
    EXPECT_EQ(paths->at(1), (place + "/deep/two.txt").toStdString());
    QFile two(place + "/deep/two.txt");
    ASSERT_TRUE(two.open(QIODevice::ReadOnly));
    EXPECT_EQ(two.readAll(), "2");
}

TEST(StagedFiles, TwoAtATimeInOneFolder) {
    const QTemporaryDir folder;
    auto one = StagedFiles::into(folder.path().toStdString());
    ASSERT_TRUE(one->write("one.txt", "1"));
    auto two = StagedFiles::into(folder.path().toStdString());
    ASSERT_TRUE(two->write("two.txt", "2"));
    ASSERT_TRUE(one->commit());
    ASSERT_TRUE(two->commit());
    EXPECT_EQ(QDir(folder.path()).entryList(QDir::Files), (QStringList{"one.txt", "two.txt"}));
}

TEST(StagedFiles, LeaveNothingHiddenBehind) {
    const QTemporaryDir folder;
    {
        auto files = StagedFiles::into(folder.path().toStdString());
        ASSERT_TRUE(files->write("one.txt", "1"));
        ASSERT_TRUE(files->commit());
    }
    EXPECT_EQ(everythingIn(folder.path()), QStringList{"one.txt"});
}

// Catches: older files that are gone when a later one cannot be moved; here one of the same name.
TEST(StagedFiles, PutOlderOnesBackWhenTheLastFails) {
    const QTemporaryDir folder;
    QFile old(folder.filePath("one.txt"));
    ASSERT_TRUE(old.open(QIODevice::WriteOnly) && old.write("old") == 3);
    old.close();
    {
        auto files = StagedFiles::into(folder.path().toStdString());
        ASSERT_TRUE(files->write("new.txt", "2"));
        ASSERT_TRUE(files->write("one.txt", "1"));
        ASSERT_TRUE(files->write("one.txt", "1"));
        const auto paths = files->commit();
        ASSERT_FALSE(paths);
        EXPECT_EQ(paths.error().code(), MessageCode::FileUnwritable);
    }
    ASSERT_TRUE(old.open(QIODevice::ReadOnly));
    EXPECT_EQ(old.readAll(), "old");
    EXPECT_EQ(everythingIn(folder.path()), QStringList{"one.txt"});
    auto files = StagedFiles::into(folder.path().toStdString());
    ASSERT_TRUE(files->write("one.txt", "1"));
    ASSERT_TRUE(files->commit());
    old.close();
    ASSERT_TRUE(old.open(QIODevice::ReadOnly));
    EXPECT_EQ(old.readAll(), "1");
}

TEST(StagedFiles, TellWhatCannotBeWritten) {
    const QTemporaryDir folder;
    QFile blocked(folder.filePath("file"));
    ASSERT_TRUE(blocked.open(QIODevice::WriteOnly));
    for (const char* place : {"file", "file/below", "/proc/no-such-place"}) {
        const QString path = *place == '/' ? QString(place) : folder.filePath(place);
        const auto files = StagedFiles::into(path.toStdString());
        ASSERT_FALSE(files) << place;
        EXPECT_EQ(files.error().code(), MessageCode::FileUnwritable) << place;
    }
    auto files = StagedFiles::into(folder.path().toStdString());
    ASSERT_TRUE(files->write("first.txt", "x"));
    ASSERT_TRUE(files->write("file/below.txt", "x"));
    EXPECT_FALSE(files->commit()) << "a file is where a folder is wanted";
    EXPECT_EQ(everythingIn(folder.path()).filter("first"), QStringList{});
    ASSERT_TRUE(QDir(folder.path()).mkpath("second.txt"));
    auto others = StagedFiles::into(folder.path().toStdString());
    ASSERT_TRUE(others->write("first.txt", "x"));
    ASSERT_TRUE(others->write("second.txt", "x"));
    EXPECT_FALSE(others->commit()) << "a folder is where a file is wanted";
    EXPECT_EQ(everythingIn(folder.path()).filter("first"), QStringList{});
}

} // namespace
} // namespace bask
