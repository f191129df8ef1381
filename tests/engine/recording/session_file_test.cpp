#include "engine/base/message_code.h"
#include "engine/base/version.h"
#include "engine/recording/recorded_session.h"
#include "engine/recording/session_file.h"
#include "engine/recording/session_header.h"
#include "engine/recording/session_store.h"
#include "tests/engine/recording/recording.h"
#include "tests/support/first_version.h"
#include "tests/support/told_shares.h"

#include <gtest/gtest.h>

#include <QCoreApplication>
#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QProcess>
#include <QSqlDatabase>
#include <QSqlError>
#include <QSqlQuery>
#include <QTemporaryDir>
#include <QThread>

#include <atomic>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <ctime>
#include <fstream>
#include <map>
#include <sstream>

namespace bask {
namespace {

using test::madeUpSample;
using test::sameSample;
using test::twoDisks;

class SessionFile : public ::testing::Test {
protected:
    std::string file(const char* name) const { return m_folder.filePath(name).toStdString(); }
    QString qfile(const char* name) const { return m_folder.filePath(name); }

    /// A finished session of `count` samples.
    std::string recorded(const char* name, int count) const {
        const std::string path = file(name);
        auto writer = SessionWriter::create(path, twoDisks(), true, 0.5, SessionWriter::Earlier::Replaced);
        if (!writer) {
            ADD_FAILURE() << describe(writer.error());
            return path;
        }
        for (int k = 0; k < count; ++k)
            EXPECT_TRUE((*writer)->add(madeUpSample(twoDisks(), k)));
        EXPECT_TRUE((*writer)->finish("settled"));
        return path;
    }

    QTemporaryDir m_folder;
};

std::string contents(const QString& path) {
    std::ifstream in(path.toStdString(), std::ios::binary);
    std::ostringstream out;
    out << in.rdbuf();
    return out.str();
}

TEST_F(SessionFile, GivesBackWhatWasRecorded) {
    const std::string path = file("run.bask");
    const Experiment experiment = twoDisks();
    {
        auto writer = SessionWriter::create(path, experiment, true);
        ASSERT_TRUE(writer) << describe(writer.error());
        for (int k = 0; k < 50; ++k)
            ASSERT_TRUE((*writer)->add(madeUpSample(experiment, k)));
        ASSERT_TRUE(
            (*writer)->add(TraceEvent{3.5, {MessageCode::ReasonInternalFault, {"a \"b\", \xC3\xA9"}}}));
        ASSERT_TRUE((*writer)->add(TraceEvent{4.5, {MessageCode::EventHeld, {}}}));
        ASSERT_TRUE((*writer)->add(TraceNote{5.25, "plate moved, \"slightly\"\nsecond line"}));
        ASSERT_TRUE((*writer)->add(CommandRow{6.5, "targets", "[313.15,320]"}));
        ASSERT_TRUE((*writer)->finish("not-settled"));
        EXPECT_EQ((*writer)->rows(), 50u);
        EXPECT_EQ((*writer)->path(), path);
    }
    const auto record = readSession(path);
    ASSERT_TRUE(record) << describe(record.error());
    EXPECT_TRUE(record->experiment == experiment);
    EXPECT_TRUE(record->simulated);
    EXPECT_EQ(record->outcome, "not-settled");
    EXPECT_FALSE(record->interrupted());
    EXPECT_EQ(record->software, "Bask " BASK_VERSION);
    EXPECT_EQ(record->created.size(), std::string("2026-01-01T00:00:00Z").size());
    ASSERT_EQ(record->samples.size(), 50u);
    for (int k = 0; k < 50; ++k)
        EXPECT_TRUE(sameSample(record->samples[static_cast<std::size_t>(k)], madeUpSample(experiment, k)))
            << k;
    ASSERT_EQ(record->events.size(), 2u);
    EXPECT_EQ(record->events[0].time_s, 3.5);
    EXPECT_EQ(record->events[0].message, (Message{MessageCode::ReasonInternalFault, {"a \"b\", \xC3\xA9"}}));
    ASSERT_EQ(record->notes.size(), 1u);
    EXPECT_EQ(record->notes[0].text, "plate moved, \"slightly\"\nsecond line");
    ASSERT_EQ(record->commands.size(), 1u);
    EXPECT_EQ(record->commands[0].value, "[313.15,320]");
    EXPECT_EQ(QDir(m_folder.path()).entryList(QDir::Files), QStringList{"run.bask"})
        << "nothing is left beside it";
}

// Catches names that are lost, files that do not name operators refused, and an export over that of such a
// file.
TEST_F(SessionFile, NamesOperatorSampleAndBatch) {
    const std::string path = file("run.bask");
    const RunLabels labels{"A. Hu", "plate 7", "B3"};
    {
        auto writer =
            SessionWriter::create(path, twoDisks(), true, 0.5, SessionWriter::Earlier::Replaced, labels);
        ASSERT_TRUE(writer) << describe(writer.error());
        ASSERT_TRUE((*writer)->add(madeUpSample(twoDisks(), 0)));
        ASSERT_TRUE((*writer)->add(TraceNote{0.1, "hello", "A. Hu"}));
        ASSERT_TRUE((*writer)->add(CommandRow{0.2, "hold", "", "B. Li"}));
        ASSERT_TRUE((*writer)->finish("stopped"));
    }
    const auto record = readSession(path);
    ASSERT_TRUE(record) << describe(record.error());
    EXPECT_EQ(record->labels, labels);
    EXPECT_EQ(readSessionHeader(path).labels, labels);
    EXPECT_EQ(record->notes[0].operatorName, "A. Hu");
    EXPECT_EQ(record->commands[0].operatorName, "B. Li");
    ASSERT_TRUE(exportSessionCsv(path, file("new")));

    auto store = SessionStore::create(path);
    ASSERT_TRUE(store);
    for (const char* sql :
         {"ALTER TABLE note DROP COLUMN operator", "ALTER TABLE command DROP COLUMN operator"})
        ASSERT_TRUE((*store)->execute(sql)) << sql;
    store->reset();
    const auto earlier = readSession(path);
    ASSERT_TRUE(earlier) << describe(earlier.error());
    EXPECT_EQ(earlier->notes[0].text, "hello");
    EXPECT_EQ(earlier->notes[0].operatorName, "");
    EXPECT_EQ(earlier->commands[0].name, "hold");
    EXPECT_TRUE(exportSessionCsv(path, file("new"))) << "over one that names them";
    ASSERT_TRUE(exportSessionCsv(recorded("next.bask", 3), file("new"))) << "and back";
}

// Catches a share that stands still while a long session is read or written, or that does not end.
TEST_F(SessionFile, ReadingAndExportTellHowFarTheyAre) {
    const std::string path = recorded("run.bask", 700);
    test::ToldShares whole, samples, tables;
    ASSERT_TRUE(readSession(path, whole.told()));
    whole.expectAWhole(50);
    ASSERT_TRUE(readSamples(
        path, [](const TraceSample&) {}, {}, samples.told()));
    samples.expectAWhole(50);
    ASSERT_TRUE(exportSessionCsv(path, file("csv"), tables.told()));
    tables.expectAWhole(120);
}

// Catches files of version 1 refused, or read as something else.
TEST_F(SessionFile, VersionOneReadsTheSame) {
    const std::string path = recorded("first.bask", 40);
    ASSERT_TRUE(test::makeFirstVersion(path));
    const auto record = readSession(path);
    ASSERT_TRUE(record) << describe(record.error());
    EXPECT_EQ(record->outcome, "settled");
    ASSERT_EQ(record->samples.size(), 40u);
    for (int k = 0; k < 40; ++k)
        EXPECT_TRUE(sameSample(record->samples[static_cast<std::size_t>(k)],
                               test::asVersionOne(madeUpSample(twoDisks(), k))))
            << k;
    EXPECT_EQ(exportSessionCsv(path, file("csv"))->size(), 15u) << "with the crate and columns.csv";
}

// Catches a source that lies still stored again and again, or not found again.
TEST_F(SessionFile, ASourceAsInTheExperimentIsStoredOnce) {
    const std::string path = file("still.bask");
    Experiment experiment = twoDisks();
    experiment.source.pose << 0.03, -0.01, 0.002, 0.1, 0.2, 0.3;
    {
        auto writer = SessionWriter::create(path, experiment, true);
        ASSERT_TRUE(writer) << describe(writer.error());
        for (int k = 0; k < 6; ++k) {
            TraceSample sample = madeUpSample(experiment, k);
            if (k % 2 == 0)
                sample.source = experiment.source.pose;
            ASSERT_TRUE((*writer)->add(sample));
        }
    }
    const auto record = readSession(path);
    ASSERT_TRUE(record) << describe(record.error());
    EXPECT_EQ(record->samples[4].source, experiment.source.pose);
    EXPECT_TRUE(sameSample(record->samples[3], madeUpSample(experiment, 3)));
    const auto store = SessionStore::open(path);
    std::vector<double> x_m;
    int stored = 0;
    ASSERT_TRUE((*store)->select("SELECT x_m FROM source_pose",
                                 [&](SessionStore::Row row) { x_m.push_back(numberOf(row[0])); }));
    ASSERT_TRUE((*store)->select("SELECT 1 FROM step WHERE source_x_m IS NOT NULL",
                                 [&](SessionStore::Row) { ++stored; }));
    EXPECT_EQ(x_m[2], 0.03);
    EXPECT_EQ(stored, 3);
}

TEST_F(SessionFile, ARealRigHasNoTruth) {
    const std::string path = file("real.bask");
    {
        auto writer = SessionWriter::create(path, twoDisks(), false);
        ASSERT_TRUE((*writer)->add(madeUpSample(twoDisks(), 1)));
    }
    const auto record = readSession(path);
    ASSERT_TRUE(record) << describe(record.error());
    EXPECT_FALSE(record->simulated);
    EXPECT_TRUE(record->interrupted());
    EXPECT_TRUE(std::isnan(record->samples.at(0).objects.at(0).true_K));
}

TEST_F(SessionFile, AnEmptyRunIsReadToo) {
    const auto record = readSession(recorded("none.bask", 0));
    ASSERT_TRUE(record) << describe(record.error());
    EXPECT_TRUE(record->samples.empty());
}

// Catches files of the first versions refused or misread for a table that they cannot have.
TEST_F(SessionFile, OneWithoutTheSourcesPoseHasItAsInTheExperiment) {
    const std::string path = file("old.bask");
    Experiment experiment = twoDisks();
    experiment.source.pose[kX] = 0.03;
    {
        auto writer = SessionWriter::create(path, experiment, true);
        ASSERT_TRUE(writer) << describe(writer.error());
        for (int k = 0; k < 3; ++k)
            ASSERT_TRUE((*writer)->add(madeUpSample(experiment, k)));
        ASSERT_TRUE((*writer)->finish("settled"));
    }
    ASSERT_TRUE(test::makeFirstVersion(path));
    {
        auto db = QSqlDatabase::addDatabase("QSQLITE", "older");
        db.setDatabaseName(QString::fromStdString(path));
        ASSERT_TRUE(db.open());
        EXPECT_TRUE(QSqlQuery(db).exec("DROP TABLE source_pose"));
        db.close();
    }
    QSqlDatabase::removeDatabase("older");
    const auto record = readSession(path);
    ASSERT_TRUE(record) << describe(record.error());
    ASSERT_EQ(record->samples.size(), 3u);
    for (const TraceSample& sample : record->samples)
        EXPECT_LT((sample.source - experiment.source.pose).cwiseAbs().maxCoeff(), 1e-15);
    EXPECT_EQ(exportSessionCsv(path, file("csv"))->size(), 14u);
    const std::string columns = contents(qfile("csv/columns.csv"));
    EXPECT_NE(columns.find("\npose.csv,"), std::string::npos) << columns;
    EXPECT_EQ(columns.find("source_pose.csv"), std::string::npos) << "it has none";
}

// The columns are a promise to scripts.
TEST_F(SessionFile, HasThePromisedHeaderAndColumns) {
    const std::string path = recorded("run.bask", 3);
    {
        auto db = QSqlDatabase::addDatabase("QSQLITE", "schema-test");
        db.setDatabaseName(QString::fromStdString(path));
        ASSERT_TRUE(db.open());
        QSqlQuery query(db);
        const auto one = [&](const char* sql) {
            EXPECT_TRUE(query.exec(sql) && query.next()) << sql;
            return query.value(0).toString().toStdString();
        };
        const auto columns = [&](const char* table) {
            return one((std::string("SELECT group_concat(name, ',') FROM pragma_table_info('") + table + "')")
                           .c_str());
        };
        EXPECT_EQ(one("PRAGMA application_id"), std::to_string(0x4261736b));
        EXPECT_EQ(one("PRAGMA user_version"), "2");
        EXPECT_EQ(one("PRAGMA journal_mode"), "wal");
        EXPECT_EQ(columns("sample"), "time_s,object,measured_K,estimated_K,rate_K_s,target_K,view_factor,"
                                     "view_factor_unshaded");
        EXPECT_EQ(columns("object_state"), "time_s,object,lambda1_K_s,lambda2_1_K3s,reading_valid");
        EXPECT_EQ(columns("truth"), "time_s,object,temperature_K");
        EXPECT_EQ(columns("motion"), "time_s,vx_m_s,vy_m_s,vz_m_s,wx_rad_s,wy_rad_s,wz_rad_s,"
                                     "smallest_singular_value,limited");
        EXPECT_EQ(columns("source"), "time_s,temperature_K");
        EXPECT_EQ(columns("pose"), "time_s,x_m,y_m,z_m,qw,qx,qy,qz");
        EXPECT_EQ(columns("source_pose"), "time_s,x_m,y_m,z_m,qw,qx,qy,qz");
        EXPECT_EQ(one("SELECT count(*) FROM sample"), "6");
        EXPECT_EQ(one("SELECT group_concat(object, ';') FROM sample"),
                  "left, the;right;left, the;right;left, the;right")
            << "samples in order, objects in the experiment's";
        EXPECT_EQ(one("SELECT count(*) FROM source_pose WHERE qw IS NOT NULL"), "3");
        EXPECT_EQ(one("SELECT count(*) FROM sample WHERE rate_K_s IS NULL"), "6") << "not known is NULL";
        EXPECT_EQ(one("SELECT max(abs(qw*qw + qx*qx + qy*qy + qz*qz - 1)) < 1e-14 FROM pose"), "1");
        query.clear();
        db.close();
    }
    QSqlDatabase::removeDatabase("schema-test");
}

TEST_F(SessionFile, TakesEightHoursInSeconds) {
    const std::string path = file("long.bask");
    Experiment experiment = twoDisks();
    experiment.objects.pop_back();
    const std::clock_t start = std::clock(); // of this process: other work on the machine does not count
    const auto since_s = [start] { return static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC; };
    {
        auto writer = SessionWriter::create(path, experiment, true);
        for (int k = 0; k < 28'800; ++k)
            ASSERT_TRUE((*writer)->add(madeUpSample(experiment, k)));
        ASSERT_TRUE((*writer)->finish("settled"));
    }
    const double writing_s = since_s();
    const auto record = readSession(path);
    const double reading_s = since_s() - writing_s;
    ASSERT_TRUE(record);
    EXPECT_EQ(record->samples.size(), 28'800u);
    std::printf("28,800 samples: written in %.2f s, read in %.2f s of processor time\n", writing_s,
                reading_s);
    EXPECT_LT(writing_s, 5.0);
    EXPECT_LT(reading_s, 5.0);
}

TEST_F(SessionFile, CanBeReadWhileItIsWritten) {
    const std::string path = file("live.bask");
    auto writer = SessionWriter::create(path, twoDisks(), true, 0.0);
    ASSERT_TRUE(writer);
    for (int k = 0; k < 20; ++k) {
        ASSERT_TRUE((*writer)->add(madeUpSample(twoDisks(), k)));
        const auto record = readSession(path);
        ASSERT_TRUE(record) << describe(record.error());
        ASSERT_EQ(record->samples.size(), static_cast<std::size_t>(k + 1));
    }
    ASSERT_TRUE((*writer)->add(madeUpSample(twoDisks(), 20)));
    ASSERT_TRUE(copySession(path, file("copy.bask"))) << "also while it is written";
    EXPECT_EQ(readSession(file("copy.bask"))->samples.size(), 21u);
    ASSERT_TRUE((*writer)->finish("stopped"));
    EXPECT_EQ(readSession(path)->outcome, "stopped");
}

// Each read is one moment: never a sample without its pose.
TEST_F(SessionFile, AReaderInAnotherThreadSeesWholeSamples) {
    const std::string path = file("threads.bask");
    auto writer = SessionWriter::create(path, twoDisks(), true, 0.0);
    ASSERT_TRUE(writer);
    std::atomic<bool> done{false};
    std::atomic<int> reads{0};
    std::string trouble;
    std::unique_ptr<QThread> reader(QThread::create([&] {
        while (!done || reads == 0) {
            if (const auto record = readSession(path); !record)
                trouble = describe(record.error());
            ++reads;
        }
    }));
    reader->start();
    for (int k = 0; k < 300; ++k)
        ASSERT_TRUE((*writer)->add(madeUpSample(twoDisks(), k)));
    done = true;
    reader->wait();
    EXPECT_EQ(trouble, "");
    EXPECT_EQ(readSession(path)->samples.size(), 300u);
}

// Without the timer the last row before a pause would wait for the next one.
TEST_F(SessionFile, CommitsWithoutAFollowingRow) {
    const std::string path = file("pause.bask");
    auto writer = SessionWriter::create(path, twoDisks(), true, 0.05);
    ASSERT_TRUE((*writer)->add(madeUpSample(twoDisks(), 0)));
    const auto before = std::chrono::steady_clock::now();
    std::size_t seen = 0;
    while (seen == 0 && std::chrono::steady_clock::now() - before < std::chrono::seconds(10)) {
        QCoreApplication::processEvents(QEventLoop::WaitForMoreEvents);
        seen = readSession(path)->samples.size();
    }
    EXPECT_EQ(seen, 1u);
}

TEST_F(SessionFile, AKilledProcessLosesLessThanASecond) {
    const QString path = qfile("killed.bask");
    QProcess child;
    child.start(QCoreApplication::applicationFilePath(), {"--record-until-killed", path});
    ASSERT_TRUE(child.waitForStarted());
    double last_s = 0.0;
    std::size_t written = 0;
    while (last_s < 2.5) {
        ASSERT_TRUE(child.waitForReadyRead(20'000)) << child.readAllStandardError().toStdString();
        while (child.canReadLine()) {
            last_s = child.readLine().toDouble();
            ++written;
        }
    }
    child.kill(); // SIGKILL
    ASSERT_TRUE(child.waitForFinished());
    ASSERT_EQ(child.exitStatus(), QProcess::CrashExit);
    ASSERT_TRUE(QFile::exists(path + "-wal")) << "the process was killed in mid-run";
    const std::string database = contents(path);
    const std::string log = contents(path + "-wal");

    const auto record = readSession(path.toStdString());
    ASSERT_TRUE(record) << describe(record.error());
    EXPECT_TRUE(record->interrupted());
    ASSERT_FALSE(record->samples.empty());
    EXPECT_GT(record->samples.back().time_s, last_s - 1.0);
    std::size_t older = 0;
    for (const TraceSample& sample : record->samples)
        older += sample.time_s < last_s - 1.0 ? 1 : 0;
    EXPECT_GT(older, 10u);
    for (std::size_t k = 0; k < record->samples.size(); ++k) {
        TraceSample expected = madeUpSample(twoDisks(), static_cast<int>(k));
        expected.time_s = record->samples[k].time_s;
        ASSERT_TRUE(sameSample(record->samples[k], expected)) << k;
    }
    EXPECT_EQ(contents(path), database) << "reading changes nothing";
    EXPECT_EQ(contents(path + "-wal"), log);

    ASSERT_TRUE(copySession(path.toStdString(), file("saved.bask")));
    EXPECT_EQ(readSession(file("saved.bask"))->samples.size(), record->samples.size());
    const auto next =
        SessionWriter::create(path.toStdString(), twoDisks(), true, 0.5, SessionWriter::Earlier::Replaced);
    EXPECT_TRUE(next) << "an interrupted session can be replaced";
}

TEST_F(SessionFile, ReplacesAnOlderSessionAndNothingElse) {
    const std::string path = recorded("run.bask", 5);
    EXPECT_EQ(readSession(recorded("run.bask", 2))->samples.size(), 2u);

    QFile letter(qfile("letter.txt"));
    ASSERT_TRUE(letter.open(QIODevice::WriteOnly));
    letter.write("Dear reader");
    letter.close();
    const auto refused = SessionWriter::create(file("letter.txt"), twoDisks(), true);
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().code(), MessageCode::FileUnwritable);
    EXPECT_EQ(contents(qfile("letter.txt")), "Dear reader");
    EXPECT_FALSE(copySession(path, file("letter.txt")));
    EXPECT_EQ(contents(qfile("letter.txt")), "Dear reader");
    EXPECT_FALSE(QFile::exists(qfile("letter.txt.part")));

    QFile empty(qfile("empty.bask"));
    ASSERT_TRUE(empty.open(QIODevice::WriteOnly));
    empty.close();
    EXPECT_TRUE(SessionWriter::create(file("empty.bask"), twoDisks(), true));
}

// Catches a recording that is replaced by one that nobody allowed to.
TEST_F(SessionFile, AnEarlierOneIsKeptUnlessAsked) {
    const std::string path = recorded("run.bask", 5);
    const std::string before = contents(qfile("run.bask"));
    const auto refused = SessionWriter::create(path, twoDisks(), true);
    ASSERT_FALSE(refused);
    EXPECT_EQ(describe(refused.error()),
              path + ": the file cannot be written: there is a recording of that name");
    EXPECT_EQ(contents(qfile("run.bask")), before);
    EXPECT_EQ(QDir(m_folder.path()).entryList(QDir::AllEntries | QDir::Hidden | QDir::NoDotAndDotDot),
              QStringList{"run.bask"});
}

TEST_F(SessionFile, IsNotTakenFromARunThatRecordsIntoIt) {
    const std::string path = file("busy.bask");
    auto writer = SessionWriter::create(path, twoDisks(), true, 0.0);
    ASSERT_TRUE((*writer)->add(madeUpSample(twoDisks(), 0)));
    const auto second = SessionWriter::create(path, twoDisks(), true, 0.5, SessionWriter::Earlier::Replaced);
    ASSERT_FALSE(second);
    EXPECT_EQ(second.error().code(), MessageCode::SessionBusy) << describe(second.error());
    const std::string other = recorded("other.bask", 2);
    EXPECT_EQ(copySession(other, path).error().code(), MessageCode::SessionBusy);
    ASSERT_TRUE((*writer)->add(madeUpSample(twoDisks(), 1)));
    ASSERT_TRUE((*writer)->finish("stopped"));
    EXPECT_EQ(readSession(path)->samples.size(), 2u);
}

TEST_F(SessionFile, CopiesWholeOrNotAtAll) {
    const std::string path = recorded("run.bask", 5);
    ASSERT_TRUE(copySession(path, file("it's a copy.bask")));
    EXPECT_EQ(readSession(file("it's a copy.bask"))->samples.size(), 5u);
    ASSERT_TRUE(copySession(path, file("it's a copy.bask"))) << "over an older copy";
    ASSERT_TRUE(copySession(path, path)) << "onto itself: nothing to do";
    EXPECT_EQ(readSession(path)->samples.size(), 5u);
    EXPECT_EQ(copySession(path, file("no/folder.bask")).error().code(), MessageCode::FileUnwritable);
    EXPECT_EQ(copySession(file("none.bask"), file("x.bask")).error().code(), MessageCode::FileNotFound);
    EXPECT_FALSE(QFile::exists(qfile("x.bask")));
}

TEST_F(SessionFile, IsReadThroughALinkAndWithOddNames) {
    const std::string path = recorded("50% & more?#1 \xC3\xA9.bask", 4);
    EXPECT_EQ(readSession(path)->samples.size(), 4u);
    ASSERT_TRUE(QFile::link(QString::fromStdString(path), qfile("link.bask")));
    EXPECT_EQ(readSession(file("link.bask"))->samples.size(), 4u);
}

// Catches: a column under another's header, a number that lost digits.
TEST_F(SessionFile, ExportsTheTracesSideBySideWithUnits) {
    const std::string path = recorded("run.bask", 12);
    ASSERT_TRUE(exportSessionCsv(path, file("csv"), {}, CsvDigits::All));
    std::istringstream traces(contents(qfile("csv/traces.csv")));
    std::string header, line;
    std::getline(traces, header);
    EXPECT_EQ(header.substr(0, 30), "time (s),source (degC),x (m),y");
    EXPECT_NE(header.find("\"left, the measured (degC)\""), std::string::npos) << header;
    EXPECT_TRUE(header.ends_with(",right true (degC)")) << header;
    for (int k = 0; k < 12; ++k)
        ASSERT_TRUE(std::getline(traces, line)) << k;
    const TraceSample expected = madeUpSample(twoDisks(), 11);
    std::vector<std::string> fields;
    std::istringstream row(line);
    for (std::string field; std::getline(row, field, ',');)
        fields.push_back(field);
    ASSERT_EQ(fields.size(), 8u + 2u * 9u);
    EXPECT_EQ(std::stod(fields[0]), expected.time_s);
    EXPECT_NEAR(std::stod(fields[1]), expected.source_K - 273.15, 1e-9);
    EXPECT_NEAR(std::stod(fields[7]), expected.coordinates[kThetaZ], 1e-12);
    EXPECT_NEAR(std::stod(fields[17]), expected.objects[1].measured_K - 273.15, 1e-9);
    EXPECT_NEAR(std::stod(fields[20]), expected.objects[1].measured_K - expected.objects[1].target_K, 1e-9);
    EXPECT_EQ(std::stod(fields[22]), expected.objects[1].viewFactor);
    EXPECT_EQ(std::stod(fields[23]), expected.objects[1].unshadedViewFactor);
    EXPECT_EQ(fields[24], expected.objects[1].valid ? "1" : "0");
    EXPECT_NEAR(std::stod(fields[25]), expected.objects[1].true_K - 273.15, 1e-9);
}

// Catches: 40.12299999999999 of a reading of 40.123, and a number that is rounded to nothing.
TEST_F(SessionFile, TracesHaveTheDigitsThatMeanSomething) {
    const std::string path = file("run.bask");
    TraceSample sample = madeUpSample(twoDisks(), 3);
    sample.time_s = 0.1 + 0.2;
    sample.source_K = 473.15 + 1e-8;
    sample.coordinates[kX] = -1e-9;
    sample.coordinates[kZ] = 0.15 + 1e-9;
    sample.objects[1].measured_K = 273.15 + 40.123;
    sample.objects[1].estimated_K = 273.15 + 40.0 + 1.0 / 3.0;
    sample.objects[1].rate_K_s = 1.2345678912e-5;
    sample.objects[1].viewFactor = 0.123456789;
    sample.objects[1].unshadedViewFactor = std::nan("");
    {
        auto writer = SessionWriter::create(path, twoDisks(), true);
        ASSERT_TRUE((*writer)->add(sample));
    }
    ASSERT_TRUE(exportSessionCsv(path, file("csv")));
    const auto at = [this](const char* folder, std::size_t column) {
        std::istringstream traces(contents(qfile(folder)));
        std::string line;
        std::getline(traces, line);
        std::getline(traces, line);
        std::vector<std::string> fields;
        std::istringstream row(line);
        for (std::string field; std::getline(row, field, ',');)
            fields.push_back(field);
        return column < fields.size() ? fields[column] : "none";
    };
    EXPECT_EQ(at("csv/traces.csv", 0), "0.3");
    EXPECT_EQ(at("csv/traces.csv", 1), "200");
    EXPECT_EQ(at("csv/traces.csv", 2), "0");
    EXPECT_EQ(at("csv/traces.csv", 4), "0.15");
    EXPECT_EQ(at("csv/traces.csv", 17), "40.123");
    EXPECT_EQ(at("csv/traces.csv", 18), "40.333");
    EXPECT_EQ(std::stod(at("csv/traces.csv", 21)), 1.23456789e-5);
    EXPECT_EQ(at("csv/traces.csv", 22), "0.123457");
    EXPECT_EQ(at("csv/traces.csv", 23), "");
    ASSERT_TRUE(exportSessionCsv(path, file("all"), {}, CsvDigits::All));
    EXPECT_EQ(std::stod(at("all/traces.csv", 0)), 0.1 + 0.2);
    EXPECT_EQ(at("all/traces.csv", 17), "40.123") << "313.273 K less 273.15 K is 40.12299999999999";
    EXPECT_EQ(at("all/traces.csv", 1), "200.00000001") << "what was recorded is not rounded";
    EXPECT_EQ(std::stod(at("all/traces.csv", 21)), 1.2345678912e-5);
    EXPECT_EQ(at("all/traces.csv", 22), "0.123456789");
}

// Catches: 297.9533333333333 K of a sensor with steps of 0.1 K in a table, a table that is left out, a number
// or a time that loses what means something, and rounded numbers where all digits are asked for.
TEST_F(SessionFile, TablesHaveTheDigitsThatMeanSomething) {
    const std::string path = file("run.bask");
    Experiment experiment = twoDisks();
    experiment.simulation.thermalCamera.emplace().profile = "lepton-3.5";
    TraceSample sample = madeUpSample(experiment, 11);
    sample.time_s = 1.0 / 3.0;
    {
        auto writer = SessionWriter::create(path, experiment, true);
        ASSERT_TRUE((*writer)->add(sample));
        ASSERT_TRUE((*writer)->add(TraceEvent{1.0 / 3.0, {MessageCode::EventStarted, {}}}));
    }
    ASSERT_TRUE(exportSessionCsv(path, file("csv")));
    ASSERT_TRUE(exportSessionCsv(path, file("all"), {}, CsvDigits::All));
    // By the headers, of the last row.
    const auto last = [this](const std::string& name) {
        std::istringstream text(contents(qfile(name.c_str())));
        std::string header, line, row;
        std::getline(text, header);
        while (std::getline(text, line))
            row = line;
        std::map<std::string, std::string> out;
        std::istringstream keys(header), fields(row);
        for (std::string key, field; std::getline(keys, key, ',') && std::getline(fields, field, ',');)
            out[key] = field;
        return out;
    };
    const std::map<std::string, double> units{{"_K", 1e-3},     {"_m", 1e-6}, {"_m_s", 1e-7},
                                              {"_rad_s", 1e-7}, {"_1", 1e-6}, {"quaternion", 1e-7}};
    const std::map<std::string, std::map<std::string, const char*>> tables{
        {"sample",
         {{"measured_K", "_K"},
          {"estimated_K", "_K"},
          {"target_K", "_K"},
          {"view_factor", "_1"},
          {"view_factor_unshaded", "_1"}}},
        {"truth", {{"temperature_K", "_K"}}},
        {"camera", {{"camera_K", "_K"}, {"camera_uncertainty_K", "_K"}, {"camera_spread_K", "_K"}}},
        {"source", {{"temperature_K", "_K"}}},
        {"motion",
         {{"vx_m_s", "_m_s"}, {"vz_m_s", "_m_s"}, {"wz_rad_s", "_rad_s"}, {"smallest_singular_value", "_1"}}},
        {"pose", {{"x_m", "_m"}, {"y_m", "_m"}, {"z_m", "_m"}, {"qw", "quaternion"}, {"qz", "quaternion"}}},
        {"source_pose", {{"x_m", "_m"}, {"z_m", "_m"}, {"qw", "quaternion"}, {"qy", "quaternion"}}}};
    for (const auto& [table, columns] : tables) {
        auto rounded = last("csv/" + table + ".csv"), all = last("all/" + table + ".csv");
        EXPECT_EQ(std::stod(rounded["time_s"]), 1.0 / 3.0) << table << ": the key of every table";
        for (const auto& [column, kind] : columns) {
            SCOPED_TRACE(testing::Message()
                         << table << ' ' << column << ' ' << rounded[column] << ' ' << all[column]);
            ASSERT_FALSE(rounded[column].empty() || all[column].empty());
            const double step = units.at(kind), exact = std::stod(all[column]);
            EXPECT_DOUBLE_EQ(std::stod(rounded[column]), std::nearbyint(exact / step) * step);
        }
        for (const auto& [column, text] : rounded)
            EXPECT_TRUE(column == "time_s" || text.size() <= 14) << table << ' ' << column << ' ' << text;
    }
    EXPECT_EQ(std::stod(last("all/sample.csv")["measured_K"]), sample.objects[1].measured_K);
    EXPECT_GT(std::stod(last("csv/object_state.csv")["lambda2_1_K3s"]), 0.0) << "small, but not nothing";
    EXPECT_EQ(contents(qfile("csv/event.csv")), contents(qfile("all/event.csv"))) << "times as they are";
    EXPECT_EQ(contents(qfile("csv/experiment.csv")), contents(qfile("all/experiment.csv")));
}

// Catches: a count that loses its units, and numbers at the ends of what a double holds that become empty.
TEST_F(SessionFile, TracesKeepNumbersOfAnySize) {
    constexpr double kNumbers[] = {1234567.0, 1e305, -1.5e300, 4e-320, 1234567890123.0, 12345678.26};
    for (const double number : kNumbers) {
        const std::string path = file("run.bask");
        QFile::remove(qfile("run.bask"));
        TraceSample sample = madeUpSample(twoDisks(), 3);
        sample.objects[1].rate_K_s = number;
        {
            auto writer = SessionWriter::create(path, twoDisks(), true);
            ASSERT_TRUE((*writer)->add(sample));
        }
        ASSERT_TRUE(exportSessionCsv(path, file("csv")));
        std::istringstream traces(contents(qfile("csv/traces.csv")));
        std::string line, field;
        std::getline(traces, line);
        std::getline(traces, line);
        std::istringstream row(line);
        for (int column = 0; column <= 21; ++column)
            std::getline(row, field, ',');
        ASSERT_FALSE(field.empty()) << number;
        EXPECT_DOUBLE_EQ(std::strtod(field.c_str(), nullptr), number == 12345678.26 ? 12345678.3 : number);
    }
}

TEST_F(SessionFile, ExportsOneCsvPerTable) {
    const std::string path = file("run.bask");
    {
        auto writer = SessionWriter::create(path, twoDisks(), true);
        for (int k = 9; k < 12; ++k)
            ASSERT_TRUE((*writer)->add(madeUpSample(twoDisks(), k)));
        ASSERT_TRUE((*writer)->add(TraceNote{1.5, "said \"no\", twice\nand left", "A. Hu"}));
    }
    const std::string folder = file("deep/csv");
    const auto files = exportSessionCsv(path, folder);
    ASSERT_TRUE(files) << describe(files.error());
    EXPECT_EQ(files->size(), 15u);
    ASSERT_TRUE(exportSessionCsv(path, folder)) << "existing files are replaced";

    std::istringstream sample(contents(qfile("deep/csv/sample.csv")));
    std::string line;
    std::getline(sample, line);
    EXPECT_EQ(line,
              "time_s,object,measured_K,estimated_K,rate_K_s,target_K,view_factor,view_factor_unshaded");
    std::getline(sample, line);
    EXPECT_EQ(line.substr(line.find(','), 13), ",\"left, the\",");
    EXPECT_NE(line.find(",,,313.15,"), std::string::npos) << "not known is an empty field: " << line;
    std::getline(sample, line);
    const double measured = std::stod(line.substr(line.find("right,") + 6));
    EXPECT_NEAR(measured, madeUpSample(twoDisks(), 9).objects[1].measured_K, 0.5e-3 + 1e-9);
    EXPECT_EQ(contents(qfile("deep/csv/note.csv")),
              "time_s,text,operator\n1.5,\"said \"\"no\"\", twice\nand left\",A. Hu\n");
    EXPECT_EQ(contents(qfile("deep/csv/pose.csv")).substr(0, 29), "time_s,x_m,y_m,z_m,qw,qx,qy,q");

    QFile blocked(qfile("blocked"));
    ASSERT_TRUE(blocked.open(QIODevice::WriteOnly));
    EXPECT_EQ(exportSessionCsv(path, file("blocked")).error().code(), MessageCode::FileUnwritable);
}

// Catches: a column whose unit, frame or angle nobody tells, a header that is not in its table, and a table
// of that name that is lost.
TEST_F(SessionFile, ColumnsSayWhatTheTablesHold) {
    const std::string path = recorded("run.bask", 3);
    ASSERT_TRUE(exportSessionCsv(path, file("csv")));
    const std::string columns = contents(qfile("csv/columns.csv"));
    for (const char* line : {"file,column,unit,meaning\n",
                             "traces.csv,x (m),m,\"origin of the end-effector E in the robot's base R, along",
                             "Rz(theta_z) Ry(theta_y) Rx(theta_x)",
                             "traces.csv,right measured (degC),degC,measured temperature\n",
                             "sample.csv,measured_K,K,measured temperature\n", "truth.csv,temperature_K,K,",
                             "meta.csv,created,,", "meta.csv,verification,,", "meta.csv,simulation_pace,,"})
        EXPECT_NE(columns.find(line), std::string::npos) << line << '\n' << columns;
    std::istringstream traces(contents(qfile("csv/traces.csv")));
    std::string header;
    std::getline(traces, header);
    std::size_t told = 0, from = 0;
    for (; (from = columns.find("\ntraces.csv,", from)) != std::string::npos; ++from)
        ++told;
    EXPECT_EQ(told, 8u + 2u * 9u) << header;
    ASSERT_TRUE((*SessionStore::create(path))->execute("CREATE TABLE columns(a)"));
    ASSERT_TRUE(exportSessionCsv(path, file("other")));
    EXPECT_EQ(contents(qfile("other/columns.csv")), "a\n");
}

// Catches times of a fast simulation that contradict each other in the tables.
TEST_F(SessionFile, MetaCsvTellsHowFastItWasSimulated) {
    ASSERT_TRUE(exportSessionCsv(recorded("fast.bask", 600), file("fast")));
    EXPECT_NE(contents(qfile("fast/meta.csv")).find("simulation_pace,599.1 s of the simulated rig in "),
              std::string::npos)
        << contents(qfile("fast/meta.csv"));
    ASSERT_TRUE(exportSessionCsv(recorded("short.bask", 2), file("short")));
    EXPECT_EQ(contents(qfile("short/meta.csv")).find("simulation_pace"), std::string::npos);
}

// Catches: a note or a name that a spreadsheet runs as a formula, and a number that is made a text.
TEST_F(SessionFile, TextsOfACsvAreNoFormulas) {
    const std::string path = file("run.bask");
    Experiment experiment = twoDisks();
    experiment.objects[1].name = "=cmd|'/c calc'!A0";
    TraceSample sample = madeUpSample(experiment, 11);
    sample.coordinates[0] = -0.25;
    {
        auto writer = SessionWriter::create(path, experiment, true);
        ASSERT_TRUE((*writer)->add(sample));
        for (const char* text : {"=1,2", "+1", "-1", "@a", "\tb", "\rc", "d=1"})
            ASSERT_TRUE((*writer)->add(TraceNote{-1.5, text}));
    }
    ASSERT_TRUE(exportSessionCsv(path, file("csv")));
    EXPECT_EQ(
        contents(qfile("csv/note.csv")),
        "time_s,text,operator\n-1.5,\"'=1,2\",\n-1.5,'+1,\n-1.5,'-1,\n-1.5,'@a,\n-1.5,'\tb,\n-1.5,\"'\rc\",\n"
        "-1.5,d=1,\n");
    EXPECT_NE(contents(qfile("csv/sample.csv")).find(",'=cmd|'/c calc'!A0,"), std::string::npos);
    EXPECT_NE(contents(qfile("csv/traces.csv")).find(",'=cmd|'/c calc'!A0 measured (degC),"),
              std::string::npos);
    EXPECT_NE(contents(qfile("csv/pose.csv")).find(",-0.25,"), std::string::npos);
}

// Catches: a file of before a column came that cannot be read, or is read as if the value had been 0.
TEST_F(SessionFile, AColumnThatCameLaterIsUnknownInAnOlderFile) {
    const std::string path = recorded("run.bask", 3);
    {
        auto db = QSqlDatabase::addDatabase("QSQLITE", "older");
        db.setDatabaseName(QString::fromStdString(path));
        ASSERT_TRUE(db.open());
        QSqlQuery query(db);
        for (const char* sql : {"DROP VIEW sample", "ALTER TABLE step DROP COLUMN view_factor_unshaded_1",
                                "ALTER TABLE step DROP COLUMN view_factor_unshaded_2"})
            EXPECT_TRUE(query.exec(sql)) << sql << query.lastError().text().toStdString();
        query.clear();
        db.close();
    }
    QSqlDatabase::removeDatabase("older");
    const auto record = readSession(path);
    ASSERT_TRUE(record) << describe(record.error());
    ASSERT_EQ(record->samples.size(), 3u);
    for (const ObjectSample& object : record->samples[2].objects) {
        EXPECT_TRUE(std::isnan(object.unshadedViewFactor));
        EXPECT_TRUE(std::isfinite(object.viewFactor));
    }
}

} // namespace
} // namespace bask
