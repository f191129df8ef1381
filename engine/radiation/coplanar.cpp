#include "engine/radiation/coplanar.h"

#include <algorithm>
#include <cmath>

namespace bask {

namespace {

using Points = std::vector<Eigen::Vector2d>;

constexpr std::size_t kMostAsked = 4096; // points of one outline looked for in the other

// The outline in S with no two neighbours farther apart than a 512th of the way round.
Points denseOutline(const Shape& shape, const Pose& X) {
    constexpr int kPlaces = 512;
    const Points corners = shapeOutline(shape, kPlaces);
    const double most = shapePerimeter(shape) / kPlaces;
    Points dense;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const Eigen::Vector2d& a = corners[i];
        const Eigen::Vector2d& b = corners[(i + 1) % corners.size()];
        const int parts = std::max(1, static_cast<int>(std::ceil((b - a).norm() / most)));
        for (int k = 0; k < parts; ++k) {
            const Eigen::Vector2d p = a + (b - a) * k / parts;
            dense.push_back((X * Eigen::Vector3d(p.x(), p.y(), 0.0)).head<2>());
        }
    }
    return dense;
}

bool isInside(const Eigen::Vector2d& p, const Points& outline, double margin) {
    int winding = 0;
    for (std::size_t i = 0; i < outline.size(); ++i) {
        const Eigen::Vector2d a = outline[i] - p;
        const Eigen::Vector2d b = outline[(i + 1) % outline.size()] - p;
        const Eigen::Vector2d edge = b - a;
        const double share = std::clamp(-a.dot(edge) / std::max(edge.squaredNorm(), 1e-300), 0.0, 1.0);
        if ((a + share * edge).norm() <= margin)
            return false;
        const double cross = a.x() * b.y() - a.y() * b.x();
        if (a.y() <= 0.0 && b.y() > 0.0 && cross > 0.0)
            ++winding;
        else if (a.y() > 0.0 && b.y() <= 0.0 && cross < 0.0)
            --winding;
    }
    return winding != 0;
}

} // namespace

bool overlapInPlane(const Shape& source, const Shape& object, const Pose& X_SO) {
    if (X_SO.translation().norm() >= shapeRadius(source) + shapeRadius(object))
        return false;
    const Points a = denseOutline(source, Pose::Identity());
    const Points b = denseOutline(object, X_SO);
    const double margin = 1e-9 * (shapeRadius(source) + shapeRadius(object));
    // Equal outlines have no corner inside each other: their own insides decide.
    const auto anyInside = [&](const Points& points, const Points& outline) {
        const std::size_t stride = 1 + points.size() / kMostAsked;
        for (std::size_t i = 0; i < points.size(); i += stride)
            if (isInside(points[i], outline, margin))
                return true;
        return false;
    };
    return anyInside(b, a) || anyInside(a, b) ||
           (isInside(X_SO.translation().head<2>(), a, margin) &&
            isInside(X_SO.translation().head<2>(), b, margin));
}

} // namespace bask
