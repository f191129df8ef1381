// The window's undo, files and recovery: every page's edits come back exactly, and none are lost by a crash.

#include "app/unsaved_file.h"
#include "engine/experiment/experiment_file.h"
#include "engine/experiment/rig_file.h"
#include "engine/runtime/simulated_run.h"
#include "tests/app/window_fixture.h"
#include "widgets/calibrate/calibrate_page.h"
#include "widgets/common/message_bar.h"
#include "widgets/common/quantity_spin_box.h"
#include "widgets/common/run_state_chip.h"
#include "widgets/objects/objects_page.h"
#include "widgets/rig/rig_page.h"
#include "widgets/targets/targets_page.h"

#include <QAbstractButton>
#include <QComboBox>
#include <QDir>
#include <QDoubleSpinBox>
#include <QDropEvent>
#include <QLineEdit>
#include <QMenu>
#include <QMimeData>
#include <QTabWidget>
#include <QTemporaryDir>

namespace bask::test {
namespace {

class UndoTest : public WindowTest {
protected:
    const Experiment& experiment() { return window->document().experiment(); }
    QString said(const char* bar) { return find<MessageBar>(bar)->sentence(); }
    void undoByKey() { QTest::keyClick(window.get(), Qt::Key_Z, Qt::ControlModifier); }
    void redoByKey() { QTest::keyClick(window.get(), Qt::Key_Y, Qt::ControlModifier); }
    void type(const char* name, const QString& text) {
        auto* field = find<QWidget>(name);
        ASSERT_NE(field, nullptr);
        ASSERT_TRUE(field->isVisible()) << name;
        field->setFocus();
        QTest::keyClick(field, Qt::Key_A, Qt::ControlModifier);
        QTest::keyClicks(field, text);
        QTest::keyClick(field, Qt::Key_Return);
    }
    /// Edits on `page`, takes it back on another page, does it again and takes it back again: the experiment
    /// must be the same to the last digit each time, and the page shown.
    void comesBack(const char* what, Page page, const std::function<void()>& edit) {
        SCOPED_TRACE(what);
        const Experiment before = experiment();
        const bool wasModified = window->document().modified();
        window->pages().show(page);
        edit();
        const Experiment after = experiment();
        ASSERT_NE(after, before);
        EXPECT_TRUE(window->document().modified());
        EXPECT_TRUE(window->actions().undo->text().startsWith(QStringLiteral("&Undo: ")));
        for (int round = 0; round < 2; ++round) {
            window->pages().show(page == Page::Run ? Page::Objects : Page::Run);
            undoByKey();
            EXPECT_EQ(experiment(), before);
            EXPECT_EQ(experimentToJson(experiment()), experimentToJson(before));
            EXPECT_EQ(window->document().modified(), wasModified);
            EXPECT_EQ(window->pages().page(), page);
            EXPECT_TRUE(said("messageBar").startsWith(QStringLiteral("Undone: ")))
                << qPrintable(said("messageBar"));
            EXPECT_EQ(window->pages().objects()->experiment(), before) << "another page has another one";
            if (round == 1)
                break;
            redoByKey();
            EXPECT_EQ(experiment(), after);
            EXPECT_EQ(experimentToJson(experiment()), experimentToJson(after));
        }
    }
    QMimeData* files(const QStringList& paths) {
        auto* data = new QMimeData;
        QList<QUrl> urls;
        for (const QString& path : paths)
            urls << QUrl::fromLocalFile(path);
        data->setUrls(urls);
        return data;
    }
    void drop(const QStringList& paths) {
        const std::unique_ptr<QMimeData> data(files(paths));
        QDragEnterEvent enter(QPoint(400, 300), Qt::CopyAction, data.get(), Qt::LeftButton, Qt::NoModifier);
        QApplication::sendEvent(window.get(), &enter);
        EXPECT_TRUE(enter.isAccepted());
        QDropEvent event(QPointF(400, 300), Qt::CopyAction, data.get(), Qt::LeftButton, Qt::NoModifier);
        QApplication::sendEvent(window.get(), &event);
    }
    /// As a Bask that was killed leaves it.
    void leaveUnsaved(const Experiment& unsaved, const QString& path, const QString& name) {
        ASSERT_TRUE(UnsavedFile(unsavedFolder()).write({unsaved, path, name}).ok());
    }
    void answer(const char* button) {
        auto* found = find<MessageBar>("questionBar")->findChild<QAbstractButton*>(QLatin1String(button));
        ASSERT_NE(found, nullptr);
        ASSERT_TRUE(found->isVisible()) << button;
        QTest::mouseClick(found, Qt::LeftButton);
    }
};

// Catches an edit of any page that cannot be undone, that comes back rounded or with something else changed,
// a page that keeps showing what was undone.
TEST_F(UndoTest, EveryPagesEditsComeBackExactly) {
    openWindow({1280, 900});
    ASSERT_TRUE(waitForState(RunState::Ready));
    const Experiment begin = experiment();
    comesBack("a target", Page::Targets, [&] { type("target0", QStringLiteral("41.3")); });
    comesBack("the start of runs", Page::Targets, [&] {
        Vector6d pose = experiment().start;
        pose[kZ] += 0.0123456789;
        emit window->findChild<TargetsPage*>()->startWanted(pose);
    });
    comesBack("an object's place", Page::Objects, [&] {
        window->pages().objects()->selectObject(1);
        type("mountX", QStringLiteral("3.3"));
    });
    EXPECT_EQ(window->pages().objects()->selectedObject(), 1);
    comesBack("a material", Page::Objects, [&] { type("emittance", QStringLiteral("0.45")); });
    comesBack("a name", Page::Objects, [&] { type("objectName", QStringLiteral("hare")); });
    comesBack("an object's target", Page::Objects, [&] { type("target", QStringLiteral("43.5")); });
    comesBack("an object more", Page::Objects, [&] { click("addDisk"); });
    comesBack("an object less", Page::Objects, [&] { click("removeObject"); });
    comesBack("gains", Page::Run, [&] {
        auto* gain = find<QDoubleSpinBox>("gain.level_servo.time_constant");
        gain->setValue(2.0 * gain->value());
        click("gainsApply");
    });
    window->pages().show(Page::Rig);
    find<QTabWidget>("rigTabs")->setCurrentIndex(1);
    comesBack("the workspace", Page::Rig, [&] { type("upper.z", QStringLiteral("261.5")); });
    comesBack("a speed", Page::Rig, [&] { type("maxSpeed", QStringLiteral("9.5")); });
    comesBack("the source", Page::Rig, [&] { type("sourceSetPoint", QStringLiteral("190")); });
    comesBack("a safety limit", Page::Rig, [&] { type("safety.trip", QStringLiteral("140")); });
    comesBack("the devices", Page::Rig, [&] {
        RigSpec rig;
        rig.name = "bench";
        window->findChild<RigPage*>()->useRig(rig);
    });
    auto* calibrate = window->findChild<CalibratePage*>();
    comesBack("a calibration", Page::Calibrate, [&] {
        VisionSpec vision = experiment().vision;
        vision.cameraPose = Vector6d::Constant(0.123456789);
        emit calibrate->visionEdited(vision);
    });
    comesBack("the source's place", Page::Calibrate, [&] {
        VisionSpec vision = experiment().vision;
        vision.sourcePoseDate = "2026-11-22T10:00:00Z";
        emit calibrate->sourceMeasured(vision, Vector6d::Constant(0.00123456789));
    });
    EXPECT_EQ(experiment(), begin);
    EXPECT_FALSE(window->isWindowModified());
    EXPECT_EQ(window->actions().undo->isEnabled(), false);
    ASSERT_TRUE(waitForState(RunState::Ready)) << "the engine has the simulated rig again";

    Experiment followed = readExperiment(BASK_EXAMPLES "/moving-source.json").value();
    followed.simulation.sourceMotion = {};
    window->document().open(followed, {});
    comesBack("following", Page::Calibrate, [&] { emit calibrate->followWanted(false); });
}

// Catches rates taken from a session that cannot be given back.
TEST_F(UndoTest, StartValuesOfASessionComeBack) {
    openWindow();
    const QTemporaryDir folder;
    const std::string path = folder.filePath(QStringLiteral("run.bask")).toStdString();
    SimulatedRunOptions options;
    options.duration_s = 300.0;
    options.sessionPath = path;
    Experiment wrong = experiment();
    wrong.controller.estimatedRateErrorFactor = 3.0;
    ASSERT_TRUE(runSimulated(wrong, options).ok());
    window->files().open(QString::fromStdString(path));
    ASSERT_TRUE(waitFor([this] { return find<QAbstractButton>("useIdentified")->isEnabled(); }));
    find<QComboBox>("reviewDetails")->setCurrentIndex(3); // heat rates
    const Experiment before = experiment();
    click("useIdentified");
    const Experiment after = experiment();
    ASSERT_TRUE(after.objects[0].estimatedRates);
    undoByKey();
    EXPECT_EQ(experiment(), before);
    EXPECT_EQ(window->pages().page(), Page::Objects);
    redoByKey();
    EXPECT_EQ(experiment(), after);
}

// Catches an undo that the engine does not hear of, that changes the objects under a run, or that takes the
// Run page from view.
TEST_F(UndoTest, DuringARunTargetsComeBackAndObjectsStay) {
    openWindow();
    ASSERT_NO_FATAL_FAILURE(goFast());
    ASSERT_TRUE(waitForState(RunState::Ready));
    window->pages().show(Page::Objects);
    click("addDisk");
    click("removeObject");
    ASSERT_TRUE(waitForState(RunState::NotReady));
    ASSERT_TRUE(waitForState(RunState::Ready));
    const Experiment before = experiment();
    click("armButton");
    ASSERT_TRUE(waitForState(RunState::Armed));
    EXPECT_FALSE(window->actions().undo->isEnabled());
    click("startButton");
    ASSERT_TRUE(waitForState(RunState::Running));
    ASSERT_TRUE(window->document().setTargets({318.15, 313.15, 313.15}).ok());
    const auto engineHas = [&](double target_K) {
        return waitFor([&] {
            const auto& targets_K = window->lastSnapshot().targets_K;
            return !targets_K.empty() && std::abs(targets_K[0] - target_K) < 1e-9;
        });
    };
    ASSERT_TRUE(engineHas(318.15));
    undoByKey();
    EXPECT_EQ(experiment(), before);
    EXPECT_TRUE(engineHas(before.objects[0].target_K));
    EXPECT_EQ(window->pages().page(), Page::Run);
    EXPECT_EQ(said("messageBar"), QStringLiteral("Undone: target of “circle”"));
    keepPicture(QStringLiteral("undone-during-run"));
    EXPECT_FALSE(window->actions().undo->isEnabled());
    undoByKey();
    EXPECT_EQ(experiment(), before);
    EXPECT_EQ(state(), RunState::Running);
}

// Catches a run to other targets than the fields show: one that no run may have is a reason against Arm, and
// is not taken once armed. And a refusal that goes on standing there after the next edit.
TEST_F(UndoTest, ATargetThatNoRunMayHaveNeitherArmsNorStays) {
    openWindow();
    ASSERT_TRUE(waitForState(RunState::Ready));
    ASSERT_TRUE(window->document().setTargets({473.15, 313.15, 313.15}).ok());
    const auto reasons = [&] { return find<RunStateChip>("runStateChip")->reasons().join(u' '); };
    ASSERT_TRUE(waitFor([&] { return reasons().contains(QStringLiteral("circle")); }));
    EXPECT_EQ(state(), RunState::NotReady);
    EXPECT_FALSE(window->actions().verb(Verb::Arm)->isEnabled());
    undoByKey();
    ASSERT_TRUE(waitForState(RunState::Ready));
    EXPECT_EQ(reasons(), QString());

    click("armButton");
    ASSERT_TRUE(waitForState(RunState::Armed));
    const Experiment armed = experiment();
    ASSERT_TRUE(window->document().setTargets({473.15, 313.15, 313.15}).ok());
    ASSERT_TRUE(waitFor([&] { return said("messageBar").contains(QStringLiteral("200")); }));
    EXPECT_EQ(experiment(), armed);
    ASSERT_TRUE(window->document().setTargets({318.15, 313.15, 313.15}).ok());
    EXPECT_FALSE(said("messageBar").contains(QStringLiteral("200"))) << qPrintable(said("messageBar"));

    // Nor one that comes as the run ends, which the engine takes no more.
    const auto engineHas = [&](double target_K) {
        return waitFor([&] { return std::abs(window->lastSnapshot().targets_K[0] - target_K) < 1e-9; });
    };
    ASSERT_TRUE(engineHas(318.15));
    click("startButton");
    ASSERT_TRUE(waitForState(RunState::Running));
    click("stopRunButton");
    ASSERT_TRUE(waitForState(RunState::Stopping));
    ASSERT_TRUE(window->document().setTargets({330.0, 313.15, 313.15}).ok());
    EXPECT_TRUE(waitFor([&] { return experiment().objects[0].target_K == 318.15; }));
    EXPECT_TRUE(engineHas(318.15));

    // Once stopped it is the document's again, and a reason against Arm.
    ASSERT_TRUE(waitForState(RunState::Stopped));
    EXPECT_TRUE(window->actions().verb(Verb::Arm)->isEnabled());
    ASSERT_TRUE(window->document().setTargets({473.15, 313.15, 313.15}).ok());
    EXPECT_TRUE(waitFor([&] { return !window->actions().verb(Verb::Arm)->isEnabled(); }));
    EXPECT_TRUE(reasons().contains(QStringLiteral("circle")));
}

// Catches a menu that speaks the language of the edit, and buttons of the Objects page that do not follow.
TEST_F(UndoTest, TheMenuSaysWhatIsUndone) {
    openWindow();
    window->pages().show(Page::Objects);
    window->pages().objects()->selectObject(1);
    type("mountX", QStringLiteral("3.3"));
    EXPECT_EQ(find<QAbstractButton>("undo")->toolTip(), QStringLiteral("Undo: move of “bunny”"));
    EXPECT_FALSE(find<QAbstractButton>("redo")->isEnabled());
    auto* menu = window->findChild<QMenu*>(QStringLiteral("editMenu"));
    ASSERT_NE(menu, nullptr);
    menu->popup(window->mapToGlobal(QPoint(60, 24)));
    keepPicture(QStringLiteral("undo-menu"));
    menu->hide();
    window->setLanguage(QStringLiteral("fr"));
    ASSERT_TRUE(
        waitFor([this] { return window->actions().undo->text().contains(QStringLiteral("déplacement")); }));
    EXPECT_TRUE(find<QAbstractButton>("undo")->toolTip().contains(QStringLiteral("déplacement")));
    menu->popup(window->mapToGlobal(QPoint(60, 24)));
    keepPicture(QStringLiteral("undo-menu-french"));
    menu->hide();
    click("undo");
    EXPECT_FALSE(window->document().modified());
    EXPECT_TRUE(find<QAbstractButton>("redo")->isEnabled());
}

// Catches edits that a crash loses, an offer that covers the window or goes away by itself, what is recovered
// that passes for saved.
TEST_F(UndoTest, WhatACrashLeftIsOffered) {
    const QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("mine.json"));
    Experiment saved = readExperiment(BASK_EXAMPLES "/two-circles.json").value();
    Experiment unsaved = saved;
    unsaved.objects[0].target_K += 3.0;
    ASSERT_TRUE(writeExperiment(saved, path.toStdString()).ok());
    leaveUnsaved(unsaved, path, QStringLiteral("mine.json"));
    openWindow();
    EXPECT_TRUE(said("questionBar").contains(QStringLiteral("mine.json"))) << qPrintable(said("questionBar"));
    EXPECT_EQ(QApplication::activeModalWidget(), nullptr);
    keepPicture(QStringLiteral("recovery-light"));
    window->setTheme(Theme::Dark);
    window->setLanguage(QStringLiteral("fr"));
    keepPicture(QStringLiteral("recovery-dark-french"));
    window->setTheme(Theme::Light);
    window->setLanguage(QStringLiteral("en"));
    answer("messageAction");
    ASSERT_TRUE(waitFor([&] { return experiment() == unsaved; }));
    EXPECT_EQ(window->document().path(), path);
    EXPECT_TRUE(window->isWindowModified());
    EXPECT_EQ(said("questionBar"), QString());
    EXPECT_FALSE(QDir(unsavedFolder()).isEmpty()) << "not saved yet";
    QTest::keyClick(window.get(), Qt::Key_S, Qt::ControlModifier);
    EXPECT_TRUE(waitFor([&] { return QDir(unsavedFolder()).isEmpty(); }));
    EXPECT_EQ(readExperiment(path.toStdString()).value(), unsaved);
}

// Catches an offer that comes back after it was refused, or that is gone after it was put off.
TEST_F(UndoTest, AnOfferIsDiscardedOrPutOff) {
    const Experiment unsaved = Document::blank();
    leaveUnsaved(unsaved, {}, QStringLiteral("first"));
    leaveUnsaved(unsaved, {}, QStringLiteral("second"));
    openWindow();
    const QString first = said("questionBar");
    answer("messageOther");
    const QString second = said("questionBar");
    EXPECT_NE(second, first);
    EXPECT_FALSE(second.isEmpty());
    answer("messageClose");
    closeWindow();
    openWindow();
    EXPECT_EQ(said("questionBar"), second);
    answer("messageOther");
    EXPECT_EQ(said("questionBar"), QString());
    EXPECT_TRUE(QDir(unsavedFolder()).isEmpty());
}

// Catches another experiment slipped in under a run.
TEST_F(UndoTest, NothingIsRecoveredDuringARun) {
    leaveUnsaved(Document::blank(), {}, QStringLiteral("mine"));
    openWindow();
    ASSERT_NO_FATAL_FAILURE(goFast());
    ASSERT_TRUE(waitForState(RunState::Ready));
    click("armButton");
    ASSERT_TRUE(waitForState(RunState::Armed));
    const Experiment before = experiment();
    answer("messageAction");
    EXPECT_TRUE(said("messageBar").contains(QStringLiteral("A run is on")));
    EXPECT_EQ(experiment(), before);
    EXPECT_FALSE(said("questionBar").isEmpty()) << "it can wait";
}

// Catches a drop that does nothing and says nothing.
TEST_F(UndoTest, DroppedFilesAreOpenedOrRefusedInWords) {
    openWindow();
    drop({QStringLiteral(BASK_EXAMPLES "/two-circles.json")});
    ASSERT_TRUE(waitFor([this] { return experiment().objects.size() == 2; }));
    EXPECT_FALSE(window->document().modified());

    window->pages().show(Page::Run);
    drop({QStringLiteral(BASK_TEST_DATA "/contours/svg/bunny_mm.svg")});
    EXPECT_EQ(window->pages().page(), Page::Objects);
    ASSERT_TRUE(waitFor([this] { return experiment().objects.size() == 3; }));

    const QTemporaryDir folder;
    RigSpec rig;
    rig.name = "bench";
    const QString rigPath = folder.filePath(QStringLiteral("bench.json"));
    ASSERT_TRUE(writeRigFile(rig, rigPath.toStdString()).ok());
    drop({rigPath});
    EXPECT_EQ(window->pages().page(), Page::Rig);
    ASSERT_TRUE(experiment().rig);
    undoByKey();
    EXPECT_FALSE(experiment().rig);

    const Experiment before = experiment();
    drop({QStringLiteral("/tmp/paper.pdf")});
    EXPECT_TRUE(said("messageBar").startsWith(QStringLiteral("paper.pdf cannot be opened")))
        << qPrintable(said("messageBar"));
    EXPECT_TRUE(said("messageBar").contains(QStringLiteral("outlines (SVG, DXF, CSV, pictures)")))
        << qPrintable(said("messageBar"));
    drop({rigPath, rigPath});
    EXPECT_TRUE(said("messageBar").startsWith(QStringLiteral("Only one file")))
        << qPrintable(said("messageBar"));
    keepPicture(QStringLiteral("drop-refused"));
    EXPECT_EQ(experiment(), before);
}

// Catches a list of recent files that cannot be cleared, or in which two files look the same.
TEST_F(UndoTest, RecentFilesAreToldApartAndCleared) {
    SettingsStore().addRecentFile(QStringLiteral("/a/mine.json"));
    SettingsStore().addRecentFile(QStringLiteral("/b/mine.json"));
    SettingsStore().addRecentFile(QStringLiteral("/b/run.bask"));
    openWindow();
    auto* menu = window->findChild<QMenu*>(QStringLiteral("recentMenu"));
    QStringList texts;
    for (const QAction* action : menu->actions())
        texts << action->text().remove(u'&');
    EXPECT_EQ(texts,
              (QStringList{QStringLiteral("run.bask"), QStringLiteral("mine.json (/b)"),
                           QStringLiteral("mine.json (/a)"), QString(), QStringLiteral("Clear the list")}));
    menu->actions().at(2)->trigger();
    EXPECT_TRUE(waitFor([this] { return said("messageBar").contains(QStringLiteral("/a/mine.json")); }))
        << qPrintable(said("messageBar"));
    EXPECT_EQ(SettingsStore().recentFiles().size(), 2) << "what is gone leaves the list";
    menu->actions().back()->trigger();
    EXPECT_TRUE(SettingsStore().recentFiles().isEmpty());
    EXPECT_FALSE(menu->isEnabled());
}

} // namespace
} // namespace bask::test
