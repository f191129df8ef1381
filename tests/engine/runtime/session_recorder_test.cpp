#include "engine/runtime/session_recorder.h"

#include "engine/session/session_store.h"
#include "tests/engine/runtime/loop_on_rig.h"
#include "tests/support/wait_for.h"

#include <QElapsedTimer>
#include <QTemporaryDir>

#include <gtest/gtest.h>

namespace bask {
namespace {

class SessionRecorderTest : public testing::Test {
protected:
    std::unique_ptr<SessionRecorder> recorder() const {
        return std::move(SessionRecorder::create(m_path, m_experiment, false).value());
    }
    LoopRecord sampleAt(double time_s) const {
        LoopRecord rows;
        rows.samples.emplace_back().time_s = time_s;
        rows.samples.back().objects.resize(m_experiment.objects.size());
        return rows;
    }

    QTemporaryDir m_folder;
    std::string m_path = m_folder.filePath(QStringLiteral("run.bask")).toStdString();
    Experiment m_experiment = twoDisks(40.0);
};

} // namespace

// Catches an engine that is held up by its disk, and rows that are lost on the way.
TEST_F(SessionRecorderTest, aFileThatCannotBeWrittenForAWhileHoldsNobodyUp) {
    const auto recording = recorder();
    const auto other = SessionStore::create(m_path);
    ASSERT_TRUE(other && (*other)->execute("BEGIN IMMEDIATE"));
    QElapsedTimer since;
    since.start();
    qint64 longest_ms = 0;
    int samples = 0;
    while (since.elapsed() < 1500) {
        QElapsedTimer spent;
        spent.start();
        ASSERT_TRUE(recording->add(sampleAt(samples++)));
        longest_ms = std::max(longest_ms, spent.elapsed());
        std::this_thread::sleep_for(std::chrono::milliseconds(20));
    }
    EXPECT_LT(longest_ms, 300) << "the lock is kept for longer";
    EXPECT_EQ(recording->rows(), 0U);
    ASSERT_TRUE((*other)->execute("ROLLBACK"));
    ASSERT_TRUE(recording->finish("settled"));
    const auto session = readSession(m_path);
    ASSERT_TRUE(session) << describe(session.error());
    EXPECT_EQ(session->samples.size(), static_cast<std::size_t>(samples));
    EXPECT_EQ(session->outcome, "settled");
}

// Catches rows told as recorded that are not in the file yet.
TEST_F(SessionRecorderTest, whatIsToldAsRecordedIsInTheFile) {
    const auto recording = recorder();
    for (int i = 0; i < 3; ++i)
        ASSERT_TRUE(recording->add(sampleAt(i)));
    EXPECT_EQ(recording->rows(), 0U) << "it is not waited for";
    ASSERT_TRUE(test::waitFor([&] { return recording->rows() == 3; }));
    const auto session = readSession(m_path);
    ASSERT_TRUE(session) << describe(session.error());
    EXPECT_EQ(session->samples.size(), 3U);
    EXPECT_TRUE(session->interrupted());
}

// Catches a recording that has failed and a run that goes on without.
TEST_F(SessionRecorderTest, aFailureIsToldByTheNextCall) {
    const auto recording = recorder();
    const auto other = SessionStore::create(m_path);
    ASSERT_TRUE(other && (*other)->execute("DROP TABLE step"));
    ASSERT_TRUE(recording->add(sampleAt(0.0)));
    ASSERT_TRUE(test::waitFor([&] { return !recording->add({}).ok(); }));
    EXPECT_FALSE(recording->finish("settled"));
    EXPECT_EQ(recording->rows(), 0U);
}

} // namespace bask
