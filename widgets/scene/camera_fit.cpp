#include "widgets/scene/camera_fit.h"

#include <vtkCamera.h>
#include <vtkMatrix4x4.h>

#include <algorithm>

namespace bask {

void applyPreset(vtkCamera& camera, ViewPreset preset) {
    Eigen::Vector3d direction = -Eigen::Vector3d::UnitZ();
    Eigen::Vector3d up = Eigen::Vector3d::UnitZ();
    switch (preset) {
    case ViewPreset::AlongMinusZ:
        up = Eigen::Vector3d::UnitY();
        break;
    case ViewPreset::AlongX:
        direction = Eigen::Vector3d::UnitX();
        break;
    case ViewPreset::Isometric:
        // From the front right, a little lower than a true isometric, so that height reads well.
        direction = Eigen::Vector3d(-0.62, 1.0, -0.58);
        break;
    }
    direction.normalize();
    camera.ParallelProjectionOn();
    camera.SetFocalPoint(0.0, 0.0, 0.0);
    camera.SetPosition(-direction.x(), -direction.y(), -direction.z());
    camera.SetViewUp(up.data());
    camera.OrthogonalizeViewUp();
}

void fitCamera(vtkCamera& camera, const Box& box, QSizeF size, QMarginsF margins) {
    if (box.isEmpty() || size.width() < 1.0 || size.height() < 1.0)
        return;
    const double min = 0.5;
    const double across = margins.left() + margins.right();
    const double upright = margins.top() + margins.bottom();
    const double shrink = std::min({1.0, across > 0.0 ? min * size.width() / across : 1.0,
                                    upright > 0.0 ? min * size.height() / upright : 1.0});
    margins *= shrink;

    const Eigen::Vector3d direction = Eigen::Map<const Eigen::Vector3d>(camera.GetDirectionOfProjection());
    const Eigen::Vector3d up = Eigen::Map<const Eigen::Vector3d>(camera.GetViewUp()).normalized();
    const Eigen::Vector3d right = direction.cross(up).normalized();
    const Eigen::Vector3d top = right.cross(direction).normalized();
    Eigen::AlignedBox2d extent;
    for (int i = 0; i < 8; ++i) {
        const Eigen::Vector3d corner = box.corner(static_cast<Box::CornerType>(i));
        extent.extend(Eigen::Vector2d(right.dot(corner), top.dot(corner)));
    }
    const double width = size.width() - margins.left() - margins.right();
    const double height = size.height() - margins.top() - margins.bottom();
    const double metresPerPixel = std::max({extent.sizes().x() / width, extent.sizes().y() / height, 1e-6});
    // The middle of the free area is not the middle of the view.
    const double dx = 0.5 * (margins.right() - margins.left()) * metresPerPixel;
    const double dy = 0.5 * (margins.top() - margins.bottom()) * metresPerPixel;
    const Eigen::Vector3d focus = right * (extent.center().x() + dx) + top * (extent.center().y() + dy) +
                                  direction * direction.dot(box.center());
    const Eigen::Vector3d eye = focus - direction * (3.0 * box.diagonal().norm() + 0.1);
    camera.SetFocalPoint(focus.x(), focus.y(), focus.z());
    camera.SetPosition(eye.x(), eye.y(), eye.z());
    camera.SetParallelScale(0.5 * size.height() * metresPerPixel);
}

Projection::Projection(vtkCamera& camera, QSizeF size) : m_size(size) {
    const double aspect = size.height() > 0.0 ? size.width() / size.height() : 1.0;
    const vtkMatrix4x4* matrix = camera.GetCompositeProjectionTransformMatrix(aspect, -1.0, 1.0);
    for (int row = 0; row < 4; ++row)
        for (int column = 0; column < 4; ++column)
            m_clipFromR(row, column) = matrix->GetElement(row, column);
}

QPointF Projection::operator()(const Eigen::Vector3d& p_R) const {
    const Eigen::Vector4d clip = m_clipFromR * p_R.homogeneous();
    const double w = clip.w() != 0.0 ? clip.w() : 1.0;
    return {0.5 * (clip.x() / w + 1.0) * m_size.width(), 0.5 * (1.0 - clip.y() / w) * m_size.height()};
}

} // namespace bask
