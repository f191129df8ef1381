#pragma once
// From a picture's pixels to lengths in the plane that the object lies in.

#include <Eigen/Core>

#include <array>
#include <optional>

namespace bask {

/// Pixels (x right, y down, pixel centres at whole numbers) to metres (y up).
class PicturePlane {
public:
    /// Seen straight on; the origin is the picture's lower left corner.
    static PicturePlane scaled(double scale_px_per_mm, int height_px);
    /// By a square's corners, clockwise as seen from its upper left one, and its side: the perspective of a
    /// flat scene is undone. Origin at the square's lower left corner, x along its lower side. Nothing when
    /// the corners are no convex quadrangle.
    static std::optional<PicturePlane> ofSquare(const std::array<Eigen::Vector2d, 4>& corners_px,
                                                double side_m);

    double pixel_m() const { return m_pixel_m; } ///< size of a pixel; of a square, its mean one there
    /// Nothing near and beyond the plane's horizon, where a pixel is twenty times as long as at the square.
    std::optional<Eigen::Vector2d> toMetres(const Eigen::Vector2d& point_px) const;
    /// Where the picture shows a point of the plane.
    Eigen::Vector2d toPixels(const Eigen::Vector2d& point_m) const;

private:
    Eigen::Matrix3d m_toMetres = Eigen::Matrix3d::Identity(); // third row: 1 in the middle of the square
    double m_pixel_m = 0.0;
};

} // namespace bask
