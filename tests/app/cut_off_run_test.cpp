// A run that the program's end cut off: told at the next start, once, and never of a run that goes on.

#include "app/cut_off_run.h"
#include "app/document.h"
#include "engine/session/session_file.h"
#include "tests/support/wait_for.h"
#include "widgets/common/message_bar.h"

#include <QAbstractButton>
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
    QString mark = folder.filePath(QStringLiteral("run-on"));
    MessageBar bar;
    CutOffRun cutOff{bar, mark};

    /// A recording that nobody gave its end.
    QString recording(bool simulated) {
        const QString path = folder.filePath(QStringLiteral("run.bask"));
        auto writer = SessionWriter::create(path.toStdString(), Document::blank(), simulated);
        EXPECT_TRUE(writer);
        return path;
    }
    /// Another Bask that is killed in its run.
    void killIn(const QString& session) {
        const pid_t child = fork();
        if (child == 0) {
            CutOffRun other(bar, mark);
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
        bar.clear();
        ASSERT_TRUE(tells()) << "nobody has answered";
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
    CutOffRun other(elsewhere, mark);
    other.apply(running(session, RunState::Armed));
    EXPECT_FALSE(QFile::exists(mark));
    for (const RunState state :
         {RunState::Running, RunState::Holding, RunState::Settled, RunState::Stopping}) {
        other.apply(running(session, state));
        EXPECT_TRUE(QFile::exists(mark)) << runStateName(state);
    }
    EXPECT_FALSE(tells());
    other.apply(running({}, RunState::Stopped));
    EXPECT_FALSE(QFile::exists(mark));
    EXPECT_FALSE(tells());

    // The mark alone outlived its process: the recording has its end.
    ASSERT_NO_FATAL_FAILURE(killIn(session));
    auto writer = SessionWriter::create(session.toStdString(), Document::blank(), true);
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
    // A run of this process leaves what it has not been told alone, and its own end takes only its own mark.
    cutOff.apply(running(recording(true)));
    click("messageClose");
    EXPECT_TRUE(QFile::exists(mark));
    cutOff.apply(running({}, RunState::Stopped));
    EXPECT_FALSE(QFile::exists(mark));
}

} // namespace
} // namespace bask::test
