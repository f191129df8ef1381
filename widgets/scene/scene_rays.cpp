#include "widgets/scene/scene_rays.h"

#include <vtkCamera.h>

#include <algorithm>
#include <cmath>

namespace bask {

namespace {

constexpr double kParallel = 1e-14;

/// Moeller and Trumbore: Fast, Minimum Storage Ray/Triangle Intersection, 1997.
std::optional<double> distanceTo(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c,
                                 const Ray& ray) {
    const Eigen::Vector3d ab = b - a, ac = c - a;
    const Eigen::Vector3d p = ray.direction.cross(ac);
    const double determinant = ab.dot(p);
    if (std::abs(determinant) < kParallel)
        return std::nullopt;
    const Eigen::Vector3d t = ray.origin - a;
    const double u = t.dot(p) / determinant;
    const Eigen::Vector3d q = t.cross(ab);
    const double v = ray.direction.dot(q) / determinant;
    const double along = ac.dot(q) / determinant;
    if (u < 0.0 || v < 0.0 || u + v > 1.0 || along < 0.0)
        return std::nullopt;
    return along;
}

} // namespace

Ray rayThrough(vtkCamera& camera, QSizeF size, QPointF place) {
    const Eigen::Vector3d direction = Eigen::Vector3d(camera.GetDirectionOfProjection()).normalized();
    const Eigen::Vector3d right = direction.cross(Eigen::Vector3d(camera.GetViewUp())).normalized();
    const double metresPerPixel = 2.0 * camera.GetParallelScale() / size.height();
    const double x_m = metresPerPixel * (place.x() - 0.5 * size.width());
    const double y_m = metresPerPixel * (0.5 * size.height() - place.y());
    return {Eigen::Vector3d(camera.GetPosition()) + x_m * right + y_m * right.cross(direction), direction};
}

std::optional<double> distanceTo(const Isosurface& surface, const Ray& ray) {
    std::optional<double> nearest;
    for (const auto& [a, b, c] : surface.triangles) {
        const auto point = [&surface](int i) { return surface.points[static_cast<std::size_t>(i)]; };
        const auto along = distanceTo(point(a), point(b), point(c), ray);
        if (along && (!nearest || *along < *nearest))
            nearest = along;
    }
    return nearest;
}

std::optional<double> distanceToCut(const Box& box, int axis, double position, const Ray& ray) {
    if (std::abs(ray.direction[axis]) < kParallel)
        return std::nullopt;
    const double along = (position - ray.origin[axis]) / ray.direction[axis];
    Eigen::Vector3d point = ray.origin + along * ray.direction;
    point[axis] = std::clamp(position, box.min()[axis], box.max()[axis]); // but for rounding
    if (along < 0.0 || !box.contains(point))
        return std::nullopt;
    return along;
}

std::vector<Eigen::Vector3d> planeInBox(const Box& box, const Eigen::Vector3d& normal, double offset) {
    std::vector<Eigen::Vector3d> points;
    for (int a = 0; a < 8; ++a)
        for (const int bit : {1, 2, 4}) {
            if ((a & bit) != 0)
                continue;
            const Eigen::Vector3d from = box.corner(static_cast<Box::CornerType>(a));
            const Eigen::Vector3d to = box.corner(static_cast<Box::CornerType>(a | bit));
            const double below = normal.dot(from) - offset, above = normal.dot(to) - offset;
            if ((below < 0.0) != (above < 0.0))
                points.push_back(from + (to - from) * (below / (below - above)));
        }
    if (points.size() < 3)
        return {};
    Eigen::Vector3d middle = Eigen::Vector3d::Zero();
    for (const Eigen::Vector3d& point : points)
        middle += point / static_cast<double>(points.size());
    const Eigen::Vector3d u = normal.unitOrthogonal(), v = normal.cross(u);
    std::ranges::sort(points, {}, [&](const Eigen::Vector3d& p) {
        return std::atan2(v.dot(p - middle), u.dot(p - middle));
    });
    return points;
}

std::vector<Eigen::Vector3d> edgesOf(const Box& box) {
    std::vector<Eigen::Vector3d> ends;
    for (int a = 0; a < 8; ++a)
        for (const int bit : {1, 2, 4})
            if ((a & bit) == 0)
                for (const int corner : {a, a | bit})
                    ends.push_back(box.corner(static_cast<Box::CornerType>(corner)));
    return ends;
}

std::vector<Eigen::Vector3d> sidesOf(const std::vector<Eigen::Vector3d>& polygon) {
    std::vector<Eigen::Vector3d> ends;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        ends.push_back(polygon[i]);
        ends.push_back(polygon[(i + 1) % polygon.size()]);
    }
    return ends;
}

} // namespace bask
