#pragma once
// Geometry of the target scene: what a line of sight meets, and where a plane cuts a box.

#include "engine/exchange/isosurface.h"
#include "widgets/scene/camera_fit.h"

#include <QPointF>
#include <QSizeF>

#include <optional>
#include <vector>

class vtkCamera;

namespace bask {

/// Half a line from `origin` along `direction` (R).
struct Ray {
    Eigen::Vector3d origin;
    Eigen::Vector3d direction;
};

/// What the person looks along at a place of a view of that size (logical pixels).
Ray rayThrough(vtkCamera& camera, QSizeF size, QPointF place);

/// How far along the ray (in lengths of its direction) the first triangle is; nothing when it meets none.
std::optional<double> distanceTo(const Isosurface& surface, const Ray& ray);

/// How far along the ray the plane `coordinate axis = position` is, within the box.
std::optional<double> distanceToCut(const Box& box, int axis, double position, const Ray& ray);

/// The polygon in which the plane normal . p = offset cuts the box, its corners in order; empty when it does
/// not.
std::vector<Eigen::Vector3d> planeInBox(const Box& box, const Eigen::Vector3d& normal, double offset);

/// Both ends of each edge of a box, and of each side of a polygon.
std::vector<Eigen::Vector3d> edgesOf(const Box& box);
std::vector<Eigen::Vector3d> sidesOf(const std::vector<Eigen::Vector3d>& polygon);

} // namespace bask
