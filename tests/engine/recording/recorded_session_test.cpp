#include "engine/recording/recorded_session.h"

#include "engine/base/message_code.h"
#include "engine/recording/session_store.h"
#include "tests/engine/recording/recording.h"
#include "tests/support/first_version.h"

#include <gtest/gtest.h>

#include <QTemporaryDir>

#include <cmath>
#include <random>

namespace bask {
namespace {

using test::madeUpSample;
using test::sameSample;
using test::twoDisks;

constexpr int kSamples = 3000; // some rows of the overview, and the beginning of one

class RecordedSessionTest : public ::testing::Test {
protected:
    std::string recorded(bool isFinished) {
        const std::string path = m_folder.filePath(QStringLiteral("run.bask")).toStdString();
        auto writer = SessionWriter::create(path, twoDisks(), true, 0.5, SessionWriter::Earlier::Replaced);
        EXPECT_TRUE(writer);
        for (int k = 0; k < kSamples; ++k)
            EXPECT_TRUE((*writer)->add(at(k)));
        EXPECT_TRUE((*writer)->add(TraceNote{7.0, "a note"}));
        if (isFinished) {
            EXPECT_TRUE((*writer)->finish("settled"));
        }
        return path;
    }
    static TraceSample at(int k) {
        TraceSample sample = madeUpSample(twoDisks(), k);
        for (ObjectSample& object : sample.objects)
            object.target_K = k < 1500 ? 313.15 : 320.0;
        return sample;
    }
    static void alter(const std::string& path, const std::string& sql) {
        const auto store = SessionStore::create(path);
        ASSERT_TRUE((*store)->execute(sql)) << sql;
    }

    /// What a page wants of it, against what was recorded.
    void expectAll(RecordedSession& session) const {
        ASSERT_EQ(session.size(), static_cast<std::size_t>(kSamples));
        EXPECT_EQ(session.lastTime_s(), at(kSamples - 1).time_s);
        TraceOverview expected(2);
        for (int k = 0; k < kSamples; ++k)
            expected.add(at(k));
        ASSERT_EQ(session.overview().stretches(), expected.stretches());
        for (std::size_t k = 0; k < expected.stretches(); ++k) {
            EXPECT_EQ(session.overview().from_s(k), expected.from_s(k));
            EXPECT_EQ(session.overview().extremes(Quantity::Temperature, 1, k).max,
                      expected.extremes(Quantity::Temperature, 1, k).max);
        }
        const std::vector<std::pair<double, double>> steps{{at(0).time_s, 313.15}, {at(1500).time_s, 320.0}};
        EXPECT_EQ(session.targetSteps(0), steps);
        std::mt19937 random(5);
        for (int i = 0; i < 200; ++i) {
            const int k = std::uniform_int_distribution<int>(0, kSamples - 1)(random);
            for (const double later_s : {0.0, 0.5}) {
                const auto sample = session.sampleAt(at(k).time_s + later_s);
                ASSERT_TRUE(sample) << describe(sample.error());
                EXPECT_TRUE(sameSample(*sample, read(k))) << k;
            }
        }
        EXPECT_TRUE(sameSample(*session.sampleAt(-5.0), read(0)));
        EXPECT_TRUE(sameSample(*session.sampleAt(1e9), read(kSamples - 1)));
        const auto some = session.samples(at(1000).time_s, at(1050).time_s + 0.5); // over a block's end
        ASSERT_TRUE(some) << describe(some.error());
        ASSERT_EQ(some->size(), 51u);
        for (int k = 0; k <= 50; ++k)
            EXPECT_TRUE(sameSample((*some)[static_cast<std::size_t>(k)], read(1000 + k))) << k;
        EXPECT_EQ(*session.lowerIndex(1e9), session.size());
    }

    TraceSample read(int k) const { return m_isVersionOne ? test::asVersionOne(at(k)) : at(k); }

    QTemporaryDir m_folder;
    bool m_isVersionOne = false;
};

} // namespace

TEST_F(RecordedSessionTest, HasFactsOverviewAndSamples) {
    const auto session = RecordedSession::open(recorded(true));
    ASSERT_TRUE(session) << describe(session.error());
    const SessionRecord& facts = (*session)->facts();
    EXPECT_TRUE(facts.samples.empty());
    EXPECT_EQ(facts.outcome, "settled");
    EXPECT_TRUE(facts.simulated);
    EXPECT_TRUE(facts.experiment == twoDisks());
    ASSERT_EQ(facts.notes.size(), 1u);
    expectAll(**session);
}

TEST_F(RecordedSessionTest, ReadsAnInterruptedRunAndVersionOne) {
    const std::string path = recorded(false);
    {
        const auto interrupted = RecordedSession::open(path);
        ASSERT_TRUE(interrupted) << describe(interrupted.error());
        EXPECT_TRUE((*interrupted)->facts().interrupted());
        expectAll(**interrupted);
    }
    ASSERT_TRUE(test::makeFirstVersion(path));
    m_isVersionOne = true;
    const auto first = RecordedSession::open(path);
    ASSERT_TRUE(first) << describe(first.error());
    expectAll(**first);
}

// Catches a picture made of an overview that does not go with the samples.
TEST_F(RecordedSessionTest, AnOverviewThatIsMissingOrDamagedIsMadeAnew) {
    for (const char* sql : {"DELETE FROM overview", "DELETE FROM overview WHERE last_step = 1024",
                            "UPDATE overview SET extremes = x'0011'", "UPDATE overview SET extremes = 7",
                            "UPDATE overview SET last_step = last_step + 1"}) {
        const std::string path = recorded(true);
        alter(path, sql);
        const auto session = RecordedSession::open(path);
        ASSERT_TRUE(session) << sql << ": " << describe(session.error());
        expectAll(**session);
    }
}

TEST_F(RecordedSessionTest, AMissingSampleIsFoundWhereItIsRead) {
    const std::string path = recorded(true);
    alter(path, "DELETE FROM step WHERE number = 1100");
    const auto session = RecordedSession::open(path);
    ASSERT_TRUE(session) << describe(session.error());
    EXPECT_TRUE((*session)->sampleAt(at(3).time_s));
    EXPECT_EQ((*session)->sampleAt(at(1200).time_s).error().code(), MessageCode::SessionDamaged);
    EXPECT_EQ((*session)->samples(0.0, 1e9).error().code(), MessageCode::SessionDamaged);
    EXPECT_EQ(readSamples(path, [](const TraceSample&) {}).error().code(), MessageCode::SessionDamaged);
}

// Catches a run that is too long to be read when it is opened, and of which then nothing is looked at.
TEST_F(RecordedSessionTest, ALongRunThatIsNoneIsRefusedWhenOpened) {
    const std::string path = m_folder.filePath(QStringLiteral("long.bask")).toStdString();
    auto writer = SessionWriter::create(path, twoDisks(), true, 0.0);
    for (int k = 0; k < 20'500; ++k) // beyond RecordedSession's kMaxReadWhole
        ASSERT_TRUE((*writer)->add(at(k)));
    ASSERT_TRUE((*writer)->finish("stopped"));
    ASSERT_TRUE(RecordedSession::open(path));
    for (const char* values : {"measured_K_1 = 'hot'", "time_s = 0", "source_qw = 0.5"}) {
        const std::string altered = m_folder.filePath(QStringLiteral("altered.bask")).toStdString();
        QFile::remove(QString::fromStdString(altered));
        ASSERT_TRUE(QFile::copy(QString::fromStdString(path), QString::fromStdString(altered)));
        alter(altered, std::string("UPDATE step SET ") + values);
        const auto session = RecordedSession::open(altered);
        EXPECT_TRUE(!session && session.error().code() == MessageCode::SessionDamaged) << values;
    }
}

// Catches a reader that is led astray by rows that come while it reads.
TEST_F(RecordedSessionTest, ShowsARunThatIsBeingRecordedAsItWas) {
    const std::string path = m_folder.filePath(QStringLiteral("live.bask")).toStdString();
    auto writer = SessionWriter::create(path, twoDisks(), true, 0.0);
    for (int k = 0; k < 20; ++k)
        ASSERT_TRUE((*writer)->add(at(k)));
    const auto session = RecordedSession::open(path);
    ASSERT_TRUE(session) << describe(session.error());
    for (int k = 20; k < 40; ++k)
        ASSERT_TRUE((*writer)->add(at(k)));
    EXPECT_EQ((*session)->size(), 20u);
    EXPECT_EQ((*session)->samples(0.0, 1e9)->size(), 20u);
    EXPECT_EQ((*RecordedSession::open(path))->size(), 40u);
}

TEST_F(RecordedSessionTest, ARunWithoutSamples) {
    const std::string path = m_folder.filePath(QStringLiteral("none.bask")).toStdString();
    ASSERT_TRUE((*SessionWriter::create(path, twoDisks(), true))->finish("stopped"));
    const auto session = RecordedSession::open(path);
    ASSERT_TRUE(session) << describe(session.error());
    EXPECT_EQ((*session)->size(), 0u);
    EXPECT_FALSE((*session)->sampleAt(1.0));
    EXPECT_TRUE((*session)->samples(0.0, 1.0)->empty());
    EXPECT_EQ((*session)->lastTime_s(), 0.0);
}

TEST_F(RecordedSessionTest, EachSampleIsReadOnceInOrder) {
    const std::string path = recorded(true);
    for (const bool isFirstVersion : {false, true}) {
        if (isFirstVersion) {
            ASSERT_TRUE(test::makeFirstVersion(path));
            m_isVersionOne = true;
        }
        int k = 0;
        const auto done =
            readSamples(path, [&](const TraceSample& sample) { EXPECT_TRUE(sameSample(sample, read(k++))); });
        EXPECT_TRUE(done);
        EXPECT_EQ(k, kSamples);
    }
    EXPECT_EQ(RecordedSession::open("none.bask").error().code(), MessageCode::FileNotFound);
}

} // namespace bask
