#include "engine/simulation/scene_painter.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

namespace bask {
namespace {

constexpr double kNearest_m = 1e-3; // what is nearer to the camera's plane is cut off

// Where Brown's formula, radially, turns back upon itself: no picture shows more.
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

// Which part of a closed ring lies where n . p >= 0 (Sutherland and Hodgman).
void cutOff(std::vector<Eigen::Vector3d>& ring, const Eigen::Vector3d& n, double min) {
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

// What one face asks of the order, in camera axes.
struct Plane {
    std::array<Eigen::Vector3d, 4> corners; // of the rectangle that holds it
    Eigen::Vector3d normal, origin;         // the normal towards the camera
    double distance_m = 0.0;
    int layer = 0;

    explicit Plane(const PlacedFace& placed) : layer(placed.face->layer) {
        Eigen::AlignedBox2d box;
        for (const Eigen::Vector2d& p : placed.face->rings.front())
            box.extend(p);
        const auto at = [&](double x, double y) { return placed.X_CF * Eigen::Vector3d(x, y, 0.0); };
        corners = {at(box.min().x(), box.min().y()), at(box.max().x(), box.min().y()),
                   at(box.max().x(), box.max().y()), at(box.min().x(), box.max().y())};
        origin = placed.X_CF.translation();
        normal = placed.X_CF.linear().col(2);
        if (normal.dot(origin) > 0.0)
            normal = -normal;
        distance_m = at(box.center().x(), box.center().y()).norm();
    }

    /// How far the other reaches to the camera's side of this plane, and to the far side.
    std::pair<double, double> reachOf(const Plane& other) const {
        std::pair reach(-HUGE_VAL, -HUGE_VAL);
        for (const Eigen::Vector3d& p : other.corners) {
            const double d = normal.dot(p - origin);
            reach = {std::max(reach.first, d), std::max(reach.second, -d)};
        }
        return reach;
    }
};

// Whether a has to be painted before b.
bool isCoveredBy(const Plane& a, const Plane& b) {
    constexpr double kSame_m = 2e-4;
    const auto [bNear, bFar] = a.reachOf(b);
    const auto [aNear, aFar] = b.reachOf(a);
    if (bNear <= kSame_m && bFar <= kSame_m)
        return a.layer < b.layer;
    const bool first = bFar <= kSame_m || aNear <= kSame_m, second = bNear <= kSame_m || aFar <= kSame_m;
    if (first != second)
        return first;
    if (first)
        return false; // no line of sight meets both
    return a.layer != b.layer ? a.layer < b.layer : a.distance_m > b.distance_m; // they pass through another
}

bool isFrontSeen(const PlacedFace& placed) {
    return placed.X_CF.linear().col(2).dot(placed.X_CF.translation()) < 0.0;
}

} // namespace

Eigen::Vector2d rayAt(const Lens& lens, const Eigen::Vector2d& pixel, Eigen::Vector2d guess, int times) {
    const Eigen::Array2d focal(lens.fx, lens.fy);
    for (int k = 0; k < times; ++k) {
        const Eigen::Vector3d ray(guess.x(), guess.y(), 1.0);
        guess += ((pixel - shownAt(lens, ray)).array() / focal).matrix();
    }
    return guess;
}

std::vector<PlacedFace> inPaintingOrder(std::span<const PlacedFace> faces) {
    std::vector<PlacedFace> left(faces.begin(), faces.end()), order;
    std::ranges::sort(left, std::greater{}, [](const PlacedFace& f) { return Plane(f).distance_m; });
    std::vector<Plane> planes(left.begin(), left.end());
    while (!left.empty()) {
        const auto isFree = [&](const Plane& b) {
            return std::ranges::none_of(planes,
                                        [&](const Plane& a) { return &a != &b && isCoveredBy(a, b); });
        };
        auto next = std::ranges::find_if(planes, isFree);
        if (next == planes.end()) // in a circle: the farthest
            next = planes.begin();
        const auto k = next - planes.begin();
        order.push_back(left[static_cast<std::size_t>(k)]);
        left.erase(left.begin() + k);
        planes.erase(next);
    }
    return order;
}

const CameraModel& paintable(const CameraModel& camera) {
    if (!(camera.width > 0 && camera.height > 0 && camera.fx > 0.0 && camera.fy > 0.0))
        throw std::invalid_argument("ScenePainter: a camera has a size and focal lengths");
    return camera;
}

ScenePainter::ScenePainter(const CameraModel& camera, GreyCanvas background)
    : m_lens(paintable(camera)), m_background(std::move(background)) {
    if (m_background.width != camera.width || m_background.height != camera.height)
        throw std::invalid_argument("ScenePainter: the background has another size");
    setBounds();
}

void ScenePainter::setBounds() {
    const double max = farthestRay(m_lens), right = m_background.width - 0.5,
                 bottom = m_background.height - 0.5;
    const Eigen::Vector2d margin(3.0 / m_lens.fx, 3.0 / m_lens.fy);
    constexpr int kSteps = 32;
    for (int k = 0; k <= kSteps; ++k) {
        const double s = static_cast<double>(k) / kSteps, x = -0.5 + s * (right + 0.5),
                     y = -0.5 + s * (bottom + 0.5);
        for (const Eigen::Vector2d& pixel : {Eigen::Vector2d(x, -0.5), {x, bottom}, {-0.5, y}, {right, y}}) {
            const Eigen::Vector2d ideal((pixel.x() - m_lens.cx) / m_lens.fx,
                                        (pixel.y() - m_lens.cy) / m_lens.fy);
            const Eigen::Vector2d ray = rayAt(m_lens, pixel, ideal, 50);
            if (ray.norm() < max) // not of a lens that never shows anything there
                m_seen.extend(Eigen::AlignedBox2d(ray - margin, ray + margin));
            else
                m_seen.extend(
                    Eigen::Vector2d(std::clamp(ideal.x(), -max, max), std::clamp(ideal.y(), -max, max)));
        }
    }
}

std::vector<Ring> ScenePainter::shown(const std::vector<Ring>& rings, const Pose& X_CF) const {
    constexpr double kFar_px = 1e6;   // only lenses that cannot be show something there
    constexpr double kStep_px = 12.0; // the lens bends such a piece by some thousandths of a pixel
    std::vector<Ring> result;
    for (const Ring& ring : rings) {
        std::vector<Eigen::Vector3d> points;
        for (const Eigen::Vector2d& p : ring)
            points.push_back(X_CF * Eigen::Vector3d(p.x(), p.y(), 0.0));
        cutOff(points, {0, 0, 1}, kNearest_m);
        cutOff(points, {1, 0, -m_seen.min().x()}, 0.0);
        cutOff(points, {-1, 0, m_seen.max().x()}, 0.0);
        cutOff(points, {0, 1, -m_seen.min().y()}, 0.0);
        cutOff(points, {0, -1, m_seen.max().y()}, 0.0);
        Ring picture;
        for (std::size_t k = 0; k < points.size(); ++k) {
            const Eigen::Vector2d a = points[k].hnormalized(),
                                  b = points[(k + 1) % points.size()].hnormalized();
            const int pieces = 1 + static_cast<int>((b - a).norm() * m_lens.fx / kStep_px);
            for (int i = 0; i < pieces; ++i) {
                const Eigen::Vector2d ray = a + static_cast<double>(i) / pieces * (b - a);
                const Eigen::Vector2d p = shownAt(m_lens, Eigen::Vector3d(ray.x(), ray.y(), 1.0));
                if (p.norm() < kFar_px)
                    picture.push_back(p);
            }
        }
        if (!picture.empty())
            result.push_back(std::move(picture));
    }
    return result;
}

void ScenePainter::paint(const PlacedFace& placed) {
    const SceneFace& face = *placed.face;
    const bool isFront = isFrontSeen(placed);
    m_painter.paint(m_canvas, shown(face.rings, placed.X_CF), isFront ? face.front : face.behind);
    if (isFront)
        m_painter.paint(m_canvas, shown(face.marks, placed.X_CF), face.markGrey);
}

const GreyCanvas& ScenePainter::paint(std::span<const PlacedFace> faces, std::span<const PlacedFace> onTop) {
    m_canvas = m_background;
    for (const PlacedFace& placed : inPaintingOrder(faces))
        paint(placed);
    for (const PlacedFace& placed : onTop)
        paint(placed);
    return m_canvas;
}

} // namespace bask
