// `bask verify` as a person reads it.

#include "app/commands/command_line.h"
#include "engine/base/message_code.h"
#include "engine/recording/session_store.h"
#include "tests/engine/recording/recording.h"
#include "tests/support/captured_command.h"

#include <gtest/gtest.h>

#include <QFile>
#include <QTemporaryDir>

namespace bask::test {
namespace {

class VerifyCommand : public testing::Test {
protected:
    void SetUp() override {
        const Experiment experiment = twoDisks();
        const auto writer = SessionWriter::create(path("run.bask").toStdString(), experiment, true);
        ASSERT_TRUE(writer) << describe(writer.error());
        for (int k = 0; k < 40; ++k) {
            const TraceSample sample = madeUpSample(experiment, k);
            ASSERT_TRUE((*writer)->add(sample));
            if (k % 10 == 0) {
                ASSERT_TRUE((*writer)->add(TraceNote{sample.time_s, "a note"}));
            }
        }
        ASSERT_TRUE((*writer)->finish("settled"));
    }
    QString path(const char* name) const { return m_folder.filePath(QLatin1String(name)); }

    Captured verifiedAfter(std::initializer_list<const char*> statements) const {
        QFile::remove(path("b.bask"));
        EXPECT_TRUE(QFile::copy(path("run.bask"), path("b.bask")));
        {
            const auto store = SessionStore::create(path("b.bask").toStdString());
            for (const char* sql : statements)
                EXPECT_TRUE((*store)->execute(sql)) << sql;
        }
        return captured(verifyCommand, {path("b.bask")});
    }

    static bool has(const Captured& told, const char* words) {
        return told.out.find(words) != std::string::npos;
    }

    QTemporaryDir m_folder;
};

// Catches: a change that is told without its name or its time, or as another one.
TEST_F(VerifyCommand, NamesWhatWasAlteredInOneLine) {
    const struct {
        std::initializer_list<const char*> statements;
        const char* line;
    } kCases[] = {
        {{"DROP TABLE chain"}, "sqlite_master, table chain: removed\n"},
        {{"DELETE FROM seal"}, "altered: the seal was removed; tags"},
        {{"DROP VIEW sample"}, "sqlite_master, view sample: removed\n"},
        {{"UPDATE meta SET value = 'stopped' WHERE key = 'outcome'"}, "meta, key outcome: changed\n"},
        {{"DELETE FROM note WHERE rowid > 2"}, "note, rows 3 to 4, after 10.001 s: removed\n"},
        {{"DELETE FROM note WHERE rowid > 3"}, "note, row 4, after 20.002 s: removed\n"},
        {{"DELETE FROM step WHERE number BETWEEN 11 AND 20"}, "step, rows 11 to 20, 20.002 s: removed\n"},
        {{"UPDATE step SET source_K = 300 WHERE number = 11"}, "step, row 11, 10.001 s: changed\n"},
        {{"DELETE FROM chain WHERE number = 1"}, "chain, row 1: removed\n"},
        {{"PRAGMA application_id = 7"}, "header, number application_id: changed\n"},
        {{"CREATE TABLE \"a\u001b[2J\"(x)"}, "sqlite_master, table a"},
    };
    for (const auto& each : kCases) {
        SCOPED_TRACE(each.line);
        const Captured told = verifiedAfter(each.statements);
        EXPECT_EQ(told.code, 3);
        EXPECT_TRUE(has(told, each.line)) << told.out << told.err;
        EXPECT_TRUE(has(told, "\naltered: ")) << told.out;
        EXPECT_FALSE(has(told, "\x1b")) << "it would reach the terminal";
        EXPECT_FALSE(has(told, "recorded by an older Bask")) << told.out;
    }
    const Captured intact = verifiedAfter({});
    EXPECT_EQ(intact.code, 0);
    EXPECT_TRUE(intact.out.ends_with("\nintact\n")) << intact.out;
}

} // namespace
} // namespace bask::test
