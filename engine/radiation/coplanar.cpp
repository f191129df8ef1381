#include "engine/radiation/coplanar.h"

#include <algorithm>
#include <cmath>

namespace bask {

namespace {

using Points = std::vector<Eigen::Vector2d>;

constexpr std::size_t kMaxAsked = 4096; // maximum number of points of one outline tested against the other

// The rings of a shape in S with no two neighbours of the outline farther apart than a 512th of the way
// round; the outline first.
std::vector<Points> denseRings(const Shape& shape, const Pose& X) {
    constexpr int kPlaces = 512;
    const double max = shapePerimeter(shape) / kPlaces;
    std::vector<Points> rings;
    for (const Points& corners : shapeRings(shape, kPlaces)) {
        Points& dense = rings.emplace_back();
        for (std::size_t i = 0; i < corners.size(); ++i) {
            const Eigen::Vector2d& a = corners[i];
            const Eigen::Vector2d& b = corners[(i + 1) % corners.size()];
            const int parts = std::max(1, static_cast<int>(std::ceil((b - a).norm() / max)));
            for (int k = 0; k < parts; ++k) {
                const Eigen::Vector2d p = a + (b - a) * k / parts;
                dense.push_back((X * Eigen::Vector3d(p.x(), p.y(), 0.0)).head<2>());
            }
        }
    }
    return rings;
}

enum class Place { Outside, Edge, Inside };

Place placeIn(const Points& outline, const Eigen::Vector2d& p, double margin) {
    int winding = 0;
    for (std::size_t i = 0; i < outline.size(); ++i) {
        const Eigen::Vector2d a = outline[i] - p;
        const Eigen::Vector2d b = outline[(i + 1) % outline.size()] - p;
        const Eigen::Vector2d edge = b - a;
        const double share = std::clamp(-a.dot(edge) / std::max(edge.squaredNorm(), 1e-300), 0.0, 1.0);
        if ((a + share * edge).norm() <= margin)
            return Place::Edge;
        const double cross = a.x() * b.y() - a.y() * b.x();
        if (a.y() <= 0.0 && b.y() > 0.0 && cross > 0.0)
            ++winding;
        else if (a.y() > 0.0 && b.y() <= 0.0 && cross < 0.0)
            --winding;
    }
    return winding != 0 ? Place::Inside : Place::Outside;
}

bool isInside(const std::vector<Points>& rings, const Eigen::Vector2d& p, double margin) {
    return placeIn(rings.front(), p, margin) == Place::Inside &&
           std::all_of(rings.begin() + 1, rings.end(),
                       [&](const Points& hole) { return placeIn(hole, p, margin) == Place::Outside; });
}

// A point well inside: the middle of the widest part of the face on the horizontal line at half its height.
Eigen::Vector2d innerPoint(const std::vector<Points>& rings) {
    const auto [low, high] =
        std::ranges::minmax(rings.front(), {}, [](const Eigen::Vector2d& p) { return p.y(); });
    const double y = 0.5 * (low.y() + high.y());
    std::vector<double> crossings;
    for (const Points& ring : rings)
        for (std::size_t i = 0; i < ring.size(); ++i) {
            const Eigen::Vector2d &a = ring[i], &b = ring[(i + 1) % ring.size()];
            if ((a.y() > y) != (b.y() > y))
                crossings.push_back(a.x() + (y - a.y()) / (b.y() - a.y()) * (b.x() - a.x()));
        }
    std::ranges::sort(crossings);
    Eigen::Vector2d inner = rings.front().front();
    double widest = 0.0;
    for (std::size_t i = 0; i + 1 < crossings.size(); i += 2)
        if (const double width = crossings[i + 1] - crossings[i]; width > widest) {
            widest = width;
            inner = {0.5 * (crossings[i] + crossings[i + 1]), y};
        }
    return inner;
}

} // namespace

bool overlapInPlane(const Shape& source, const Shape& object, const Pose& X_SO) {
    if (X_SO.translation().norm() >= shapeRadius(source) + shapeRadius(object))
        return false;
    const std::vector<Points> a = denseRings(source, Pose::Identity());
    const std::vector<Points> b = denseRings(object, X_SO);
    const double margin = 1e-9 * (shapeRadius(source) + shapeRadius(object));
    const auto anyInside = [&](const std::vector<Points>& rings, const std::vector<Points>& face) {
        for (const Points& points : rings) {
            const std::size_t stride = 1 + points.size() / kMaxAsked;
            for (std::size_t i = 0; i < points.size(); i += stride)
                if (isInside(face, points[i], margin))
                    return true;
        }
        return false;
    };
    // Equal faces have no corner inside each other: then their inner points decide.
    const Eigen::Vector2d inner = innerPoint(b);
    return anyInside(b, a) || anyInside(a, b) || (isInside(a, inner, margin) && isInside(b, inner, margin));
}

} // namespace bask
