#pragma once
// Maps a picture's pixels to lengths in the plane of the object.

#include <Eigen/Core>

#include <array>
#include <optional>

namespace bask {

/// Maps pixels (x right, y down, pixel centres at whole numbers) to metres (y up).
class PicturePlane {
public:
    /// Makes the plane of a picture taken straight from the front; the origin is the picture's lower left
    /// corner.
    static PicturePlane scaled(double scale_px_per_mm, int height_px);
    /// Makes the plane from a square's corners, clockwise from its upper left one, and its side; corrects the
    /// perspective of a flat scene. The origin is the square's lower left corner, with x along its lower
    /// side. Empty if the corners are not a convex quadrangle.
    static std::optional<PicturePlane> ofSquare(const std::array<Eigen::Vector2d, 4>& corners_px,
                                                double side_m);

    double pixel_m() const { return m_pixel_m; } ///< size of a pixel; for a square, the mean size there
    /// Returns the point in the plane; empty near and beyond the plane's horizon, where a pixel is twenty
    /// times as long as at the square.
    std::optional<Eigen::Vector2d> toMetres(const Eigen::Vector2d& point_px) const;
    /// Returns where the picture shows a point of the plane.
    Eigen::Vector2d toPixels(const Eigen::Vector2d& point_m) const;

private:
    Eigen::Matrix3d m_toMetres = Eigen::Matrix3d::Identity(); // third row: 1 in the middle of the square
    double m_pixel_m = 0.0;
};

} // namespace bask
