#pragma once
// Which pixels of a thermal picture show the face of an object, and nothing else.

#include "engine/base/pose.h"
#include "engine/base/result.h"
#include "engine/calibration/camera_model.h"
#include "engine/shape/shape.h"

#include <span>
#include <vector>

namespace bask {

/// The direction in which each pixel of a camera looks. Made once a camera; immutable, thread-safe.
class PixelRays {
public:
    /// Throws std::invalid_argument if the camera's size is unknown or above 4096 pixels, or if its lens
    /// model cannot be inverted within the picture.
    explicit PixelRays(const CameraModel& camera);

    /// Returns whether a lens model can be inverted within the whole picture.
    static bool isUsable(const CameraModel& camera);

    const CameraModel& camera() const { return m_camera; }
    /// Returns (X/Z, Y/Z) of a pixel's line of sight in camera axes; pixels count row by row.
    const Eigen::Vector2d& ray(std::size_t pixel) const { return m_rays[pixel]; }

private:
    CameraModel m_camera;
    std::vector<Eigen::Vector2d> m_rays;
};

/// A thin opaque plate: an object, a fixture, a shield, the source. The front looks along -z of O.
struct PlacedPlate {
    Shape shape;
    Pose X_WO = Pose::Identity();
};

/// Standard uncertainties of the places where a camera looks for plates, by that of its own pose.
struct SightUncertainty {
    double across_m = 0.0;  ///< of a plate's place, across the line of sight
    double angle_rad = 0.0; ///< of the line of sight
};

struct FacePixelOptions {
    /// How far from every edge a pixel has to lie: the radius beyond which the camera's blur (its lens, and
    /// the pixels themselves) carries nothing across, px. At least kMinBlur_px.
    double blur_px = 1.5;
    int minPixels = 9; ///< with fewer the face is too small
    double minAngle_rad =
        0.017453292519943295; ///< between line of sight and face; a face seen at less is grazing
    /// All edges may be elsewhere: twice this is added to `blur_px`.
    SightUncertainty sight{};
};
inline constexpr double kMinBlur_px = 1.5;

/// What a camera sees of an object.
struct FacePixels {
    std::vector<int> pixels; ///< ascending; row by row
    bool isFront = true;     ///< the face that looks at the source, or the back
    bool isWhole = true;     ///< the whole outline lies in the picture
    double angle_rad = 0.0;  ///< between the face's normal and the line of sight to its origin
};

/// Returns for each object the pixels that show it: its outline as the lens shows it, without what lies
/// within `blur_px` of where an edge may be, its own or that of a nearer plate, and without what nearer
/// objects and screens hide. A pixel counts by its centre; the nearer plate is told on each pixel's line of
/// sight. `X_WC`: the camera (x right, y down, z forward). Errors: ThermalFaceOutside (not in the picture, or
/// behind the camera), ThermalFaceGrazing, ThermalFaceHidden, ThermalFaceSmall; ThermalPlaceVague for an
/// object that could be read if `sight` were better known. Throws std::invalid_argument for options out of
/// their range.
std::vector<Result<FacePixels>> facePixels(const PixelRays& rays, const Pose& X_WC,
                                           std::span<const PlacedPlate> objects,
                                           std::span<const PlacedPlate> screens,
                                           const FacePixelOptions& options = {});

} // namespace bask
