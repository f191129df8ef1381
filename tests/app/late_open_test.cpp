// What is read slowly and comes when there is something to lose: edits typed or recovered meanwhile.

#include "app/autosave.h"
#include "app/examples.h"
#include "app/recovery_offer.h"
#include "app/resources.h"
#include "app/session_actions.h"
#include "app/settings_store.h"
#include "engine/experiment/experiment_file.h"
#include "tests/support/wait_for.h"
#include "widgets/common/message_bar.h"

#include <QApplication>
#include <QMessageBox>
#include <QPushButton>
#include <QTemporaryDir>
#include <QThreadPool>
#include <QTimer>

#include <gtest/gtest.h>

namespace bask::test {
namespace {

struct LateOpenTest : testing::Test {
    QTemporaryDir folder;
    QString path = folder.filePath(QStringLiteral("slow.json"));
    QString unsaved = folder.filePath(QStringLiteral("unsaved"));
    Document document;
    SettingsStore settings;
    SessionActions files{document, settings, nullptr};
    QStringList problems;
    Experiment slow;

    void SetUp() override {
        initResources();
        slow = readExample(QStringLiteral("two-circles")).value();
        ASSERT_TRUE(writeExperiment(slow, path.toStdString()));
        QObject::connect(&files, &SessionActions::problem,
                         [this](const QString& sentence) { problems << sentence; });
        document.open(Document::blank(), {});
    }
    void edit(double target_K) { ASSERT_TRUE(document.setTargets({target_K})); }
    Experiment crashed() {
        Experiment edited = Document::blank();
        edited.objects[0].target_K = 321.0;
        EXPECT_TRUE(UnsavedFile(unsaved).write({edited, path, QStringLiteral("slow.json")}));
        return edited;
    }
};

} // namespace

TEST_F(LateOpenTest, editsMadeMeanwhileStay) {
    files.open(path);
    edit(320.0);
    ASSERT_TRUE(waitFor([&] { return !problems.isEmpty(); }));
    EXPECT_TRUE(problems[0].startsWith(QStringLiteral("\"slow.json\" was not opened")))
        << problems[0].toStdString();
    EXPECT_EQ(document.experiment().objects[0].target_K, 320.0);
    EXPECT_TRUE(document.modified());
    EXPECT_FALSE(settings.recentFiles().contains(path));

    // Those that the person gave up before are no reason against it.
    QTimer answer;
    QObject::connect(&answer, &QTimer::timeout, [] {
        if (auto* box = qobject_cast<QMessageBox*>(QApplication::activeModalWidget()))
            for (auto* button : box->buttons())
                if (box->buttonRole(button) == QMessageBox::DestructiveRole)
                    button->click();
    });
    answer.start(10);
    files.open(path);
    ASSERT_TRUE(waitFor([&] { return document.path() == path; }));
    EXPECT_EQ(document.experiment(), slow);
    EXPECT_EQ(problems.size(), 1);
}

TEST_F(LateOpenTest, whatWasSavedOrOpenedMeanwhileGivesWay) {
    files.open(path);
    edit(320.0);
    document.markSaved(folder.filePath(QStringLiteral("other.json")));
    EXPECT_TRUE(waitFor([&] { return document.path() == path; }));
    EXPECT_TRUE(problems.isEmpty());
}

// Catches: `bask slow.json` after a crash, whose reading ends after the recovery and takes what was recovered
// out of memory and off the disk.
TEST_F(LateOpenTest, whatWasRecoveredMeanwhileStaysAndStaysKept) {
    const Experiment edited = crashed();
    {
        Autosave autosave(document, unsaved);
        files.open(path);
        autosave.adopt(UnsavedFile::left(unsaved).at(0));
        document.openUnsaved(edited, path);
        ASSERT_TRUE(waitFor([&] { return !problems.isEmpty(); }));
        EXPECT_EQ(document.experiment(), edited);
        files.openExample(QStringLiteral("three-objects"), false); // as at a start without a file
        edit(322.0);
        QThreadPool::globalInstance()->waitForDone();
        QCoreApplication::processEvents();
        EXPECT_EQ(document.experiment().objects.size(), 1U);
        EXPECT_EQ(problems.size(), 1) << "of an example that nobody asked for";
    }
    EXPECT_EQ(UnsavedFile::left(unsaved).size(), 1U);
}

TEST_F(LateOpenTest, whatIsRecoveredDoesNotReplaceNewerEdits) {
    crashed();
    Autosave autosave(document, unsaved);
    MessageBar bar;
    RecoveryOffer offer(bar, document, autosave, files);
    offer.begin(unsaved);
    emit bar.actionClicked();
    edit(320.0);
    ASSERT_TRUE(waitFor([&] { return !problems.isEmpty(); }));
    EXPECT_EQ(document.experiment().objects[0].target_K, 320.0);
    EXPECT_FALSE(bar.isHidden()) << "it can be had still";
    document.undo();
    emit bar.actionClicked();
    EXPECT_TRUE(waitFor([&] { return document.path() == path; }));
    EXPECT_EQ(document.experiment().objects[0].target_K, 321.0);
}

} // namespace bask::test
