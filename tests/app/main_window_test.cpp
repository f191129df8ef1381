// The window's own promises: buttons follow the engine, edits are refused during a run, closing asks, starts
// need the tick.

#include "app/settings_store.h"
#include "engine/base/message_code.h"
#include "engine/experiment/experiment_file.h"
#include "engine/experiment/rig_file.h"
#include "engine/model/mounting_check.h"
#include "engine/recording/session_file.h"
#include "tests/app/window_fixture.h"
#include "tests/support/fake_opener.h"
#include "widgets/calibrate/live_picture.h"
#include "widgets/common/display.h"
#include "widgets/common/message_bar.h"
#include "widgets/common/object_tile.h"
#include "widgets/common/quantity_spin_box.h"
#include "widgets/common/run_state_chip.h"
#include "widgets/objects/objects_page.h"
#include "widgets/plots/plot_place.h"
#include "widgets/plots/trace_plot.h"
#include "widgets/review/replay_view.h"
#include "widgets/review/review_page.h"
#include "widgets/review/session_list.h"
#include "widgets/run/run_page.h"
#include "widgets/targets/reach_bar.h"
#include "widgets/targets/reach_map.h"
#include "widgets/targets/targets_page.h"

#include <QAbstractButton>
#include <QAction>
#include <QCheckBox>
#include <QComboBox>
#include <QDialog>
#include <QDir>
#include <QDoubleSpinBox>
#include <QFile>
#include <QHeaderView>
#include <QLabel>
#include <QLayout>
#include <QLineEdit>
#include <QMenu>
#include <QMessageBox>
#include <QOpenGLWidget>
#include <QSplitter>
#include <QSqlDatabase>
#include <QSqlQuery>
#include <QStatusBar>
#include <QTabWidget>
#include <QTemporaryDir>
#include <QTreeWidget>
#include <QUrl>

#include <algorithm>

namespace bask::test {
namespace {

class MainWindowTest : public WindowTest {
protected:
    void arm() {
        ASSERT_NO_FATAL_FAILURE(goFast());
        ASSERT_TRUE(waitForState(RunState::Ready));
        click("armButton");
        ASSERT_TRUE(waitForState(RunState::Armed));
    }
    QString message() { return window->findChild<MessageBar*>(QStringLiteral("messageBar"))->sentence(); }
};

// Catches: a verb enabled by what a button hoped for rather than by the reported state.
TEST_F(MainWindowTest, ButtonsFollowTheReportedState) {
    openWindow();
    for (const char* name : {"startButton", "holdButton", "stopRunButton"})
        EXPECT_FALSE(find<QAbstractButton>(name)->isEnabled()) << name;
    ASSERT_NO_FATAL_FAILURE(arm());
    EXPECT_FALSE(find<QAbstractButton>("armButton")->isEnabled());
    EXPECT_TRUE(find<QAbstractButton>("startButton")->isEnabled());
    click("stopRunButton"); // while armed: disarm
    ASSERT_TRUE(waitForState(RunState::Ready));
    EXPECT_TRUE(find<QAbstractButton>("armButton")->isEnabled());
    EXPECT_FALSE(find<QAbstractButton>("startButton")->isEnabled());
}

// Catches: an export whose file has to be looked for, and buttons that stay at a message about something
// else.
TEST_F(MainWindowTest, WhatWasExportedIsOpenedFromItsMessage) {
    openWindow();
    const FakeOpener desktop;
    window->pages().desktop().setOpener(desktop.opener());
    const QTemporaryDir folder;
    QFile file(folder.filePath(QStringLiteral("two.csv")));
    ASSERT_TRUE(file.open(QIODevice::WriteOnly));
    file.close();
    emit window->files().exported(QStringLiteral("two.csv written to exports"), {file.fileName()});
    EXPECT_EQ(message(), QStringLiteral("two.csv written to exports"));
    const auto button = [&](const char* name) {
        return find<MessageBar>("messageBar")->findChild<QAbstractButton*>(QLatin1String(name));
    };
    EXPECT_EQ(button("messageAction")->text(), QStringLiteral("Open"));
    EXPECT_EQ(button("messageOther")->text(), QStringLiteral("Show in folder"));
    EXPECT_TRUE(button("messageOther")->isVisible());
    QTest::mouseClick(button("messageAction"), Qt::LeftButton);
    EXPECT_TRUE(waitFor([&] { return desktop.asked() == QUrl::fromLocalFile(file.fileName()); }));
    emit window->files().exported(QStringLiteral("Session saved"), {QStringLiteral("/nowhere/evening.bask")});
    QTest::mouseClick(button("messageAction"), Qt::LeftButton);
    EXPECT_TRUE(waitFor([&] { return message().contains(QStringLiteral("evening.bask")); })) << "read here";
    EXPECT_EQ(desktop.asked(), QUrl::fromLocalFile(file.fileName())) << "not by the desktop";
    window->pages().showNote(QStringLiteral("Something else."));
    EXPECT_FALSE(button("messageAction")->isVisible());
    EXPECT_FALSE(button("messageOther")->isVisible());
}

// Catches: a message over what the engine is about to do by itself, whichever comes first.
TEST_F(MainWindowTest, NoMessageCoversACountdown) {
    openWindow({1024, 600});
    auto* countdown = find<QWidget>("countdownBar");
    Snapshot calm = window->lastSnapshot();
    calm.newSamples.clear();
    calm.newEvents.clear();
    Snapshot pending = calm;
    pending.pending =
        PendingAction{{MessageCode::ActionEndRun, {}}, {MessageCode::ReasonSourcePoseLost, {}}, 9.0};
    const QString words = QStringLiteral("Start was refused, and this is why. ").repeated(80);
    const auto isFree = [&](const QPoint& place) {
        const QWidget* on = window->pages().childAt(countdown->mapTo(&window->pages(), place));
        return on == countdown || countdown->isAncestorOf(on);
    };
    for (const bool isMessageFirst : {true, false}) {
        window->pages().messages().clear();
        window->pages().apply(calm);
        if (isMessageFirst)
            window->pages().showProblem(words);
        window->pages().apply(pending);
        if (!isMessageFirst)
            window->pages().showProblem(words);
        window->pages().layout()->activate();
        ASSERT_TRUE(countdown->isVisible());
        ASSERT_TRUE(find<MessageBar>("messageBar")->isVisible());
        for (const QPoint& place : {countdown->rect().center(), countdown->rect().topLeft() + QPoint(2, 2),
                                    countdown->rect().bottomRight() - QPoint(2, 2)})
            EXPECT_TRUE(isFree(place)) << place.x() << ", " << place.y() << ", " << isMessageFirst;
    }
}

// Catches: Start has the keyboard, cannot be pressed any more, and the next Space is for Stop.
TEST_F(MainWindowTest, TheKeyboardDoesNotSlideFromStartToStop) {
    openWindow();
    ASSERT_NO_FATAL_FAILURE(arm());
    find<QWidget>("startButton")->setFocus(Qt::TabFocusReason);
    QTest::keyClick(window->focusWidget(), Qt::Key_Space);
    ASSERT_TRUE(waitForState(RunState::Running));
    EXPECT_EQ(window->focusWidget(), find<QWidget>("runStateChip"));
}

// Catches a run that its page does not predict, a prediction that goes at Arm or Start, and one that outlives
// an edit.
TEST_F(MainWindowTest, TheRunIsPredictedBeforeStart) {
    openWindow();
    auto* plot = find<TracePlot>("plot.measured_K");
    ASSERT_NE(plot, nullptr);
    const RunForecast& forecast = window->pages().forecast();
    window->pages().show(Page::Rig);
    ASSERT_TRUE(waitForState(RunState::Ready));
    EXPECT_FALSE(waitFor([&] { return forecast.isPending() || !plot->predictedPoints(0).isEmpty(); },
                         2 * RunForecast::kRest_ms))
        << "nobody looks";
    window->pages().show(Page::Run);
    ASSERT_TRUE(waitFor([&] { return !plot->predictedPoints(0).isEmpty(); }));
    EXPECT_TRUE(find<QCheckBox>("showPrediction")->isVisible());
    keepPicture(QStringLiteral("run-predicted"));
    const QList<QPointF> predicted = plot->predictedPoints(0);
    EXPECT_NEAR(predicted.front().y(), 25.0, 1.0);
    ASSERT_NO_FATAL_FAILURE(startRun(20));
    EXPECT_EQ(plot->predictedPoints(0), predicted);
    keepPicture(QStringLiteral("run-predicted-run"));
    ASSERT_TRUE(window->document().setTargets(std::vector<double>(3, 312.0)));
    EXPECT_TRUE(plot->predictedPoints(0).isEmpty()) << "it was for other targets";
}

// Catches a run that is started from another page and has no prediction, without a word.
TEST_F(MainWindowTest, ARunWithoutPredictionSaysWhy) {
    openWindow();
    window->pages().show(Page::Targets);
    window->pages().forecast().setExperiment(window->document().experiment()); // as an edit there does
    ASSERT_TRUE(waitForState(RunState::Ready));
    window->actions().verb(Verb::Arm)->trigger();
    ASSERT_TRUE(waitForState(RunState::Armed));
    window->actions().verb(Verb::Start)->trigger();
    EXPECT_EQ(window->pages().page(), Page::Run);
    EXPECT_TRUE(message().contains(QStringLiteral("has no prediction"))) << message().toStdString();
    EXPECT_TRUE(waitForState(RunState::Running)) << "it does not wait for that";
}

// Catches a plot on a second screen that loses its prediction with the page, or is never given one.
TEST_F(MainWindowTest, APlotInItsWindowIsPredictedToo) {
    openWindow();
    window->pages().show(Page::Rig);
    auto* plot = find<TracePlot>("plot.measured_K");
    ASSERT_NE(plot, nullptr);
    for (PlotPlace* place : window->findChildren<PlotPlace*>())
        if (place->plot() == plot)
            place->takeOut();
    EXPECT_TRUE(waitFor([&] { return !plot->predictedPoints(0).isEmpty(); }));
    EXPECT_FALSE(window->pages().run()->isVisible());
}

TEST_F(MainWindowTest, HoldBecomesResume) {
    openWindow();
    ASSERT_NO_FATAL_FAILURE(arm());
    click("startButton");
    ASSERT_TRUE(waitForState(RunState::Running));
    click("holdButton");
    ASSERT_TRUE(waitForState(RunState::Holding));
    EXPECT_EQ(find<QAbstractButton>("holdButton")->text().remove(u'&'), QStringLiteral("Resume"));
    click("holdButton");
    EXPECT_TRUE(waitForState(RunState::Running));
}

// Catches: controls of the surfaces that a small window cuts off, in any of their states and in the longer
// language.
TEST_F(MainWindowTest, TheSurfacesControlsFitASmallWindow) {
    openWindow({1100, 700});
    window->pages().show(Page::Targets);
    auto* view = find<QWidget>("targetScene")->parentWidget();
    const auto look = [&](const QString& name) {
        keepPicture(QStringLiteral("surfaces-") + name);
        EXPECT_EQ(window->width(), 1100) << "it grew " << qPrintable(name);
        const auto* sides = qobject_cast<QSplitter*>(find<QWidget>("targetViews")->parentWidget());
        ASSERT_NE(sides, nullptr);
        EXPECT_LE(sides->widget(0)->geometry().right(), sides->widget(1)->x())
            << "the table covers them " << qPrintable(name);
        for (QWidget* part : view->findChildren<QWidget*>()) {
            if (!part->isVisible() || part->parentWidget()->inherits("QComboBox"))
                continue;
            const QRect place(part->mapTo(view, QPoint()), part->size());
            EXPECT_TRUE(view->rect().contains(place)) << qPrintable(part->objectName() + name);
            const auto* box = qobject_cast<QComboBox*>(part);
            const auto* label = qobject_cast<QLabel*>(part);
            if (box != nullptr || qobject_cast<QAbstractButton*>(part) != nullptr) {
                EXPECT_GE(part->width(), part->sizeHint().width()) << qPrintable(part->objectName() + name);
            }
            if (label != nullptr) {
                EXPECT_GE(part->width(), label->wordWrap() ? 0 : part->sizeHint().width())
                    << qPrintable(part->objectName() + name);
                EXPECT_GE(part->height(), part->heightForWidth(part->width()))
                    << qPrintable(part->objectName() + name);
            }
        }
        EXPECT_GE(find<QWidget>("targetScene")->height(), 200) << qPrintable(name);
    };
    auto* space = find<QComboBox>("surfaceSpace");
    auto* object = find<QComboBox>("cutObject");
    for (const char* language : {"en", "fr"}) {
        window->setLanguage(QLatin1String(language));
        for (int i = 0; i < space->count(); ++i) {
            space->setCurrentIndex(i);
            object->setCurrentIndex(2);
            const QString name = QLatin1String(language) + QString::number(i);
            look(name + QStringLiteral("-cut"));
            object->setCurrentIndex(0);
            QWidget* scene = find<QWidget>("targetScene")->findChild<QOpenGLWidget*>();
            if (scene == nullptr)
                continue;
            const auto isPicked = [&] { // the surfaces may still be on their way
                for (int y = 30; y < 60 && !find<QWidget>("startHere")->isVisible(); y += 5)
                    QTest::mouseClick(scene, Qt::LeftButton, {},
                                      {scene->width() / 2, scene->height() * y / 100});
                return find<QWidget>("startHere")->isVisible();
            };
            ASSERT_TRUE(waitFor(isPicked)) << qPrintable(name);
            look(name + QStringLiteral("-picked"));
        }
    }
    window->setTheme(Theme::Dark);
    look(QStringLiteral("dark"));
}

// Catches: a text size that is chosen and forgotten, or changes half of the window at once.
TEST_F(MainWindowTest, TextSizeIsKeptForTheNextStart) {
    openWindow();
    const QFont before = window->font();
    for (QAction* action : window->findChildren<QAction*>(QStringLiteral("textSize")))
        if (action->data().toInt() == 200)
            action->trigger();
    EXPECT_EQ(SettingsStore().textSize_percent(), 200);
    EXPECT_EQ(window->font(), before);
    const auto notes = window->findChildren<QLabel*>();
    EXPECT_TRUE(std::ranges::any_of(notes, [](const QLabel* label) {
        return label->isVisible() && label->text().contains(QStringLiteral("next start"));
    }));
}

// Catches: another experiment slipped in under a run.
TEST_F(MainWindowTest, OpeningAnExperimentDuringARunIsRefusedInWords) {
    openWindow();
    ASSERT_NO_FATAL_FAILURE(arm());
    const Experiment before = window->document().experiment();
    window->files().setFileChooser(
        [](const FileQuestion&) { return QStringLiteral(BASK_EXAMPLES "/two-circles.json"); });
    QTest::keyClick(window.get(), Qt::Key_O, Qt::ControlModifier);
    EXPECT_TRUE(waitFor([this] { return message().contains(QStringLiteral("A run is on")); }));
    EXPECT_EQ(window->document().experiment(), before);
    EXPECT_EQ(state(), RunState::Armed);
}

// Catches: a bad file that replaces the experiment, or a refusal without file and reason.
TEST_F(MainWindowTest, ABadFileIsRefusedAndNothingChanges) {
    openWindow();
    const Experiment before = window->document().experiment();
    const QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("bad.json"));
    QFile file(path);
    ASSERT_TRUE(file.open(QIODevice::WriteOnly));
    file.write("{\"format\": \"bask-experiment\", \"version\": 1, \"colour\": \"red\"}");
    file.close();
    window->files().open(path);
    ASSERT_TRUE(waitFor([this] { return !message().isEmpty(); }));
    EXPECT_TRUE(message().contains(QStringLiteral("bad.json"))) << message().toStdString();
    EXPECT_TRUE(message().contains(QStringLiteral("colour"))) << message().toStdString();
    EXPECT_EQ(window->document().experiment(), before);
}

// Catches: a run started on a target out of reach without the tick, or a tick that is not asked for.
TEST_F(MainWindowTest, AnUnreachableTargetNeedsTheTick) {
    openWindow();
    ASSERT_TRUE(window->document().setTargets({kelvinFromCelsius(118.0), 313.15, 313.15}).ok());
    ASSERT_TRUE(waitFor([this] { return !window->pages().judge().isStale(); }));
    ASSERT_NO_FATAL_FAILURE(arm());
    click("startButton");
    QDialog* dialog = nullptr;
    ASSERT_TRUE(waitFor([&] {
        dialog = window->findChild<QDialog*>(QStringLiteral("infeasibleDialog"));
        return dialog != nullptr;
    }));
    EXPECT_EQ(state(), RunState::Armed);
    auto* start = dialog->findChild<QAbstractButton*>(QStringLiteral("startAnyway"));
    EXPECT_FALSE(start->isEnabled());
    keepPicture(QStringLiteral("infeasible-dialog"));
    auto* tick = dialog->findChild<QCheckBox*>(QStringLiteral("acceptInfeasible"));
    QTest::keyClick(tick, Qt::Key_Space);
    QTest::mouseClick(start, Qt::LeftButton);
    EXPECT_TRUE(waitForState(RunState::Running));
}

// Catches: maps of pairs that never come to the page, ones that do not follow its fields, and a pick that
// does not become the experiment's targets. Keeps pictures.
TEST_F(MainWindowTest, PairsAreMappedOnTheTargetsPage) {
    openWindow();
    window->pages().show(Page::Targets);
    find<QTabWidget>("targetViews")->setCurrentIndex(1);
    auto* map = find<ReachMap>("map0");
    ASSERT_TRUE(waitFor([map] { return map->words().endsWith(QStringLiteral("inside")); }));
    const std::vector<ObjectSpec> before = window->document().experiment().objects;
    const QPoint place = map->rect().center();
    QTest::mouseDClick(map, Qt::LeftButton, {}, place);
    const std::vector<ObjectSpec> after = window->document().experiment().objects;
    EXPECT_NE(after[0].target_K, before[0].target_K);
    EXPECT_NE(after[1].target_K, before[1].target_K);
    EXPECT_EQ(after[2].target_K, before[2].target_K);
    EXPECT_TRUE(map->words().startsWith(QStringLiteral("Checking")));
    auto* field = find<QuantitySpinBox>("target0");
    field->setFocus();
    field->selectAll();
    QTest::keyClicks(field, QStringLiteral("99"));
    QTest::keyClick(field, Qt::Key_Return);
    const auto placed = [map] { return map->words().endsWith(QStringLiteral("outside")); };
    ASSERT_TRUE(waitFor(placed)) << map->words().toStdString();
    keepPicture(QStringLiteral("pairs-light"));
    window->setTheme(Theme::Dark);
    keepPicture(QStringLiteral("pairs-dark"));
    window->setLanguage(QStringLiteral("fr"));
    window->setTheme(Theme::Light);
    window->resize(1600, 1000);
    keepPicture(QStringLiteral("pairs-french"));
    EXPECT_TRUE(map->words().contains(QStringLiteral("extérieur")));
}

// Catches: targets that can be edited while the engine refuses them, so that the next run has others than the
// page shows; a start pose that is moved during a run.
TEST_F(MainWindowTest, TargetsAreLockedWhileTheEngineRefusesThem) {
    openWindow();
    ASSERT_NO_FATAL_FAILURE(arm());
    auto* field = find<QuantitySpinBox>("target0");
    auto* start = find<QWidget>("startHere");
    EXPECT_TRUE(field->isEnabled());
    EXPECT_FALSE(start->isEnabled());
    Snapshot stopping = window->lastSnapshot();
    stopping.state = RunState::Stopping;
    window->pages().apply(stopping);
    EXPECT_FALSE(field->isEnabled());
    stopping.state = RunState::Stopped;
    window->pages().apply(stopping);
    EXPECT_TRUE(field->isEnabled());
    EXPECT_TRUE(start->isEnabled());
}

// Catches: a start pose taken from the Targets page that the next edit on the Objects page undoes; a window
// that goes with edits to be undone and crashes on its way.
TEST_F(MainWindowTest, AStartPoseOutlivesAnEditOfObjects) {
    openWindow();
    Vector6d pose = window->document().experiment().start;
    pose[kZ] += 0.01;
    emit window->findChild<TargetsPage*>()->startWanted(pose);
    ASSERT_TRUE(window->document().experiment().start.isApprox(pose));
    window->pages().show(Page::Objects);
    click("addDisk");
    EXPECT_TRUE(window->document().experiment().start.isApprox(pose));
}

// Catches: dragged targets that stay on the page when the drag is broken off, ticks of the experiment before,
// and a predicted time of the controller before.
TEST_F(MainWindowTest, ThePageShowsNothingOfWhatIsPast) {
    openWindow();
    window->pages().show(Page::Targets);
    auto* page = window->findChild<TargetsPage*>();
    auto* detail = find<QLabel>("jointDetail");
    const auto predicted = [&] { return detail->text().contains(QStringLiteral("has settled after")); };
    ASSERT_TRUE(waitFor(predicted));
    const QString before = detail->text();
    window->pages().show(Page::Run);
    ControllerSettings other = window->document().experiment().controller;
    other.kind = ControllerKind::ModelBased; // slower
    ASSERT_TRUE(window->document().setController(other).ok());
    window->pages().show(Page::Targets);
    EXPECT_FALSE(predicted()) << detail->text().toStdString();
    EXPECT_TRUE(waitFor([&] { return !detail->text().contains(QStringLiteral("Predicting")); }));
    EXPECT_NE(detail->text(), before);

    find<QCheckBox>("keep1")->click();
    const std::vector<double> own_K = page->targets_K();
    auto* bar = find<ReachBar>("reach0");
    const int middle = bar->height() / 2;
    for (int x = 0; x < bar->width() && page->targets_K() == own_K; x += 8) {
        QTest::mousePress(bar, Qt::LeftButton, {}, {x, middle});
        QMouseEvent move(QEvent::MouseMove, QPointF(x + 60, middle),
                         bar->mapToGlobal(QPointF(x + 60, middle)), Qt::NoButton, Qt::LeftButton, {});
        QApplication::sendEvent(bar, &move);
    }
    EXPECT_NE(page->targets_K(), own_K);
    window->pages().show(Page::Run);
    EXPECT_EQ(page->targets_K(), own_K);
    window->document().open(window->document().experiment(), {});
    EXPECT_EQ(page->kept(), std::vector<bool>(own_K.size()));
}

// Catches: a window that closes over a run without asking, or whose safe answer is not to stay.
TEST_F(MainWindowTest, ClosingDuringARunAsks) {
    openWindow();
    ASSERT_NO_FATAL_FAILURE(arm());
    click("startButton");
    ASSERT_TRUE(waitForState(RunState::Running));
    bool asked = false;
    QTimer answer;
    QObject::connect(&answer, &QTimer::timeout, [&] {
        if (QWidget* box = QApplication::activeModalWidget()) {
            asked = box->objectName() == QStringLiteral("closeQuestion");
            QTest::keyClick(box, Qt::Key_Return); // the default answer
        }
    });
    answer.start(20);
    EXPECT_FALSE(window->close());
    EXPECT_TRUE(asked);
    EXPECT_EQ(state(), RunState::Running);
}

// Catches a recording after a run that is ended by closing, without a word.
TEST_F(MainWindowTest, ClosingBeforeAllIsColdAsks) {
    openWindow();
    ASSERT_NO_FATAL_FAILURE(startRun(5));
    click("stopButton");
    ASSERT_TRUE(waitFor([this] { return window->lastSnapshot().isRecordedUntilCold; }));
    QString asked;
    QTimer answer;
    QObject::connect(&answer, &QTimer::timeout, [&] {
        if (auto* box = qobject_cast<QMessageBox*>(QApplication::activeModalWidget())) {
            asked = box->objectName() + u' ' + box->text();
            QTest::keyClick(box, Qt::Key_Return); // the default answer
        }
    });
    answer.start(20);
    EXPECT_FALSE(window->close());
    EXPECT_TRUE(asked.startsWith(QStringLiteral("recordingQuestion"))) << asked.toStdString();
    EXPECT_TRUE(asked.contains(QStringLiteral("\u00a0°C"))) << "how far it is";
}

// Catches objects that are left standing over a hot source by a window that closes at once.
TEST_F(MainWindowTest, ClosingCanWaitForTheRetreat) {
    openWindow();
    ASSERT_NO_FATAL_FAILURE(goFast());
    ASSERT_NO_FATAL_FAILURE(arm());
    click("startButton");
    ASSERT_TRUE(waitForState(RunState::Running));
    window->setCloseQuestion([] { return Closing::Keep; });
    EXPECT_FALSE(window->close());
    EXPECT_EQ(state(), RunState::Running);
    window->setCloseQuestion([] { return Closing::Stop; });
    EXPECT_FALSE(window->close());
    EXPECT_TRUE(window->isVisible());
    ASSERT_TRUE(waitFor([this] { return !window->isVisible(); }));
    EXPECT_EQ(state(), RunState::Stopped);
    EXPECT_FALSE(window->lastSnapshot().heatOn);
}

// Catches a file of the command line that is refused without a word, since the example is opened after it.
TEST_F(MainWindowTest, ADamagedSessionOfTheCommandLineIsTold) {
    const QTemporaryDir folder;
    const QString path = folder.filePath("cut.bask");
    QFile file(path);
    ASSERT_TRUE(file.open(QIODevice::WriteOnly) && file.write(QByteArray(1000, 'x')) == 1000);
    file.close();
    openWindow({1280, 800}, path);
    ASSERT_TRUE(waitFor(
        [this] { return find<MessageBar>("messageBar")->sentence().contains(QStringLiteral("cut.bask")); }));
    EXPECT_FALSE(window->document().experiment().objects.empty());
}

// Catches damage that is found while a run is shown first, and is told only until it is shown.
TEST_F(MainWindowTest, ASampleThatIsMissingIsToldWhenTheRunIsOpened) {
    openWindow();
    const QTemporaryDir folder;
    const QString path = folder.filePath("holed.bask");
    auto writer = SessionWriter::create(path.toStdString(), window->document().experiment(), true);
    ASSERT_TRUE(writer);
    TraceSample sample;
    sample.objects.resize(window->document().experiment().objects.size());
    for (int i = 0; i < 600; ++i) { // the first 512 have an overview, and are read when they are looked at
        sample.time_s = 0.1 * i;
        ASSERT_TRUE((*writer)->add(sample));
    }
    ASSERT_TRUE((*writer)->finish("stopped"));
    writer->reset();
    {
        QSqlDatabase database = QSqlDatabase::addDatabase(QStringLiteral("QSQLITE"), path);
        database.setDatabaseName(path);
        ASSERT_TRUE(database.open());
        QSqlQuery query(database);
        ASSERT_TRUE(query.exec(QStringLiteral("DELETE FROM step WHERE number = 5")));
    }
    QSqlDatabase::removeDatabase(path);
    window->files().open(path);
    ASSERT_TRUE(waitFor([this] { return window->pages().page() == Page::Review; }));
    EXPECT_TRUE(waitFor([this] { return message().contains(QStringLiteral("holed.bask")); }))
        << message().toStdString();
}

// Catches: one changed value of a recording that the window shows without a word, and runs that are selected
// together and not laid over each other.
TEST_F(MainWindowTest, AnAlteredRunSaysSoWhereverItIsShown) {
    openWindow();
    const QTemporaryDir folder;
    const auto record = [&](const char* name) {
        QString path = folder.filePath(QLatin1String(name));
        auto writer = SessionWriter::create(path.toStdString(), window->document().experiment(), true);
        EXPECT_TRUE(writer);
        TraceSample sample;
        sample.objects.resize(window->document().experiment().objects.size());
        for (int i = 0; i < 40; ++i) {
            sample.time_s = i;
            EXPECT_TRUE((*writer)->add(sample));
        }
        EXPECT_TRUE((*writer)->finish("stopped"));
        return path;
    };
    const auto alter = [](const QString& path) {
        {
            QSqlDatabase database = QSqlDatabase::addDatabase(QStringLiteral("QSQLITE"), path);
            database.setDatabaseName(path);
            EXPECT_TRUE(database.open());
            QSqlQuery query(database);
            EXPECT_TRUE(query.exec(QStringLiteral("UPDATE step SET measured_K_1 = 300 WHERE number = 12")));
        }
        QSqlDatabase::removeDatabase(path);
    };
    const QString whole = record("whole.bask"), changed = record("changed.bask"), late = record("late.bask");
    alter(changed);
    const auto* altered = window->pages().review()->findChild<MessageBar*>(QStringLiteral("sessionAltered"));
    window->files().open(changed);
    ASSERT_TRUE(waitFor([&] { return altered->sentence().contains(QStringLiteral("row 12, at 0:11")); }));
    EXPECT_EQ(find<QLabel>("outcomeWord")->text(), QStringLiteral("Altered"));
    window->files().open(whole);
    const auto* verdict = window->pages().review()->findChild<QLabel*>(QStringLiteral("factVerification"));
    ASSERT_TRUE(waitFor([&] { return verdict->text().startsWith(QStringLiteral("Intact")); }));
    EXPECT_TRUE(altered->isHidden());
    emit window->pages().review()->sessions()->comparisonRequested(whole, {late, changed});
    EXPECT_TRUE(waitFor([&] { return message().contains(QStringLiteral("changed.bask: Altered")); }));
    EXPECT_TRUE(altered->isHidden()) << "the open one is not";
    alter(late); // which was verified before the other
    emit window->pages().review()->sessions()->closeRequested(late);
    EXPECT_TRUE(waitFor([&] { return message().contains(QStringLiteral("late.bask: Altered")); }))
        << "what was let go of is verified again";
}

// Catches: a run that is opened for an alarm and begins at Start, and one that begins where another one was
// left, or at an alarm that could not be opened.
TEST_F(MainWindowTest, ARunOpenedForAnAlarmBeginsAtIt) {
    openWindow();
    const QTemporaryDir folder;
    const Experiment& experiment = window->document().experiment();
    const QString path = folder.filePath(QStringLiteral("run.bask"));
    {
        auto writer = SessionWriter::create(path.toStdString(), experiment, true);
        ASSERT_TRUE(writer);
        TraceSample sample;
        sample.objects.resize(experiment.objects.size());
        for (int k = 0; k <= 60; ++k) {
            sample.time_s = k;
            ASSERT_TRUE((*writer)->add(sample));
        }
        const std::string object = experiment.objects[0].name;
        ASSERT_TRUE((*writer)->add(TraceEvent{42.0, {MessageCode::SafetyObjectHot, {object, "91", "90"}}}));
        ASSERT_TRUE((*writer)->finish("fault"));
    }
    ReviewPage* review = window->pages().review();
    window->files().setFileChooser([&](const FileQuestion&) { return folder.path(); });
    window->pages().show(Page::Review);
    emit review->sessions()->folderRequested();
    ASSERT_TRUE(waitFor([&] { return review->sessions()->listed().size() == 1; }));
    click("sessionAlarms");
    auto* runs = find<QTreeWidget>("alarmHistoryRuns");
    ASSERT_TRUE(waitFor([&] { return runs->topLevelItemCount() == 1; }));
    click("alarmHistoryOpen");
    ASSERT_TRUE(waitFor([&] { return find<QLabel>("sessionFile")->text() == QStringLiteral("run.bask"); }));
    EXPECT_NEAR(review->replay()->position_s(), 42.0, 0.01);
    ASSERT_TRUE(QFile::rename(path, path + QStringLiteral(".away")));
    click("alarmHistoryOpen");
    ASSERT_TRUE(waitFor([this] { return message().contains(QStringLiteral("run.bask")); }));
    ASSERT_TRUE(QFile::rename(path + QStringLiteral(".away"), path));
    ASSERT_NO_FATAL_FAILURE(openRecording(path));
    EXPECT_EQ(review->replay()->position_s(), 0.0) << "not for an alarm";
}

// Catches: the experiment of a run that is not the open one's, takes its place in a file, or comes in under a
// run.
TEST_F(MainWindowTest, TheExperimentOfTheOpenRunOpensAsANewOne) {
    openWindow();
    const QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("yesterday.bask"));
    Experiment ran = window->document().experiment();
    ran.title = "as it ran yesterday";
    ran.objects[0].target_K += 1.0;
    {
        auto writer = SessionWriter::create(path.toStdString(), ran, true);
        ASSERT_TRUE(writer);
        TraceSample sample;
        sample.objects.resize(ran.objects.size());
        ASSERT_TRUE((*writer)->add(sample));
        ASSERT_TRUE((*writer)->finish("stopped"));
    }
    window->files().open(path);
    ASSERT_TRUE(waitFor([this] { return window->pages().page() == Page::Review; }));
    find<QComboBox>("reviewDetails")->setCurrentIndex(4);
    click("useExperiment");
    EXPECT_EQ(window->document().experiment().title, ran.title);
    EXPECT_DOUBLE_EQ(window->document().experiment().objects[0].target_K, ran.objects[0].target_K);
    EXPECT_TRUE(window->document().path().isEmpty());
    EXPECT_TRUE(window->document().modified());
    EXPECT_TRUE(message().contains(QStringLiteral("yesterday.bask"))) << message().toStdString();

    ASSERT_NO_FATAL_FAILURE(arm());
    window->pages().show(Page::Review);
    click("useExperiment");
    EXPECT_TRUE(waitFor([this] { return message().contains(QStringLiteral("A run is on")); }))
        << message().toStdString();
}

// Catches: runs that have to be sorted again at each start, and a search of yesterday that hides today's.
TEST_F(MainWindowTest, TheOrderOfTheRunsIsRememberedAndTheSearchIsNot) {
    const auto list = [this] { return window->pages().review()->sessions(); };
    openWindow();
    EXPECT_EQ(list()->sorting(), QStringLiteral("recorded descending"));
    window->pages().show(Page::Review);
    find<QLineEdit>("sessionSearch")->setText(QStringLiteral("hand"));
    const QHeaderView* header = find<QTreeWidget>("sessionTree")->header();
    QCoreApplication::processEvents(); // the page is laid out
    const int duration = 3;
    const QPoint middle(header->sectionViewportPosition(duration) + header->sectionSize(duration) / 2,
                        header->height() / 2);
    ASSERT_TRUE(header->viewport()->rect().contains(middle));
    QTest::mouseClick(header->viewport(), Qt::LeftButton, {}, middle);
    EXPECT_EQ(list()->sorting(), QStringLiteral("duration"));
    closeWindow();
    openWindow();
    EXPECT_EQ(list()->sorting(), QStringLiteral("duration"));
    EXPECT_TRUE(find<QLineEdit>("sessionSearch")->text().isEmpty());
}

// Catches a window that marks no runs, leaves the mark of one that it ended, or tells no one of a crash.
TEST_F(MainWindowTest, ARunThatWasCutOffIsToldAndOpened) {
    const auto marks = [] { return QDir(runMarkFolder()).entryList({QStringLiteral("*.run")}, QDir::Files); };
    openWindow();
    ASSERT_NO_FATAL_FAILURE(arm());
    EXPECT_TRUE(marks().isEmpty());
    click("startButton");
    ASSERT_TRUE(waitForState(RunState::Running));
    EXPECT_EQ(marks().size(), 1);
    const Experiment experiment = window->document().experiment();
    closeWindow();
    EXPECT_TRUE(marks().isEmpty());

    const QTemporaryDir folder;
    const QString recording = folder.filePath(QStringLiteral("cut-off.bask"));
    ASSERT_TRUE(SessionWriter::create(recording.toStdString(), experiment, true)); // never finished
    QFile mark(QDir(runMarkFolder()).filePath(QStringLiteral("1-1.run")));
    ASSERT_TRUE(mark.open(QIODevice::WriteOnly));
    mark.write(recording.toUtf8());
    mark.close();
    openWindow();
    auto* bar = find<MessageBar>("cutOffBar");
    ASSERT_TRUE(waitFor([&] { return bar->sentence().contains(QStringLiteral("simulated run")); }));
    QTest::mouseClick(bar->findChild<QAbstractButton*>(QStringLiteral("messageAction")), Qt::LeftButton);
    EXPECT_TRUE(waitFor([this] { return window->pages().page() == Page::Review; }));
    EXPECT_EQ(find<QLabel>("sessionFile")->text(), QStringLiteral("cut-off.bask"));
    EXPECT_FALSE(bar->isVisible());
    EXPECT_TRUE(marks().isEmpty());
}

// Catches: an undone or refused edit that the engine still has, and edits that are possible while armed.
TEST_F(MainWindowTest, ObjectsCannotBeChangedWhileArmed) {
    openWindow();
    ASSERT_NO_FATAL_FAILURE(arm());
    window->pages().show(Page::Objects);
    EXPECT_FALSE(find<QAbstractButton>("addDisk")->isEnabled());
    EXPECT_FALSE(window->actions().newExperiment->isEnabled());
}

TEST_F(MainWindowTest, TheChipSaysWhyNotReady) {
    openWindow();
    auto* chip = find<RunStateChip>("runStateChip");
    if (state() == RunState::NotReady) {
        ASSERT_FALSE(chip->reasons().isEmpty());
        EXPECT_TRUE(chip->reasons().first().contains(QStringLiteral("Ready in")))
            << chip->reasons().first().toStdString();
    }
    EXPECT_TRUE(waitForState(RunState::Ready));
    EXPECT_TRUE(chip->reasons().isEmpty());
}

// Catches: a remedy in the chip's list that does nothing after a stop, and a reason whose page is there
// already and that leads nowhere.
TEST_F(MainWindowTest, TheChipsRemedyDoesWhatItSays) {
    openWindow();
    ASSERT_TRUE(waitForState(RunState::Ready));
    auto* chip = find<RunStateChip>("runStateChip");
    QAction* reset = window->actions().verb(Verb::Reset);
    EXPECT_FALSE(chip->reasonsMenu()->actions().contains(reset));
    QTest::keyClick(window.get(), Qt::Key_F12);
    ASSERT_TRUE(waitForState(RunState::Fault));
    ASSERT_TRUE(waitFor([&] { return chip->reasonsMenu()->actions().contains(reset); }));
    EXPECT_EQ(chip->caption(), QStringLiteral("STOP was pressed")) << "the state's word is that of a fault";
    auto* tabs = find<QTabWidget>("dockTabs");
    tabs->setCurrentIndex(1);
    ASSERT_EQ(window->pages().page(), Page::Run);
    chip->reasonsMenu()->actions().front()->trigger();
    EXPECT_EQ(tabs->currentIndex(), 0) << "the alarm that it is about";
    reset->trigger();
    EXPECT_TRUE(waitForState(RunState::Ready));
    EXPECT_TRUE(waitFor([&] { return !chip->reasonsMenu()->actions().contains(reset); }));
}

TEST_F(MainWindowTest, KeysSwitchPages) {
    openWindow();
    for (int i = 0; i < kPages; ++i) {
        QTest::keyClick(window.get(), static_cast<Qt::Key>(Qt::Key_1 + i), Qt::ControlModifier);
        EXPECT_EQ(static_cast<int>(window->pages().page()), i);
        EXPECT_TRUE(window->actions().page(i)->isChecked());
    }
}

// Catches: a Calibrate page that is not connected: no picture, one that goes on being made while nobody
// looks, a robot that is not sent, a measured place that does not reach the experiment and the engine.
TEST_F(MainWindowTest, TheCalibratePageMeasuresTheCamerasPlace) {
    openWindow();
    ASSERT_NO_FATAL_FAILURE(goFast());
    auto experiment = readExperiment(BASK_EXAMPLES "/moving-source.json");
    ASSERT_TRUE(experiment.ok());
    experiment->source.tracked = false; // it stands still here
    experiment->simulation.sourceMotion = {};
    ASSERT_TRUE(window->document().edit(*experiment).ok());
    ASSERT_TRUE(waitFor([&] { return window->lastSnapshot().latest.objects.size() == 2; }));
    ASSERT_TRUE(waitForState(RunState::Ready));
    window->pages().show(Page::Calibrate);
    auto* picture = find<LivePicture>("livePicture");
    ASSERT_TRUE(waitFor([&] { return picture->accessibleDescription().contains("marker 10"); }))
        << picture->accessibleDescription().toStdString();
    find<QTabWidget>("calibrateTabs")->setCurrentIndex(1);
    click("placeTour");
    EXPECT_TRUE(waitFor([&] { return window->lastSnapshot().isMoving; }));
    auto* use = find<QAbstractButton>("placeUse");
    ASSERT_TRUE(waitFor([&] { return use->isEnabled(); }))
        << find<QWidget>("rigPanel")->findChild<QLabel*>("surveyStatus")->text().toStdString();
    const auto before = window->document().experiment().vision.cameraPose;
    use->click();
    EXPECT_NE(window->document().experiment().vision.cameraPose, before);
    click("sourceMeasure");
    auto* useSource = find<QAbstractButton>("sourceUse");
    ASSERT_TRUE(waitFor([&] { return useSource->isEnabled(); }))
        << find<QWidget>("rigPanel")->findChild<QLabel*>("surveyStatus")->text().toStdString();
    keepPicture(QStringLiteral("calibrate-rig"));
    const auto loadId = window->lastSnapshot().loadId;
    useSource->click();
    EXPECT_FALSE(window->document().experiment().vision.sourcePoseDate.empty());
    EXPECT_LT(window->document().experiment().source.pose.head<3>().norm(), 0.01);
    EXPECT_EQ(message(), QString());

    ASSERT_TRUE(waitFor([&] { return window->lastSnapshot().loadId != loadId; })); // with the source there
    ASSERT_NO_FATAL_FAILURE(arm());
    window->pages().show(Page::Calibrate);
    EXPECT_TRUE(waitFor([&] {
        return find<QWidget>("rigPanel")->findChild<QLabel*>("surveyStatus")->text().contains("armed");
    }));
    EXPECT_FALSE(find<QAbstractButton>("placeTour")->isEnabled());
}

// Catches: a Rig page that is not connected: steps that do not reach the robot, limits that do not reach the
// other pages, a robot that can be moved while a run is armed.
TEST_F(MainWindowTest, TheRigPageMovesTheRobotAndSetsLimits) {
    openWindow();
    ASSERT_NO_FATAL_FAILURE(goFast());
    ASSERT_TRUE(waitForState(RunState::Ready));
    QTest::keyClick(window.get(), Qt::Key_1, Qt::ControlModifier);
    ASSERT_EQ(window->pages().page(), Page::Rig);
    const double before = window->lastSnapshot().latest.coordinates[kX];
    find<QComboBox>("stepLength")->setCurrentIndex(2);
    click("stepUp.x");
    EXPECT_TRUE(waitFor(
        [&] { return std::abs(window->lastSnapshot().latest.coordinates[kX] - before - 0.01) < 2e-4; }));
    find<QDoubleSpinBox>("goTo.x")->setValue(1e9); // the workspace's end
    click("goToPose");
    const double last = window->document().experiment().robot.upper[kX];
    EXPECT_TRUE(
        waitFor([&] { return std::abs(window->lastSnapshot().latest.coordinates[kX] - last) < 2e-4; }));

    ASSERT_TRUE(waitForState(RunState::Ready));
    click("armButton");
    ASSERT_TRUE(waitForState(RunState::Armed));
    EXPECT_FALSE(find<QAbstractButton>("stepUp.x")->isEnabled());
    EXPECT_FALSE(find<QDoubleSpinBox>("upper.z")->isEnabled());
    click("stopRunButton"); // disarms
    ASSERT_TRUE(waitForState(RunState::Ready));
    EXPECT_TRUE(find<QAbstractButton>("stepUp.x")->isEnabled());

    find<QTabWidget>("rigTabs")->setCurrentIndex(1);
    find<QDoubleSpinBox>("upper.z")->setValue(260.0);
    EXPECT_NEAR(window->document().experiment().robot.upper[kZ], 0.26, 1e-12);
    window->pages().show(Page::Objects); // an edit there must not undo it
    click("addDisk");
    EXPECT_NEAR(window->document().experiment().robot.upper[kZ], 0.26, 1e-12);
}

// Catches: an object that takes its neighbour's sensor, or cannot be added or removed at all, on a real rig.
TEST_F(MainWindowTest, ChannelsFollowTheObjects) {
    openWindow();
    Experiment experiment = window->document().experiment();
    experiment.rig.emplace().thermometer.emplace().driver = "stream";
    experiment.rig->thermometer->port = "/dev/none";
    experiment.rig->thermometer->channels = {4, 2, 0};
    experiment.objects.back().target_K = experiment.objects.front().target_K;
    window->document().open(experiment, {});
    window->pages().objects()->selectObject(0);
    window->pages().show(Page::Objects);
    click("removeObject");
    const auto& rig = window->document().experiment().rig;
    ASSERT_TRUE(rig);
    EXPECT_EQ(rig->thermometer->channels, (std::vector{2, 0}));
    click("addDisk");
    EXPECT_EQ(window->document().experiment().rig->thermometer->channels, (std::vector{2, 0, 1}));
}

// Catches: a rig file that is taken for an experiment when it is double-clicked, or put in before there are
// objects.
TEST_F(MainWindowTest, ARigFileOpensFromTheCommandLine) {
    const QTemporaryDir folder;
    RigSpec rig;
    rig.name = "bench";
    ASSERT_TRUE(writeRigFile(rig, folder.filePath(QStringLiteral("bench.json")).toStdString()));
    openWindow({1280, 800}, folder.filePath(QStringLiteral("bench.json")));
    ASSERT_TRUE(waitFor([this] { return window->document().experiment().rig.has_value(); }));
    EXPECT_EQ(window->document().experiment().rig->name, "bench");
    EXPECT_EQ(window->document().experiment().objects.size(), 3U);
    EXPECT_TRUE(find<QTabWidget>("rigTabs")->isVisible());
}

// Catches: a real rig that is armed by one click, ages of its devices that nobody sees, a rig that is said to
// be simulated.
TEST_F(MainWindowTest, ALiveRigIsArmedAfterAQuestion) {
    openWindow();
    ASSERT_NO_FATAL_FAILURE(goFast());
    ASSERT_TRUE(waitForState(RunState::Ready));
    const auto seeLive = [this] { // as a real rig would be told
        Snapshot live = window->lastSnapshot();
        live.simulated = false;
        live.source_K = 473.15;
        live.heat = HeatState::Unknown;
        live.simulationSpeed = 20.0;
        live.newSamples.clear();
        for (const DeviceRole role : {DeviceRole::Robot, DeviceRole::HeatSource}) {
            live.devices.emplace_back().role = role;
            live.devices.back().status.link = LinkState::Live;
            live.devices.back().age_s = 0.012;
        }
        live.devices.back().status.link = LinkState::Lost;
        emit window->engine().snapshot(live);
    };
    const auto question = [this] { return window->findChild<QMessageBox*>(QStringLiteral("armQuestion")); };
    seeLive();
    EXPECT_EQ(find<QLabel>("sampleAge")->text(), QStringLiteral("robot 12 ms, heat source lost"));
    EXPECT_EQ(find<QLabel>("sourceState")->text(), QStringLiteral("source 200.0\u00a0°C,"));
    EXPECT_EQ(find<QLabel>("heatWord")->text(), QStringLiteral("heat UNKNOWN")) << "its link is lost";
    EXPECT_FALSE(find<QLabel>("loopRate")->text().contains(QStringLiteral("×"))) << "nothing is simulated";
    EXPECT_EQ(find<QFrame>("rigTag")->accessibleName(), QStringLiteral("LIVE"));
    window->actions().verb(Verb::Arm)->trigger();
    ASSERT_TRUE(question());
    EXPECT_FALSE(question()->isModal());         // STOP stays within reach
    QTest::keyClick(question(), Qt::Key_Return); // the default answer
    QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
    EXPECT_FALSE(question());
    EXPECT_EQ(state(), RunState::Ready);
    seeLive();
    window->actions().verb(Verb::Arm)->trigger();
    ASSERT_TRUE(question());
    for (QAbstractButton* button : question()->buttons())
        if (question()->buttonRole(button) == QMessageBox::AcceptRole)
            QTest::mouseClick(button, Qt::LeftButton);
    EXPECT_TRUE(waitForState(RunState::Armed));
}

// Catches: a run with plates that overlap, started without a word.
TEST_F(MainWindowTest, ArmAsksAboutObjectsThatOverlap) {
    openWindow();
    ASSERT_TRUE(waitForState(RunState::Ready));
    Experiment edited = window->document().experiment();
    ASSERT_GE(edited.objects.size(), 2U);
    edited.objects[1].shape = edited.objects[0].shape;
    edited.objects[1].mounting = edited.objects[0].mounting;
    edited.objects[1].mounting[kX] += 0.01;
    ASSERT_EQ(overlapsInPlane(edited).size(), 1U);
    ASSERT_TRUE(window->document().edit(edited).ok());
    ASSERT_TRUE(waitForState(RunState::Ready));
    window->actions().verb(Verb::Arm)->trigger();
    auto* question = window->findChild<QMessageBox*>(QStringLiteral("armQuestion"));
    ASSERT_TRUE(question);
    EXPECT_TRUE(question->text().contains(QStringLiteral("overlap; move one of them. Are they mounted")))
        << question->text().toStdString();
    EXPECT_EQ(question->textFormat(), Qt::PlainText) << "names from files are in it";
    QTest::keyClick(question, Qt::Key_Return); // the default answer
    EXPECT_EQ(state(), RunState::Ready);
}

// Catches: "Nothing stands in the way" over plates that overlap or targets that cannot be held, of which Arm
// and Start then ask.
TEST_F(MainWindowTest, ReadyTellsWhatWillBeAsked) {
    openWindow();
    ASSERT_TRUE(waitForState(RunState::Ready));
    const auto* chip = find<RunStateChip>("runStateChip");
    const auto told = [&] { return chip->reasonsMenu()->actions().front()->text(); };
    const auto isTold = [&](const char* words) {
        return waitFor([&] { return state() == RunState::Ready && told().contains(QLatin1String(words)); });
    };
    ASSERT_TRUE(isTold("Nothing stands in the way")) << told().toStdString();
    const std::vector<double> before_K = window->lastSnapshot().targets_K;
    ASSERT_TRUE(window->document().setTargets({kelvinFromCelsius(118.0), 313.15, 313.15}).ok());
    EXPECT_FALSE(told().contains(QStringLiteral("Nothing"))) << "it is not known yet";
    EXPECT_EQ(chip->caption(), QString()) << "it is not known yet";
    ASSERT_TRUE(isTold("Start asks about it")) << told().toStdString();
    EXPECT_EQ(chip->caption(), QStringLiteral("cannot be held"));
    EXPECT_TRUE(told().contains(messageText(window->pages().judge().verdict()->reason)));
    ASSERT_TRUE(window->document().setTargets(before_K).ok());
    ASSERT_TRUE(isTold("Nothing stands in the way")) << told().toStdString();
    EXPECT_EQ(chip->caption(), QString());

    Experiment edited = window->document().experiment();
    edited.objects[1].shape = edited.objects[0].shape;
    edited.objects[1].mounting = edited.objects[0].mounting;
    edited.objects[1].mounting[kX] += 0.01;
    ASSERT_TRUE(window->document().edit(edited).ok());
    ASSERT_TRUE(isTold("Ready, but: circle and bunny overlap; move one of them. Arm asks about it."))
        << told().toStdString();
    EXPECT_EQ(chip->caption(), QStringLiteral("objects overlap"));
    EXPECT_FALSE(told().contains(QStringLiteral("Nothing")));
    qsizetype lines = 0;
    for (const QAction* line : chip->reasonsMenu()->actions())
        lines += line->text().count(QStringLiteral("overlap"));
    EXPECT_EQ(lines, 1) << "once";
}

// Catches: targets that cannot be held, of which the chip speaks in *Ready* and no more once armed.
TEST_F(MainWindowTest, ArmedTellsWhatStartWillAsk) {
    openWindow();
    ASSERT_TRUE(waitForState(RunState::Ready));
    const auto* chip = find<RunStateChip>("runStateChip");
    ASSERT_TRUE(window->document().setTargets({kelvinFromCelsius(118.0), 313.15, 313.15}).ok());
    const auto isTold = [&] {
        return chip->caption() == QStringLiteral("cannot be held") &&
               std::ranges::any_of(chip->reasonsMenu()->actions(), [](const QAction* line) {
                   return line->text().contains(QStringLiteral("Start asks about it"));
               });
    };
    ASSERT_TRUE(waitFor(isTold)) << chip->caption().toStdString();
    QTest::keyClick(window.get(), Qt::Key_F5);
    ASSERT_TRUE(waitForState(RunState::Armed));
    EXPECT_TRUE(waitFor(isTold)) << chip->caption().toStdString();
}

// Catches: a key or a click that does nothing and says nothing, and a sentence that stays when it is no more
// so.
TEST_F(MainWindowTest, AVerbThatCannotActSaysWhy) {
    openWindow();
    ASSERT_TRUE(waitForState(RunState::Ready));
    QTest::keyClick(window.get(), Qt::Key_F6);
    EXPECT_TRUE(message().contains(QStringLiteral("Press Arm first"))) << message().toStdString();
    EXPECT_EQ(state(), RunState::Ready);
    QTest::keyClick(window.get(), Qt::Key_E, Qt::ControlModifier); // nothing is recorded yet
    EXPECT_TRUE(window->statusBar()->currentMessage().contains(QStringLiteral("no recording to save yet")))
        << window->statusBar()->currentMessage().toStdString();
    QTest::mouseClick(find<QAbstractButton>("stopRunButton"), Qt::LeftButton);
    EXPECT_TRUE(message().contains(QStringLiteral("no run to stop"))) << message().toStdString();
    QTest::keyClick(window.get(), Qt::Key_F6);
    ASSERT_TRUE(message().contains(QStringLiteral("Press Arm first")));
    QTest::keyClick(window.get(), Qt::Key_F5); // which is possible
    ASSERT_TRUE(waitForState(RunState::Armed));
    EXPECT_EQ(message(), QString()) << "its cause is gone";
    QTest::keyClick(window.get(), Qt::Key_F5);
    EXPECT_TRUE(message().contains(QStringLiteral("armed already"))) << message().toStdString();
}

// Catches: "Not ready" said over a rig that is ready again.
TEST_F(MainWindowTest, ARefusalGoesWithItsCause) {
    openWindow();
    ASSERT_TRUE(waitForState(RunState::Ready));
    Snapshot told = window->lastSnapshot();
    told.newSamples.clear();
    told.newEvents.clear();
    told.state = RunState::NotReady;
    const Message lost{MessageCode::ReasonSensorInvalid, {"hand"}};
    told.reasons = {lost};
    told.refusal = lost;
    window->engine().blockSignals(true); // the engine's own go on
    const auto tell = [&] {
        window->engine().blockSignals(false);
        emit window->engine().snapshot(told);
        window->engine().blockSignals(true);
        told.refusal = {};
    };
    tell();
    EXPECT_TRUE(message().contains(QStringLiteral("hand"))) << message().toStdString();
    tell();
    EXPECT_TRUE(message().contains(QStringLiteral("hand")));
    told.reasons = {{MessageCode::ReasonRecorderFailed, {"full"}}}; // another one
    tell();
    EXPECT_EQ(message(), QString());
    window->engine().blockSignals(false);
}

// Catches: a robot that moves at one slip of the mouse, and a retreat that cannot be asked for.
TEST_F(MainWindowTest, RetreatAsksAndKeepsStopWithinReach) {
    openWindow();
    ASSERT_TRUE(waitForState(RunState::Ready));
    ASSERT_TRUE(waitFor([this] { return window->lastSnapshot().canRetreat; }));
    const auto question = [this] {
        return window->findChild<QMessageBox*>(QStringLiteral("retreatQuestion"));
    };
    click("retreatButton");
    ASSERT_TRUE(question());
    EXPECT_FALSE(question()->isModal());
    QTest::keyClick(question(), Qt::Key_Return); // the default answer
    QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
    ASSERT_FALSE(question());
    EXPECT_EQ(state(), RunState::Ready);
    const double before_m = window->lastSnapshot().latest.coordinates[kZ];
    click("retreatButton");
    ASSERT_TRUE(question());
    for (QAbstractButton* button : question()->buttons())
        if (question()->buttonRole(button) == QMessageBox::AcceptRole)
            QTest::mouseClick(button, Qt::LeftButton);
    EXPECT_TRUE(waitFor([&] { return window->lastSnapshot().latest.coordinates[kZ] > before_m + 0.01; }));
}

// Catches: a question that stays open over another state, and is answered in it.
TEST_F(MainWindowTest, AQuestionGoesWithTheStateItWasAskedIn) {
    openWindow();
    ASSERT_NO_FATAL_FAILURE(startRun(2));
    click("stopButton");
    ASSERT_TRUE(waitForState(RunState::Fault));
    const auto question = [this] {
        return window->findChild<QMessageBox*>(QStringLiteral("retreatQuestion"));
    };
    ASSERT_TRUE(waitFor([this] { return window->lastSnapshot().canRetreat; }));
    click("retreatButton");
    ASSERT_TRUE(question());
    EXPECT_TRUE(question()->text().startsWith(QStringLiteral("The robot will move"))) << "nothing moves yet";
    click("resetButton");
    EXPECT_TRUE(waitFor([&] { return question() == nullptr; }));
    EXPECT_TRUE(message().contains(QStringLiteral("Retreat"))) << message().toStdString();
    EXPECT_TRUE(waitForState(RunState::Ready));
}

// Catches: a rig that is armed, or moved by hand, behind "Are all hands off the robot?", and an answer that
// is no longer awaited but still said to be.
TEST_F(MainWindowTest, NothingBeginsWhileAMotionIsAskedAbout) {
    openWindow();
    ASSERT_TRUE(waitForState(RunState::Ready));
    const auto question = [this](const char* name = "retreatQuestion") {
        return window->findChild<QMessageBox*>(QLatin1String(name));
    };
    const auto isRefused = [this] { return message().contains(QStringLiteral("\"Retreat\" is open")); };
    click("retreatButton");
    ASSERT_TRUE(question());
    click("armButton");
    EXPECT_TRUE(isRefused()) << message().toStdString();
    ASSERT_TRUE(question());
    EXPECT_EQ(state(), RunState::Ready);
    emit window->pages().commandIssued(SetHeat{400.0});
    emit window->pages().commandIssued(MoveTo{window->lastSnapshot().latest.coordinates});
    find<QAbstractButton>("homeRobot")->click();
    EXPECT_FALSE(question("homeQuestion"));
    EXPECT_TRUE(isRefused()) << message().toStdString();
    QTest::keyClick(question(), Qt::Key_Return); // the default answer
    EXPECT_TRUE(waitFor([&] { return message().isEmpty(); })) << message().toStdString();
    EXPECT_EQ(state(), RunState::Ready);
    EXPECT_FALSE(window->lastSnapshot().heatSetPoint_K);

    click("armButton");
    ASSERT_TRUE(waitForState(RunState::Armed));
    click("retreatButton");
    ASSERT_TRUE(question());
    click("startButton");
    EXPECT_TRUE(isRefused()) << message().toStdString();
    EXPECT_EQ(state(), RunState::Armed);
    click("stopRunButton"); // ends something
    EXPECT_TRUE(waitForState(RunState::Ready));
    EXPECT_TRUE(waitFor([&] { return question() == nullptr; }));
}

// Catches: an armed rig that is retreated by an answer to what was asked before, as when a recipe arms it.
TEST_F(MainWindowTest, TheQuestionOfRetreatGoesWithArm) {
    openWindow();
    Snapshot told = freeze();
    told.canRetreat = true;
    emit window->engine().snapshot(told);
    const auto question = [this] {
        return window->findChild<QMessageBox*>(QStringLiteral("retreatQuestion"));
    };
    window->actions().verb(Verb::Retreat)->trigger();
    ASSERT_TRUE(question());
    told.state = RunState::NotReady;
    emit window->engine().snapshot(told);
    EXPECT_TRUE(question()) << "robot at rest, as before";
    told.state = RunState::Armed;
    emit window->engine().snapshot(told);
    EXPECT_FALSE(question());
    EXPECT_TRUE(message().contains(QStringLiteral("Retreat"))) << message().toStdString();
}

// Catches: a rig that is armed by the key that refreshes a list in other programs, and a key that two have
// and neither hears.
TEST_F(MainWindowTest, F5OnReviewReadsTheListAgain) {
    openWindow();
    ASSERT_TRUE(waitForState(RunState::Ready));
    const auto isListed = [this] {
        return window->statusBar()->currentMessage() == QStringLiteral("List of runs is up to date");
    };
    const auto tipHasTheKey = [this] {
        return window->actions().verb(Verb::Arm)->toolTip().contains(QStringLiteral("F5"));
    };
    EXPECT_TRUE(tipHasTheKey());
    QTest::keyClick(window.get(), Qt::Key_6, Qt::ControlModifier);
    EXPECT_FALSE(tipHasTheKey());
    QTest::keyClick(window.get(), Qt::Key_F5);
    EXPECT_TRUE(waitFor(isListed, 10000));
    EXPECT_EQ(state(), RunState::Ready);

    QTest::keyClick(window.get(), Qt::Key_5, Qt::ControlModifier);
    EXPECT_TRUE(tipHasTheKey());
    QTest::keyClick(window.get(), Qt::Key_F5);
    ASSERT_TRUE(waitForState(RunState::Armed));
    QTest::keyClick(window.get(), Qt::Key_6, Qt::ControlModifier);
    window->statusBar()->clearMessage();
    QTest::keyClick(window.get(), Qt::Key_F5);
    EXPECT_TRUE(waitFor(isListed, 10000)) << "Arm is not possible now";
    EXPECT_EQ(message(), QString());
    QTest::keyClick(window.get(), Qt::Key_1, Qt::ControlModifier);
    QTest::keyClick(window.get(), Qt::Key_F5);
    EXPECT_TRUE(message().contains(QStringLiteral("armed already"))) << message().toStdString();
}

// Catches: a robot that is homed by an answer that was meant for another state.
TEST_F(MainWindowTest, TheQuestionOfHomeGoesWithItsState) {
    openWindow();
    Snapshot told = freeze();
    const auto question = [this] { return window->findChild<QMessageBox*>(QStringLiteral("homeQuestion")); };
    const auto ask = [&] {
        told.state = RunState::Ready;
        emit window->engine().snapshot(told);
        find<QAbstractButton>("homeRobot")->click(); // of the page Rig, as the action
        emit window->engine().snapshot(told);
    };
    for (const RunState other : {RunState::Armed, RunState::Fault, RunState::NotReady}) {
        ask();
        ASSERT_TRUE(question());
        EXPECT_TRUE(question()->text().startsWith(QStringLiteral("The robot will move"))) << "not yet";
        told.state = other;
        emit window->engine().snapshot(told);
        EXPECT_EQ(question() != nullptr, other == RunState::NotReady) << "robot at rest, as before";
    }
    told.place = PlaceState::Unknown; // it does not answer
    emit window->engine().snapshot(told);
    EXPECT_FALSE(question());
    EXPECT_TRUE(message().contains(QStringLiteral("Home the robot"))) << message().toStdString();
}

// Catches: "Ready" alone over a hot plate.
TEST_F(MainWindowTest, ReadyOverAHotSourceSaysSo) {
    openWindow();
    Snapshot told = freeze();
    auto* chip = find<RunStateChip>("runStateChip");
    told.source_K = told.latest.source_K = kelvinFromCelsius(212.0);
    told.sourceAge_s = 0.1;
    for (ObjectSample& object : told.latest.objects)
        object.viewFactor = 0.2;
    told.heat = HeatState::Off;
    emit window->engine().snapshot(told);
    EXPECT_FALSE(chip->caption().contains(QStringLiteral("over hot source"))) << "its shutter is closed";
    told.simulated = false;
    emit window->engine().snapshot(told);
    EXPECT_EQ(chip->caption(), QStringLiteral("over hot source: 212\u00a0°C")) << "not: too cold, below 212";
    EXPECT_TRUE(chip->reasonsMenu()->actions().at(2)->text().contains(QStringLiteral("Retreat")));
    told.isAway = true;
    emit window->engine().snapshot(told);
    EXPECT_EQ(chip->caption(), QString()) << "a retreat takes them no further";
    told.isAway = false;
    for (ObjectSample& object : told.latest.objects)
        object.viewFactor = 0.001; // away from it
    emit window->engine().snapshot(told);
    EXPECT_EQ(chip->caption(), QString());
}

// Catches: "ready in 5 s" while something else stands in the way as well.
TEST_F(MainWindowTest, ReadyInASecondIsSaidOnlyWhereNothingElseIsMissing) {
    openWindow();
    Snapshot told = freeze();
    const auto* chip = find<RunStateChip>("runStateChip");
    told.state = RunState::NotReady;
    told.heat = HeatState::Off;
    told.reasons = {{MessageCode::ReasonEstimatorFilling, {"5"}}};
    emit window->engine().snapshot(told);
    EXPECT_EQ(chip->caption(), QStringLiteral("ready in 5 s"));
    told.reasons.push_back({MessageCode::RobotPlaceUnsure, {}});
    emit window->engine().snapshot(told);
    EXPECT_FALSE(chip->caption().contains(QStringLiteral("ready in"))) << chip->caption().toStdString();
}

// Catches: a Start with a cold source of which nobody was told what it costs.
TEST_F(MainWindowTest, AColdSourceIsToldBeforeStart) {
    openWindow();
    Snapshot told = freeze();
    ASSERT_TRUE(told.warmUp);
    auto* chip = find<RunStateChip>("runStateChip");
    const auto notes = [&] {
        QStringList lines;
        for (const QAction* line : chip->reasonsMenu()->actions())
            lines << line->text();
        return lines.join(u'\n');
    };
    told.source_K = told.latest.source_K = kelvinFromCelsius(25.0);
    told.sourceAge_s = 0.1;
    told.warmUp = SourceWarmUp{kelvinFromCelsius(200.0), 213.3};
    for (const RunState before : {RunState::Ready, RunState::Armed, RunState::Stopped}) {
        told.state = before;
        emit window->engine().snapshot(told);
        EXPECT_EQ(chip->caption(), QStringLiteral("source 25 of 200\u00a0\u00b0C")) << runStateName(before);
        EXPECT_TRUE(notes().contains(QStringLiteral("Start does not wait for it"))) << notes().toStdString();
        EXPECT_TRUE(notes().contains(QStringLiteral("about 3:40")));
    }
    told.warmUp->in_s.reset();
    emit window->engine().snapshot(told);
    EXPECT_TRUE(notes().contains(QStringLiteral("not known")));
    EXPECT_EQ(find<QLabel>("sourceTileTemperature")->text(), QStringLiteral("25.0\u00a0\u00b0C"));
    EXPECT_EQ(find<QLabel>("sourceTileSetPoint")->text(), QStringLiteral("200.0\u00a0\u00b0C"));
    told.state = RunState::Running;
    emit window->engine().snapshot(told);
    EXPECT_EQ(chip->caption(), QString());
    EXPECT_FALSE(notes().contains(QStringLiteral("Start does not wait")));
}

// Catches: pages that call good what was told before the engine hung.
TEST_F(MainWindowTest, PagesGreyWhatASilentEngineToldLast) {
    openWindow();
    ASSERT_TRUE(waitForState(RunState::Ready));
    auto* tile = find<ObjectTile>("objectTile.0");
    EXPECT_NE(tile->activity(), ObjectActivity::SensorStale);
    emit window->engine().answeringChanged(false);
    EXPECT_EQ(tile->activity(), ObjectActivity::SensorStale);
    emit window->engine().answeringChanged(true);
    EXPECT_TRUE(waitFor([&] { return tile->activity() != ObjectActivity::SensorStale; }));
}

// Catches: a change lost by closing.
TEST_F(MainWindowTest, AChangedExperimentIsSavedAndRemembered) {
    openWindow();
    ASSERT_TRUE(window->document().setTargets({318.15, 313.15, 313.15}).ok());
    EXPECT_TRUE(window->isWindowModified());
    const QTemporaryDir folder;
    window->files().setFileChooser(
        [&](const FileQuestion&) { return folder.filePath(QStringLiteral("mine")); });
    QTest::keyClick(window.get(), Qt::Key_S, Qt::ControlModifier);
    EXPECT_FALSE(window->isWindowModified());
    EXPECT_TRUE(window->windowTitle().contains(QStringLiteral("mine.json")));
    const auto read = readExperiment(folder.filePath(QStringLiteral("mine.json")).toStdString());
    ASSERT_TRUE(read.ok());
    EXPECT_NEAR(read->objects[0].target_K, 318.15, 1e-9);
    EXPECT_EQ(SettingsStore().recentFiles().value(0), folder.filePath(QStringLiteral("mine.json")));
}

// Catches a row of the alarm table that nobody can raise from the menu, or that has no name there; and
// one that does not reach the engine.
TEST_F(MainWindowTest, EveryFaultCanBeSimulated) {
    openWindow();
    for (int i = 1; i < kSimulatedFaults; ++i) {
        const auto fault = static_cast<SimulatedFault>(i);
        const QString name = QLatin1String(simulatedFaultName(fault));
        if (isOfObject(fault)) {
            const auto* menu = window->findChild<QMenu*>(name);
            ASSERT_NE(menu, nullptr) << qPrintable(name);
            EXPECT_FALSE(menu->title().isEmpty()) << qPrintable(name);
            EXPECT_EQ(menu->actions().size(), 3) << qPrintable(name);
        } else {
            const auto* action = window->findChild<QAction*>(name);
            ASSERT_NE(action, nullptr) << qPrintable(name);
            EXPECT_FALSE(action->text().isEmpty()) << qPrintable(name);
        }
    }
    auto* alarm = window->findChild<QAction*>(QStringLiteral("robot-alarm"));
    auto* restore = window->findChild<QAction*>(QStringLiteral("restoreDevices"));
    EXPECT_FALSE(restore->isEnabled());
    alarm->trigger();
    EXPECT_TRUE(waitForState(RunState::Fault));
    EXPECT_TRUE(waitFor([alarm] { return alarm->isChecked(); }));
    EXPECT_TRUE(find<QWidget>("faultWord")->isVisible());
    EXPECT_TRUE(std::ranges::any_of(
        find<RunStateChip>("runStateChip")->reasonsMenu()->actions(), [](const QAction* line) {
            return line->text().startsWith(QStringLiteral("Simulated faults are active: Robot"));
        }));
    alarm->trigger(); // ends it
    EXPECT_TRUE(waitFor([alarm] { return !alarm->isChecked(); }));
    EXPECT_FALSE(find<QWidget>("faultWord")->isVisible());
    alarm->trigger();
    ASSERT_TRUE(waitFor([restore] { return restore->isEnabled(); }));
    restore->trigger();
    EXPECT_TRUE(waitFor([alarm] { return !alarm->isChecked(); }));
    click("resetButton");
    EXPECT_TRUE(waitFor([this] { return state() == RunState::Ready; }));
}

} // namespace
} // namespace bask::test
