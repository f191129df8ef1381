// Files that are no session, or no longer one; disks that are full.

#include "engine/base/message_code.h"
#include "engine/recording/session_file.h"
#include "engine/recording/session_header.h"
#include "tests/engine/recording/recording.h"
#include "tests/support/first_version.h"

#include <gtest/gtest.h>

#include <QDir>
#include <QFile>
#include <QSqlDatabase>
#include <QSqlQuery>
#include <QTemporaryDir>

#include <algorithm>
#include <csignal>
#include <random>

#include <sys/resource.h>

namespace bask {
namespace {

using test::madeUpSample;
using test::twoDisks;

class DamagedSession : public ::testing::Test {
protected:
    void SetUp() override {
        auto writer = SessionWriter::create(file("whole.bask"), twoDisks(), true);
        ASSERT_TRUE(writer);
        for (int k = 0; k < 500; ++k)
            ASSERT_TRUE((*writer)->add(madeUpSample(twoDisks(), k)));
        ASSERT_TRUE((*writer)->finish("settled"));
        writer->reset();
        QFile whole(m_folder.filePath("whole.bask"));
        ASSERT_TRUE(whole.open(QIODevice::ReadOnly));
        m_bytes = whole.readAll();
    }

    std::string file(const char* name) const { return m_folder.filePath(name).toStdString(); }

    Result<SessionRecord> readBytes(const QByteArray& bytes) const {
        QFile out(m_folder.filePath("damaged.bask"));
        EXPECT_TRUE(out.open(QIODevice::WriteOnly));
        out.write(bytes);
        out.close();
        return readSession(out.fileName().toStdString());
    }

    MessageCode refusal(const QByteArray& bytes) const {
        const auto record = readBytes(bytes);
        EXPECT_FALSE(record);
        if (record)
            return MessageCode::None;
        EXPECT_EQ(record.error().where.rfind(file("damaged.bask"), 0), 0u) << describe(record.error());
        return record.error().code();
    }

    /// Runs SQL on a copy of the session, behind Bask's back.
    std::string altered(const char* sql) const {
        const QString path = m_folder.filePath("altered.bask");
        QFile::remove(path);
        EXPECT_TRUE(QFile::copy(m_folder.filePath("whole.bask"), path));
        {
            auto db = QSqlDatabase::addDatabase("QSQLITE", "alter");
            db.setDatabaseName(path);
            EXPECT_TRUE(db.open());
            EXPECT_TRUE(QSqlQuery(db).exec(sql)) << sql;
            db.close();
        }
        QSqlDatabase::removeDatabase("alter");
        return path.toStdString();
    }

    QTemporaryDir m_folder;
    QByteArray m_bytes;
};

TEST_F(DamagedSession, CutShortIsSaidSo) {
    for (const qsizetype size : {qsizetype{16}, qsizetype{60}, qsizetype{100}, qsizetype{4096},
                                 qsizetype{10'000}, m_bytes.size() / 2, m_bytes.size() - 1})
        EXPECT_EQ(refusal(m_bytes.left(size)), MessageCode::SessionDamaged) << size;
}

TEST_F(DamagedSession, OtherFilesAreNoSession) {
    EXPECT_EQ(refusal({}), MessageCode::NotASession);
    EXPECT_EQ(refusal("hello"), MessageCode::NotASession);
    EXPECT_EQ(refusal(QByteArray(100'000, 'x')), MessageCode::NotASession);
    EXPECT_EQ(refusal(m_bytes.left(10)), MessageCode::NotASession);
    EXPECT_EQ(readSession(altered("PRAGMA application_id = 7")).error().code(), MessageCode::NotASession);
    EXPECT_EQ(readSession(m_folder.path().toStdString()).error().code(), MessageCode::FileUnreadable);
    EXPECT_EQ(readSession(file("none.bask")).error().code(), MessageCode::FileNotFound);
    EXPECT_EQ(readSession("").error().code(), MessageCode::FileNotFound);
}

TEST_F(DamagedSession, ANewerVersionIsNamed) {
    const auto record = readSession(altered("PRAGMA user_version = 9"));
    ASSERT_FALSE(record);
    EXPECT_EQ(record.error().message, (Message{MessageCode::VersionTooNew, {"9", "2"}}));
}

TEST_F(DamagedSession, MissingAndInconsistentTables) {
    for (const char* sql :
         {"DROP TABLE step", "DROP TABLE meta", "DROP TABLE event", "DELETE FROM step WHERE number = 7",
          "UPDATE step SET number = 1000 WHERE number = 500",
          "ALTER TABLE step RENAME COLUMN view_factor_1 TO other"}) {
        EXPECT_EQ(readSession(altered(sql)).error().code(), MessageCode::SessionDamaged) << sql;
    }
    const auto experiment = readSession(altered("UPDATE experiment SET json = '{'"));
    ASSERT_FALSE(experiment);
    EXPECT_EQ(experiment.error().where, file("altered.bask") + ": experiment");
    EXPECT_FALSE(readSession(altered("DELETE FROM experiment")));
}

TEST_F(DamagedSession, MissingAndInconsistentTablesOfVersionOne) {
    ASSERT_TRUE(test::makeFirstVersion(file("whole.bask")));
    for (const char* sql :
         {"DROP TABLE pose", "DROP TABLE sample", "DROP TABLE meta", "DROP TABLE truth",
          "DELETE FROM pose WHERE rowid = 7", "DELETE FROM sample WHERE rowid = 7",
          "DELETE FROM motion WHERE rowid = 500", "DELETE FROM source_pose WHERE rowid = 5",
          "UPDATE sample SET object = 'x' WHERE rowid = 3", "UPDATE source SET time_s = 0.5 WHERE rowid = 3",
          "ALTER TABLE sample DROP COLUMN view_factor"})
        EXPECT_EQ(readSession(altered(sql)).error().code(), MessageCode::SessionDamaged) << sql;
}

// Catches limits read from a number that is no set of limits, of which the conversion is undefined.
TEST_F(DamagedSession, LimitsThatAreNoneAreNoLimits) {
    for (const char* value : {"-1", "1e300", "4096", "0.0 - 9e999"}) {
        const auto record = readSession(altered((std::string("UPDATE step SET limited = ") + value).c_str()));
        ASSERT_TRUE(record) << describe(record.error());
        EXPECT_EQ(record->samples[7].limits, ActiveLimits{}) << value;
    }
}

TEST_F(DamagedSession, AHostileTableNameIsNotExported) {
    const std::string path = altered("CREATE TABLE \"../evil\"(a)");
    const auto files = exportSessionCsv(path, file("csv"));
    ASSERT_TRUE(files) << describe(files.error());
    EXPECT_FALSE(QFile::exists(m_folder.filePath("evil.csv")));
}

// Catches a file from elsewhere that computes when it is read, without end or until the memory is full; here
// each computes little.
TEST_F(DamagedSession, WhatComputesIsRefused) {
    const auto refusals = [&](const char* from, const std::vector<std::string>& statements) {
        const std::string path = file("computes.bask");
        QFile::remove(QString::fromStdString(path));
        ASSERT_TRUE(QFile::copy(QString::fromStdString(file(from)), QString::fromStdString(path)));
        for (const std::string& sql : statements) {
            const auto store = SessionStore::create(path);
            ASSERT_TRUE((*store)->execute(sql)) << sql;
        }
        const SessionHeader header = readSessionHeader(path);
        ASSERT_TRUE(header.error) << statements.back();
        EXPECT_EQ(header.error->code(), MessageCode::SessionDamaged) << describe(*header.error);
        EXPECT_NE(describe(*header.error).find("Bask does not make this"), std::string::npos);
        EXPECT_FALSE(readSession(path)) << statements.back();
    };
    const std::string many = " AS WITH n(i) AS (SELECT 1 UNION ALL SELECT i + 1 FROM n LIMIT 9) SELECT ";
    for (const std::vector<std::string>& statements : std::vector<std::vector<std::string>>{
             {"DROP TABLE note", "CREATE VIEW note" + many + "i AS time_s, 'x' AS text FROM n"},
             {"DROP TABLE meta", "CREATE VIEW Meta" + many + "'key' AS key, 'value' AS value FROM n"},
             {"DROP VIEW pose", "CREATE VIEW pose" + many + "i AS time_s FROM n"},
             {"DROP VIEW pose", "CREATE VIEW pose AS SELECT a.time_s FROM step AS a CROSS JOIN step"},
             {"DROP VIEW pose", "CREATE VIEW pose AS SELECT hex(zeroblob(9)) AS time_s FROM step"},
             {"DROP TABLE object", "CREATE VIEW object AS SELECT number, time_s AS name FROM step"},
             {"WITH n(i) AS (SELECT 3 UNION ALL SELECT i + 1 FROM n LIMIT 9) INSERT INTO object SELECT i, "
              "'x' FROM n"},
             {"CREATE TRIGGER more AFTER INSERT ON meta BEGIN DELETE FROM step; END"},
             {"ALTER TABLE note ADD COLUMN long TEXT AS (hex(zeroblob(9)))"}})
        ASSERT_NO_FATAL_FAILURE(refusals("whole.bask", statements));
    ASSERT_TRUE(test::makeFirstVersion(file("whole.bask")));
    ASSERT_NO_FATAL_FAILURE(
        refusals("whole.bask", {"CREATE TABLE step(time_s REAL)", "DROP TABLE source",
                                "CREATE VIEW source AS SELECT time_s FROM step CROSS JOIN object"}));
    EXPECT_TRUE(readSession(altered("CREATE INDEX mine ON sample(object)")));
    EXPECT_TRUE(readSession(altered("CREATE TABLE mine(what TEXT)")));
}

// Catches a list that reads whatever lies in its folder into the memory.
TEST_F(DamagedSession, AListReadsNoMoreThanItNeeds) {
    const SessionHeader header = readSessionHeader(altered(
        "INSERT INTO note SELECT a.time_s, hex(zeroblob(5000)), '' FROM step AS a, step AS b LIMIT 2000"));
    ASSERT_FALSE(header.error) << describe(*header.error);
    EXPECT_EQ(header.notes.size(), 1000U);
    EXPECT_EQ(header.notes.front().size(), 4096U);
    EXPECT_EQ(header.title, twoDisks().title);
    EXPECT_EQ(readSessionHeader(altered("UPDATE experiment SET json = hex(zeroblob(9000000))")).title, "");
}

TEST_F(DamagedSession, ADamagedOneIsNotExported) {
    const std::string path = altered("DROP TABLE step");
    EXPECT_FALSE(exportSessionCsv(path, file("csv")));
    EXPECT_FALSE(QDir(m_folder.filePath("csv")).exists());
}

// Catches crashes and hangs; damage in the empty end of a page may go unseen, in the structure it may not.
TEST_F(DamagedSession, RandomDamageNeverCrashes) {
    std::mt19937 random(11);
    const auto below = [&](qsizetype n) {
        return std::uniform_int_distribution<qsizetype>(0, n - 1)(random);
    };
    int refused = 0;
    for (int k = 0; k < 60; ++k) {
        QByteArray bytes = m_bytes;
        const qsizetype at = below(bytes.size());
        const qsizetype length = std::min<qsizetype>(1 + below(3000), bytes.size() - at);
        for (qsizetype i = at; i < at + length; ++i)
            bytes[i] = static_cast<char>(below(256));
        refused += readBytes(bytes) ? 0 : 1;
    }
    EXPECT_GT(refused, 30);
}

TEST_F(DamagedSession, ADamagedLogIsIgnoredFromTheDamageOn) {
    auto writer = SessionWriter::create(file("live.bask"), twoDisks(), true, 0.0);
    for (int k = 0; k < 30; ++k)
        ASSERT_TRUE((*writer)->add(madeUpSample(twoDisks(), k)));
    // What a crash would leave: the files as they are now, the log cut in the middle of a page.
    ASSERT_TRUE(QFile::copy(m_folder.filePath("live.bask"), m_folder.filePath("crashed.bask")));
    ASSERT_TRUE(QFile::copy(m_folder.filePath("live.bask-wal"), m_folder.filePath("crashed.bask-wal")));
    QFile log(m_folder.filePath("crashed.bask-wal"));
    ASSERT_TRUE(log.resize(log.size() - 5000));
    const auto record = readSession(file("crashed.bask"));
    ASSERT_TRUE(record) << describe(record.error());
    EXPECT_LT(record->samples.size(), 30u);
    EXPECT_GT(record->samples.size(), 20u);
}

TEST_F(DamagedSession, CannotBeMadeWhereThereIsNoFolder) {
    const auto writer = SessionWriter::create(file("no/such/run.bask"), twoDisks(), true);
    ASSERT_FALSE(writer);
    EXPECT_EQ(writer.error().code(), MessageCode::FileUnwritable);
    EXPECT_FALSE(SessionWriter::create(m_folder.path().toStdString(), twoDisks(), true));
    EXPECT_FALSE(SessionWriter::create("", twoDisks(), true));
    EXPECT_FALSE(SessionWriter::create("/proc/run.bask", twoDisks(), true));
}

TEST_F(DamagedSession, AnInvalidExperimentIsNotRecorded) {
    Experiment experiment = twoDisks();
    experiment.objects[1].name = experiment.objects[0].name;
    const auto writer = SessionWriter::create(file("invalid.bask"), experiment, true);
    ASSERT_FALSE(writer);
    EXPECT_EQ(writer.error().code(), MessageCode::DuplicateName);
    EXPECT_FALSE(QFile::exists(m_folder.filePath("invalid.bask")));
}

// A limit on the size of files is what a full disk looks like to SQLite.
TEST_F(DamagedSession, AFullDiskIsReportedAndWhatWasWrittenStays) {
    auto writer = SessionWriter::create(file("full.bask"), twoDisks(), true, 0.0);
    ASSERT_TRUE(writer);
    ASSERT_TRUE((*writer)->add(madeUpSample(twoDisks(), 0)));
    rlimit before{};
    ASSERT_EQ(getrlimit(RLIMIT_FSIZE, &before), 0);
    const auto oldHandler = std::signal(SIGXFSZ, SIG_IGN);
    rlimit small = before;
    small.rlim_cur = 256 * 1024;
    ASSERT_EQ(setrlimit(RLIMIT_FSIZE, &small), 0);
    Result<void> added;
    int k = 1;
    while (added && k < 20'000)
        added = (*writer)->add(madeUpSample(twoDisks(), k++));
    const auto next = (*writer)->add(TraceNote{1.0, "still full"});
    setrlimit(RLIMIT_FSIZE, &before);
    std::signal(SIGXFSZ, oldHandler);
    ASSERT_FALSE(added);
    EXPECT_EQ(added.error().code(), MessageCode::FileUnwritable) << describe(added.error());
    EXPECT_FALSE(next) << "a failed recording stays failed";
    EXPECT_FALSE((*writer)->finish("stopped"));
    writer->reset();
    const auto record = readSession(file("full.bask"));
    ASSERT_TRUE(record) << describe(record.error());
    EXPECT_GT(record->samples.size(), 5u);
    EXPECT_TRUE(record->interrupted());
}

} // namespace
} // namespace bask
