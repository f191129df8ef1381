#include "engine/runtime/session_recorder.h"

#include "engine/base/message_code.h"
#include "engine/recording/session_store.h"
#include "engine/recording/session_verify.h"
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
        auto out = std::make_unique<SessionRecorder>(m_path, m_experiment, false);
        EXPECT_TRUE(test::waitFor([&] { return out->made().has_value(); }) && *out->made());
        return out;
    }
    static bool isFinished(SessionRecorder& recording) {
        recording.finish("settled");
        return test::waitFor([&] { return recording.finished().has_value(); }) && *recording.finished();
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

// Catches pictures that fill the memory while the disk takes nothing, and samples that are lost for them.
TEST_F(SessionRecorderTest, picturesThatWaitAreBounded) {
    m_experiment.simulation.thermalCamera.emplace().profile = "p2-pro";
    const auto picture = std::make_shared<ThermalPicture>(
        ThermalPicture{256, 192, std::vector<double>(std::size_t{256} * 192, 300.0)});
    const std::size_t most = SessionRecorder::kMaxPictures / (picture->T_K.size() * sizeof(double));
    auto recording = std::make_unique<SessionRecorder>(m_path, m_experiment, true);
    ASSERT_TRUE(test::waitFor([&] { return recording->made().has_value(); }) && *recording->made());
    const auto other = SessionStore::create(m_path);
    ASSERT_TRUE(other && (*other)->execute("BEGIN IMMEDIATE"));
    for (int k = 0; k < 1000; ++k) {
        LoopRecord rows = sampleAt(k);
        rows.frames.push_back({static_cast<double>(k), picture});
        ASSERT_TRUE(recording->add(std::move(rows)));
    }
    ASSERT_TRUE((*other)->execute("ROLLBACK"));
    ASSERT_TRUE(isFinished(*recording));
    std::size_t pictures = 0;
    ASSERT_TRUE(readThermalFrames(m_path, [&](double, const std::string&) { ++pictures; }));
    EXPECT_GE(pictures, most);
    EXPECT_LE(pictures, 2 * most) << "those being written, and those that wait";
    EXPECT_EQ(recording->rows(), 1000U);
}

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
    ASSERT_TRUE(isFinished(*recording));
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
    EXPECT_FALSE(isFinished(*recording));
    EXPECT_EQ(recording->rows(), 0U);
}

// Catches a caller that is held up by a file that cannot be made yet, and rows that come before it is.
TEST_F(SessionRecorderTest, whatComesBeforeTheFileIsThereIsWritten) {
    QElapsedTimer since;
    since.start();
    SessionRecorder recording(m_path + "2", m_experiment, false);
    ASSERT_TRUE(recording.add(sampleAt(0.0)));
    recording.finish("stopped");
    EXPECT_LT(since.elapsed(), 300);
    ASSERT_TRUE(test::waitFor([&] { return recording.finished().has_value(); }));
    const auto session = readSession(m_path + "2");
    ASSERT_TRUE(session) << describe(session.error());
    EXPECT_EQ(session->samples.size(), 1U);
}

// Catches a program that ends while a file is being sealed: the seal is lost, and the database of a thread
// that still runs is gone.
TEST_F(SessionRecorderTest, whoWaitsForAllHasSealedFiles) {
    for (int k = 0; k < 20; ++k) {
        const std::string path = m_path + std::to_string(k);
        SessionRecorder recording(path, m_experiment, false);
        ASSERT_TRUE(recording.add(sampleAt(0.0)));
        recording.finish("stopped");
        ASSERT_TRUE(SessionRecorder::waitForAll(std::chrono::seconds(10)));
        EXPECT_TRUE(recording.finished().has_value());
        const auto verdict = verifySession(path);
        ASSERT_TRUE(verdict) << describe(verdict.error());
        EXPECT_EQ(verdict->seal, Seal::Holds);
    }
}

// Catches a recording that is lost to one of the same name.
TEST_F(SessionRecorderTest, anEarlierFileIsKeptUnlessAsked) {
    ASSERT_TRUE(isFinished(*recorder()));
    ASSERT_TRUE(SessionRecorder::waitForAll(std::chrono::seconds(10)));
    SessionRecorder refused(m_path, m_experiment, false);
    ASSERT_TRUE(test::waitFor([&] { return refused.made().has_value(); }));
    EXPECT_EQ(refused.made()->error().code(), MessageCode::FileUnwritable);
    EXPECT_EQ(readSession(m_path)->outcome, "settled");
    SessionRecorder asked(m_path, m_experiment, false, 0.0, {}, SessionRecorder::Earlier::Replaced);
    ASSERT_TRUE(test::waitFor([&] { return asked.made().has_value(); }));
    EXPECT_TRUE(asked.made()->ok());
}

// Catches a recording that is begun where there is no room for it.
TEST_F(SessionRecorderTest, noFileIsMadeWhereThereIsNoRoom) {
    SessionRecorder recording(m_path, m_experiment, false, 1e12);
    ASSERT_TRUE(test::waitFor([&] { return recording.made().has_value(); }));
    EXPECT_EQ(recording.made()->error().code(), MessageCode::SafetyDiskLow);
    EXPECT_FALSE(QFile::exists(QString::fromStdString(m_path)));
}

} // namespace bask
