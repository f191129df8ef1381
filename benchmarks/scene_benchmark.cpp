// Frame time of the 3-D scenes, three objects, 1000 x 700: a trajectory of 600 or 30,000 samples, one new
// sample a frame; the targets' surfaces at the 1 cm grid, turned, or new ones each frame.

#include "engine/base/units.h"
#include "engine/exchange/target_surfaces.h"
#include "engine/experiment/experiment_file.h"
#include "widgets/common/theme.h"
#include "widgets/scene/scene_view.h"
#include "widgets/scene/target_scene.h"
#include "widgets/scene/vtk_view.h"

#include <QApplication>
#include <QElapsedTimer>
#include <QWindow>

#include <benchmark/benchmark.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <numbers>
#include <vector>

namespace bask {
namespace {

ObjectSpec object(const std::string& name, Shape shape, double x_m, double y_m) {
    ObjectSpec spec;
    spec.name = name;
    spec.shape = std::move(shape);
    spec.mounting[kX] = x_m;
    spec.mounting[kY] = y_m;
    return spec;
}

Experiment threeObjects() {
    Experiment experiment;
    experiment.objects = {
        object("circle", Disk{0.015}, 0.0, 0.05),
        object("bunny", FourierContour({{0.004, 0.0}, {0.0, 0.0}, {0.027, 0.0}, {0.003, 0.0}, {0.0, 0.002}}),
               -0.0435, -0.025),
        object("hand", FourierContour({{0.0, 0.003}, {0.0, 0.0}, {0.025, 0.0}, {0.0, 0.0}, {0.004, 0.0}}),
               0.0435, -0.025)};
    return experiment;
}

/// Sample `i` of a run that wanders through the whole workspace and never stands still: the worst case for
/// the trail.
TraceSample sampleAt(int i, int count) {
    const double t = static_cast<double>(i) / count;
    const double angle = 24.0 * std::numbers::pi * t;
    TraceSample sample;
    sample.time_s = i;
    sample.source_K = kelvinFromCelsius(200.0);
    sample.coordinates << 0.18 * t * std::cos(angle), 0.18 * t * std::sin(angle), 0.28 - 0.25 * t,
        0.5 * std::sin(3.0 * angle), 0.0, 0.0;
    for (const double target_degC : {50.0, 40.0, 35.0}) {
        ObjectSample reading;
        reading.estimated_K = kelvinFromCelsius(25.0 + (target_degC - 25.0) * t + 2.0 * std::sin(angle));
        sample.objects.push_back(reading);
    }
    return sample;
}

/// Draws one frame to the pixels in the window and waits for it.
void drawFrame(VtkView& picture) {
    const int before = picture.frames();
    picture.update();
    while (picture.frames() == before)
        QApplication::processEvents();
}

double median(std::vector<double> values) {
    std::sort(values.begin(), values.end());
    return values[values.size() / 2];
}

/// One frame with a new sample: wall time (others' load included) and this process's processor time on all
/// cores.
void frame(benchmark::State& state) {
    SceneView view;
    view.resize(1000, 700);
    view.setExperiment(threeObjects());
    const int count = static_cast<int>(state.range(0));
    std::vector<TraceSample> samples;
    for (int i = 0; i < count; ++i)
        samples.push_back(sampleAt(i, count));
    view.setSamples(samples);
    view.show();
    auto* picture = view.findChild<VtkView*>();
    if (picture == nullptr) {
        state.SkipWithError("no OpenGL 3.2 on this display");
        return;
    }
    QElapsedTimer timer;
    timer.start();
    while (!view.windowHandle()->isExposed() && timer.elapsed() < 5000)
        QApplication::processEvents();
    if (!view.windowHandle()->isExposed()) {
        state.SkipWithError("the display does not show the window");
        return;
    }
    drawFrame(*picture);
    std::vector<double> frames_ms;
    std::vector<double> processor_ms;
    int next = 0;
    for ([[maybe_unused]] auto _ : state) {
        const std::clock_t processor = std::clock();
        timer.start();
        view.appendSamples({samples[static_cast<std::size_t>(next++ % count)]});
        drawFrame(*picture);
        const double elapsed_s = 1e-9 * static_cast<double>(timer.nsecsElapsed());
        state.SetIterationTime(elapsed_s);
        frames_ms.push_back(1e3 * elapsed_s);
        processor_ms.push_back(1e3 * static_cast<double>(std::clock() - processor) / CLOCKS_PER_SEC);
    }
    state.counters["median_ms"] = median(frames_ms);
    state.counters["max_ms"] = *std::max_element(frames_ms.begin(), frames_ms.end());
    state.counters["processor_ms"] = median(processor_ms);
}
BENCHMARK(frame)
    ->Name("scene_frame")
    ->Arg(600)
    ->Arg(30000)
    ->Iterations(100)
    ->UseManualTime()
    ->Unit(benchmark::kMillisecond);

std::vector<Isosurface> surfacesOf(const Experiment& experiment) {
    TargetGeometry geometry{RadiatingContour(experiment.source.shape),
                            Pose::Identity(),
                            {},
                            {},
                            surfaceAxes(PoseSubset::Translation, experiment.robot, kSurfaceStep_m)};
    for (const ObjectSpec& spec : experiment.objects)
        geometry.objects.push_back({RadiatingContour(spec.shape), poseFromCoordinates(spec.mounting)});
    const auto fields = targetFields(geometry);
    return *targetSurfaces(*fields, std::array{0.35, 0.2, 0.13});
}

/// One frame of the targets' surfaces; with a range of 1 they are new each time.
void targetFrame(benchmark::State& state) {
    const Experiment experiment = *readExperiment(BASK_EXAMPLES "/three-objects.json");
    const std::vector<Isosurface> surfaces = surfacesOf(experiment);
    TargetScene scene;
    scene.resize(1000, 700);
    scene.setExperiment(experiment);
    scene.setSurfaces(surfaces, experiment.start);
    scene.show();
    auto* picture = scene.findChild<VtkView*>();
    if (picture == nullptr) {
        state.SkipWithError("no OpenGL 3.2 on this display");
        return;
    }
    drawFrame(*picture);
    std::vector<double> frames_ms;
    std::vector<double> processor_ms;
    QElapsedTimer timer;
    for ([[maybe_unused]] auto _ : state) {
        const std::clock_t processor = std::clock();
        timer.start();
        if (state.range(0) == 1)
            scene.setSurfaces(surfaces, experiment.start);
        drawFrame(*picture);
        const double elapsed_s = 1e-9 * static_cast<double>(timer.nsecsElapsed());
        state.SetIterationTime(elapsed_s);
        frames_ms.push_back(1e3 * elapsed_s);
        processor_ms.push_back(1e3 * static_cast<double>(std::clock() - processor) / CLOCKS_PER_SEC);
    }
    state.counters["median_ms"] = median(frames_ms);
    state.counters["max_ms"] = *std::max_element(frames_ms.begin(), frames_ms.end());
    state.counters["processor_ms"] = median(processor_ms);
}
BENCHMARK(targetFrame)
    ->Name("target_frame")
    ->Arg(0)
    ->Arg(1)
    ->Iterations(60)
    ->UseManualTime()
    ->Unit(benchmark::kMillisecond);

/// What 1,000 appended samples cost the GUI thread besides frames.
void append(benchmark::State& state) {
    SceneView view;
    view.setExperiment(threeObjects());
    std::vector<TraceSample> samples;
    for (int i = 0; i < 1000; ++i)
        samples.push_back(sampleAt(i, 1000));
    for ([[maybe_unused]] auto _ : state)
        view.appendSamples(samples);
}
BENCHMARK(append)->Name("scene_append_1000")->Unit(benchmark::kMillisecond);

} // namespace
} // namespace bask

int main(int argc, char** argv) {
    if (qEnvironmentVariableIsEmpty("DISPLAY") && qEnvironmentVariableIsEmpty("WAYLAND_DISPLAY") &&
        qEnvironmentVariableIsEmpty("QT_QPA_PLATFORM")) {
        std::puts("No display: the scene's frame time is not measured. Try: xvfb-run -a -s \"-screen 0 "
                  "1600x1000x24\" "
                  "bask_scene_benchmark");
        return 0;
    }
    benchmark::Initialize(&argc, argv);
    QApplication application(argc, argv);
    bask::applyTheme(application, bask::Theme::Light);
    benchmark::RunSpecifiedBenchmarks();
    return 0;
}
