#include "app/commands/command_line.h"
#include "tests/engine/recording/recording.h"
#include "tests/support/captured_command.h"

#include <gtest/gtest.h>

#include <QFile>
#include <QTemporaryDir>

namespace bask {
namespace {

test::Captured run(const QStringList& arguments) {
    return test::captured(exportCommand, arguments);
}

TEST(ExportCommand, WritesTheTablesAndNamesThem) {
    const QTemporaryDir folder;
    const QString session = folder.filePath("run.bask");
    {
        auto writer = SessionWriter::create(session.toStdString(), test::twoDisks(), true);
        ASSERT_TRUE((*writer)->add(test::madeUpSample(test::twoDisks(), 0)));
    }
    const test::Captured outcome = run({session, "--csv", folder.filePath("csv")});
    EXPECT_EQ(outcome.code, kExitDone) << outcome.err;
    EXPECT_NE(outcome.out.find(folder.filePath("csv/sample.csv\n").toStdString()), std::string::npos);
    EXPECT_TRUE(QFile::exists(folder.filePath("csv/pose.csv")));
    EXPECT_EQ(outcome.err, "");

    QFile blocked(folder.filePath("blocked"));
    ASSERT_TRUE(blocked.open(QIODevice::WriteOnly));
    EXPECT_EQ(run({session, "--csv", blocked.fileName()}).code, kExitBadInput);
}

// Catches: a user's table of the same name lost to an export, or the others written before it is seen.
TEST(ExportCommand, ReplacesNothingButItsOwnTables) {
    const QTemporaryDir folder;
    const QString session = folder.filePath("run.bask");
    ASSERT_TRUE(SessionWriter::create(session.toStdString(), test::twoDisks(), true));
    QFile mine(folder.filePath("sample.csv"));
    ASSERT_TRUE(mine.open(QIODevice::WriteOnly) && mine.write("my own figures\n") > 0);
    mine.close();
    const test::Captured outcome = run({session, "--csv", folder.path()});
    EXPECT_EQ(outcome.code, kExitBadInput);
    EXPECT_NE(outcome.err.find("sample.csv: a file of that name exists"), std::string::npos) << outcome.err;
    ASSERT_TRUE(mine.open(QIODevice::ReadOnly));
    EXPECT_EQ(mine.readAll(), "my own figures\n");
    EXPECT_FALSE(QFile::exists(folder.filePath("pose.csv")));

    ASSERT_TRUE(mine.remove());
    EXPECT_EQ(run({session, "--csv", folder.path()}).code, kExitDone);
    EXPECT_EQ(run({session, "--csv", folder.path()}).code, kExitDone) << "its own tables are replaced";
}

TEST(ExportCommand, RefusesBadInputOnStandardError) {
    for (const QStringList& arguments :
         {QStringList{}, QStringList{"a.bask"}, QStringList{"--csv", "dir"},
          QStringList{"none.bask", "--csv", "dir"}, QStringList{"a.bask", "b.bask", "--csv", "dir"},
          QStringList{"a.bask", "--csv", "dir", "--frobnicate"}}) {
        const test::Captured outcome = run(arguments);
        EXPECT_EQ(outcome.code, kExitBadInput) << arguments.join(' ').toStdString();
        EXPECT_EQ(outcome.out, "");
        EXPECT_NE(outcome.err, "");
    }
    EXPECT_NE(run({"none.bask", "--csv", "dir"}).err.find("none.bask: there is no such file"),
              std::string::npos);
}

TEST(ExportCommand, HelpsOnStandardOutput) {
    const test::Captured outcome = run({"--help"});
    EXPECT_EQ(outcome.code, kExitDone);
    EXPECT_NE(outcome.out.find("--csv <DIR>"), std::string::npos) << outcome.out;
}

} // namespace
} // namespace bask
