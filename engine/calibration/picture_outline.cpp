#include "engine/calibration/picture_outline.h"

#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace bask {
namespace {

constexpr double kNearestShown_m = 1e-3;  ///< nothing nearer to the camera's plane is shown
constexpr double kFarthestShown_px = 1e6; ///< only lenses that cannot be show something there

/// Returns the radius where Brown's formula, radially, turns back upon itself: no picture shows more.
double farthestRay(const Lens& lens) {
    constexpr double kMax = 8.0, kStep = 0.01; // 83 degrees
    const auto shownRadius = [&](double r) {
        const double r2 = r * r;
        const auto& k = lens.k;
        return r * (1.0 + r2 * (k[0] + r2 * (k[1] + r2 * k[4]))) /
               (1.0 + r2 * (k[5] + r2 * (k[6] + r2 * k[7])));
    };
    double r = 0.0;
    while (r < kMax && shownRadius(r + kStep) > shownRadius(r))
        r += kStep;
    return r;
}

/// Leaves of a closed ring what lies where n . p >= min (Sutherland and Hodgman).
void cutRing(std::vector<Eigen::Vector3d>& ring, const Eigen::Vector3d& n, double min) {
    std::vector<Eigen::Vector3d> kept;
    for (std::size_t k = 0; k < ring.size(); ++k) {
        const Eigen::Vector3d &a = ring[k], &b = ring[(k + 1) % ring.size()];
        const double da = n.dot(a) - min, db = n.dot(b) - min;
        if (da >= 0.0)
            kept.push_back(a);
        if ((da >= 0.0) != (db >= 0.0))
            kept.push_back(a + da / (da - db) * (b - a));
    }
    ring = std::move(kept);
}

} // namespace

std::optional<Eigen::Vector2d> rayOf(const Lens& lens, const Eigen::Vector2d& pixel) {
    constexpr double kStep = 1e-6, kGood_px = 1e-6;
    Eigen::Vector2d ray{(pixel.x() - lens.cx) / lens.fx, (pixel.y() - lens.cy) / lens.fy};
    const auto shownOf = [&](double x, double y) { return shownAt(lens, Eigen::Vector3d(x, y, 1.0)); };
    for (int i = 0; i < 30; ++i) {
        const Eigen::Vector2d off = shownOf(ray.x(), ray.y()) - pixel;
        if (off.norm() < kGood_px)
            return ray;
        Eigen::Matrix2d J;
        J.col(0) = (shownOf(ray.x() + kStep, ray.y()) - shownOf(ray.x() - kStep, ray.y())) / (2.0 * kStep);
        J.col(1) = (shownOf(ray.x(), ray.y() + kStep) - shownOf(ray.x(), ray.y() - kStep)) / (2.0 * kStep);
        ray -= J.inverse() * off;
    }
    return std::nullopt;
}

Eigen::AlignedBox2d raysInPicture(const CameraModel& camera, double margin_px) {
    if (!(camera.width > 0 && camera.height > 0 && camera.fx > 0.0 && camera.fy > 0.0))
        throw std::invalid_argument("raysInPicture: a camera has a size and focal lengths");
    const Lens lens(camera);
    const double max = farthestRay(lens), right = camera.width - 0.5, bottom = camera.height - 0.5;
    const Eigen::Vector2d margin(margin_px / lens.fx, margin_px / lens.fy);
    Eigen::AlignedBox2d bounds;
    constexpr int kSteps = 32;
    for (int k = 0; k <= kSteps; ++k) {
        const double s = static_cast<double>(k) / kSteps, x = -0.5 + s * (right + 0.5),
                     y = -0.5 + s * (bottom + 0.5);
        for (const Eigen::Vector2d& pixel : {Eigen::Vector2d(x, -0.5), {x, bottom}, {-0.5, y}, {right, y}}) {
            const auto ray = rayOf(lens, pixel);
            if (ray && ray->norm() < max) { // else the lens never shows anything there
                bounds.extend(
                    Eigen::AlignedBox2d((*ray - margin).cwiseMax(-max), (*ray + margin).cwiseMin(max)));
                continue;
            }
            const Eigen::Vector2d ideal((pixel.x() - lens.cx) / lens.fx, (pixel.y() - lens.cy) / lens.fy);
            bounds.extend(ideal.cwiseMax(-max).cwiseMin(max));
        }
    }
    return bounds;
}

std::vector<Eigen::Vector3d> ringWithin(const Eigen::AlignedBox2d& bounds, const Pose& X_CO,
                                        const std::vector<Eigen::Vector2d>& ring_O) {
    std::vector<Eigen::Vector3d> points;
    points.reserve(ring_O.size());
    for (const Eigen::Vector2d& p : ring_O)
        points.push_back(X_CO * Eigen::Vector3d(p.x(), p.y(), 0.0));
    cutRing(points, {0, 0, 1}, kNearestShown_m);
    cutRing(points, {1, 0, -bounds.min().x()}, 0.0);
    cutRing(points, {-1, 0, bounds.max().x()}, 0.0);
    cutRing(points, {0, 1, -bounds.min().y()}, 0.0);
    cutRing(points, {0, -1, bounds.max().y()}, 0.0);
    return points;
}

std::vector<Eigen::Vector2d> ringInPicture(const Lens& lens, const Eigen::AlignedBox2d& bounds,
                                           const Pose& X_CO, const std::vector<Eigen::Vector2d>& ring_O,
                                           double maxPiece_px) {
    const std::vector<Eigen::Vector3d> points = ringWithin(bounds, X_CO, ring_O);
    std::vector<Eigen::Vector2d> shown;
    for (std::size_t k = 0; k < points.size(); ++k) {
        const Eigen::Vector2d a = points[k].hnormalized(), b = points[(k + 1) % points.size()].hnormalized();
        const int pieces = 1 + static_cast<int>((b - a).norm() * lens.fx / maxPiece_px);
        for (int i = 0; i < pieces; ++i) {
            const Eigen::Vector2d ray = a + static_cast<double>(i) / pieces * (b - a);
            const Eigen::Vector2d p = shownAt(lens, Eigen::Vector3d(ray.x(), ray.y(), 1.0));
            if (p.norm() < kFarthestShown_px)
                shown.push_back(p);
        }
    }
    return shown;
}

std::vector<Eigen::Vector2d> outlineInPicture(const CameraModel& camera, const Pose& X_CO,
                                              const Shape& shape) {
    constexpr int kPoints = 180;         // of a disk: 0.015 px off at a radius of 100 px
    constexpr double kMargin_px = 6.0;   // no edge of the cut is in the picture
    constexpr double kMaxPiece_px = 6.0; // the lens bends such a piece by some thousandths of a pixel
    return ringInPicture(Lens(camera), raysInPicture(camera, kMargin_px), X_CO, shapeOutline(shape, kPoints),
                         kMaxPiece_px);
}

} // namespace bask
