// The first five minutes as the coach tells them, done with mouse and keys, with a picture of every step.

#include "app/coach.h"
#include "app/examples.h"
#include "engine/base/message_code.h"
#include "engine/model/limits_widened.h"
#include "tests/app/window_fixture.h"
#include "widgets/common/display.h"
#include "widgets/common/language.h"
#include "widgets/common/message_bar.h"
#include "widgets/review/review_page.h"
#include "widgets/rig/device_dialog.h"

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFileInfo>
#include <QLabel>
#include <QLineEdit>
#include <QListView>
#include <QMenu>
#include <QMenuBar>
#include <QPushButton>
#include <QRegularExpression>
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
    for (const char* port : {"/tmp/bask-robot", "/tmp/bask-thermometer", "/tmp/bask-heater"})
        if (QFileInfo(QLatin1String(port)).isSymLink() || QFileInfo::exists(QLatin1String(port)))
            GTEST_SKIP() << port << " is there: this test would drive what it belongs to";
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
    step(Step::Restore, [this] { simulateFault(QStringLiteral("Sensor lost"), 1); });
    step(Step::Resume, [this] {
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
    keepPicture(QStringLiteral("five-minutes-14b"));
    const QTemporaryDir folder;
    window->files().setFileChooser([&](const FileQuestion&) { return folder.path(); });
    emit window->pages().review()->exportRequested(SessionForm::Csv);
    EXPECT_TRUE(waitFor([&] { // in a folder of the run's name
        const QStringList runs = QDir(folder.path()).entryList(QDir::Dirs | QDir::NoDotAndDotDot);
        return runs.size() == 1 &&
               QFileInfo::exists(folder.filePath(runs.first() + QStringLiteral("/pose.csv")));
    }));
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
    step(Step::SerialRig, [this] { window->files().openExample(QStringLiteral("serial-rig"), false); });
    if (HasFatalFailure())
        return;
    for (const char* control : {"card.robot", "setUp.thermometer"}) { // nobody plays the devices here
        ASSERT_NO_FATAL_FAILURE(pressIn("messageAction"));
        EXPECT_TRUE(find<QWidget>(control)->isVisible()) << control;
        ASSERT_NO_FATAL_FAILURE(pressIn("messageOther"));
    }
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
    EXPECT_TRUE(waitFor([this] { return bar->sentence().startsWith(QStringLiteral("2 sur 18")); }));
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

/// One that is on its way to `step`, with what it says.
class CoachSteps : public testing::Test {
protected:
    void beginAt(Coach::Step step) {
        coach.begin();
        while (coach.step() && coach.step() != step)
            emit bar.otherClicked();
        ASSERT_EQ(coach.step(), step);
    }
    static Snapshot rigAt(const char* folder, LinkState link) {
        Snapshot snapshot;
        snapshot.simulated = false;
        for (const auto& [role, port] : {std::pair{DeviceRole::Robot, "robot"},
                                         {DeviceRole::Thermometer, "thermometer"},
                                         {DeviceRole::HeatSource, "heater"}}) {
            RigDeviceState device;
            device.role = role;
            device.port = std::string(folder) + port;
            device.status.link = link;
            snapshot.devices.push_back(device);
        }
        return snapshot;
    }

    MessageBar bar;
    Coach coach{bar};
};

// Catches a step that goes on before it is done: an alarm that nobody has acknowledged, a fault that is still
// there, a run that still is held.
TEST_F(CoachSteps, AFaultIsSeenAcknowledgedRemovedAndLeft) {
    using Step = Coach::Step;
    ASSERT_NO_FATAL_FAILURE(beginAt(Step::Fault));
    Snapshot snapshot;
    const auto stepAfter = [&] {
        coach.see(snapshot);
        return coach.step();
    };
    snapshot.state = RunState::Holding;
    EXPECT_EQ(stepAfter(), Step::Fault) << "held by hand";
    EXPECT_TRUE(bar.sentence().contains(simulatedFaultWord(SimulatedFault::SensorLost)))
        << qPrintable(bar.sentence());
    snapshot.alarms.emplace_back();
    snapshot.faults.push_back({SimulatedFault::SensorLost, 1});
    EXPECT_EQ(stepAfter(), Step::Acknowledge);
    EXPECT_EQ(stepAfter(), Step::Acknowledge);
    snapshot.alarms[0].isAcknowledged = true;
    EXPECT_EQ(stepAfter(), Step::Restore);
    EXPECT_EQ(stepAfter(), Step::Restore);
    snapshot.faults.clear();
    EXPECT_EQ(stepAfter(), Step::Resume);
    EXPECT_EQ(stepAfter(), Step::Resume);
    snapshot.state = RunState::Running;
    EXPECT_EQ(stepAfter(), Step::Stop);
}

// Catches a rig that is taken for connected before all of its devices answer, and a device that counts as
// found because it was there before.
TEST_F(CoachSteps, ARigOfSerialPortsIsConnectedAndADeviceFound) {
    using Step = Coach::Step;
    ASSERT_NO_FATAL_FAILURE(beginAt(Step::SerialRig));
    const auto stepAfter = [&](const Snapshot& snapshot) {
        coach.see(snapshot);
        return coach.step();
    };
    EXPECT_EQ(stepAfter(Snapshot()), Step::SerialRig);
    Snapshot rig = rigAt("/tmp/bask-", LinkState::Opening);
    EXPECT_EQ(stepAfter(rig), Step::Connect);
    EXPECT_TRUE(bar.sentence().contains(QStringLiteral("bask simulate-rig"))) << qPrintable(bar.sentence());
    rig.devices[0].status.link = rig.devices[1].status.link = LinkState::Live;
    EXPECT_EQ(stepAfter(rig), Step::Connect) << "the heat source does not answer";
    rig.devices[2].status.link = LinkState::Live;
    EXPECT_EQ(stepAfter(rig), Step::Find);
    EXPECT_TRUE(bar.sentence().contains(QStringLiteral("/tmp/bask-thermometer")))
        << qPrintable(bar.sentence());
    EXPECT_EQ(stepAfter(rig), Step::Find) << "nothing was looked for";
    Snapshot without = rig;
    without.devices.erase(without.devices.begin() + 1);
    without.search.emplace();
    EXPECT_EQ(stepAfter(without), Step::Find);
    without.search->found.push_back({1, {}, 0});
    EXPECT_EQ(stepAfter(without), Step::Find) << "found, and not used";
    EXPECT_EQ(stepAfter(rig), std::nullopt);
    EXPECT_TRUE(bar.sentence().startsWith(QStringLiteral("That was all"))) << qPrintable(bar.sentence());
}

// Catches a tour that says "nothing can burn" over a rig that can, and its end on the one that it asks for.
TEST_F(CoachSteps, EndOnARigThatIsNobodysSimulation) {
    ASSERT_NO_FATAL_FAILURE(beginAt(Coach::Step::SerialRig));
    coach.see(rigAt("/dev/ttyUSB-", LinkState::Live));
    EXPECT_EQ(coach.step(), std::nullopt);
    EXPECT_EQ(bar.sentence(), QString());
}

// Catches a link in /tmp to a true port, and a rig of nothing, that are taken for played ones.
TEST_F(CoachSteps, EndOnALinkToATruePortAndOnARigWithoutDevices) {
    const std::string folder = "/tmp/bask-coach" + std::to_string(QCoreApplication::applicationPid()) + '-';
    const QString heater = QString::fromStdString(folder) + QStringLiteral("heater");
    const Snapshot rig = rigAt(folder.c_str(), LinkState::Opening);
    Snapshot bare = rig;
    bare.devices.clear();
    const auto staysOn = [this](const Snapshot& snapshot) {
        beginAt(Coach::Step::Connect);
        coach.see(snapshot);
        return coach.step().has_value();
    };
    EXPECT_TRUE(staysOn(rig)) << "nothing is there yet";
    EXPECT_FALSE(staysOn(bare));
    for (const auto& [target, isPlayed] :
         {std::pair{"/dev/pts/99999", true}, {"/dev/null", false}, {"/dev/ttyUSB99", false}}) {
        ASSERT_TRUE(QFile::link(QLatin1String(target), heater));
        coach.see(Snapshot()); // a simulated one
        EXPECT_EQ(staysOn(rig), isPlayed) << target;
        QFile::remove(heater);
    }
}

// Catches an example whose ports are not those that the tour names, or that a real rig's question about
// limits comes before.
TEST(CoachTest, TheExampleHasThePortsThatAreNamed) {
    const auto example = readExample(QStringLiteral("serial-rig"));
    ASSERT_TRUE(example.ok()) << describe(example.error());
    ASSERT_TRUE(example->rig && example->rig->robot && example->rig->thermometer && example->rig->source);
    EXPECT_EQ(example->rig->robot->port, "/tmp/bask-robot");
    EXPECT_EQ(example->rig->thermometer->port, "/tmp/bask-thermometer");
    EXPECT_EQ(example->rig->source->port, "/tmp/bask-heater");
    EXPECT_TRUE(widenedOnRealRig({}, *example, {}).empty());
}

QString withoutMnemonic(QString text) {
    static const QRegularExpression kOfChinese(QStringLiteral("\\(&.\\)$"));
    return text.remove(kOfChinese).remove(u'&');
}

/// "Tools > Simulate fault > Sensor lost", and so on.
void addPaths(const QList<QAction*>& actions, const QString& before, QStringList& paths) {
    for (const QAction* action : actions) {
        if (action->isSeparator())
            continue;
        const QString path = before + withoutMnemonic(action->text());
        paths << path;
        if (action->menu() != nullptr)
            addPaths(action->menu()->actions(), path + QStringLiteral(" > "), paths);
    }
}

// Catches a step that names a menu or a button which is not there, or not so in that language.
TEST_F(FiveMinutesTest, NameNothingThatIsNotThere) {
    openWindow();
    static const QRegularExpression kQuoted(
        QStringLiteral("“([^”]+)”|«[\\s\u00a0]*([^»]+?)[\\s\u00a0]*»|「([^」]+)」"));
    for (const QString& code : Language::codes()) {
        int checked = 0;
        window->setLanguage(code);
        ASSERT_TRUE(waitFor([this] {
            return find<QAbstractButton>("setUp.thermometer")->text() ==
                   QCoreApplication::translate("bask::DeviceCard", "Set up…");
        }));
        const DeviceDialog dialog(DeviceRole::Thermometer, {}, {"bunny"});
        QStringList paths, names{QStringLiteral("bunny"), QStringLiteral("bask simulate-rig"),
                                 QCoreApplication::translate("bask::RunPage", "Thermal picture")};
        addPaths(window->menuBar()->actions(), {}, paths);
        for (const QAction* action : window->findChildren<QAction*>())
            names << withoutMnemonic(action->text());
        for (const QWidget* within : std::initializer_list<const QWidget*>{window.get(), &dialog}) {
            for (const auto* button : within->findChildren<QAbstractButton*>())
                names << withoutMnemonic(button->text());
            for (const auto* label : within->findChildren<QLabel*>())
                names << withoutMnemonic(label->text());
            for (const auto* tabs : within->findChildren<QTabWidget*>())
                for (int i = 0; i < tabs->count(); ++i)
                    names << withoutMnemonic(tabs->tabText(i));
        }
        MessageBar said;
        Coach alone(said);
        alone.begin();
        std::ranges::sort(paths, std::ranges::greater(), &QString::size);
        for (; alone.step(); emit said.otherClicked()) {
            QString sentence = said.sentence();
            for (const QString& path : paths)
                if (path.contains(u'>'))
                    sentence.remove(path);
            EXPECT_FALSE(sentence.contains(u'>')) << qPrintable(code + u' ' + said.sentence());
            for (const QRegularExpressionMatch& quoted : kQuoted.globalMatch(sentence)) {
                const QString name = quoted.captured(quoted.lastCapturedIndex());
                EXPECT_TRUE(names.contains(name)) << qPrintable(code + u' ' + name);
                ++checked;
            }
        }
        EXPECT_GE(checked, 7) << qPrintable(code);
    }
}

} // namespace
} // namespace bask::test
