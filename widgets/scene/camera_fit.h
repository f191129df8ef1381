#pragma once
// Cameras of the scene: preset directions, a box fitted between margins, and the projection onto the widget.

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <QMarginsF>
#include <QPointF>
#include <QSizeF>

class vtkCamera;

namespace bask {

/// Box in R (m).
using Box = Eigen::AlignedBox3d;

/// Directions a scene is looked at from.
enum class ViewPreset { AlongMinusZ, AlongX, Isometric };

/// Turns the camera (parallel projection) to a preset and fits the box; see fitCamera.
void applyPreset(vtkCamera& camera, ViewPreset preset);

/// Moves and scales the camera without turning it, so that the box fills a view of `size` (logical pixels)
/// minus `margins`. Margins that leave less than half of the view are scaled down.
void fitCamera(vtkCamera& camera, const Box& box, QSizeF size, QMarginsF margins);

/// From R (m) to logical pixels of the widget, y down.
class Projection {
public:
    Projection(vtkCamera& camera, QSizeF size);
    QPointF operator()(const Eigen::Vector3d& p_R) const;

private:
    Eigen::Matrix4d m_clipFromR;
    QSizeF m_size;
};

} // namespace bask
