// The Objects page: one redraw while the slider of harmonics is dragged, and what an import takes. Needs no
// display.

#include "engine/experiment/experiment_file.h"
#include "engine/shape/contour_import.h"
#include "engine/shape/svg_outlines.h"
#include "widgets/common/theme.h"
#include "widgets/objects/fourier_fits.h"
#include "widgets/objects/objects_page.h"

#include <QApplication>
#include <QDeadlineTimer>
#include <QElapsedTimer>
#include <QFile>
#include <QImage>
#include <QLocale>
#include <QSlider>
#include <QTemporaryDir>

#include <benchmark/benchmark.h>

#include <clocale>
#include <cmath>
#include <fstream>

namespace bask {
namespace {

constexpr int kFewHarmonics = 1, kHarmonics = 20;

/// The bunny's outline with `n` points at even distances.
Contour bunny(int n) {
    const Contour outline =
        centred(readContourCsv(BASK_EXAMPLES "/contours/bunny_mm.csv", LengthUnit::Millimetre).value());
    const double step_m = contourPerimeter(outline) / n;
    Contour fine;
    double left_m = 0.0; // along the edge, to the next point
    for (std::size_t k = 0; k < outline.points_m.size(); ++k) {
        const Eigen::Vector2d a = outline.points_m[k];
        const Eigen::Vector2d edge = outline.points_m[(k + 1) % outline.points_m.size()] - a;
        for (; left_m < edge.norm(); left_m += step_m)
            fine.points_m.push_back(a + left_m * edge.normalized());
        left_m -= edge.norm();
    }
    return fine;
}

/// All that a move of the slider's handle does, and the page drawn: with `range(0)` points.
void sliderMove(benchmark::State& state) {
    Experiment experiment = readExperiment(BASK_EXAMPLES "/three-objects.json").value();
    ObjectSpec& object = experiment.objects[1];
    object.origin.outline = bunny(static_cast<int>(state.range(0)));
    ObjectsPage page;
    page.resize(1600, 900);
    page.setExperiment(experiment);
    page.selectObject(1);
    const auto* fits = page.findChild<FourierFits*>();
    auto* slider = page.findChild<QSlider*>("harmonicsSlider");
    for (const QDeadlineTimer deadline(120'000); !fits->complete() && !deadline.hasExpired();)
        QCoreApplication::processEvents(QEventLoop::WaitForMoreEvents | QEventLoop::AllEvents, 100);
    if (!fits->complete())
        return state.SkipWithError("never fitted");
    QImage picture(page.size(), QImage::Format_ARGB32_Premultiplied);
    page.render(&picture);
    slider->setSliderDown(true);
    for (auto _ : state) {
        slider->setValue(slider->value() % kMaxHarmonics + 1);
        page.render(&picture);
    }
    slider->setSliderDown(false);
    state.counters["frames/s"] =
        benchmark::Counter(static_cast<double>(state.iterations()), benchmark::Counter::kIsRate);
}
BENCHMARK(sliderMove)->ArgName("points")->Arg(1000)->Arg(60000)->Unit(benchmark::kMillisecond)->UseRealTime();

/// From an outline of 60,000 points to the fit that is shown, and to all 40 (counter `all_s`).
void fitsOffTheGuiThread(benchmark::State& state) {
    const Contour outline = bunny(60000);
    double all_s = 0.0;
    for (auto _ : state) {
        QElapsedTimer timer;
        timer.start();
        FourierFits fits;
        fits.setOutline(outline);
        fits.want(kHarmonics);
        while (!fits.fit(kHarmonics))
            QCoreApplication::processEvents(QEventLoop::WaitForMoreEvents | QEventLoop::AllEvents, 10);
        state.SetIterationTime(static_cast<double>(timer.nsecsElapsed()) * 1e-9);
        while (!fits.complete())
            QCoreApplication::processEvents(QEventLoop::WaitForMoreEvents | QEventLoop::AllEvents, 10);
        all_s += static_cast<double>(timer.nsecsElapsed()) * 1e-9;
    }
    state.counters["all_s"] = all_s / static_cast<double>(state.iterations());
}
BENCHMARK(fitsOffTheGuiThread)->Unit(benchmark::kMillisecond)->UseManualTime()->Iterations(3);

const QTemporaryDir& folder() {
    static const QTemporaryDir made;
    return made;
}

std::string hugeList() {
    const std::string path = folder().filePath("huge.csv").toStdString();
    std::ofstream file(path);
    file.precision(9);
    file << "x_mm,y_mm\n";
    for (const Eigen::Vector2d& p : bunny(60000).points_m)
        file << p.x() * 1e3 << ',' << p.y() * 1e3 << '\n';
    return path;
}

void bytesOf(benchmark::State& state, const std::string& path) {
    for (auto _ : state) {
        QFile file(QString::fromStdString(path));
        if (!file.open(QIODevice::ReadOnly))
            return state.SkipWithError("not there");
        benchmark::DoNotOptimize(file.readAll());
    }
}

// Baselines of what follows: the same bytes from the disk, and a fit of one harmonic.
void hugeListBytes(benchmark::State& state) {
    bytesOf(state, hugeList());
}
BENCHMARK(hugeListBytes)->Unit(benchmark::kMillisecond);

void hugeListReadAndFitted(benchmark::State& state) {
    const std::string path = hugeList();
    for (auto _ : state) {
        const auto contour = readContour(path, {});
        if (!contour)
            return state.SkipWithError("not read");
        benchmark::DoNotOptimize(fitFourier(*contour, static_cast<int>(state.range(0))));
    }
}
BENCHMARK(hugeListReadAndFitted)
    ->ArgName("harmonics")
    ->Arg(kFewHarmonics)
    ->Arg(kHarmonics)
    ->Unit(benchmark::kMillisecond);

const std::string kHugeDrawing = BASK_TEST_DATA "/contours/svg/huge_bamboo.svg"; // 1.5 MB

void hugeDrawingBytes(benchmark::State& state) {
    bytesOf(state, kHugeDrawing);
}
BENCHMARK(hugeDrawingBytes)->Unit(benchmark::kMillisecond);

void hugeDrawingRead(benchmark::State& state) {
    for (auto _ : state) {
        const auto file = readSvgOutlines(kHugeDrawing);
        if (!file)
            return state.SkipWithError("not read");
        benchmark::DoNotOptimize(file->outlines.size());
    }
}
BENCHMARK(hugeDrawingRead)->Unit(benchmark::kMillisecond);

} // namespace
} // namespace bask

int main(int argc, char** argv) {
    qputenv("QT_QPA_PLATFORM", "offscreen");
    QApplication application(argc, argv);
    std::setlocale(LC_NUMERIC, "C");
    QLocale::setDefault(QLocale::c());
    bask::applyTheme(application, bask::Theme::Light);
    benchmark::Initialize(&argc, argv);
    benchmark::RunSpecifiedBenchmarks();
    benchmark::Shutdown();
    return 0;
}
