// One frame of tracking at 1280 x 720, four 50 mm markers at 0.6 m, f = 1000 px: near the last place, by the
// whole picture, and lost. Wanted at 30 frames a second: under half a core, 16 ms of its time a frame; near
// the last place 5 ms.

#include "engine/vision/part_tracker.h"
#include "tests/support/marker_pictures.h"

#include <benchmark/benchmark.h>

namespace bask {
namespace {

const Pose kX_CS = test::facingFrom({-0.03, 0.02, 0.6}, {0.35, 0.2, 0.1});
constexpr double kFrame_s = 1.0 / 30.0;

std::vector<CameraFrame> frames(bool shown) {
    test::MarkerPictures pictures(test::plainCamera());
    std::vector<CameraFrame> result;
    for (int k = 0; k < 10; ++k) {
        GreyPicture picture = shown ? pictures.of(test::fourOnTheSource(), kX_CS) : pictures.blank();
        if (!shown)
            pictures.addNoise(picture);
        result.push_back({0.0, 0.0, 0, std::move(picture)});
    }
    return result;
}

void follow(benchmark::State& state, bool shown) {
    std::vector<CameraFrame> film = frames(shown);
    PartTracker tracker(test::fourOnTheSource(), Part::Source, test::plainCamera());
    std::size_t k = 0;
    int searchedAll = 0;
    for (auto _ : state) {
        CameraFrame& frame = film[k % film.size()];
        frame.time_s = kFrame_s * static_cast<double>(++k);
        searchedAll += tracker.step(frame).searchedAll ? 1 : 0;
    }
    state.counters["searchedAll"] = searchedAll / static_cast<double>(state.iterations());
}

void near(benchmark::State& state) {
    follow(state, true);
}

void lost(benchmark::State& state) {
    follow(state, false);
}

void everyFrameAnew(benchmark::State& state) {
    const std::vector<CameraFrame> film = frames(true);
    PartTracker tracker(test::fourOnTheSource(), Part::Source, test::plainCamera());
    std::size_t k = 0;
    for (auto _ : state) {
        tracker.forget();
        benchmark::DoNotOptimize(tracker.step(film[k++ % film.size()]));
    }
}

void searchOnly(benchmark::State& state) {
    const std::vector<CameraFrame> film = frames(true);
    const MarkerLayout layout = test::fourOnTheSource();
    const auto regions = state.range(0) == 0 ? expectedMarkers(layout, Part::Source, test::plainCamera(),
                                                               kX_CS, Matrix6d::Identity() * 1e-8)
                                                   .regions
                                             : std::vector{wholeOf(film[0].picture)};
    std::size_t k = 0;
    for (auto _ : state)
        benchmark::DoNotOptimize(findMarkersIn(film[k++ % film.size()].picture, regions, layout.dictionary));
}

BENCHMARK(near)->Unit(benchmark::kMillisecond)->MeasureProcessCPUTime()->UseRealTime();
BENCHMARK(everyFrameAnew)->Unit(benchmark::kMillisecond)->MeasureProcessCPUTime()->UseRealTime();
BENCHMARK(lost)->Unit(benchmark::kMillisecond)->MeasureProcessCPUTime()->UseRealTime();
BENCHMARK(searchOnly)->Arg(0)->Arg(1)->Unit(benchmark::kMillisecond)->MeasureProcessCPUTime()->UseRealTime();

} // namespace
} // namespace bask
