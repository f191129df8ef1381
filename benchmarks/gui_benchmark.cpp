// Start to first picture, key to picture on each page, and how long the GUI thread is not available outside
// painting, at rest and in recorded runs, with the time of a frame. What is beyond a limit below is told at
// the end, and the exit code is 1. Needs a display with OpenGL and a machine that does nothing else:
// xvfb-run -a -s "-screen 0 1600x1000x24" bask_gui_benchmark

#include "app/gui_watchdog.h"
#include "app/main_window.h"
#include "widgets/common/quantity_spin_box.h"
#include "widgets/objects/fourier_fits.h"
#include "widgets/objects/objects_page.h"
#include "widgets/scene/target_scene.h"
#include "widgets/scene/vtk_view.h"

#include <QAbstractButton>
#include <QDeadlineTimer>
#include <QLabel>
#include <QLocale>
#include <QProcess>
#include <QScrollArea>
#include <QStackedWidget>
#include <QTabWidget>
#include <QTemporaryDir>
#include <QTest>
#include <QTimer>
#include <QTreeWidget>

#include <benchmark/benchmark.h>

#include <algorithm>
#include <clocale>
#include <cstdio>
#include <limits>
#include <memory>
#include <string>
#include <vector>

namespace bask {
namespace {

constexpr double kFirstPicture_ms = 3000.0, kKeyToPicture_ms = 350.0, kBlock_ms = 50.0;

std::vector<std::string> beyond; ///< what was slower than promised, or could not be measured

/// Counts it, and remembers it if it is beyond the limit.
void judge(benchmark::State& state, const std::string& what, const std::string& counter, double is_ms,
           double limit_ms) {
    state.counters[counter] = is_ms;
    if (!(is_ms <= limit_ms))
        beyond.push_back(what + ": " + counter + ' ' + std::to_string(is_ms) + ", at most " +
                         std::to_string(limit_ms));
}

/// Nothing was measured, which is no success.
void fail(benchmark::State& state, const char* why) {
    beyond.push_back(why);
    state.SkipWithError(why);
}

double percentile(std::vector<double> values, double p) {
    std::ranges::sort(values);
    return values.empty() ? 0.0
                          : values[static_cast<std::size_t>(p * static_cast<double>(values.size() - 1))];
}

template <class Condition> bool waitFor(Condition condition, int limit_ms) {
    const QDeadlineTimer deadline(limit_ms);
    while (!condition()) {
        if (deadline.hasExpired())
            return false;
        QCoreApplication::processEvents(QEventLoop::AllEvents, 10);
    }
    return true;
}

void rest(int time_ms) {
    const QDeadlineTimer over(time_ms);
    waitFor([&] { return over.hasExpired(); }, 2 * time_ms);
}

std::unique_ptr<MainWindow> openWindow() {
    auto window = std::make_unique<MainWindow>();
    window->resize(1280, 800);
    window->show();
    window->begin({});
    window->activateWindow(); // keys go nowhere otherwise, with no window manager
    if (!QTest::qWaitForWindowActive(window.get()))
        return nullptr;
    if (!waitFor([&] { return !window->lastSnapshot().latest.objects.empty(); }, 20000))
        return nullptr;
    window->repaint();
    return window;
}

void closeWindow(MainWindow& window) {
    window.setCloseQuestion([] { return Closing::Now; });
    window.document().markSaved({}); // or closing asks
    window.close();
}

/// Each time in a window of its own.
template <class Work> void inWindow(benchmark::State& state, const Work& work) {
    for (auto _ : state) {
        const auto window = openWindow();
        if (!window)
            return fail(state, "no readings came");
        work(*window);
        closeWindow(*window);
    }
}

/// Of the window in this process, whose libraries are loaded.
void startToFirstPicture(benchmark::State& state) {
    double longest_ms = 0.0;
    for (auto _ : state) {
        QElapsedTimer timer;
        timer.start();
        const auto window = openWindow();
        if (!window)
            return fail(state, "no readings came");
        longest_ms = std::max(longest_ms, static_cast<double>(timer.nsecsElapsed()) * 1e-6);
        state.PauseTiming();
        closeWindow(*window);
        state.ResumeTiming();
    }
    judge(state, "window", "longest_ms", longest_ms, kFirstPicture_ms);
}
BENCHMARK(startToFirstPicture)->Unit(benchmark::kMillisecond)->UseRealTime()->Iterations(3);

/// As a person has it: from the start of the program until it says that its first picture is there.
void programToFirstPicture(benchmark::State& state) {
    double longest_ms = 0.0;
    for (auto _ : state) {
        QProcess program;
        QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
        environment.insert(QStringLiteral("BASK_TIMING"), QStringLiteral("1"));
        program.setProcessEnvironment(environment);
        program.setReadChannel(QProcess::StandardError);
        QElapsedTimer timer;
        timer.start();
        program.start(QStringLiteral(BASK_PROGRAM), QStringList());
        QByteArray said;
        while (!said.contains("first picture") && program.waitForReadyRead(20000))
            said += program.readAll();
        const double is_ms = static_cast<double>(timer.nsecsElapsed()) * 1e-6;
        program.terminate(); // as a signal, which asks nobody
        program.waitForFinished(20000);
        if (!said.contains("first picture"))
            return fail(state, "the program told no first picture");
        state.SetIterationTime(is_ms * 1e-3);
        longest_ms = std::max(longest_ms, is_ms);
    }
    judge(state, "program", "longest_ms", longest_ms, kFirstPicture_ms);
}
BENCHMARK(programToFirstPicture)->Unit(benchmark::kMillisecond)->UseManualTime()->Iterations(3);

/// Hears when a widget is painted.
class PaintWatch : public QObject {
public:
    explicit PaintWatch(QWidget* watched) { watched->installEventFilter(this); }
    bool isPainted() const { return m_isPainted; }
    void forget() { m_isPainted = false; }

protected:
    bool eventFilter(QObject*, QEvent* event) override {
        m_isPainted = m_isPainted || event->type() == QEvent::Paint;
        return false;
    }

private:
    bool m_isPainted = false;
};

const char* nameOf(Page page) {
    constexpr const char* kNames[] = {"Rig", "Objects", "Calibrate", "Targets", "Run", "Review"};
    return kNames[static_cast<int>(page)];
}

/// In a recorded run at a speed; the state that it did not come to, or nothing.
const char* startRun(MainWindow& window, double speed) {
    const auto reached = [&](RunState wanted) {
        return waitFor([&] { return window.lastSnapshot().state == wanted; }, 60000);
    };
    window.engine().send(SetSimulationSpeed{20.0});
    if (!waitFor([&] { return window.lastSnapshot().simulationSpeed == 20.0; },
                 20000) || // after what was sent
        !reached(RunState::Ready))
        return "never ready";
    window.actions().verb(Verb::Arm)->trigger();
    if (!reached(RunState::Armed))
        return "never armed";
    window.actions().verb(Verb::Start)->trigger();
    if (!reached(RunState::Running))
        return "never running";
    if (window.lastSnapshot().recordingPath.empty())
        return "not recorded";
    window.engine().send(SetSimulationSpeed{speed});
    return nullptr;
}

/// The longest block of a stretch of five seconds: that of the quietest of three, since whatever else the
/// machine does comes on top. The longest of all is told beside it.
void watchBlocks(benchmark::State& state, const std::string& what) {
    double quietest_ms = std::numeric_limits<double>::infinity(), longest_ms = 0.0;
    std::vector<double> all_s;
    for (int stretch = 0; stretch < 3; ++stretch) {
        GuiWatchdog watchdog;
        rest(5000);
        quietest_ms = std::min(quietest_ms, watchdog.longestBlock_s() * 1e3);
        longest_ms = std::max(longest_ms, watchdog.longestBlock_s() * 1e3);
        all_s.insert(all_s.end(), watchdog.blocks_s().begin(), watchdog.blocks_s().end());
    }
    state.counters["block_p99_ms"] = percentile(all_s, 0.99) * 1e3;
    state.counters["longest_block_ms"] = longest_ms;
    judge(state, what, "block_ms", quietest_ms, kBlock_ms);
}

/// A page while a recorded run at `speed` simulated seconds a second is on.
void guiDuringRun(benchmark::State& state) {
    const auto page = static_cast<Page>(state.range(1));
    inWindow(state, [&](MainWindow& window) {
        if (const char* failure = startRun(window, static_cast<double>(state.range(0))))
            return fail(state, failure);
        window.pages().show(page);
        const auto* scene = window.findChild<QWidget*>(QStringLiteral("runScene"))->findChild<VtkView*>();
        std::vector<double> frames_s;
        int seen = scene->frames();
        QTimer frames;
        QObject::connect(&frames, &QTimer::timeout, [&] {
            if (scene->frames() != seen) {
                seen = scene->frames();
                frames_s.push_back(scene->lastFrame_s());
            }
        });
        frames.start(10);
        watchBlocks(state, std::string("run, ") + nameOf(page));
        frames.stop();
        if (page == Page::Run && frames_s.empty())
            return fail(state, "the scene was not drawn");
        if (!frames_s.empty()) {
            state.counters["frame_median_ms"] = percentile(frames_s, 0.5) * 1e3;
            state.counters["frame_p99_ms"] = percentile(frames_s, 0.99) * 1e3;
        }
        state.SetLabel(nameOf(page));
    });
}
BENCHMARK(guiDuringRun)
    ->ArgNames({"speed", "page"})
    ->ArgsProduct({{1, 20}, {0, 1, 2, 3, 4, 5}})
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime()
    ->Iterations(1);

/// The Run page in a recorded run of the rig with a thermal camera, with its picture in front.
void guiWithThermalPicture(benchmark::State& state) {
    inWindow(state, [&](MainWindow& window) {
        window.files().openExample(QStringLiteral("thermal-camera"));
        if (const char* failure = startRun(window, static_cast<double>(state.range(0))))
            return fail(state, failure);
        auto* tabs = window.findChild<QTabWidget*>(QStringLiteral("plotTabs"));
        tabs->setCurrentIndex(tabs->count() - 1);
        PaintWatch picture(tabs->currentWidget());
        watchBlocks(state, "run with a thermal picture");
        if (!picture.isPainted())
            return fail(state, "the thermal picture was not drawn");
    });
}
BENCHMARK(guiWithThermalPicture)
    ->ArgName("speed")
    ->Arg(1)
    ->Arg(20)
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime()
    ->Iterations(1);

/// Keys one after another, each from the key to the end of the first painting after it, and the longest block
/// meanwhile.
class Keys {
public:
    template <class Press> void press(QWidget* picture, const Press& press) {
        PaintWatch watch(picture);
        GuiWatchdog watchdog;
        QElapsedTimer timer;
        timer.start();
        press();
        const bool isPainted = waitFor([&] { return watch.isPainted(); }, 5000);
        const double is_ms = isPainted ? static_cast<double>(timer.nsecsElapsed()) * 1e-6
                                       : std::numeric_limits<double>::infinity();
        rest(60); // what follows it
        times_ms.push_back(is_ms);
        blocks_ms.push_back(watchdog.longestBlock_s() * 1e3);
    }
    void judge(benchmark::State& state, const std::string& what, const std::string& counter) const {
        bask::judge(state, what, counter + "_to_picture_ms", percentile(times_ms, 1.0), kKeyToPicture_ms);
        bask::judge(state, what, counter + "_block_ms", percentile(blocks_ms, 1.0), kBlock_ms);
    }

    std::vector<double> times_ms, blocks_ms;
};

/// From Ctrl and a digit to the page's picture: the first time, when it is made, and ten times after it.
void turnToPage(benchmark::State& state) {
    const int index = static_cast<int>(state.range(0));
    const auto page = static_cast<Page>(index);
    const auto other = page == Page::Run ? Page::Objects : Page::Run;
    inWindow(state, [&](MainWindow& window) {
        const auto turn = [&](Keys& keys) {
            window.pages().show(other);
            rest(300);
            auto* picture = window.findChild<QStackedWidget*>(QStringLiteral("pages"))->widget(index);
            keys.press(qobject_cast<QScrollArea*>(picture)->widget(), [&] {
                QTest::keyClick(&window, static_cast<Qt::Key>(Qt::Key_1 + index), Qt::ControlModifier);
            });
        };
        Keys first, later;
        turn(first);
        for (int k = 0; k < 10; ++k)
            turn(later);
        if (window.pages().page() != page)
            return fail(state, "another page");
        first.judge(state, nameOf(page), "first");
        later.judge(state, nameOf(page), "key");
        state.SetLabel(nameOf(page));
    });
}
BENCHMARK(turnToPage)
    ->ArgName("page")
    ->DenseRange(0, 5)
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime()
    ->Iterations(1);

/// From a key that changes a target to the first picture with the surfaces of the new verdict, and the
/// longest block of the GUI thread outside painting meanwhile. Time is for twenty such keys, one after
/// another.
void keyToPicture(benchmark::State& state) {
    const auto window = openWindow();
    if (!window)
        return fail(state, "no readings came");
    window->pages().show(Page::Targets);
    auto* target = window->findChild<QuantitySpinBox*>(QStringLiteral("target0"));
    auto* scene = window->findChild<TargetScene*>();
    bool drawn = false;
    QObject::connect(scene, &TargetScene::surfacesDrawn, scene, [&] { drawn = true; });
    if (!scene->hasPicture() || !waitFor([&] { return drawn; }, 30000))
        return fail(state, "no surfaces were drawn");
    std::vector<double> times_ms, blocks_ms;
    for (auto _ : state)
        for (int key = 0; key < 20; ++key) {
            drawn = false;
            GuiWatchdog watchdog;
            QElapsedTimer timer;
            timer.start();
            QTest::keyClick(target, key % 2 == 0 ? Qt::Key_Up : Qt::Key_Down);
            waitFor([&] { return drawn; }, 5000);
            times_ms.push_back(static_cast<double>(timer.nsecsElapsed()) * 1e-6);
            blocks_ms.push_back(watchdog.longestBlock_s() * 1e3);
        }
    state.counters["median_ms"] = percentile(times_ms, 0.5);
    judge(state, "Targets, surfaces", "largest_ms", percentile(times_ms, 1.0), kKeyToPicture_ms);
    judge(state, "Targets, surfaces", "longest_block_ms", percentile(blocks_ms, 1.0), kBlock_ms);
    closeWindow(*window);
}
BENCHMARK(keyToPicture)->Unit(benchmark::kMillisecond)->UseRealTime()->Iterations(1);

/// Twenty keys in a control, each to the picture that it changes.
void keysIn(benchmark::State& state, MainWindow& window, Page page, const char* control, Qt::Key up,
            Qt::Key down, const char* picture) {
    auto* field = window.findChild<QWidget*>(QLatin1String(control));
    auto* shows = window.findChild<QWidget*>(QLatin1String(picture));
    if (field == nullptr || shows == nullptr || !shows->isVisible())
        return fail(state, "there is no such control or picture");
    if (auto* canvas =
            shows->findChild<QWidget*>(QStringLiteral("tracePlotCanvas"))) // what is painted of a plot
        shows = canvas;
    field->setFocus();
    rest(500);
    Keys keys;
    for (int key = 0; key < 20; ++key)
        keys.press(shows, [&] { QTest::keyClick(field, key % 2 == 0 ? up : down); });
    keys.judge(state, nameOf(page), "key");
}

/// Turns the tabs until the one with this widget is in front.
void showTabWith(const MainWindow& window, const char* tabs, const char* widget) {
    auto* all = window.findChild<QTabWidget*>(QLatin1String(tabs));
    const auto* wanted = window.findChild<QWidget*>(QLatin1String(widget));
    for (int tab = 0; tab < all->count() && !wanted->isVisible(); ++tab)
        all->setCurrentIndex(tab);
}

/// A limit on the Rig page; harmonics of an outline; the sheet of a board.
void keyOnRig(benchmark::State& state) {
    inWindow(state, [&](MainWindow& window) {
        window.pages().show(Page::Rig);
        showTabWith(window, "rigTabs", "maxSpeed");
        keysIn(state, window, Page::Rig, "maxSpeed", Qt::Key_Up, Qt::Key_Down, "maxSpeed");
    });
}
BENCHMARK(keyOnRig)->Unit(benchmark::kMillisecond)->UseRealTime()->Iterations(1);

void keyOnObjects(benchmark::State& state) {
    inWindow(state, [&](MainWindow& window) {
        window.pages().show(Page::Objects);
        window.pages().objects()->selectObject(1);
        const auto* fits = window.findChild<FourierFits*>();
        if (!waitFor([&] { return fits->complete(); }, 60000))
            return fail(state, "never fitted");
        keysIn(state, window, Page::Objects, "harmonicsSlider", Qt::Key_Right, Qt::Key_Left,
               "outlinePreview");
    });
}
BENCHMARK(keyOnObjects)->Unit(benchmark::kMillisecond)->UseRealTime()->Iterations(1);

void keyOnCalibrate(benchmark::State& state) {
    inWindow(state, [&](MainWindow& window) {
        window.pages().show(Page::Calibrate);
        showTabWith(window, "calibrateTabs", "sheetPreview");
        keysIn(state, window, Page::Calibrate, "sheetSide", Qt::Key_Up, Qt::Key_Down, "sheetPreview");
    });
}
BENCHMARK(keyOnCalibrate)->Unit(benchmark::kMillisecond)->UseRealTime()->Iterations(1);

/// Zooms the traces of a recorded run, while it is on and in Review; moves the replay.
void keyOnTraces(benchmark::State& state) {
    const bool isReview = state.range(0) == 1;
    inWindow(state, [&](MainWindow& window) {
        if (const char* failure = startRun(window, 20.0))
            return fail(state, failure);
        if (!waitFor([&] { return window.lastSnapshot().runTime_s > 60.0; }, 60000))
            return fail(state, "the run does not go on");
        if (isReview) {
            window.actions().verb(Verb::Stop)->trigger();
            bool isOpened = false;
            QObject::connect(&window.files(), &SessionActions::sessionOpened, &window,
                             [&] { isOpened = true; });
            window.files().open(QString::fromStdString(window.lastSnapshot().recordingPath));
            if (!waitFor([&] { return isOpened; }, 60000))
                return fail(state, "the recording was not opened");
            keysIn(state, window, Page::Review, "replaySlider", Qt::Key_Right, Qt::Key_Left,
                   "review.measured_K");
        } else {
            window.pages().show(Page::Run);
            keysIn(state, window, Page::Run, "plot.measured_K", Qt::Key_Plus, Qt::Key_Minus,
                   "plot.measured_K");
        }
    });
}
BENCHMARK(keyOnTraces)
    ->ArgName("review")
    ->Arg(0)
    ->Arg(1)
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime()
    ->Iterations(1);

/// The longest block of the GUI thread while views of a board come live, are taken, and the camera is solved
/// from fifteen of them.
void guiWhileCalibrating(benchmark::State& state) {
    inWindow(state, [&](MainWindow& window) {
        window.pages().show(Page::Calibrate);
        const auto* panel = window.findChild<QWidget*>(QStringLiteral("cameraPanel"));
        const auto button = [&](const char* name) {
            return panel->findChild<QAbstractButton*>(QLatin1String(name));
        };
        auto* verdict = panel->findChild<QLabel*>(QStringLiteral("cameraVerdict"));
        const auto* views = panel->findChild<QTreeWidget*>(QStringLiteral("viewList"));
        GuiWatchdog live;
        button("captureStart")->click();
        if (!waitFor([&] { return views->topLevelItemCount() >= 15; }, 90000))
            return fail(state, "no fifteen views");
        judge(state, "Calibrate, live", "live_block_ms", live.longestBlock_s() * 1e3, kBlock_ms);
        const QString before = verdict->text();
        GuiWatchdog solving;
        button("solve")->click();
        if (!waitFor([&] { return verdict->text() != before; }, 60000))
            return fail(state, "no camera");
        judge(state, "Calibrate, solving", "solving_block_ms", solving.longestBlock_s() * 1e3, kBlock_ms);
    });
}
BENCHMARK(guiWhileCalibrating)->Unit(benchmark::kMillisecond)->UseRealTime()->Iterations(1);

} // namespace
} // namespace bask

int main(int argc, char** argv) {
    const QTemporaryDir settings;
    qputenv("BASK_SETTINGS_DIR", settings.path().toLocal8Bit());
    bask::MeasuredApplication application(argc, argv);
    std::setlocale(LC_NUMERIC, "C");
    QLocale::setDefault(QLocale::c());
    bask::applyTheme(application, bask::Theme::Light);
    benchmark::Initialize(&argc, argv);
    benchmark::RunSpecifiedBenchmarks();
    benchmark::Shutdown();
    for (const std::string& one : bask::beyond)
        std::fprintf(stderr, "beyond the limit, or not measured: %s\n", one.c_str());
    return bask::beyond.empty() ? 0 : 1;
}
