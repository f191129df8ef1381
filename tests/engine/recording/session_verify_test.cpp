// The hash chain and the seal of sessions: what was changed, removed or added is found and named.

#include "engine/recording/session_verify.h"

#include "engine/base/message_code.h"
#include "engine/recording/recorded_session.h"
#include "engine/recording/row_chain.h"
#include "engine/recording/session_header.h"
#include "tests/engine/recording/recording.h"
#include "tests/support/first_version.h"
#include "tests/support/told_shares.h"

#include <QElapsedTimer>
#include <QFile>
#include <QFileInfo>
#include <QTemporaryDir>

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace bask::test {
namespace {

constexpr int kSamples = 700;

class SessionVerify : public testing::Test {
protected:
    std::string path(const char* name = "run.bask") const {
        return m_folder.filePath(QLatin1String(name)).toStdString();
    }
    /// A run with rows in every table.
    void record(const std::string& to, bool isFinished = true) const {
        Experiment experiment = twoDisks();
        const auto writer =
            SessionWriter::create(to, experiment, true, 0.01, SessionWriter::Earlier::Replaced);
        ASSERT_TRUE(writer) << describe(writer.error());
        for (int k = 0; k < kSamples; ++k) {
            ASSERT_TRUE((*writer)->add(madeUpSample(experiment, k)));
            if (k % 50 == 0) {
                const double now_s = madeUpSample(experiment, k).time_s;
                ASSERT_TRUE((*writer)->add(TraceEvent{now_s, {MessageCode::EventHeld, {}}}));
                ASSERT_TRUE((*writer)->add(TraceNote{now_s, "note \xc3\xa9 " + std::to_string(k)}));
                ASSERT_TRUE((*writer)->add(CommandRow{now_s, "gains", "{\"kp\":1}"}));
                ASSERT_TRUE((*writer)->add(
                    TrafficLine{1, now_s, 0, TrafficKind::Sent, "robot", std::string("a\0b", 3)}, 0.0));
                ASSERT_TRUE((*writer)->flush());
            }
        }
        if (isFinished) {
            ASSERT_TRUE((*writer)->finish("settled"));
        }
    }
    static SessionVerdict verified(const std::string& file) {
        const auto verdict = verifySession(file);
        if (!verdict) {
            ADD_FAILURE() << describe(verdict.error());
            return {};
        }
        for (const SessionFinding& finding : verdict->findings)
            std::printf("%s, %s %s, row %lld to %lld, %s%g s: %d\n", finding.table.c_str(),
                        finding.type.c_str(), finding.name.c_str(), static_cast<long long>(finding.row),
                        static_cast<long long>(finding.lastRow), finding.isAfter ? "after " : "",
                        finding.time_s.value_or(-1.0), static_cast<int>(finding.kind));
        return *verdict;
    }
    /// What somebody with an SQLite tool does.
    static void tamper(const std::string& file, const std::string& sql) {
        const auto store = SessionStore::create(file);
        ASSERT_TRUE(store);
        const auto done = (*store)->execute(sql);
        ASSERT_TRUE(done) << describe(done.error());
    }
    static SessionFinding onlyFinding(const std::string& file) {
        const SessionVerdict verdict = verified(file);
        EXPECT_EQ(verdict.seal, Seal::Broken);
        EXPECT_FALSE(verdict.isIntact());
        EXPECT_EQ(verdict.allFindings, 1);
        return verdict.findings.empty() ? SessionFinding() : verdict.findings.front();
    }

    QTemporaryDir m_folder;
};

TEST_F(SessionVerify, findsWhatWasRecordedIntact) {
    record(path());
    const SessionVerdict verdict = verified(path());
    EXPECT_TRUE(verdict.hasChain);
    EXPECT_EQ(verdict.seal, Seal::Holds);
    EXPECT_TRUE(verdict.isIntact());
    EXPECT_GT(verdict.rows, kSamples + 4 * kSamples / 50);
    EXPECT_EQ(verdict.head.size(), 64U);
    EXPECT_EQ(*chainHead(path()), verdict.head);
}

TEST_F(SessionVerify, tellsHowFarItIs) {
    record(path());
    ToldShares shares;
    ASSERT_TRUE(verifySession(path(), {}, shares.told()));
    shares.expectAWhole(50);
}

// Catches: an altered recording that is exported without a word, and a verdict or a head of the chain that an
// export does not tell.
TEST_F(SessionVerify, exportsTellIt) {
    const auto told = [&](const std::string& session) {
        const QString folder = m_folder.filePath("csv of " + QFileInfo(session.c_str()).baseName());
        EXPECT_TRUE(exportSessionCsv(session, folder.toStdString()));
        QFile table(folder + "/meta.csv"), crate(folder + "/ro-crate-metadata.json");
        EXPECT_TRUE(table.open(QIODevice::ReadOnly) && crate.open(QIODevice::ReadOnly));
        const QByteArray key = "\nverification,", rows = table.readAll();
        const auto at = rows.indexOf(key);
        EXPECT_GE(at, 0) << rows.toStdString();
        const QByteArray word = rows.mid(at + key.size()).split('\n').first().trimmed();
        EXPECT_TRUE(crate.readAll().contains("Verification of the recording: " + word + '.'));
        return word.toStdString();
    };
    const auto withHead = [](const std::string& word, const std::string& session) {
        return word + " (head " + *chainHead(session) + ')';
    };
    record(path());
    EXPECT_EQ(chainHead(path())->size(), 64u);
    EXPECT_EQ(told(path()), withHead("intact", path()));
    record(path("cut.bask"), false);
    EXPECT_EQ(told(path("cut.bask")), withHead("not sealed", path("cut.bask")));
    tamper(path(), "UPDATE step SET measured_K_1 = measured_K_1 + 1 WHERE number = 123");
    EXPECT_EQ(told(path()), withHead("altered", path()));
    tamper(path(), "DROP TABLE chain");
    EXPECT_EQ(told(path()), "altered") << "there is no head";
    EXPECT_EQ(verificationOf(path("none.bask")), "not verified");
}

// Catches: a verdict on rows that nobody waited for, which would tell the others as removed.
TEST_F(SessionVerify, endsWhenItIsAskedTo) {
    record(path());
    std::stop_source stop;
    stop.request_stop();
    const auto verdict = verifyOpenSession(path(), stop.get_token());
    ASSERT_TRUE(verdict);
    EXPECT_EQ(verdict->allFindings, 0);
    EXPECT_TRUE(verifyOpenSession(path())->isIntact());
}

// Catches: one changed byte that is taken for a version to come.
TEST_F(SessionVerify, namesAFormatNumberThatNoVersionHasAsDamage) {
    record(path());
    QFile file(QString::fromStdString(path()));
    ASSERT_TRUE(file.open(QIODevice::ReadWrite));
    constexpr qint64 kVersion = 60; // in the database's header
    ASSERT_TRUE(file.seek(kVersion));
    ASSERT_EQ(file.write("\x01", 1), 1);
    file.close();
    const auto record = readSession(path());
    ASSERT_FALSE(record);
    EXPECT_EQ(record.error().message, (Message{MessageCode::SessionDamaged, {kNoVersion}}));
    const SessionVerdict verdict = verified(path());
    EXPECT_TRUE(verdict.isDamaged);
    EXPECT_GT(verdict.rows, kSamples) << "what is in it can be read";
    EXPECT_STREQ(verificationWord(verdict), "damaged");
}

// Catches: what Bask itself does with a session afterwards taken for tampering.
TEST_F(SessionVerify, staysIntactThroughTagsCopiesAndTheClosingOfAnInterruptedRun) {
    record(path());
    const std::string head = *chainHead(path());
    for (const auto& tags : {std::vector<std::string>{"good"}, std::vector<std::string>{"good", "second"}}) {
        ASSERT_TRUE(writeSessionTags(path(), tags));
        EXPECT_TRUE(verified(path()).isIntact());
        EXPECT_EQ(verified(path()).seal, Seal::Holds);
    }
    ASSERT_TRUE(copySession(path(), path("copy.bask")));
    EXPECT_TRUE(verified(path("copy.bask")).isIntact());
    EXPECT_EQ(verified(path("copy.bask")).seal, Seal::Holds);
    EXPECT_EQ(*chainHead(path("copy.bask")), head);

    record(path("cut.bask"), false);
    EXPECT_TRUE(verified(path("cut.bask")).isIntact());
    ASSERT_TRUE(closeInterrupted(path("cut.bask")));
    const SessionVerdict closed = verified(path("cut.bask"));
    EXPECT_TRUE(closed.isIntact());
    EXPECT_NE(closed.head, "");
}

// Catches: a recording that is called altered between its end and its seal, or because another program kept
// it open.
TEST_F(SessionVerify, isIntactWithoutItsSeal) {
    const Experiment experiment = twoDisks();
    auto writer = SessionWriter::create(path(), experiment, true);
    ASSERT_TRUE(writer);
    ASSERT_TRUE((*writer)->add(madeUpSample(experiment, 0)));
    ASSERT_TRUE((*writer)->finish("settled"));
    ASSERT_TRUE((*writer)->close());
    EXPECT_EQ(verified(path()).seal, Seal::None) << "as after a kill";
    EXPECT_TRUE(verified(path()).isIntact());
    {
        const auto reader = SessionStore::create(path()); // as another program has it, with its log
        ASSERT_TRUE((*reader)->execute("PRAGMA journal_mode = WAL"));
        ASSERT_TRUE((*reader)->select("SELECT count(*) FROM step", [](SessionStore::Row) {}));
        writer->reset();
    }
    EXPECT_NE(verified(path()).seal, Seal::Broken);
    EXPECT_TRUE(verified(path()).isIntact());
    QFile::link(QString::fromStdString(path()), m_folder.filePath("link.bask"));
    EXPECT_TRUE(verified(path("link.bask")).isIntact());
    ASSERT_TRUE(writeSessionTags(path("link.bask"), {"good"}));
    EXPECT_EQ(verified(path()).seal, Seal::Holds);
}

// Catches: tags or a copy by Bask that give a new seal to what was altered before.
TEST_F(SessionVerify, whatWasAlteredIsNotSealedAnew) {
    record(path());
    tamper(path(), "INSERT INTO meta VALUES('tags', '[\"forged\"]')");
    EXPECT_EQ(verified(path()).seal, Seal::Broken);
    ASSERT_TRUE(writeSessionTags(path(), {"mine"}));
    EXPECT_EQ(verified(path()).seal, Seal::Broken);
    ASSERT_TRUE(copySession(path(), path("copy.bask")));
    EXPECT_EQ(verified(path("copy.bask")).seal, Seal::Broken);
}

// Catches: text that the database keeps otherwise than it was given.
TEST_F(SessionVerify, hashesTextAsItIsStored) {
    Experiment experiment = twoDisks();
    experiment.title = "A\xef\xbf\xbf"
                       "B\xef\xbf\xbe"; // U+FFFF, U+FFFE
    {
        const auto writer = SessionWriter::create(path(), experiment, true);
        ASSERT_TRUE(writer);
        for (const char* text : {"\xef\xbb\xbf\xef\xbb\xbftwo marks", "\xef\xbf\xbeswapped", "",
                                 "\xff broken", "a\xf0\x9f\x94\xa5"})
            ASSERT_TRUE((*writer)->add(TraceNote{1.0, text}));
        ASSERT_TRUE((*writer)->add(TraceNote{1.0, std::string("nul\0inside", 10)}));
        ASSERT_TRUE((*writer)->finish("settled"));
    }
    EXPECT_TRUE(verified(path()).isIntact());
}

// Catches: a long cut that is told as thousands of changed samples.
TEST_F(SessionVerify, namesALongCutOnce) {
    record(path());
    tamper(path(), "DELETE FROM step WHERE number BETWEEN 201 AND 500");
    tamper(path(), "DELETE FROM target_step WHERE rowid BETWEEN 2 AND 101");
    const SessionVerdict verdict = verified(path());
    ASSERT_EQ(verdict.allFindings, 2);
    EXPECT_EQ(verdict.findings[0].table, "step");
    EXPECT_EQ(verdict.findings[0].kind, SessionFinding::Kind::Removed);
    EXPECT_EQ(verdict.findings[0].row, 201);
    EXPECT_EQ(verdict.findings[1].table, "target_step");
    EXPECT_EQ(verdict.findings[1].row, 2);
}

// Catches: the head of a report that was made before an interrupted run was closed, called forged.
TEST_F(SessionVerify, knowsTheHeadOfAnEarlierReport) {
    record(path(), false);
    const std::string head = *chainHead(path());
    ASSERT_TRUE(closeInterrupted(path()));
    EXPECT_NE(*chainHead(path()), head);
    const auto verdict = verifySession(path(), head);
    ASSERT_TRUE(verdict);
    EXPECT_TRUE(verdict->isIntact());
    EXPECT_EQ(verdict->expectedLink, verdict->links - 1);
    EXPECT_EQ(verifySession(path(), std::string(64, '0'))->expectedLink, 0);
}

// Catches: a table of other columns that is read beyond its end, and rows by the thousand where there are a
// few.
TEST_F(SessionVerify, readsHostileTables) {
    record(path());
    for (const char* view : {"sample", "object_state", "truth", "pose", "motion", "source", "source_pose"})
        tamper(path(), std::string("DROP VIEW ") + view);
    tamper(path(), "DROP TABLE step");
    tamper(path(), "CREATE TABLE step(number INTEGER PRIMARY KEY)");
    tamper(path(), "INSERT INTO step VALUES(1)");
    const auto verdict = verifySession(path());
    EXPECT_TRUE(!verdict || !verdict->isIntact());
    tamper(path(), "WITH RECURSIVE k(n) AS (SELECT 1 UNION ALL SELECT n + 1 FROM k LIMIT 20000) "
                   "INSERT INTO meta SELECT 'key' || n, 'x' FROM k");
    EXPECT_FALSE(verifySession(path()));
}

TEST_F(SessionVerify, looksAtARunThatIsBeingRecorded) {
    const Experiment experiment = twoDisks();
    const auto writer = SessionWriter::create(path(), experiment, true);
    ASSERT_TRUE(writer);
    for (int k = 0; k < 20; ++k)
        ASSERT_TRUE((*writer)->add(madeUpSample(experiment, k)));
    ASSERT_TRUE((*writer)->flush());
    const SessionVerdict verdict = verified(path());
    EXPECT_TRUE(verdict.isIntact());
    EXPECT_EQ(verdict.seal, Seal::None);
}

TEST_F(SessionVerify, namesWhatWasChanged) {
    record(path());
    const Experiment experiment = twoDisks();
    const auto copied = [&] {
        QFile::remove(QString::fromStdString(path("b.bask")));
        QFile::copy(QString::fromStdString(path()), QString::fromStdString(path("b.bask")));
        return path("b.bask");
    };
    using Kind = SessionFinding::Kind;
    const struct {
        const char* sql;
        const char* table;
        Kind kind;
        std::int64_t row;
        int sample; ///< whose time is named; -1: none
    } kCases[] = {
        {"UPDATE step SET measured_K_1 = measured_K_1 + 1e-9 WHERE number = 301", "step", Kind::Changed, 301,
         300},
        {"DELETE FROM step WHERE number = 301", "step", Kind::Removed, 301, 301},
        {"DELETE FROM note WHERE rowid = 3", "note", Kind::Removed, 3, 150},
        {"INSERT INTO note VALUES(999.0, 'mine', '')", "note", Kind::Added, 15, -2},
        {"UPDATE event SET text = 'nothing' WHERE rowid = 2", "event", Kind::Changed, 2, 50},
        {"UPDATE command SET value = '{}' WHERE rowid = 14", "command", Kind::Changed, 14, 650},
        {"UPDATE traffic SET bytes = x'00' WHERE rowid = 1", "traffic", Kind::Changed, 1, 0},
        {"UPDATE target_step SET target_K = 1 WHERE rowid = 1", "target_step", Kind::Changed, 1, 0},
        {"UPDATE overview SET extremes = x'00'", "overview", Kind::Changed, 1, 511},
        {"UPDATE meta SET value = 'stopped' WHERE key = 'outcome'", "meta", Kind::Changed, 3, -1},
        {"UPDATE object SET name = 'x' WHERE number = 1", "object", Kind::Changed, 1, -1},
        {"UPDATE experiment SET json = replace(json, '1', '2')", "experiment", Kind::Changed, 1, -1},
    };
    for (const auto& each : kCases) {
        SCOPED_TRACE(each.sql);
        const std::string file = copied();
        tamper(file, each.sql);
        const SessionFinding finding = onlyFinding(file);
        EXPECT_EQ(finding.table, each.table);
        EXPECT_EQ(finding.kind, each.kind);
        EXPECT_EQ(finding.row, each.row);
        EXPECT_EQ(finding.time_s.has_value(), each.sample != -1);
        if (each.sample >= 0) {
            EXPECT_EQ(finding.time_s, madeUpSample(experiment, each.sample).time_s);
        }
    }
}

// Catches: many rows at once told as thousands, or one that hides another.
TEST_F(SessionVerify, namesEveryOneOfSeveral) {
    record(path());
    tamper(path(), "DELETE FROM step WHERE number BETWEEN 101 AND 110");
    tamper(path(), "UPDATE step SET source_K = 300 WHERE number IN (50, 600)");
    const SessionVerdict verdict = verified(path());
    ASSERT_EQ(verdict.allFindings, 3);
    EXPECT_EQ(verdict.findings[0].row, 50);
    EXPECT_EQ(verdict.findings[1].kind, SessionFinding::Kind::Removed);
    EXPECT_EQ(verdict.findings[1].row, 101);
    EXPECT_EQ(verdict.findings[2].kind, SessionFinding::Kind::Changed);
}

// Catches: a forger who also changes the row's check.
TEST_F(SessionVerify, findsAChainThatWasForgedInOneLink) {
    record(path());
    const std::string head = *chainHead(path());
    tamper(path(), "UPDATE note SET text = 'forged' WHERE rowid = 5");
    std::string checks;
    std::int64_t number = 0;
    {
        const auto store = SessionStore::open(path());
        std::vector<std::uint32_t> notes;
        ASSERT_TRUE((*store)->select(selectRows(ChainTable::Note), [&](SessionStore::Row row) {
            notes.push_back(checkOf(digestOf(ChainTable::Note, row)));
        }));
        std::size_t note = 0;
        ASSERT_TRUE((*store)->select(kSelectLinks, [&](SessionStore::Row row) {
            ChainLink link = *linkOf(row);
            for (ChainLink::Entry& entry : link.rows)
                if (entry.table == ChainTable::Note && ++note == 5) {
                    entry.check = notes[4];
                    number = link.number;
                    checks = std::get<SqlBlob>(rowOf(link)[1]).bytes;
                }
        }));
    }
    tamper(path(), "UPDATE chain SET row_checks = x'" +
                       QByteArray::fromStdString(checks).toHex().toStdString() +
                       "' WHERE number = " + std::to_string(number));
    const SessionFinding finding = onlyFinding(path());
    EXPECT_EQ(finding.table, "chain");
    EXPECT_EQ(finding.row, number);
    EXPECT_EQ(*chainHead(path()), head);
}

// A byte anywhere: in rows, in pages' heads, in what is unused.
TEST_F(SessionVerify, findsOneByteChangedAnywhere) {
    record(path());
    QFile file(QString::fromStdString(path()));
    ASSERT_TRUE(file.open(QIODevice::ReadOnly));
    const QByteArray whole = file.readAll();
    file.close();
    std::mt19937 random(29);
    int named = 0;
    for (int k = 0; k < 1000; ++k) {
        QByteArray changed = whole;
        const auto at = static_cast<qsizetype>(random() % static_cast<unsigned>(whole.size()));
        changed[at] = static_cast<char>(changed[at] ^ (1 << random() % 8));
        const QString to = m_folder.filePath(QStringLiteral("flipped.bask"));
        QFile out(to);
        ASSERT_TRUE(out.open(QIODevice::WriteOnly));
        out.write(changed);
        out.close();
        const auto verdict = verifySession(to.toStdString());
        EXPECT_FALSE(verdict && verdict->isIntact()) << "byte " << at;
        named += verdict && (verdict->allFindings > 0 || !verdict->damages.empty());
    }
    std::printf("%d of 1000 are named by row or table\n", named);
    EXPECT_GT(named, 500) << "most bytes are in rows";
}

// Catches: a file that is cut short told in the database's words, or nothing of it looked at.
TEST_F(SessionVerify, saysWhatOfACutFileCanBeRead) {
    record(path());
    QFile file(QString::fromStdString(path()));
    ASSERT_TRUE(file.resize(file.size() / 4 * 3));
    const SessionVerdict verdict = verified(path());
    EXPECT_TRUE(verdict.isDamaged);
    EXPECT_FALSE(verdict.isIntact());
    const auto step = std::ranges::find(verdict.damages, "step", &TableDamage::table);
    ASSERT_NE(step, verdict.damages.end());
    EXPECT_GT(step->rows, 0);
    EXPECT_LT(step->rows, kSamples);
    EXPECT_EQ(step->time_s, madeUpSample(twoDisks(), static_cast<int>(step->rows) - 1).time_s);
    EXPECT_FALSE(readSession(path())) << "nobody else takes it for whole";
}

// Catches: damage in one table that hides what of the others can be read, or that they are as recorded.
TEST_F(SessionVerify, namesTheTableThatWasWrittenOver) {
    record(path());
    QFile file(QString::fromStdString(path()));
    ASSERT_TRUE(file.open(QIODevice::ReadWrite));
    const QByteArray whole = file.readAll();
    constexpr qsizetype kPage = 16384; // as SessionWriter has it
    const qsizetype note = whole.indexOf("note \xc3\xa9 350");
    ASSERT_GT(note, kPage);
    ASSERT_TRUE(file.seek(note / kPage * kPage));
    ASSERT_EQ(file.write(QByteArray(kPage, '\x55')), kPage);
    file.close();
    const SessionVerdict verdict = verified(path());
    EXPECT_TRUE(verdict.isDamaged);
    ASSERT_EQ(verdict.damages.size(), 1U);
    EXPECT_EQ(verdict.damages[0].table, "note");
    EXPECT_EQ(verdict.damages[0].rows, 0) << "they were on that page";
    EXPECT_FALSE(verdict.damages[0].time_s);
    EXPECT_EQ(verdict.allFindings, 0);
    const auto checked = checkSession(path());
    ASSERT_FALSE(checked);
    EXPECT_EQ(describe(checked.error()), path() + ": the session file is damaged: its database is not whole");
}

// Catches: tables that damage of their list has taken away told as readable, or as removed by somebody.
TEST_F(SessionVerify, namesTablesThatAreMissingInADamagedList) {
    record(path());
    QFile file(QString::fromStdString(path()));
    ASSERT_TRUE(file.open(QIODevice::ReadWrite));
    const QByteArray whole = file.readAll();
    constexpr qsizetype kPage = 16384; // as SessionWriter has it; the list is on the first
    const auto overwrite = [&](qsizetype from, qsizetype to) {
        ASSERT_TRUE(file.seek(0));
        ASSERT_EQ(file.write(whole), whole.size());
        ASSERT_TRUE(file.seek(from));
        ASSERT_EQ(file.write(QByteArray(to - from, '\x55')), to - from);
        ASSERT_TRUE(file.flush());
    };
    const auto isNamed = [](const SessionVerdict& verdict, const char* table) {
        return std::ranges::find(verdict.damages, table, &TableDamage::table) != verdict.damages.end();
    };
    constexpr qsizetype kHeaders = 200; // of the file and the page, with the places of the rows
    overwrite(kHeaders, kPage);
    const SessionVerdict none = verified(path());
    EXPECT_TRUE(none.isDamaged);
    EXPECT_EQ(none.allFindings, 0);
    for (const char* table :
         {"sqlite_master", "meta", "experiment", "object", "step", "event", "note", "chain"})
        EXPECT_TRUE(isNamed(none, table)) << table;

    // Rows of the list are written from the page's end: what was made after `command` is gone.
    const qsizetype event = whole.indexOf("CREATE TABLE event"),
                    command = whole.indexOf("CREATE TABLE command");
    ASSERT_GT(event, kHeaders);
    ASSERT_LT(event, command);
    ASSERT_LT(command, kPage);
    overwrite(kHeaders, event + 40);
    const SessionVerdict some = verified(path());
    EXPECT_TRUE(some.isDamaged);
    EXPECT_EQ(some.allFindings, 0) << "nothing was removed";
    for (const char* table : {"sqlite_master", "note", "target_step", "overview", "chain"})
        EXPECT_TRUE(isNamed(some, table)) << table;
    for (const char* table : {"meta", "experiment", "object", "step", "command"})
        EXPECT_FALSE(isNamed(some, table)) << table;
    EXPECT_GT(some.rows, kSamples);

    // The place of the row of `note` says that of `event`, the row before: the chain knows that there were
    // notes.
    constexpr qsizetype kPlaces = 108;
    const auto placeAt = [&](qsizetype at) {
        return static_cast<unsigned char>(whole[at]) * 256 + static_cast<unsigned char>(whole[at + 1]);
    };
    qsizetype at = kPlaces;
    while (at < kHeaders && placeAt(at) > event)
        at += 2;
    ASSERT_LT(event - placeAt(at), 40) << "the row begins a few bytes before its words";
    ASSERT_TRUE(file.seek(0));
    ASSERT_EQ(file.write(whole), whole.size());
    ASSERT_TRUE(file.seek(at + 2));
    ASSERT_EQ(file.write(whole.mid(at, 2)), 2);
    file.close();
    const SessionVerdict one = verified(path());
    EXPECT_TRUE(one.isDamaged);
    EXPECT_EQ(one.allFindings, 0);
    EXPECT_EQ(one.damages.size(), 2U);
    EXPECT_TRUE(isNamed(one, "sqlite_master"));
    EXPECT_TRUE(isNamed(one, "note"));
}

TEST_F(SessionVerify, saysThatAnOlderSessionHasNoChain) {
    record(path());
    for (const char* later :
         {"DROP TABLE chain", "DROP TABLE seal", "ALTER TABLE command DROP COLUMN operator",
          "ALTER TABLE note DROP COLUMN operator"})
        tamper(path(), later);
    const SessionVerdict verdict = verified(path());
    EXPECT_FALSE(verdict.hasChain);
    EXPECT_FALSE(verdict.isIntact());
    EXPECT_EQ(*chainHead(path()), "");
    EXPECT_TRUE(readSession(path()));
}

// Catches: what somebody has taken out of a session told as that of an older Bask, or as whole.
TEST_F(SessionVerify, seesThatChainAndSealWereRemoved) {
    record(path());
    const auto altered = [&](std::initializer_list<const char*> statements) {
        QFile::remove(QString::fromStdString(path("b.bask")));
        EXPECT_TRUE(QFile::copy(QString::fromStdString(path()), QString::fromStdString(path("b.bask"))));
        for (const char* sql : statements)
            tamper(path("b.bask"), sql);
        return verified(path("b.bask"));
    };
    for (const auto& removed :
         {altered({"DROP TABLE chain"}), altered({"DROP TABLE chain", "DROP TABLE seal"})}) {
        EXPECT_STREQ(verificationWord(removed), "altered");
        ASSERT_EQ(removed.allFindings, 1);
        EXPECT_EQ(removed.findings[0].kind, SessionFinding::Kind::Removed);
        EXPECT_EQ(removed.findings[0].type + removed.findings[0].name, "tablechain");
        EXPECT_GT(removed.rows, kSamples) << "they are counted";
    }
    for (const auto& removed :
         {altered({"DELETE FROM seal", "INSERT INTO meta VALUES('tags', '[\"forged\"]')"}),
          altered({"DROP TABLE seal"})}) {
        EXPECT_STREQ(verificationWord(removed), "altered");
        EXPECT_EQ(removed.seal, Seal::Removed);
        EXPECT_EQ(removed.allFindings, 0);
    }
    altered({"DELETE FROM seal"});
    ASSERT_TRUE(writeSessionTags(path("b.bask"), {"mine"}));
    EXPECT_EQ(verified(path("b.bask")).seal, Seal::Removed) << "it is not sealed anew";
    ASSERT_TRUE(copySession(path("b.bask"), path("copy.bask")));
    EXPECT_FALSE(verified(path("copy.bask")).isIntact());

    record(path("cut.bask"), false);
    EXPECT_TRUE(verified(path("cut.bask")).isIntact()) << "it has none yet";
    tamper(path("cut.bask"), "DROP TABLE seal");
    EXPECT_FALSE(verified(path("cut.bask")).isIntact());
}

// Catches: rows that are as recorded blamed for a change of the chain beside them.
TEST_F(SessionVerify, blamesTheChainForAChangeOfTheChain) {
    record(path());
    const std::int64_t links = verified(path()).links;
    const auto altered = [&](const std::string& sql) {
        QFile::remove(QString::fromStdString(path("b.bask")));
        EXPECT_TRUE(QFile::copy(QString::fromStdString(path()), QString::fromStdString(path("b.bask"))));
        tamper(path("b.bask"), sql);
        SCOPED_TRACE(sql);
        SessionFinding finding = onlyFinding(path("b.bask"));
        EXPECT_EQ(finding.table, "chain");
        return finding;
    };
    const auto bytes = [](const char* column, int from, int length, const char* hex, std::int64_t link) {
        const std::string name = column, at = std::to_string(from + 1);
        return "UPDATE chain SET " + name + " = CAST(substr(" + name + ", 1, " + std::to_string(from) +
               ") || x'" + hex + "' || substr(" + name + ", " + std::to_string(from + 1 + length) +
               ") AS BLOB) WHERE number = " + std::to_string(link);
    };
    constexpr int kEntry = 5;
    for (const std::int64_t link : {std::int64_t{1}, std::int64_t{4}, links}) {
        EXPECT_EQ(altered(bytes("row_checks", 1, 1, "5b", link)).row, link) << "a check";
        EXPECT_EQ(altered(bytes("row_checks", kEntry, 1, "0a", link)).row, link) << "the number of a table";
        EXPECT_EQ(altered(bytes("row_checks", 0, 1, "4d", link)).row, link) << "the number of no table";
        EXPECT_EQ(altered(bytes("hash", 7, 1, "5b", link)).row, link);
        EXPECT_EQ(altered(bytes("row_checks", 0, 1, "", link)).row, link) << "no checks";
        EXPECT_EQ(altered("UPDATE chain SET hash = 'x' WHERE number = " + std::to_string(link)).row, link);
        const SessionFinding removed = altered("DELETE FROM chain WHERE number = " + std::to_string(link));
        EXPECT_EQ(removed.kind, SessionFinding::Kind::Removed);
        EXPECT_EQ(removed.row, link);
    }
    EXPECT_GT(altered(bytes("hash", 7, 1, "5b", 4)).time_s.value_or(NAN), 0.0);
    const SessionFinding several = altered("DELETE FROM chain WHERE number BETWEEN 3 AND 6");
    EXPECT_EQ(several.row, 3);
    EXPECT_EQ(several.lastRow, 6);
    EXPECT_EQ(altered("DELETE FROM chain WHERE number > 8").row, 9);
    EXPECT_EQ(altered("DELETE FROM chain").row, 1);
}

// Catches: a lost link that hides a change of a row of another.
TEST_F(SessionVerify, namesRowsBesideALostLink) {
    record(path());
    tamper(path(), "DELETE FROM chain WHERE number = 3");
    tamper(path(), "UPDATE step SET measured_K_1 = 301 WHERE number = 600");
    const SessionVerdict verdict = verified(path());
    ASSERT_EQ(verdict.allFindings, 2);
    EXPECT_EQ(verdict.findings[0].table, "chain");
    EXPECT_EQ(verdict.findings[1].table, "step");
    EXPECT_EQ(verdict.findings[1].row, 600);
}

// Catches: a table, a view or a fact that was removed, added or changed, and is told without its name.
TEST_F(SessionVerify, namesTablesViewsAndFacts) {
    record(path());
    using Kind = SessionFinding::Kind;
    const struct {
        const char* sql;
        const char* table;
        Kind kind;
        const char* type;
        const char* name;
    } kCases[] = {
        {"DROP VIEW sample", "sqlite_master", Kind::Removed, "view", "sample"},
        {"DROP TABLE object", "sqlite_master", Kind::Removed, "table", "object"},
        {"DROP TABLE note", "sqlite_master", Kind::Removed, "table", "note"},
        {"DROP TABLE traffic", "sqlite_master", Kind::Removed, "table", "traffic"},
        {"DROP TABLE meta", "sqlite_master", Kind::Removed, "table", "meta"},
        {"CREATE TABLE mine(x)", "sqlite_master", Kind::Added, "table", "mine"},
        {"CREATE VIEW mine AS SELECT 1", "sqlite_master", Kind::Added, "view", "mine"},
        {"CREATE INDEX mine ON note(text)", "sqlite_master", Kind::Added, "index", "mine"},
        {"CREATE TRIGGER mine AFTER INSERT ON note BEGIN DELETE FROM note; END", "sqlite_master", Kind::Added,
         "trigger", "mine"},
        {"ALTER TABLE step ADD COLUMN mine REAL", "sqlite_master", Kind::Changed, "table", "step"},
        {"ALTER TABLE note ADD COLUMN mine REAL DEFAULT 7", "sqlite_master", Kind::Changed, "table", "note"},
        {"DELETE FROM meta WHERE key = 'software'", "meta", Kind::Removed, "key", "software"},
        {"DELETE FROM meta WHERE key = 'finished'", "meta", Kind::Removed, "key", "finished"},
        {"INSERT INTO meta VALUES('mine', 'x')", "meta", Kind::Added, "key", "mine"},
        {"INSERT INTO meta VALUES('operator', 'me')", "meta", Kind::Added, "key", "operator"},
        {"UPDATE meta SET value = 'false' WHERE key = 'simulated'", "meta", Kind::Changed, "key",
         "simulated"},
        {"PRAGMA user_version = 1", "header", Kind::Changed, "number", "user_version"},
        {"PRAGMA user_version = 3", "header", Kind::Changed, "number", "user_version"},
        {"PRAGMA application_id = 7", "header", Kind::Changed, "number", "application_id"},
    };
    for (const auto& each : kCases) {
        SCOPED_TRACE(each.sql);
        QFile::remove(QString::fromStdString(path("b.bask")));
        ASSERT_TRUE(QFile::copy(QString::fromStdString(path()), QString::fromStdString(path("b.bask"))));
        tamper(path("b.bask"), each.sql);
        const SessionVerdict verdict = verified(path("b.bask"));
        EXPECT_STREQ(verificationWord(verdict), "altered");
        // Rows of a table that is gone are told besides.
        EXPECT_LE(verdict.allFindings, each.kind == Kind::Removed ? 2 : 1);
        const auto found = std::ranges::find(verdict.findings, each.name, &SessionFinding::name);
        ASSERT_NE(found, verdict.findings.end());
        EXPECT_EQ(found->table, each.table);
        EXPECT_EQ(found->kind, each.kind);
        EXPECT_EQ(found->type, each.type);
    }
}

// Catches: a version to come called altered.
TEST_F(SessionVerify, aVersionToComeIsRefused) {
    record(path());
    tamper(path(), "PRAGMA user_version = 3");
    tamper(path(), "UPDATE meta SET value = 'Bask 99.0.0' WHERE key = 'software'");
    const auto verdict = verifySession(path());
    ASSERT_FALSE(verdict);
    EXPECT_EQ(verdict.error().code(), MessageCode::VersionTooNew);
}

// Catches: rows at a table's end removed without a word of when, or told one by one.
TEST_F(SessionVerify, tellsACutAtTheEndOnceAndWhen) {
    record(path());
    const Experiment experiment = twoDisks();
    const struct {
        const char* sql;
        const char* table;
        std::int64_t row, lastRow;
        int sampleBefore;
    } kCases[] = {
        {"DELETE FROM note WHERE rowid > 10", "note", 11, 14, 450},
        {"DELETE FROM event WHERE rowid > 13", "event", 14, 0, 600},
        {"DELETE FROM step WHERE number > 600", "step", 601, kSamples, 599},
        {"DELETE FROM command", "command", 1, 14, 0},
    };
    for (const auto& each : kCases) {
        SCOPED_TRACE(each.sql);
        QFile::remove(QString::fromStdString(path("b.bask")));
        ASSERT_TRUE(QFile::copy(QString::fromStdString(path()), QString::fromStdString(path("b.bask"))));
        tamper(path("b.bask"), each.sql);
        const SessionFinding finding = onlyFinding(path("b.bask"));
        EXPECT_EQ(finding.table, each.table);
        EXPECT_EQ(finding.kind, SessionFinding::Kind::Removed);
        EXPECT_EQ(finding.row, each.row);
        EXPECT_EQ(finding.lastRow, each.lastRow);
        EXPECT_TRUE(finding.isAfter);
        EXPECT_EQ(finding.time_s, madeUpSample(experiment, each.sampleBefore).time_s);
    }
}

// Catches: two rows that changed places told as others.
TEST_F(SessionVerify, namesRowsThatChangedPlaces) {
    record(path());
    for (const char* sql :
         {"UPDATE note SET rowid = -4 WHERE rowid = 4", "UPDATE note SET rowid = 4 WHERE rowid = 9",
          "UPDATE note SET rowid = 9 WHERE rowid = -4"})
        tamper(path(), sql);
    const SessionVerdict verdict = verified(path());
    ASSERT_EQ(verdict.allFindings, 2);
    for (const auto& [finding, row] :
         {std::pair(verdict.findings[0], 4), std::pair(verdict.findings[1], 9)}) {
        EXPECT_EQ(finding.table, "note");
        EXPECT_EQ(finding.kind, SessionFinding::Kind::Changed);
        EXPECT_EQ(finding.row, row);
    }
}

// Catches: values that no run has, read as if they were.
TEST_F(SessionVerify, whatNoRunRecordsIsNotOpened) {
    record(path());
    const std::string file = path("b.bask");
    for (const char* sql :
         {"UPDATE step SET measured_K_1 = 'hot' WHERE number = 5",
          "UPDATE step SET measured_K_1 = -400 WHERE number = 5",
          "UPDATE step SET qw = 0, qx = 0, qy = 0, qz = 0 WHERE number = 5", "UPDATE step SET time_s = 0",
          "UPDATE step SET time_s = 'now' WHERE number = 5",
          "UPDATE step SET source_K = 9e999 WHERE number = 5", "UPDATE step SET x_m = NULL WHERE number = 5",
          "UPDATE step SET y_m = 9e999 WHERE number = 5", "UPDATE step SET source_qw = NULL WHERE number = 5",
          "UPDATE object SET name = 'other' WHERE number = 2", "DELETE FROM object WHERE number = 2",
          "INSERT INTO object VALUES(3, 'third')", "UPDATE event SET time_s = 'now'",
          "UPDATE command SET time_s = 9e999", "UPDATE note SET time_s = x'00' WHERE rowid = 2",
          "DROP VIEW sample; CREATE VIEW sample AS SELECT time_s FROM step CROSS JOIN step"}) {
        QFile::remove(QString::fromStdString(file));
        ASSERT_TRUE(QFile::copy(QString::fromStdString(path()), QString::fromStdString(file)));
        for (const QString& each : QString::fromLatin1(sql).split(QStringLiteral("; ")))
            tamper(file, each.toStdString());
        const auto read = readSession(file);
        EXPECT_FALSE(read) << sql;
        if (!read) {
            EXPECT_EQ(read.error().code(), MessageCode::SessionDamaged) << sql;
        }
        EXPECT_FALSE(RecordedSession::open(file)) << "Review: " << sql;
    }
    for (const char* sql : {"object = 3", "object = 'circle'", "time_s = -9e999", "target_K = -5",
                            "target_K = 9e999", "target_K = 'warm'"}) { // Review alone reads this table
        QFile::remove(QString::fromStdString(file));
        ASSERT_TRUE(QFile::copy(QString::fromStdString(path()), QString::fromStdString(file)));
        tamper(file, std::string("UPDATE target_step SET ") + sql);
        EXPECT_FALSE(RecordedSession::open(file)) << sql;
    }
}

// Catches: the same in a file of version 1.
TEST_F(SessionVerify, whatNoRunRecordsIsNotOpenedInAFileOfVersion1) {
    record(path());
    ASSERT_TRUE(makeFirstVersion(path()));
    ASSERT_TRUE(readSession(path()));
    const std::string file = path("b.bask");
    for (const char* sql :
         {"UPDATE sample SET measured_K = 'hot' WHERE rowid = 5",
          "UPDATE sample SET measured_K = -400 WHERE rowid = 5",
          "UPDATE sample SET target_K = 9e999 WHERE rowid = 5",
          "UPDATE source SET temperature_K = -1 WHERE rowid = 5",
          "UPDATE motion SET vx_m_s = x'00' WHERE rowid = 5",
          "UPDATE pose SET qw = 0, qx = 0, qy = 0, qz = 0 WHERE rowid = 5",
          "UPDATE source_pose SET qw = 0, qx = 0, qy = 0, qz = 0 WHERE rowid = 5",
          "UPDATE pose SET z_m = NULL WHERE rowid = 5",
          // NOLINTNEXTLINE(bugprone-suspicious-missing-comma): one text
          "UPDATE pose SET time_s = 0; UPDATE sample SET time_s = 0; UPDATE object_state SET time_s = 0; "
          "UPDATE truth SET time_s = 0; UPDATE motion SET time_s = 0; UPDATE source SET time_s = 0; "
          "UPDATE source_pose SET time_s = 0"}) {
        QFile::remove(QString::fromStdString(file));
        ASSERT_TRUE(QFile::copy(QString::fromStdString(path()), QString::fromStdString(file)));
        for (const QString& each : QString::fromLatin1(sql).split(QStringLiteral("; ")))
            tamper(file, each.toStdString());
        const auto read = readSession(file);
        ASSERT_FALSE(read) << sql;
        EXPECT_EQ(read.error().code(), MessageCode::SessionDamaged) << sql;
        EXPECT_FALSE(RecordedSession::open(file)) << sql;
    }
}

// A day at 10 Hz with two objects is looked at in 20 s. The long form, `ctest -L soak`.
TEST_F(SessionVerify, aDayIsVerifiedInTwentySeconds) {
    const Experiment experiment = twoDisks();
    {
        const auto writer = SessionWriter::create(path(), experiment, true);
        ASSERT_TRUE(writer);
        TraceSample sample = madeUpSample(experiment, 1);
        for (int k = 0; k < 864'000; ++k) {
            sample.time_s = 0.1 * k;
            ASSERT_TRUE((*writer)->add(sample));
        }
        ASSERT_TRUE((*writer)->finish("settled"));
    }
    QElapsedTimer timer;
    timer.start();
    const SessionVerdict verdict = verified(path());
    std::printf("%lld MB verified in %.1f s\n",
                static_cast<long long>(QFileInfo(QString::fromStdString(path())).size() / 1'000'000),
                1e-3 * static_cast<double>(timer.elapsed()));
    EXPECT_TRUE(verdict.isIntact());
    EXPECT_LT(timer.elapsed(), 20'000);
}

} // namespace
} // namespace bask::test
