// A run that the program's end cut off: told at the next start, once, and never of a run that goes on.

#include "app/cut_off_run.h"
#include "app/document.h"
#include "engine/recording/session_file.h"
#include "tests/support/wait_for.h"
#include "widgets/common/message_bar.h"

#include <QAbstractButton>
#include <QDir>
#include <QTemporaryDir>

#include <gtest/gtest.h>

#include <csignal>
#include <cstdlib>

#include <sys/wait.h>
#include <unistd.h>

namespace bask::test {
namespace {

Snapshot running(const QString& recording, RunState state = RunState::Running) {
    Snapshot snapshot;
    snapshot.state = state;
    snapshot.recordingPath = recording.toStdString();
    return snapshot;
}

struct CutOffRunTest : testing::Test {
    QTemporaryDir folder;
    QString marks = folder.filePath(QStringLiteral("runs-on"));
    MessageBar bar;
    CutOffRun cutOff{bar, marks};

    int marked() { return static_cast<int>(QDir(marks).entryList(QDir::Files).size()); }

    /// A recording that nobody gave its end.
    QString recording(bool simulated) {
        const QString path = folder.filePath(QStringLiteral("run.bask"));
        auto writer = SessionWriter::create(path.toStdString(), Document::blank(), simulated, 0.5,
                                            SessionWriter::Earlier::Replaced);
        EXPECT_TRUE(writer);
        return path;
    }
    /// Another Bask that is killed in its run.
    void killIn(const QString& session) {
        const pid_t child = fork();
        if (child == 0) {
            CutOffRun other(bar, marks);
            other.apply(running(session));
            raise(SIGKILL);
        }
        int status = 0;
        ASSERT_EQ(waitpid(child, &status, 0), child);
        ASSERT_TRUE(WIFSIGNALED(status));
    }
    bool tells() {
        cutOff.begin();
        return waitFor([this] { return !bar.sentence().isEmpty(); }, 1000);
    }
    void click(const char* name) {
        auto* button = bar.findChild<QAbstractButton*>(QLatin1String(name));
        ASSERT_NE(button, nullptr);
        ASSERT_FALSE(button->isHidden());
        button->click();
    }
};

// Catches a crash in a run of which the next start says nothing, that is told again for ever, or a simulated
// one that sends a person to the plate.
TEST_F(CutOffRunTest, AKilledRunIsToldUntilItIsRead) {
    for (const bool simulated : {true, false}) {
        const QString session = recording(simulated);
        ASSERT_NO_FATAL_FAILURE(killIn(session));
        ASSERT_TRUE(tells());
        EXPECT_EQ(bar.sentence().contains(QStringLiteral("could not stop the rig")), !simulated);
        EXPECT_TRUE(bar.sentence().contains(QStringLiteral("is kept")));
        QString opened;
        QObject::connect(&cutOff, &CutOffRun::openWanted, &cutOff,
                         [&](const QString& path) { opened = path; });
        click(simulated ? "messageAction" : "messageClose");
        EXPECT_EQ(opened, simulated ? session : QString());
        EXPECT_FALSE(tells());
    }
}

// Catches an alarm about a run that ended as it should, or that another Bask is still at.
TEST_F(CutOffRunTest, ARunThatGoesOnOrHasEndedIsNotTold) {
    const QString session = recording(true);
    MessageBar elsewhere;
    CutOffRun other(elsewhere, marks);
    other.apply(running(session, RunState::Armed));
    EXPECT_EQ(marked(), 0);
    for (const RunState state :
         {RunState::Running, RunState::Holding, RunState::Settled, RunState::Stopping}) {
        other.apply(running(session, state));
        EXPECT_EQ(marked(), 1) << runStateName(state);
    }
    EXPECT_FALSE(tells());
    other.apply(running({}, RunState::Stopped));
    EXPECT_EQ(marked(), 0);
    EXPECT_FALSE(tells());

    // The mark alone outlived its process: the recording has its end.
    ASSERT_NO_FATAL_FAILURE(killIn(session));
    auto writer = SessionWriter::create(session.toStdString(), Document::blank(), true, 0.5,
                                        SessionWriter::Earlier::Replaced);
    ASSERT_TRUE(writer);
    ASSERT_TRUE((*writer)->finish("stopped"));
    writer->reset();
    EXPECT_FALSE(tells());
}

// Catches a recording that is gone and therefore a crash that is not told.
TEST_F(CutOffRunTest, ARecordingThatCannotBeReadIsToldToo) {
    ASSERT_NO_FATAL_FAILURE(killIn(folder.filePath(QStringLiteral("gone.bask"))));
    ASSERT_TRUE(tells());
    EXPECT_TRUE(bar.sentence().contains(QStringLiteral("could not stop the rig")));
    EXPECT_TRUE(bar.sentence().contains(QStringLiteral("gone.bask")));
    EXPECT_FALSE(bar.sentence().contains(QStringLiteral("is kept")));
    EXPECT_TRUE(bar.findChild<QAbstractButton*>(QStringLiteral("messageAction"))->isHidden());
}

// Catches one run's mark that stands in the way of another's, or takes it away.
TEST_F(CutOffRunTest, RunsOfTwoProcessesAreMarkedAndToldEach) {
    const QString session = recording(false);
    MessageBar elsewhere;
    CutOffRun other(elsewhere, marks);
    other.apply(running(session));
    ASSERT_NO_FATAL_FAILURE(killIn(session));
    ASSERT_TRUE(tells());
    cutOff.apply(running(session));
    EXPECT_EQ(marked(), 3);
    click("messageClose");
    EXPECT_EQ(marked(), 2);
    other.apply(running({}, RunState::Stopped));
    EXPECT_EQ(marked(), 1);
    cutOff.end();
    EXPECT_EQ(marked(), 0);
}

// Catches a run whose recorder failed, or whose engine hung when the window was closed, that passes for
// ended.
TEST_F(CutOffRunTest, ARunIsOverWhenTheEngineSaysSo) {
    {
        MessageBar elsewhere;
        CutOffRun other(elsewhere, marks);
        other.apply(running(recording(false)));
        other.apply(running({}, RunState::Stopping));
        EXPECT_EQ(marked(), 1);
    }
    EXPECT_TRUE(tells());
    click("messageClose");

    QDir().mkpath(marks); // of a full disk: nothing but that there was a run is known
    QFile empty(marks + QStringLiteral("/1-2.run"));
    ASSERT_TRUE(empty.open(QIODevice::WriteOnly));
    EXPECT_TRUE(tells());
    EXPECT_TRUE(bar.sentence().contains(QStringLiteral("could not stop the rig")));
    EXPECT_TRUE(bar.findChild<QAbstractButton*>(QStringLiteral("messageAction"))->isHidden());
}

} // namespace
} // namespace bask::test
