// Start to first picture, longest block of the GUI thread outside painting, and time of a frame, while a run
// is on. Needs a display with OpenGL: xvfb-run -a -s "-screen 0 1600x1000x24" bask_gui_benchmark

#include "app/gui_watchdog.h"
#include "app/main_window.h"
#include "widgets/common/quantity_spin_box.h"
#include "widgets/scene/target_scene.h"
#include "widgets/scene/vtk_view.h"

#include <QAbstractButton>
#include <QDeadlineTimer>
#include <QLabel>
#include <QLocale>
#include <QTemporaryDir>
#include <QTest>
#include <QTreeWidget>

#include <benchmark/benchmark.h>

#include <algorithm>
#include <clocale>
#include <memory>

namespace bask {
namespace {

template <class Condition> bool waitFor(Condition condition, int limit_ms) {
    const QDeadlineTimer deadline(limit_ms);
    while (!condition()) {
        if (deadline.hasExpired())
            return false;
        QCoreApplication::processEvents(QEventLoop::AllEvents, 10);
    }
    return true;
}

std::unique_ptr<MainWindow> openWindow() {
    auto window = std::make_unique<MainWindow>();
    window->resize(1280, 800);
    window->show();
    window->begin({});
    if (!waitFor([&] { return !window->lastSnapshot().latest.objects.empty(); }, 20000))
        return nullptr;
    window->repaint();
    return window;
}

void closeWindow(MainWindow& window) {
    window.setCloseQuestion([] { return Closing::Now; });
    window.close();
}

void startToFirstPicture(benchmark::State& state) {
    for (auto _ : state) {
        const auto window = openWindow();
        if (!window)
            return state.SkipWithError("no readings came");
        state.PauseTiming();
        closeWindow(*window);
        state.ResumeTiming();
    }
}
BENCHMARK(startToFirstPicture)->Unit(benchmark::kMillisecond)->UseRealTime()->Iterations(3);

double percentile(std::vector<double> values, double p) {
    std::ranges::sort(values);
    return values.empty() ? 0.0
                          : values[static_cast<std::size_t>(p * static_cast<double>(values.size() - 1))];
}

/// A run at `speed` simulated seconds a second, watched for ten seconds of wall time.
void guiDuringRun(benchmark::State& state) {
    for (auto _ : state) {
        const auto window = openWindow();
        if (!window)
            return state.SkipWithError("no readings came");
        const auto reached = [&](RunState wanted) {
            return waitFor([&] { return window->lastSnapshot().state == wanted; }, 30000);
        };
        window->engine().send(SetSimulationSpeed{20.0});
        if (!reached(RunState::Ready))
            return state.SkipWithError("never ready");
        window->actions().verb(Verb::Arm)->trigger();
        if (!reached(RunState::Armed))
            return state.SkipWithError("never armed");
        window->actions().verb(Verb::Start)->trigger();
        if (!reached(RunState::Running))
            return state.SkipWithError("never running");
        window->engine().send(SetSimulationSpeed{static_cast<double>(state.range(0))});
        const auto* page = window->findChild<QWidget*>(QStringLiteral("runScene"));
        const auto* scene = page != nullptr ? page->findChild<VtkView*>() : nullptr;
        std::vector<double> frames_s;
        int seen = scene != nullptr ? scene->frames() : 0;
        GuiWatchdog watchdog;
        const QDeadlineTimer over(10000);
        waitFor(
            [&] {
                if (scene != nullptr && scene->frames() != seen) {
                    seen = scene->frames();
                    frames_s.push_back(scene->lastFrame_s());
                }
                return over.hasExpired();
            },
            20000);
        if (frames_s.empty())
            return state.SkipWithError("the scene was not drawn");
        state.counters["longest_block_ms"] = watchdog.longestBlock_s() * 1e3;
        state.counters["block_p99_ms"] = percentile(watchdog.blocks_s(), 0.99) * 1e3;
        state.counters["frame_median_ms"] = percentile(frames_s, 0.5) * 1e3;
        state.counters["frame_p99_ms"] = percentile(frames_s, 0.99) * 1e3;
        state.counters["frames"] = static_cast<double>(frames_s.size());
        closeWindow(*window);
    }
}
BENCHMARK(guiDuringRun)
    ->ArgName("speed")
    ->Arg(1)
    ->Arg(20)
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime()
    ->Iterations(1);

/// From a key that changes a target to the first picture with the surfaces of the new verdict, and the
/// longest block of the GUI thread outside painting meanwhile. Time is for twenty such keys, one after
/// another.
void keyToPicture(benchmark::State& state) {
    const auto window = openWindow();
    if (!window)
        return state.SkipWithError("no readings came");
    window->pages().show(Page::Targets);
    auto* target = window->findChild<QuantitySpinBox*>(QStringLiteral("target0"));
    auto* scene = window->findChild<TargetScene*>();
    bool drawn = false;
    QObject::connect(scene, &TargetScene::surfacesDrawn, scene, [&] { drawn = true; });
    if (!scene->hasPicture() || !waitFor([&] { return drawn; }, 30000))
        return state.SkipWithError("no surfaces were drawn");
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
    state.counters["largest_ms"] = percentile(times_ms, 1.0);
    state.counters["longest_block_ms"] = percentile(blocks_ms, 1.0);
    window->document().markSaved({}); // or closing asks
    closeWindow(*window);
}
BENCHMARK(keyToPicture)->Unit(benchmark::kMillisecond)->UseRealTime()->Iterations(1);

/// The longest block of the GUI thread while views of a board come live, are taken, and the camera is solved
/// from fifteen of them.
void guiWhileCalibrating(benchmark::State& state) {
    for (auto _ : state) {
        const auto window = openWindow();
        if (!window)
            return state.SkipWithError("no readings came");
        window->pages().show(Page::Calibrate);
        const auto button = [&](const char* name) {
            return window->findChild<QAbstractButton*>(QLatin1String(name));
        };
        auto* verdict = window->findChild<QLabel*>(QStringLiteral("cameraVerdict"));
        const auto* views = window->findChild<QTreeWidget*>(QStringLiteral("viewList"));
        GuiWatchdog live;
        button("captureStart")->click();
        if (!waitFor([&] { return views->topLevelItemCount() >= 15; }, 90000))
            return state.SkipWithError("no fifteen views");
        state.counters["live_block_ms"] = live.longestBlock_s() * 1e3;
        const QString before = verdict->text();
        GuiWatchdog solving;
        button("solve")->click();
        if (!waitFor([&] { return verdict->text() != before; }, 60000))
            return state.SkipWithError("no camera");
        state.counters["solving_block_ms"] = solving.longestBlock_s() * 1e3;
        closeWindow(*window);
    }
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
    return 0;
}
