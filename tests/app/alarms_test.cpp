// Alarms as a person meets them in the window, and what goes on while the window is busy or behind a dialog.

#include "app/bottom_dock.h"
#include "engine/base/message_code.h"
#include "engine/recording/session_file.h"
#include "tests/app/window_fixture.h"
#include "widgets/common/alarm_button.h"
#include "widgets/review/review_page.h"
#include "widgets/review/session_list.h"

#include <QAction>
#include <QDialog>
#include <QElapsedTimer>
#include <QLineEdit>
#include <QMessageBox>
#include <QPushButton>
#include <QSignalSpy>
#include <QTabBar>
#include <QTabWidget>
#include <QThread>
#include <QTimer>
#include <QTreeWidget>

namespace bask::test {
namespace {

class AlarmsTest : public WindowTest {
protected:
    /// With samples at 10 Hz, as the promises of time are made for.
    void openAt10Hz() {
        openWindow();
        Experiment experiment = window->document().experiment();
        experiment.sampling.period_s = 0.1;
        ASSERT_TRUE(window->document().edit(experiment).ok());
        ASSERT_TRUE(waitForState(RunState::NotReady) && waitForState(RunState::Ready));
    }
    QTabWidget* tabs() { return find<QTabWidget>("dockTabs"); }
    QTreeWidget* rows() { return find<QTreeWidget>("alarmListTree"); }
    AlarmButton* bar() { return find<AlarmButton>("alarmButton"); }
    bool isInFront() { return rows()->isVisible(); }
    QString cell(int row, int column) {
        const QTreeWidgetItem* item = rows()->topLevelItem(row);
        return item != nullptr ? item->text(column) : QString();
    }
    void trigger(const char* action) { window->findChild<QAction*>(QLatin1String(action))->trigger(); }
    void atRealSpeed() {
        window->engine().send(SetSimulationSpeed{1.0});
        ASSERT_TRUE(waitFor([this] { return window->lastSnapshot().simulationSpeed == 1.0; }));
    }
};

// Catches: an alarm that nobody sees, or that takes the keyboard from who types; one that goes before it was
// seen, or stays for good.
TEST_F(AlarmsTest, IsSeenAtOnceAndLeavesOverAndAcknowledged) {
    ASSERT_NO_FATAL_FAILURE(openAt10Hz());
    EXPECT_FALSE(bar()->isVisible());
    EXPECT_FALSE(isInFront());
    EXPECT_FALSE(window->actions().acknowledgeAlarms->isEnabled());
    auto* note = find<QLineEdit>("noteEdit");
    note->setFocus();
    trigger("robot-alarm");
    EXPECT_TRUE(waitFor([&] { return bar()->isVisible() && rows()->topLevelItemCount() > 0; }));
    EXPECT_TRUE(isInFront());
    EXPECT_TRUE(note->hasFocus());
    EXPECT_EQ(QApplication::activeModalWidget(), nullptr);
    EXPECT_TRUE(cell(0, 1).startsWith(QStringLiteral("Active, new"))) << cell(0, 1).toStdString();
    EXPECT_TRUE(cell(0, 4).startsWith(QStringLiteral("The robot reports alarm"))) << cell(0, 4).toStdString();
    EXPECT_EQ(tabs()->tabText(0), QStringLiteral("Alarms (%1)").arg(window->lastSnapshot().alarms.size()));

    tabs()->setCurrentIndex(1);
    click("alarmButton");
    EXPECT_TRUE(isInFront());
    click("acknowledgeAlarm");
    EXPECT_TRUE(waitFor([&] { return cell(0, 1).startsWith(QStringLiteral("Active, seen")); }));
    EXPECT_TRUE(bar()->isVisible());
    trigger("restoreDevices");
    click("resetButton");
    EXPECT_TRUE(waitFor([&] { return rows()->topLevelItemCount() == 0 && !bar()->isVisible(); }));
    EXPECT_EQ(tabs()->tabText(0), QStringLiteral("Alarms"));
}

// Catches: the tab Events under the pointer that moves away when an alarm comes.
TEST(BottomDockTest, TabsStayWhereTheyAreWhenAnAlarmComes) {
    BottomDock dock;
    dock.resize(900, 200);
    dock.show();
    const auto* tabs = dock.findChild<QTabWidget*>(QStringLiteral("dockTabs"));
    const auto left = [&] {
        QCoreApplication::processEvents();
        return tabs->tabBar()->tabRect(1).left();
    };
    Snapshot snapshot;
    dock.apply(snapshot);
    const int before = left();
    Alarm alarm;
    alarm.key = "SafetyDiskLow";
    alarm.message = {MessageCode::SafetyDiskLow, {"12", "100"}};
    for (std::uint64_t id = 1; id <= 12; ++id) {
        alarm.id = id;
        alarm.key += 'x';
        snapshot.alarms.push_back(alarm);
        dock.apply(snapshot);
        ASSERT_NEAR(left(), before, 1) << id << " alarms"; // widths are rounded
    }
}

// Catches: alarms of earlier runs that nobody finds beside the list.
TEST_F(AlarmsTest, AllAlarmsAreBesideTheList) {
    ASSERT_NO_FATAL_FAILURE(openAt10Hz());
    click("allAlarmsButton");
    EXPECT_EQ(window->pages().page(), Page::Review);
    EXPECT_TRUE(waitFor([this] { return window->findChild<QDialog*>("alarmHistoryDialog") != nullptr; }));
}

// Catches: alarms of earlier runs that open over another page, since the list of runs was waited for.
TEST_F(AlarmsTest, AllAlarmsDoNotFollowToAnotherPage) {
    ASSERT_NO_FATAL_FAILURE(openAt10Hz());
    QSignalSpy listed(window->pages().review()->sessions(), &SessionList::sessionsChanged);
    click("allAlarmsButton");
    window->pages().show(Page::Run);
    ASSERT_TRUE(waitFor([&] { return listed.count() > 0; }));
    EXPECT_EQ(window->findChild<QDialog*>("alarmHistoryDialog"), nullptr);
}

// Catches: temperatures inside sentences that stay in degC, of an alarm, of an event and of a recorded run,
// also those that are on the screen when another unit is chosen.
TEST_F(AlarmsTest, SpeakTheUnitThatTheReaderChose) {
    ASSERT_NO_FATAL_FAILURE(openAt10Hz());
    const auto speaks = [](const QTreeWidgetItem* row, int column, const char* unit) {
        const QString text = row != nullptr ? row->text(column) : QString();
        return text.contains(QString::fromUtf8(unit));
    };
    trigger("fahrenheit");
    ASSERT_NO_FATAL_FAILURE(goFast());
    window->engine().send(SimulateFault{SimulatedFault::ObjectHot, 0});
    ASSERT_TRUE(waitFor([&] { return bar()->isVisible() && rows()->topLevelItemCount() > 0; }));
    auto* const events = find<BottomDock>("eventDock")->findChild<QTreeWidget*>("eventListTree");
    const auto lastEvent = [&] {
        const auto found = events->findItems(QStringLiteral("warning limit"), Qt::MatchContains, 2);
        return found.isEmpty() ? nullptr : found.front();
    };
    ASSERT_TRUE(waitFor([&] { return lastEvent() != nullptr; }));
    EXPECT_TRUE(speaks(rows()->topLevelItem(0), 4, "\u00a0\u00b0F,")) << cell(0, 4).toStdString();
    EXPECT_FALSE(speaks(rows()->topLevelItem(0), 4, "\u00b0C")) << cell(0, 4).toStdString();
    EXPECT_TRUE(bar()->text().contains(QString::fromUtf8("\u00b0F"))) << bar()->text().toStdString();
    EXPECT_TRUE(speaks(lastEvent(), 2, "\u00a0\u00b0F,")) << lastEvent()->text(2).toStdString();
    trigger("kelvin");
    EXPECT_TRUE(speaks(rows()->topLevelItem(0), 4, "\u00a0K,")) << cell(0, 4).toStdString();
    EXPECT_TRUE(speaks(lastEvent(), 2, "\u00a0K,")) << lastEvent()->text(2).toStdString();

    const QTemporaryDir folder;
    QString path = folder.filePath(QStringLiteral("hot.bask"));
    auto writer = SessionWriter::create(path.toStdString(), window->document().experiment(), true);
    ASSERT_TRUE(writer);
    ASSERT_TRUE((*writer)->add(TraceEvent{1.0, {MessageCode::SafetyObjectWarm, {"disk", "100", "90"}}}));
    ASSERT_TRUE((*writer)->finish("stopped"));
    writer->reset();
    window->files().setFileChooser([&](const FileQuestion&) { return path; });
    QTest::keyClick(window.get(), Qt::Key_O, Qt::ControlModifier);
    ASSERT_TRUE(waitFor([this] { return window->pages().page() == Page::Review; }));
    auto* const recorded = window->pages().review()->findChild<QTreeWidget*>("eventListTree");
    ASSERT_TRUE(waitFor([&] { return recorded->topLevelItemCount() > 0; }));
    EXPECT_TRUE(speaks(recorded->topLevelItem(0), 2, "373.2\u00a0K,"))
        << recorded->topLevelItem(0)->text(2).toStdString();
    trigger("fahrenheit");
    EXPECT_TRUE(speaks(recorded->topLevelItem(0), 2, "212.0\u00a0\u00b0F, above its warning limit of 194.0"))
        << recorded->topLevelItem(0)->text(2).toStdString();
}

// Catches: events of the run before under an experiment that was opened since, also after another unit was
// chosen, and a report of a problem without them.
TEST(BottomDockTest, EventsOfTheRunBeforeAreNotListedUnderANewExperiment) {
    BottomDock dock;
    const auto* events = dock.findChild<QTreeWidget*>("eventListTree");
    Snapshot snapshot;
    snapshot.newEvents = {{1.0, {MessageCode::EventStarted, {}}}, {9.0, {MessageCode::EventHeld, {}}}};
    snapshot.newNotes = {{5.0, "door opened"}};
    dock.apply(snapshot);
    ASSERT_EQ(events->topLevelItemCount(), 3);
    dock.beginExperiment();
    EXPECT_EQ(events->topLevelItemCount(), 0);
    EXPECT_EQ(dock.events().size(), 2U);
    dock.setTemperatureUnit(TemperatureUnit::Kelvin);
    EXPECT_EQ(events->topLevelItemCount(), 0);
    snapshot.newEvents = {{0.0, {MessageCode::EventZeroed, {}}}};
    snapshot.newNotes.clear();
    dock.apply(snapshot);
    EXPECT_EQ(events->topLevelItemCount(), 1);
    dock.setTemperatureUnit(TemperatureUnit::Celsius);
    EXPECT_EQ(events->topLevelItemCount(), 1);
}

// Catches: alarms out of sight while a recorded run is looked at, or that move it, and its events mixed with
// the present ones.
TEST_F(AlarmsTest, AlarmsAloneAreUnderAReview) {
    ASSERT_NO_FATAL_FAILURE(openAt10Hz());
    auto* dock = find<BottomDock>("eventDock");
    window->pages().show(Page::Review);
    QRect page;
    ASSERT_TRUE(waitFor([&] { // the first layouts of a window move it
        const bool isSteady = page == window->pages().geometry();
        page = window->pages().geometry();
        waitForLayouts();
        return isSteady && dock->height() < window->height() / 3;
    }));
    EXPECT_FALSE(tabs()->isTabVisible(1));
    trigger("robot-alarm");
    EXPECT_TRUE(waitFor([&] { return isInFront() && rows()->topLevelItemCount() > 0; }));
    waitForLayouts();
    EXPECT_EQ(window->pages().geometry(), page) << "the alarm has moved it";
    EXPECT_TRUE(dock->isVisible());
    EXPECT_FALSE(tabs()->isTabVisible(1));
    window->pages().show(Page::Run);
    EXPECT_TRUE(tabs()->isTabVisible(1));
    EXPECT_TRUE(isInFront());
}

// Catches: an alarm of the night that the next start does not know of, or calls active.
TEST_F(AlarmsTest, IsKeptOverARestartAndAcknowledgedByKey) {
    ASSERT_NO_FATAL_FAILURE(openAt10Hz());
    trigger("robot-alarm");
    ASSERT_TRUE(waitFor([&] { return bar()->isVisible(); }));
    closeWindow();

    openWindow();
    ASSERT_TRUE(waitFor([&] { return bar()->isVisible(); }));
    EXPECT_TRUE(isInFront());
    EXPECT_TRUE(cell(0, 1).startsWith(QStringLiteral("Over, new"))) << cell(0, 1).toStdString();
    EXPECT_TRUE(cell(0, 1).endsWith(QStringLiteral("from before"))) << cell(0, 1).toStdString();
    ASSERT_TRUE(waitFor([this] { return window->actions().acknowledgeAlarms->isEnabled(); }));
    QTest::keyClick(window.get(), Qt::Key_F9);
    EXPECT_TRUE(waitFor([&] { return rows()->topLevelItemCount() == 0; }));
    EXPECT_FALSE(bar()->isVisible());
}

// Catches: a bar that grows the window, or pushes STOP off it, in any state, with long alarms and in the
// longer language.
TEST_F(AlarmsTest, TheBarFitsASmallWindow) {
    openWindow({1100, 700});
    Snapshot snapshot = freeze();
    snapshot.runTime_s = 36000.0;
    Alarm alarm;
    alarm.id = 1;
    alarm.message = {MessageCode::SafetyObjectHot, {"aluminium hand with a painted palm", "152.3", "150"}};
    snapshot.alarms.assign(12, alarm);
    for (const char* language : {"en", "fr", "zh_CN", "zh_TW"}) {
        window->setLanguage(QLatin1String(language));
        for (const RunState state : {RunState::NotReady, RunState::Ready, RunState::Armed, RunState::Running,
                                     RunState::Holding, RunState::Stopping, RunState::Fault}) {
            window->resize(1100, 700);
            snapshot.state = state;
            emit window->engine().snapshot(snapshot);
            QCoreApplication::processEvents();
            const auto* stop = find<QWidget>("stopButton");
            const auto where = testing::Message() << language << ' ' << runStateName(state);
            EXPECT_EQ(window->width(), 1100) << where;
            EXPECT_LE(stop->mapTo(window.get(), stop->rect().topRight()).x(), 1100) << where;
            EXPECT_TRUE(bar()->isVisible()) << where;
            EXPECT_GE(bar()->width(), bar()->minimumSizeHint().width()) << where;
            EXPECT_LE(bar()->geometry().right(), stop->x()) << where;
        }
    }
}

// Catches: an over-temperature that waits for somebody to answer a question.
TEST_F(AlarmsTest, OverTemperatureIsActedUponBehindADialog) {
    openWindow();
    Experiment experiment = window->document().experiment();
    experiment.safety.warning_K = kelvinFromCelsius(49.0);
    experiment.safety.trip_K = kelvinFromCelsius(52.0);
    experiment.sampling.period_s = 0.1;
    ASSERT_TRUE(window->document().edit(experiment).ok());
    ASSERT_NO_FATAL_FAILURE(startRun(1));
    const auto true_K = [this] { return window->lastSnapshot().latest.objects[0].true_K; };
    window->engine().send(SimulateFault{SimulatedFault::ObjectHot, 0});
    ASSERT_TRUE(waitFor([&] { return true_K() > kelvinFromCelsius(40.0); }));
    ASSERT_NO_FATAL_FAILURE(atRealSpeed());
    ASSERT_LT(true_K(), experiment.safety.trip_K);

    QMessageBox box(QMessageBox::Question, QStringLiteral("Question"), QStringLiteral("Still there?"),
                    QMessageBox::Ok, window.get());
    QElapsedTimer sinceCrossed;
    qint64 reaction_ms = -1;
    qint64 seen_ms = -1;
    QObject::connect(window.get(), &MainWindow::snapshotApplied, &box, [&](const Snapshot& snapshot) {
        if (!sinceCrossed.isValid() && true_K() > experiment.safety.trip_K)
            sinceCrossed.start();
        if (!sinceCrossed.isValid())
            return;
        const bool isEnding = snapshot.state == RunState::Stopping || snapshot.state == RunState::Fault;
        if (reaction_ms < 0 && isEnding && !snapshot.heatOn)
            reaction_ms = sinceCrossed.elapsed();
        const bool isShown =
            bar()->isVisible() && bar()->text().contains(QStringLiteral("above its trip limit"));
        if (seen_ms < 0 && isShown && QApplication::activeModalWidget() == &box)
            seen_ms = sinceCrossed.elapsed();
        if (reaction_ms >= 0 && seen_ms >= 0)
            box.accept();
    });
    QTimer::singleShot(std::chrono::seconds(120), &box, &QDialog::reject);
    EXPECT_EQ(box.exec(), QMessageBox::Accepted);
    EXPECT_GE(reaction_ms, 0);
    EXPECT_LE(reaction_ms, 10000); // one second, on a machine that is there
    EXPECT_GE(seen_ms, 0);
    EXPECT_LE(seen_ms, 10000);
    RecordProperty("reaction_ms", std::to_string(reaction_ms));
    RecordProperty("seen_ms", std::to_string(seen_ms));
}

// Catches: a loop or a recording that waits for the window.
TEST_F(AlarmsTest, ABlockedWindowHoldsUpNothing) {
    ASSERT_NO_FATAL_FAILURE(openAt10Hz());
    ASSERT_NO_FATAL_FAILURE(startRun(1));
    ASSERT_NO_FATAL_FAILURE(atRealSpeed());
    const QString recording = QString::fromStdString(window->lastSnapshot().recordingPath);
    const double before_s = window->lastSnapshot().runTime_s;
    const QSignalSpy silences(&window->engine(), &EngineClient::answeringChanged);
    QThread::sleep(3);
    std::size_t got = 0; // of what came meanwhile; that it came in time is told by the recording
    QObject::connect(&window->engine(), &EngineClient::snapshot, window.get(), [&](const Snapshot& snapshot) {
        got += static_cast<std::size_t>(
            std::ranges::count_if(snapshot.newSamples, [&](const TraceSample& sample) {
                return sample.time_s > before_s && sample.time_s <= before_s + 3.0;
            }));
    });
    ASSERT_TRUE(waitFor([&] { return window->lastSnapshot().runTime_s > before_s + 3.5; }));
    EXPECT_GE(got, 25U);
    EXPECT_EQ(silences.count(), 0) << "the window was busy, not the engine";

    click("stopRunButton");
    ASSERT_TRUE(waitForState(RunState::Stopped));
    ASSERT_TRUE(waitFor([&] { return window->lastSnapshot().recordingPath.empty(); }))
        << "it is closed meanwhile";
    const auto record = readSession(recording.toStdString());
    ASSERT_TRUE(record.ok());
    double last_s = before_s, gap_s = 0.0;
    for (const TraceSample& sample : record->samples) {
        if (sample.time_s < before_s || sample.time_s > before_s + 3.5)
            continue;
        gap_s = std::max(gap_s, sample.time_s - last_s);
        last_s = sample.time_s;
    }
    EXPECT_GT(last_s, before_s + 3.0);
    EXPECT_LE(gap_s, 0.5);
}

} // namespace
} // namespace bask::test
