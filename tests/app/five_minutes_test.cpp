// The first five minutes as the coach tells them, done with mouse and keys, with a picture of every step.

#include "app/coach.h"
#include "engine/base/message_code.h"
#include "tests/app/window_fixture.h"
#include "widgets/common/message_bar.h"
#include "widgets/review/review_page.h"

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFileInfo>
#include <QLineEdit>
#include <QListView>
#include <QMenu>
#include <QPushButton>
#include <QSlider>
#include <QTabWidget>
#include <QTreeWidget>

#include <algorithm>

namespace bask::test {
namespace {

class FiveMinutesTest : public WindowTest {
protected:
    void openWindow() {
        QFile::remove(qEnvironmentVariable("BASK_SETTINGS_DIR") +
                      QLatin1String("/bask.ini")); // as at the first start
        WindowTest::openWindow();
        bar = find<MessageBar>("coachBar");
    }
    Coach& coach() { return *window->findChild<Coach*>(); }
    void press(Qt::Key key, Qt::KeyboardModifiers with = Qt::NoModifier) {
        QTest::keyClick(window.get(), key, with);
    }
    void pressIn(const char* buttonOfBar) {
        auto* button = bar->findChild<QAbstractButton*>(QLatin1String(buttonOfBar));
        ASSERT_TRUE(button->isVisible());
        QTest::mouseClick(button, Qt::LeftButton);
    }
    /// The coach shows where; then `act` does what it says, and it goes on to the next step by itself.
    void step(Coach::Step which, const std::function<void()>& act) {
        SCOPED_TRACE(qPrintable(bar->sentence()));
        ASSERT_EQ(coach().step(), which);
        ASSERT_NO_FATAL_FAILURE(pressIn("messageAction"));
        keepPicture(
            QStringLiteral("five-minutes-%1").arg(static_cast<int>(which) + 1, 2, 10, QLatin1Char('0')));
        ASSERT_NO_FATAL_FAILURE(act());
        ASSERT_TRUE(waitFor([&] { return coach().step() != which; }));
    }
    void type(const char* name, const char* text) {
        auto* field = find<QWidget>(name);
        ASSERT_TRUE(field->isVisible()) << name;
        field->setFocus();
        QTest::keyClick(field, Qt::Key_A, Qt::ControlModifier);
        QTest::keyClicks(field, QLatin1String(text));
        QTest::keyClick(field, Qt::Key_Return);
    }
    void simulateFault(const QString& name, int object) {
        for (QMenu* menu : window->findChildren<QMenu*>())
            for (QAction* action : menu->actions())
                if (action->text() == name)
                    return (action->menu() ? action->menu()->actions().at(object) : action)->trigger();
        FAIL() << qPrintable(name);
    }
    double trueError_K() const {
        double max_K = 0.0;
        for (const ObjectSample& object : samples.back().objects)
            max_K = std::max(max_K, std::abs(object.true_K - object.target_K));
        return max_K;
    }

    MessageBar* bar = nullptr;
};

// Catches: a step that cannot be done as it is written, one whose doing is not seen, a control that is not
// where the coach points.
TEST_F(FiveMinutesTest, AsTheyAreTold) {
    using Step = Coach::Step;
    openWindow();
    ASSERT_TRUE(waitForState(RunState::Ready));
    EXPECT_TRUE(bar->sentence().startsWith(QStringLiteral("New here?")));
    keepPicture(QStringLiteral("five-minutes-00"));
    ASSERT_NO_FATAL_FAILURE(pressIn("messageAction"));
    const Experiment shipped = window->document().experiment();

    step(Step::Harmonics, [this] {
        auto* list = find<QAbstractItemView>("objectList");
        QTest::mouseClick(list->viewport(), Qt::LeftButton, {},
                          list->visualRect(list->model()->index(1, 0)).center());
        auto* slider = find<QSlider>("harmonicsSlider");
        slider->setFocus();
        for (int i = 0; i < 4; ++i)
            QTest::keyClick(slider, Qt::Key_Left);
    });
    if (HasFatalFailure())
        return;
    EXPECT_NE(window->document().experiment(), shipped);
    step(Step::Undo, [this] { press(Qt::Key_Z, Qt::ControlModifier); });
    EXPECT_EQ(window->document().experiment(), shipped);
    step(Step::TooHot, [this] { type("target0", "200"); });
    step(Step::Feasible, [this] { click("useNearest"); });
    if (HasFatalFailure())
        return;
    // Back to what settles in the time of a test.
    press(Qt::Key_Z, Qt::ControlModifier);
    press(Qt::Key_Z, Qt::ControlModifier);
    EXPECT_EQ(window->document().experiment(), shipped);
    ASSERT_TRUE(waitForState(RunState::Ready));

    step(Step::Arm, [this] { press(Qt::Key_F5); });
    step(Step::Start, [this] { press(Qt::Key_F6); });
    if (HasFatalFailure())
        return;
    ASSERT_NO_FATAL_FAILURE(goFast());
    ASSERT_TRUE(waitForState(RunState::Settled));
    EXPECT_TRUE(waitFor([this] { return trueError_K() <= kSettledBand_K; }));
    step(Step::Note, [this] {
        auto* plot = find<QWidget>("plot.measured_K");
        QTest::keyClick(plot, Qt::Key_N);
        auto* edit = find<QLineEdit>("noteEdit");
        QTest::keyClicks(edit, QStringLiteral("door was open"));
        QTest::keyClick(edit, Qt::Key_Return);
    });
    step(Step::Gain, [this] {
        auto* gain = find<QWidget>("controllerPanel")->findChildren<QDoubleSpinBox*>().first();
        gain->setFocus();
        QTest::keyClick(gain, Qt::Key_Up);
        click("gainsApply");
    });
    // A person has the time to look: a hold that lasts becomes a retreat.
    auto* speed = find<QComboBox>("simulationSpeed");
    speed->setFocus();
    QTest::keyClick(speed, Qt::Key_Home);
    ASSERT_TRUE(waitFor([this] { return window->lastSnapshot().simulationSpeed <= 1.0; }));
    step(Step::Fault, [this] { simulateFault(QStringLiteral("Sensor lost"), 1); });
    step(Step::Acknowledge, [this] { press(Qt::Key_F9); });
    step(Step::Resume, [this] {
        simulateFault(QStringLiteral("Restore all devices"), 0);
        ASSERT_TRUE(waitFor(
            [this] { return std::ranges::none_of(window->lastSnapshot().alarms, &Alarm::isActive); }));
        press(Qt::Key_F7, Qt::ShiftModifier);
    });
    const std::string recording = window->lastSnapshot().recordingPath;
    step(Step::Stop, [this] { press(Qt::Key_F8); });
    if (HasFatalFailure())
        return;
    EXPECT_FALSE(window->lastSnapshot().heatOn);
    std::shared_ptr<RecordedSession> session;
    QObject::connect(&window->files(), &SessionActions::sessionOpened, window.get(),
                     [&](const std::shared_ptr<RecordedSession>& opened) { session = opened; });
    step(Step::Review, [&] {
        auto* runs = find<QTreeWidget>("sessionTree");
        ASSERT_TRUE(waitFor([&] { return runs->topLevelItemCount() > 0; }));
        runs->setFocus();
        QTest::keyClick(runs, Qt::Key_Home); // the newest
        QTest::keyClick(runs, Qt::Key_Return);
    });
    ASSERT_TRUE(waitFor([&] { return session != nullptr; }));
    const SessionRecord* const record = &session->facts();
    EXPECT_EQ(record->path, recording);
    EXPECT_EQ(record->outcome, "stopped"); // not settled again after the hold
    ASSERT_EQ(record->notes.size(), 1U);
    EXPECT_EQ(record->notes[0].text, "door was open");
    EXPECT_TRUE(std::ranges::any_of(record->events, [](const TraceEvent& event) {
        return event.message.code == MessageCode::ReasonSensorInvalid;
    }));
    auto* position = find<QSlider>("replaySlider");
    position->setFocus();
    QTest::keyClick(position, Qt::Key_Home);
    click("replayPlay");
    EXPECT_TRUE(waitFor([&] { return position->value() > position->minimum(); }));
    keepPicture(QStringLiteral("five-minutes-13b"));
    const QTemporaryDir folder;
    window->files().setFileChooser([&](const FileQuestion&) { return folder.path(); });
    emit window->pages().review()->exportRequested(SessionForm::Csv);
    EXPECT_TRUE(waitFor([&] { return QFileInfo::exists(folder.filePath(QStringLiteral("pose.csv"))); }));
    step(Step::Thermal, [this] {
        window->files().openExample(QStringLiteral("thermal-camera"), false);
        auto* tabs = find<QTabWidget>("plotTabs");
        QWidget* picture = nullptr;
        ASSERT_TRUE(waitFor([&] {
            picture = tabs->findChild<QWidget*>(QStringLiteral("thermalPictureView"));
            return picture != nullptr && tabs->indexOf(picture) >= 0;
        }));
        window->pages().show(Page::Run);
        tabs->setCurrentWidget(picture);
    });
    EXPECT_EQ(coach().step(), std::nullopt);
}

// Catches an offer that comes again, and one that takes a person's answer for another.
TEST_F(FiveMinutesTest, AreOfferedOnce) {
    openWindow();
    ASSERT_NO_FATAL_FAILURE(pressIn("messageOther"));
    EXPECT_FALSE(bar->isVisible());
    EXPECT_EQ(coach().step(), std::nullopt);
    closeWindow();
    WindowTest::openWindow();
    EXPECT_FALSE(find<MessageBar>("coachBar")->isVisible());
    // Asked for, they begin; closed, they are over.
    window->actions().firstFiveMinutes->trigger();
    bar = find<MessageBar>("coachBar");
    EXPECT_EQ(coach().step(), Coach::Step::Harmonics);
    ASSERT_NO_FATAL_FAILURE(pressIn("messageOther"));
    EXPECT_EQ(coach().step(), Coach::Step::Undo);
    window->setLanguage(QStringLiteral("fr"));
    EXPECT_TRUE(waitFor([this] { return bar->sentence().startsWith(QStringLiteral("2 sur 14")); }));
    ASSERT_NO_FATAL_FAILURE(pressIn("messageClose"));
    EXPECT_EQ(coach().step(), std::nullopt);
    EXPECT_FALSE(bar->isVisible());
}

// Catches a coach that goes on about a run which has ended by itself, and points at what cannot be pressed.
TEST(CoachTest, LeadsBackIntoARunThatHasEnded) {
    MessageBar bar;
    Coach coach(bar);
    QString shown;
    QObject::connect(&coach, &Coach::showWanted, &bar,
                     [&](Page, const QString& control) { shown = control; });
    Snapshot snapshot;
    snapshot.simulated = true;
    snapshot.state = RunState::Holding;
    snapshot.alarms.emplace_back();
    coach.begin();
    while (coach.step() != Coach::Step::Thermal) { // read through, without a run
        coach.see(Snapshot());
        EXPECT_FALSE(bar.sentence().contains(QStringLiteral("has ended"))) << qPrintable(bar.sentence());
        emit bar.otherClicked();
    }
    coach.begin();
    coach.see(snapshot);
    while (coach.step() != Coach::Step::Acknowledge)
        emit bar.otherClicked();
    const QString paused = bar.sentence();
    const auto pointsAt = [&](RunState state) {
        snapshot.state = state;
        coach.see(snapshot);
        emit bar.actionClicked();
        return shown.toStdString();
    };
    snapshot.alarms[0].isActive = true;
    EXPECT_EQ(pointsAt(RunState::Fault), "toolsMenu");
    EXPECT_TRUE(bar.sentence().contains(QStringLiteral("Reset"))) << qPrintable(bar.sentence());
    EXPECT_EQ(pointsAt(RunState::NotReady), "toolsMenu"); // reset too soon
    EXPECT_TRUE(bar.sentence().contains(QStringLiteral("End the fault"))) << qPrintable(bar.sentence());
    snapshot.alarms[0].isActive = false;
    EXPECT_EQ(pointsAt(RunState::Fault), "resetButton");
    EXPECT_EQ(pointsAt(RunState::Ready), "armButton");
    EXPECT_EQ(pointsAt(RunState::Armed), "startButton");
    EXPECT_EQ(pointsAt(RunState::Holding), "alarmButton");
    EXPECT_EQ(bar.sentence(), paused);
    snapshot.alarms.clear();
    EXPECT_EQ(pointsAt(RunState::Holding), "holdButton");
    EXPECT_EQ(pointsAt(RunState::Running), "stopRunButton");
    EXPECT_EQ(pointsAt(RunState::Fault), "sessionTree") << "there is nothing to stop any more";
}

} // namespace
} // namespace bask::test
