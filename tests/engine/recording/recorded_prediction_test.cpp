// The run as it was predicted before Start, kept with the recording.

#include "engine/recording/nexus_file.h"
#include "engine/recording/recorded_prediction.h"
#include "engine/recording/recorded_session.h"
#include "engine/recording/session_verify.h"
#include "tests/engine/recording/recording.h"

#include <QSqlDatabase>
#include <QSqlQuery>
#include <QTemporaryDir>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>

namespace bask {
namespace {

PredictedRun predicted(std::size_t objects, bool hasBand) {
    PredictedRun run;
    for (int k = 0; k <= 20; ++k) {
        PredictedSample sample;
        sample.time_s = 0.7 * k;
        for (std::size_t i = 0; i < objects; ++i) {
            const double T_K = 300.0 + k + 0.1 * static_cast<double>(i);
            sample.temperatures_K.push_back(T_K);
            if (hasBand)
                sample.lowest_K.push_back(T_K - 0.25), sample.highest_K.push_back(T_K + 0.5);
        }
        run.samples.push_back(std::move(sample));
    }
    return run;
}

struct RecordedPrediction : testing::Test {
    QTemporaryDir folder;
    std::string path = folder.filePath("run.bask").toStdString();
    Experiment experiment = test::twoDisks();

    void record(const std::vector<PredictedRun>& runs) {
        auto writer = SessionWriter::create(path, experiment, true, 0.5, SessionWriter::Earlier::Replaced);
        ASSERT_TRUE(writer) << describe(writer.error());
        for (int k = 0; k < 12; ++k) {
            ASSERT_TRUE((*writer)->add(test::madeUpSample(experiment, k)));
            const auto number = static_cast<std::size_t>(k);
            ASSERT_TRUE(number >= runs.size() || (*writer)->add(runs[number]));
        }
        ASSERT_TRUE((*writer)->finish("settled"));
    }
    void execute(const QString& sql) const {
        {
            auto database = QSqlDatabase::addDatabase(QStringLiteral("QSQLITE"), QStringLiteral("change"));
            database.setDatabaseName(QString::fromStdString(path));
            ASSERT_TRUE(database.open());
            ASSERT_TRUE(QSqlQuery(database).exec(sql)) << sql.toStdString();
        }
        QSqlDatabase::removeDatabase(QStringLiteral("change"));
    }
    std::string fileText(const std::string& name) const {
        std::ifstream file(folder.filePath("out").toStdString() + '/' + name);
        return {std::istreambuf_iterator<char>(file), {}};
    }
};

} // namespace

// Catches: a prediction that nobody can compare with its run later, or the one without the band, which came
// first; and one that is no part of the hash chain.
TEST_F(RecordedPrediction, IsReadAsItWasAndIsInTheChain) {
    PredictedRun late = predicted(2, true);
    late.end = PredictedEnd::Settled;
    record({predicted(2, false), late});
    for (const PredictedRun& read :
         {readSession(path).value().prediction, RecordedSession::open(path).value()->facts().prediction}) {
        ASSERT_EQ(read.samples.size(), late.samples.size());
        EXPECT_TRUE(read.hasBand());
        for (std::size_t k = 0; k < read.samples.size(); ++k) {
            EXPECT_EQ(read.samples[k].time_s, late.samples[k].time_s);
            EXPECT_EQ(read.samples[k].temperatures_K, late.samples[k].temperatures_K);
            EXPECT_EQ(read.samples[k].lowest_K, late.samples[k].lowest_K);
            EXPECT_EQ(read.samples[k].highest_K, late.samples[k].highest_K);
        }
    }
    EXPECT_TRUE(verifySession(path)->isIntact());
    execute(QStringLiteral("UPDATE prediction SET temperature_K = temperature_K + 5 WHERE rowid = 60"));
    const auto verdict = verifySession(path);
    ASSERT_TRUE(verdict) << describe(verdict.error());
    ASSERT_EQ(verdict->findings.size(), 1U);
    EXPECT_EQ(verdict->findings[0].table, "prediction");
    EXPECT_EQ(verdict->findings[0].row, 60);
}

// Catches a prediction that was taken out of a recording and is not named.
TEST_F(RecordedPrediction, IsNamedWhereItWasTakenOut) {
    record({predicted(2, true)});
    execute(QStringLiteral("DROP TABLE prediction"));
    const auto names = [this] {
        std::string all;
        const auto verdict = verifySession(path);
        for (const SessionFinding& finding : verdict->findings)
            all += finding.name + ' ';
        return all;
    };
    EXPECT_NE(names().find("prediction"), std::string::npos) << names();
    record({predicted(2, true)});
    execute(QStringLiteral("DELETE FROM meta WHERE key = 'prediction'"));
    EXPECT_NE(names().find("prediction"), std::string::npos) << names();
}

// Catches: words of a prediction that settles for one that does not.
TEST_F(RecordedPrediction, KeepsHowItEnds) {
    for (const PredictedEnd end :
         {PredictedEnd::Settled, PredictedEnd::Limit, PredictedEnd::Cut, PredictedEnd::Fault}) {
        PredictedRun run = predicted(2, false);
        run.end = end;
        record({run});
        const PredictedRun read = readSession(path)->prediction;
        EXPECT_EQ(read.end, end);
        EXPECT_FALSE(read.hasBand());
        EXPECT_TRUE(read.samples.front().lowest_K.empty());
        EXPECT_TRUE(verifySession(path)->isIntact());
    }
}

// Catches: a recording without one that has a table, columns or a group of it, or does not open.
TEST_F(RecordedPrediction, IsNotThereWhereNothingWasPredicted) {
    record({});
    EXPECT_TRUE(readSession(path)->prediction.samples.empty());
    const std::string out = folder.filePath("out").toStdString();
    const auto files = exportSessionCsv(path, out);
    ASSERT_TRUE(files) << describe(files.error());
    EXPECT_TRUE(std::ranges::none_of(
        *files, [](const std::string& file) { return file.find("prediction") != std::string::npos; }));
}

// Catches: an export that leaves it out.
TEST_F(RecordedPrediction, IsExported) {
    record({predicted(2, true)});
    const std::string out = folder.filePath("out").toStdString();
    const auto files = exportSessionCsv(path, out);
    ASSERT_TRUE(files) << describe(files.error());
    const std::string rows = fileText("prediction.csv");
    EXPECT_EQ(rows.find("time_s,object,temperature_K,lowest_K,highest_K\n0,"), 0U) << rows;
    EXPECT_EQ(std::ranges::count(rows, '\n'), 1 + 21 * 2);
    const auto nexus = exportNexus(*readSession(path), out);
    ASSERT_TRUE(nexus) << describe(nexus.error());
    const std::string bytes = fileText("run.nxs");
    EXPECT_NE(bytes.find("not with other material, air or source"), std::string::npos);
    EXPECT_NE(bytes.find("highest_2"), std::string::npos);
}

// Catches: rows of another maker that make a long read of it, or end one.
TEST_F(RecordedPrediction, NonsenseInItIsPassedOver) {
    record({predicted(2, true)});
    execute(QStringLiteral("INSERT INTO prediction VALUES('x', 'nobody', 'much', NULL, 1)"));
    execute(QStringLiteral("INSERT INTO prediction VALUES(1e300, 'nobody', 1, 2, 3)"));
    execute(QStringLiteral("WITH RECURSIVE n(k) AS (SELECT 1 UNION ALL SELECT k + 1 FROM n WHERE k < 200000) "
                           "INSERT INTO prediction SELECT k, 'left', 300, 300, 300 FROM n"));
    const auto session = readSession(path);
    ASSERT_TRUE(session) << describe(session.error());
    EXPECT_LT(session->prediction.samples.size(), 10'000U);
}

} // namespace bask
