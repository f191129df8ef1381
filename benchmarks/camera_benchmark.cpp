// A frame of the simulated camera at 1280 x 720 with seven markers, without and with a board held before it,
// and setting the camera up. Wanted: a frame in under 15 ms on one core.

#include "engine/simulation/simulated_camera.h"

#include <benchmark/benchmark.h>

namespace bask {
namespace {

Pose at(double x, double y, double z) {
    return Pose(Eigen::Translation3d(x, y, z));
}

SimulatedCameraConfig rig() {
    SimulatedCameraConfig config;
    config.isWallLimited = false;
    config.markers.dictionary = {"4X4_50"};
    int id = 0;
    for (const auto& [x, y] : {std::pair(-0.12, 0.12), {0.12, 0.12}, {0.12, -0.12}, {-0.12, -0.12}})
        config.markers.markers.push_back({Part::Source, id++, 0.05, at(x, y, 0)});
    for (const auto& [x, y] : {std::pair(-0.06, 0.04), {0.06, 0.04}, {0.0, -0.05}})
        config.markers.markers.push_back({Part::EndEffector, id++, 0.05, at(x, y, 0.03)});
    for (const auto& [x, y] : {std::pair(-0.06, 0.0), {0.06, 0.0}, {0.0, 0.07}})
        config.objects.push_back({Disk{0.03}, at(x, y, 0)});
    return config;
}

void frame(benchmark::State& state, const std::string& board) {
    SimulatedCamera camera(rig());
    double time_s = 0.0;
    const auto next = [&] {
        camera.observe({time_s += 0.1, at(0.02 * std::sin(time_s), 0.0, 0.15), Pose::Identity()});
        return camera.newest();
    };
    if (!board.empty())
        camera.setBoard(*parseBoard(board));
    for (auto _ : state)
        benchmark::DoNotOptimize(next());
}

BENCHMARK_CAPTURE(frame, rig, "")->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(frame, board, "charuco:5x7:0.04:0.03:4X4_50")->Unit(benchmark::kMillisecond);

void setUp(benchmark::State& state) {
    for (auto _ : state)
        SimulatedCamera camera(rig());
}
BENCHMARK(setUp)->Unit(benchmark::kMillisecond);

} // namespace
} // namespace bask
