#include "engine/simulation/scene_painter.h"

#include "engine/calibration/picture_outline.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

namespace bask {
namespace {

constexpr double kMaxPainted_px = 12.0; // the lens bends such a piece by some thousandths of a pixel

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
    : m_lens(paintable(camera)), m_bounds(raysInPicture(camera, 3.0)), m_background(std::move(background)) {
    if (m_background.width != camera.width || m_background.height != camera.height)
        throw std::invalid_argument("ScenePainter: the background has another size");
}

std::vector<Ring> ScenePainter::shown(const std::vector<Ring>& rings, const Pose& X_CF) const {
    std::vector<Ring> result;
    for (const Ring& ring : rings)
        if (Ring picture = ringInPicture(m_lens, m_bounds, X_CF, ring, kMaxPainted_px); !picture.empty())
            result.push_back(std::move(picture));
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
