#include "engine/simulation/scene_renderer.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace bask {
namespace {

double hashed(std::int64_t i, std::int64_t j) { // -1 to 1, by splitmix64
    std::uint64_t x = static_cast<std::uint64_t>(i) * 0x9e3779b1ULL + static_cast<std::uint64_t>(j);
    x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9ULL;
    x = (x ^ (x >> 27)) * 0x94d049bb133111ebULL;
    return static_cast<double>((x ^ (x >> 31)) >> 11) * 0x1p-52 - 1.0;
}

// Smooth noise of the plane, -1 to 1, with cells of the unit length.
double texture(double x, double y) {
    const auto i = static_cast<std::int64_t>(std::floor(x)), j = static_cast<std::int64_t>(std::floor(y));
    const auto smooth = [](double t) { return t * t * (3.0 - 2.0 * t); };
    const double u = smooth(x - static_cast<double>(i)), v = smooth(y - static_cast<double>(j));
    return (1 - v) * ((1 - u) * hashed(i, j) + u * hashed(i + 1, j)) +
           v * ((1 - u) * hashed(i, j + 1) + u * hashed(i + 1, j + 1));
}

// Of the bench, or of the dark room round it, into which it fades.
float benchGrey(const Eigen::Vector3d& eye, const Eigen::Vector3d& direction) {
    constexpr double kRoom = 60.0, kBench = 115.0, kFade_m = 1.0, kGone_m = 2.0;
    const double t = (SceneRenderer::kBench_m - eye.z()) / direction.z();
    if (!(t > 0.0 && t < 1e3))
        return static_cast<float>(kRoom);
    const Eigen::Vector3d p = eye + t * direction;
    const double there = std::clamp((kGone_m - p.head<2>().norm()) / (kGone_m - kFade_m), 0.0, 1.0);
    const double grain =
        4.0 * texture(p.x() / 0.05, p.y() / 0.05) + 3.0 * texture(p.x() / 0.008, p.y() / 0.004);
    return static_cast<float>(kRoom + there * (kBench + grain - kRoom));
}

GreyCanvas benchSeenBy(const CameraModel& camera, const Pose& X_RC) {
    const Lens lens(paintable(camera));
    GreyCanvas bench{camera.width, camera.height, {}};
    bench.values.reserve(static_cast<std::size_t>(bench.width) * static_cast<std::size_t>(bench.height));
    for (int v = 0; v < bench.height; ++v) {
        Eigen::Vector2d ray(-lens.cx / lens.fx, (v - lens.cy) / lens.fy);
        ray = rayAt(lens, {0.0, v}, ray, 20);
        for (int u = 0; u < bench.width; ++u) { // from its neighbour's few steps are enough
            ray = rayAt(lens, {u, v}, ray, 3);
            if (!ray.allFinite())
                ray.setZero();
            bench.values.push_back(
                benchGrey(X_RC.translation(), X_RC.linear() * Eigen::Vector3d(ray.x(), ray.y(), 1.0)));
        }
    }
    return bench;
}

} // namespace

SceneRenderer::SceneRenderer(const CameraModel& camera, const Pose& X_RC, const PictureQuality& quality)
    : m_painter(camera, benchSeenBy(camera, X_RC)), m_sensor(quality, camera.width) {}

GreyPicture SceneRenderer::render(std::span<const PlacedFace> faces, std::span<const PlacedFace> onTop,
                                  std::uint64_t number) {
    return m_sensor.caught(m_painter.paint(faces, onTop), number);
}

} // namespace bask
