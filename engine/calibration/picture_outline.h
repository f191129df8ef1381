#pragma once
// Flat outlines as a lens with distortion shows them.

#include "engine/base/pose.h"
#include "engine/calibration/projection.h"
#include "engine/shape/shape.h"

#include <Eigen/Geometry>

#include <optional>
#include <vector>

namespace bask {

/// Returns (X/Z, Y/Z) of what a lens shows at a pixel, by Newton's method. Empty if the lens model cannot be
/// inverted there.
std::optional<Eigen::Vector2d> rayOf(const Lens& lens, const Eigen::Vector2d& pixel);

/// Returns the bounds of (X/Z, Y/Z) of everything in a picture, wider by `margin_px` of a pixel of its middle
/// on each side, but not beyond where the lens model turns back upon itself: nothing is shown there. Throws
/// std::invalid_argument for a camera without size or focal lengths.
Eigen::AlignedBox2d raysInPicture(const CameraModel& camera, double margin_px);

/// Returns a closed ring in the xy-plane of O (m) in camera axes (m), cut off at the bounds of raysInPicture
/// and 1 mm before the camera. Empty if nothing of it lies within the bounds.
std::vector<Eigen::Vector3d> ringWithin(const Eigen::AlignedBox2d& bounds, const Pose& X_CO,
                                        const std::vector<Eigen::Vector2d>& ring_O);

/// Returns ringWithin as the lens shows it, in pixels, its edges divided into pieces of at most about
/// `maxPiece_px`, since the lens may bend them.
std::vector<Eigen::Vector2d> ringInPicture(const Lens& lens, const Eigen::AlignedBox2d& bounds,
                                           const Pose& X_CO, const std::vector<Eigen::Vector2d>& ring_O,
                                           double maxPiece_px);

/// Returns the outline of a shape without its holes as the camera shows it: a closed polygon in pixels
/// (centres at whole numbers), cut off a few pixels outside of the picture. Empty if it lies behind the
/// camera or outside of the picture. Throws as raysInPicture.
std::vector<Eigen::Vector2d> outlineInPicture(const CameraModel& camera, const Pose& X_CO,
                                              const Shape& shape);

} // namespace bask
