// X_SE from 30 frames, a part's pose from one (as tracking would want it 30 times a second), hand-eye from 15
// poses of the robot. Wanted: a solve that no one waits for (0.1 s), a frame's pose in under 3 ms.

#include "engine/calibration/hand_eye.h"
#include "engine/calibration/projection.h"
#include "engine/calibration/relative_pose.h"

#include <benchmark/benchmark.h>

#include <numbers>
#include <random>

namespace bask {
namespace {

/// Four markers of 50 mm on the source, three on the end-effector, corners uncertain by 0.2 px.
struct Scene {
    CameraModel camera;
    MarkerLayout layout{{"4X4_50"}, {}};
    Pose X_CS = at({-0.12, 0.02, 0.62}, {0.35, 0.2, 0.1}), X_CE = at({0.17, -0.03, 0.55}, {-0.3, 0.25, -0.4});
    std::mt19937 random{1};

    Scene() {
        camera.width = 1280;
        camera.height = 720;
        camera.fx = camera.fy = 1000.0;
        camera.cx = 639.5;
        camera.cy = 359.5;
        camera.distortion = {-0.1, 0.03, 0.0, 0.0, 0.0};
        int id = 0;
        for (const auto& [x, y] : {std::pair(-0.1, 0.1), {0.1, 0.1}, {0.1, -0.1}, {-0.1, -0.1}})
            layout.markers.push_back({Part::Source, id++, 0.05, Pose(Eigen::Translation3d(x, y, 0))});
        for (const auto& [x, y] : {std::pair(-0.05, 0.04), {0.05, 0.04}, {0.0, -0.06}})
            layout.markers.push_back({Part::EndEffector, id++, 0.05, Pose(Eigen::Translation3d(x, y, 0))});
    }

    static Pose at(const Eigen::Vector3d& p_m, const Eigen::Vector3d& turn_rad) {
        return poseFromRotationVector(p_m, {std::numbers::pi, 0, 0}) *
               poseFromRotationVector(Eigen::Vector3d::Zero(), turn_rad);
    }

    std::vector<MarkerFrame> frames(int count) {
        std::normal_distribution<double> noise(0.0, 0.2);
        std::vector<MarkerFrame> frames(static_cast<std::size_t>(count));
        for (MarkerFrame& frame : frames)
            for (const PlacedMarker& marker : layout.markers) {
                FoundMarker found{marker.id, {}};
                const auto places = marker.corners();
                for (std::size_t k = 0; k < 4; ++k) {
                    const Eigen::Vector3d p_C = (marker.part == Part::Source ? X_CS : X_CE) * places[k];
                    found.corners_px[k] =
                        shownAt(Lens(camera), p_C) + Eigen::Vector2d(noise(random), noise(random));
                }
                frame.push_back(found);
            }
        return frames;
    }
};

void thirtyFrames(benchmark::State& state) {
    Scene scene;
    const auto frames = scene.frames(30);
    for (auto _ : state)
        benchmark::DoNotOptimize(
            relativePose(frames, scene.layout, Part::Source, Part::EndEffector, scene.camera));
}

void oneFrame(benchmark::State& state) {
    Scene scene;
    scene.layout.markers.resize(static_cast<std::size_t>(state.range(0)));
    const auto frames = scene.frames(1);
    for (auto _ : state)
        benchmark::DoNotOptimize(partPose(frames, scene.layout, Part::Source, scene.camera));
}

void handEye(benchmark::State& state) {
    Scene scene;
    std::uniform_real_distribution<double> any(-0.5, 0.5);
    const Pose X_RC = poseFromRotationVector({0.4, -0.7, 0.5}, {-1.7, 0.4, 0.3});
    std::vector<HandEyeView> views;
    for (int k = 0; k < 15; ++k) {
        const auto number = [&] { return any(scene.random); };
        scene.X_CE = Scene::at({0.2 * number(), 0.1 * number(), 0.6}, {number(), number(), number()});
        views.push_back({X_RC * scene.X_CE, scene.frames(1)});
    }
    for (auto _ : state)
        benchmark::DoNotOptimize(calibrateHandEye(views, scene.layout, scene.camera, Mounting::Sought));
}

BENCHMARK(thirtyFrames)->Unit(benchmark::kMillisecond);
BENCHMARK(oneFrame)->Arg(1)->Arg(2)->Arg(4)->Unit(benchmark::kMillisecond);
BENCHMARK(handEye)->Unit(benchmark::kMillisecond);

} // namespace
} // namespace bask
