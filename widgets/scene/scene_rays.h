#pragma once
// Geometry of the target scene: what a line of sight hits, and where a plane cuts a box.

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

/// Returns the line of sight at a place of a view of this size (logical pixels).
Ray rayThrough(vtkCamera& camera, QSizeF size, QPointF place);

/// Returns the distance along the ray (in lengths of its direction) to the first triangle; empty if it hits
/// none.
std::optional<double> distanceTo(const Isosurface& surface, const Ray& ray);

/// Returns the distance along the ray to the plane `coordinate axis = position`, within the box.
std::optional<double> distanceToCut(const Box& box, int axis, double position, const Ray& ray);

/// Returns the polygon where the plane normal . p = offset cuts the box, with its corners in order; empty if
/// it does not.
std::vector<Eigen::Vector3d> planeInBox(const Box& box, const Eigen::Vector3d& normal, double offset);

/// Returns both ends of each edge of a box, and of each side of a polygon.
std::vector<Eigen::Vector3d> edgesOf(const Box& box);
std::vector<Eigen::Vector3d> sidesOf(const std::vector<Eigen::Vector3d>& polygon);

} // namespace bask
