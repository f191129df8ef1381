// Kills a recording at random moments: each sample that was told to be safe is in the file, and the file
// opens and verifies as far as it goes. Thirty times in CI, a thousand times by hand (`ctest -L soak -R
// kills`).

#include "engine/recording/recorded_session.h"
#include "engine/recording/session_verify.h"
#include "tests/engine/recording/recording.h"

#include <QCoreApplication>
#include <QDeadlineTimer>
#include <QDir>
#include <QFile>
#include <QProcess>
#include <QTemporaryDir>

#include <gtest/gtest.h>

#include <cstdio>
#include <random>
#include <string_view>

namespace bask {
namespace {

using test::madeUpSample;
using test::sameSample;
using test::twoDisks;

class SessionKills : public ::testing::Test {
protected:
    /// Records for so long and is killed; the number of samples told to be safe, or -1 when it never began.
    static long recordAndKill(const QString& path, int seed, int life_ms) {
        QProcess child;
        child.start(QCoreApplication::applicationFilePath(),
                    {QStringLiteral("--record-and-acknowledge"), path, QString::number(seed)});
        if (!child.waitForReadyRead(30'000))
            return -1;
        const QDeadlineTimer end(life_ms, Qt::PreciseTimer);
        while (!end.hasExpired() && child.state() == QProcess::Running)
            child.waitForReadyRead(static_cast<int>(std::max<qint64>(1, end.remainingTime())));
        child.kill(); // SIGKILL
        child.waitForFinished();
        if (child.exitStatus() != QProcess::CrashExit)
            return -1;
        const QByteArray told = child.readAllStandardOutput();
        const qsizetype line = told.lastIndexOf('\n'); // what comes after is half a number
        return told.left(line).mid(told.left(line).lastIndexOf('\n') + 1).toLong();
    }

    void kill(int times) {
        std::mt19937 random(20);
        std::uniform_int_distribution<int> life_ms(0, 400);
        long acknowledged = 0, found = 0, withLog = 0;
        int unopened = 0, lost = 0;
        for (int i = 0; i < times; ++i) {
            const QTemporaryDir folder;
            const QString path = folder.filePath(QStringLiteral("run.bask"));
            const long safe = recordAndKill(path, i, life_ms(random));
            ASSERT_GE(safe, 0) << i << ": it did not record";
            withLog += QFile::exists(path + QStringLiteral("-wal")) ? 1 : 0;
            const auto verdict = verifySession(path.toStdString());
            ASSERT_TRUE(verdict) << i << ": " << describe(verdict.error());
            EXPECT_TRUE(verdict->isIntact())
                << i << ": " << verdict->allFindings << " rows are not as they were";
            EXPECT_FALSE(verdict->isClosed) << i;
            const auto session = readSession(path.toStdString());
            const auto opened = RecordedSession::open(path.toStdString());
            EXPECT_TRUE(session) << i << ": " << describe(session.error());
            EXPECT_TRUE(opened) << i << ": " << describe(opened.error());
            if (!session || !opened) {
                ++unopened;
                continue;
            }
            acknowledged += safe;
            found += static_cast<long>(session->samples.size());
            lost += std::max<int>(0, static_cast<int>(safe - static_cast<long>(session->samples.size())));
            EXPECT_TRUE(session->interrupted());
            EXPECT_EQ((*opened)->size(), session->samples.size());
            for (std::size_t k = 0; k < session->samples.size(); ++k)
                ASSERT_TRUE(sameSample(session->samples[k], madeUpSample(twoDisks(), static_cast<int>(k))))
                    << i << ", sample " << k;
        }
        std::printf(
            "%d kills (%ld left a log): %ld samples acknowledged, %ld found, %d lost; %d files do not open\n",
            times, withLog, acknowledged, found, lost, unopened);
        EXPECT_EQ(lost, 0);
        EXPECT_EQ(unopened, 0);
        EXPECT_GT(acknowledged, 40L * times) << "they were killed in the midst of it";
    }
};

} // namespace

TEST_F(SessionKills, thirty) {
    kill(30);
}

TEST_F(SessionKills, thousand) {
    kill(1000);
}

// Catches: a recording that is gone, or there under a hidden name only, when its replacement is killed.
TEST_F(SessionKills, ofAReplacementLeaveTheOldOneOrTheNewOne) {
    const QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("run.bask"));
    std::mt19937 random(7);
    std::uniform_int_distribution<int> life_ms(0, 60);
    for (int i = 0; i < 40; ++i) {
        QProcess child;
        child.start(QCoreApplication::applicationFilePath(), {QStringLiteral("--replace"), path});
        ASSERT_TRUE(child.waitForReadyRead(30'000)) << i;
        child.waitForFinished(life_ms(random));
        child.kill();
        child.waitForFinished();
        ASSERT_EQ(child.exitStatus(), QProcess::CrashExit) << i;
        const auto session = readSession(path.toStdString());
        ASSERT_TRUE(session) << i << ": " << describe(session.error());
    }
    ASSERT_TRUE(
        SessionWriter::create(path.toStdString(), twoDisks(), true, 0.5, SessionWriter::Earlier::Replaced));
    EXPECT_EQ(QDir(folder.path()).entryList(QDir::AllEntries | QDir::Hidden | QDir::NoDotAndDotDot),
              QStringList{"run.bask"})
        << "what the kills left is cleared";
}

} // namespace bask

int main(int argc, char** argv) {
    const QCoreApplication app(argc, argv);
    if (argc == 4 && std::string_view(argv[1]) == "--record-and-acknowledge")
        return bask::test::recordAndAcknowledge(argv[2], static_cast<unsigned>(std::stoul(argv[3])));
    if (argc == 3 && std::string_view(argv[1]) == "--replace")
        return bask::test::replaceUntilKilled(argv[2]);
    ::testing::InitGoogleTest(&argc, argv);
    return RUN_ALL_TESTS();
}
