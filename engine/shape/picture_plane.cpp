#include "engine/shape/picture_plane.h"

#include <Eigen/Geometry>
#include <Eigen/LU>

#include <cmath>

namespace bask {
namespace {

double cross(const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
    return a.x() * b.y() - a.y() * b.x();
}

bool isConvex(const std::array<Eigen::Vector2d, 4>& corners) {
    for (std::size_t k = 0; k < 4; ++k) {
        const Eigen::Vector2d a = corners[(k + 1) % 4] - corners[k];
        const Eigen::Vector2d b = corners[(k + 2) % 4] - corners[(k + 1) % 4];
        if (!(cross(a, b) > 1e-3 * a.norm() * b.norm())) // clockwise where y points down
            return false;
    }
    return true;
}

} // namespace

PicturePlane PicturePlane::scaled(double scale_px_per_mm, int height_px) {
    PicturePlane plane;
    plane.m_pixel_m = 1e-3 / scale_px_per_mm;
    plane.m_toMetres << plane.m_pixel_m, 0.0, 0.5 * plane.m_pixel_m, //
        0.0, -plane.m_pixel_m, (height_px - 0.5) * plane.m_pixel_m,  //
        0.0, 0.0, 1.0;
    return plane;
}

std::optional<PicturePlane> PicturePlane::ofSquare(const std::array<Eigen::Vector2d, 4>& corners_px,
                                                   double side_m) {
    if (!isConvex(corners_px))
        return std::nullopt;
    // Four corners fix the eight ratios of H: H (px, py, 1) ~ (x, y, 1). In units of the square's size about
    // its middle, so that the equations are well scaled.
    Eigen::Vector2d middle = Eigen::Vector2d::Zero();
    double size_px = 0.0;
    for (std::size_t k = 0; k < 4; ++k) {
        middle += 0.25 * corners_px[k];
        size_px += 0.25 * (corners_px[(k + 1) % 4] - corners_px[k]).norm();
    }
    const std::array<Eigen::Vector2d, 4> square{
        Eigen::Vector2d(0.0, side_m), {side_m, side_m}, {side_m, 0.0}, {0.0, 0.0}};
    Eigen::Matrix<double, 8, 8> a = Eigen::Matrix<double, 8, 8>::Zero();
    Eigen::Matrix<double, 8, 1> b;
    for (int k = 0; k < 4; ++k) {
        const Eigen::Vector2d p = (corners_px[static_cast<std::size_t>(k)] - middle) / size_px;
        const Eigen::Vector2d q = square[static_cast<std::size_t>(k)] / side_m;
        a.row(2 * k) << p.x(), p.y(), 1.0, 0.0, 0.0, 0.0, -p.x() * q.x(), -p.y() * q.x();
        a.row(2 * k + 1) << 0.0, 0.0, 0.0, p.x(), p.y(), 1.0, -p.x() * q.y(), -p.y() * q.y();
        b.segment<2>(2 * k) = q;
    }
    const Eigen::Matrix<double, 8, 1> h = a.fullPivLu().solve(b);
    Eigen::Matrix3d homography, about;
    homography << h[0], h[1], h[2], h[3], h[4], h[5], h[6], h[7], 1.0;
    about << 1.0 / size_px, 0.0, -middle.x() / size_px, 0.0, 1.0 / size_px, -middle.y() / size_px, 0.0, 0.0,
        1.0;
    PicturePlane plane;
    plane.m_toMetres = Eigen::Vector3d(side_m, side_m, 1.0).asDiagonal() * homography * about;
    plane.m_pixel_m = side_m / size_px;
    if (!plane.m_toMetres.allFinite())
        return std::nullopt;
    return plane;
}

std::optional<Eigen::Vector2d> PicturePlane::toMetres(const Eigen::Vector2d& point_px) const {
    constexpr double kMinWeight = 0.05;
    const Eigen::Vector3d q = m_toMetres * point_px.homogeneous();
    if (!(q.z() > kMinWeight))
        return std::nullopt;
    return Eigen::Vector2d(q.hnormalized());
}

Eigen::Vector2d PicturePlane::toPixels(const Eigen::Vector2d& point_m) const {
    return (m_toMetres.inverse() * point_m.homogeneous()).hnormalized();
}

} // namespace bask
