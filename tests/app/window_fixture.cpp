#include "tests/app/window_fixture.h"

#include <QAbstractButton>
#include <QApplication>
#include <QComboBox>
#include <QDir>
#include <QScreen>

namespace bask::test {

void WindowTest::SetUp() {
    for (const char* kept : {"/bask.ini", "/alarms.json", "/alarms-without-run.jsonl"})
        QFile::remove(qEnvironmentVariable("BASK_SETTINGS_DIR") + QLatin1String(kept));
    for (const QString& kept : {unsavedFolder(), runMarkFolder()})
        QDir(kept).removeRecursively();
    SettingsStore().setCoachAnswered();
}

void WindowTest::TearDown() {
    if (window)
        closeWindow();
    applyTheme(*qApp, Theme::Light);
}

void WindowTest::openWindow(QSize size, const QString& file) {
    window = std::make_unique<MainWindow>();
    window->resize(size);
    window->move(0, 0);
    window->pages().forecast().setLongest_ms(100'000);
    QObject::connect(window.get(), &MainWindow::snapshotApplied, window.get(),
                     [this, runId = std::uint64_t{0}](const Snapshot& snapshot) mutable {
                         if (snapshot.runId != runId)
                             samples.clear();
                         runId = snapshot.runId;
                         samples.insert(samples.end(), snapshot.newSamples.begin(),
                                        snapshot.newSamples.end());
                     });
    window->show();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(window.get()));
    window->activateWindow(); // keys go nowhere otherwise, with no window manager
    ASSERT_TRUE(QTest::qWaitForWindowActive(window.get()));
    window->begin(file);
    ASSERT_TRUE(waitFor([this] { return window->lastSnapshot().latest.objects.size() == 3; }));
}

void WindowTest::closeWindow() {
    window->setCloseQuestion([] { return Closing::Now; });
    window->document().markSaved(window->document().path()); // no question about changes
    EXPECT_TRUE(waitFor([this] { return window->files().unfinishedExports().isEmpty(); })); // nor about these
    EXPECT_TRUE(window->close());
    window.reset();
}

void WindowTest::goFast() {
    QTest::keyClick(window.get(), Qt::Key_5, Qt::ControlModifier);
    auto* speed = find<QComboBox>("simulationSpeed");
    speed->setFocus();
    QTest::keyClick(speed, Qt::Key_End);
    ASSERT_TRUE(waitFor([this] { return window->lastSnapshot().simulationSpeed == 20.0; }));
}

void WindowTest::startRun(std::size_t count) {
    ASSERT_NO_FATAL_FAILURE(goFast());
    ASSERT_TRUE(waitForState(RunState::Ready));
    click("armButton");
    ASSERT_TRUE(waitForState(RunState::Armed));
    click("startButton");
    ASSERT_TRUE(waitFor([&] { return samples.size() >= count; }));
}

Snapshot WindowTest::freeze() {
    EXPECT_TRUE(waitForState(RunState::Ready));
    EXPECT_TRUE(window->engine().shutDown(std::chrono::seconds(3)));
    QCoreApplication::processEvents(); // what it had sent
    Snapshot snapshot = window->lastSnapshot();
    snapshot.newSamples.clear();
    snapshot.newEvents.clear();
    return snapshot;
}

void WindowTest::openRecording(const QString& path) {
    bool isOpened = false;
    QObject::connect(&window->files(), &SessionActions::sessionOpened, window.get(),
                     [&] { isOpened = true; });
    window->files().open(path);
    ASSERT_TRUE(waitFor([&] { return isOpened; }));
}

void WindowTest::holdARunAndOpenIt() {
    ASSERT_NO_FATAL_FAILURE(startRun(21));
    click("holdButton");
    ASSERT_TRUE(waitForState(RunState::Holding));
    openRecording(QString::fromStdString(window->lastSnapshot().recordingPath));
}

void WindowTest::waitForLayouts() {
    const QDeadlineTimer settled(200);
    waitFor([&] { return settled.hasExpired(); });
}

void WindowTest::click(const char* name) {
    auto* button = find<QAbstractButton>(name);
    ASSERT_NE(button, nullptr);
    ASSERT_TRUE(button->isVisible()) << name;
    ASSERT_TRUE(waitFor([button] { return button->isEnabled(); })) << name;
    QTest::mouseClick(button, Qt::LeftButton);
}

bool WindowTest::waitForState(RunState wanted, int limit_ms) {
    return waitFor([&] { return state() == wanted; }, limit_ms);
}

void WindowTest::keepPicture(const QString& name) {
    for (int i = 0; i < 4; ++i) // nested layouts settle one after the other
        QCoreApplication::processEvents();
    const QString folder = qEnvironmentVariable("BASK_SCREENSHOTS");
    if (folder.isEmpty())
        return;
    QDir().mkpath(folder);
    // Two rounds of events: layouts settle, then the last paint is on the screen.
    for (int i = 0; i < 2; ++i) {
        window->repaint();
        const QDeadlineTimer painted(150);
        waitFor([&] { return painted.hasExpired(); });
    }
    const QPixmap picture = window->screen()->grabWindow(window->winId());
    EXPECT_TRUE(picture.save(QStringLiteral("%1/%2.png").arg(folder, name)));
}

void WindowTest::keepPictures(const QString& prefix) {
    if (qEnvironmentVariableIsEmpty("BASK_SCREENSHOTS"))
        return;
    const std::array names{"rig", "objects", "calibrate", "targets", "run", "review"};
    for (std::size_t i = 0; i < names.size(); ++i) {
        window->pages().show(static_cast<Page>(i));
        keepPicture(prefix + u'-' + QLatin1String(names[i]));
    }
}

} // namespace bask::test
