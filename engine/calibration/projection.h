#pragma once
// Projection of a point into the picture for any kind of number: the formula of camera_model.h.

#include "engine/calibration/camera_model.h"

#include <Eigen/Core>

#include <algorithm>
#include <array>

namespace bask {

/// The numbers of a CameraModel.
struct Lens {
    double fx, fy, cx, cy;
    std::array<double, 8> k{};

    explicit Lens(const CameraModel& camera) : fx(camera.fx), fy(camera.fy), cx(camera.cx), cy(camera.cy) {
        std::copy_n(camera.distortion.begin(), std::min<std::size_t>(camera.distortion.size(), 8), k.begin());
    }
};

/// Returns the pixels of a point in camera axes, in front of the camera.
template <class T> Eigen::Matrix<T, 2, 1> shownAt(const Lens& lens, const Eigen::Matrix<T, 3, 1>& p_C) {
    const T x = p_C.x() / p_C.z(), y = p_C.y() / p_C.z(), r2 = x * x + y * y;
    const auto& k = lens.k;
    const T g = (1.0 + r2 * (k[0] + r2 * (k[1] + r2 * k[4]))) / (1.0 + r2 * (k[5] + r2 * (k[6] + r2 * k[7])));
    return {lens.fx * (g * x + 2.0 * k[2] * x * y + k[3] * (r2 + 2.0 * x * x)) + lens.cx,
            lens.fy * (g * y + k[2] * (r2 + 2.0 * y * y) + 2.0 * k[3] * x * y) + lens.cy};
}

/// Returns whether the point is in front of the camera and, if the picture size is known, inside the picture.
inline bool isInPicture(const CameraModel& camera, const Eigen::Vector3d& p_C) {
    if (p_C.z() <= 0.0)
        return false;
    const Eigen::Vector2d shown = shownAt(Lens(camera), p_C);
    return camera.width == 0 || (shown.x() >= 0.0 && shown.y() >= 0.0 && shown.x() <= camera.width - 1.0 &&
                                 shown.y() <= camera.height - 1.0);
}

} // namespace bask
