#pragma once
// A thermal camera as thermometer: from one picture the temperatures of the objects that it shows, with the
// reflections computed and with what they are uncertain by.

#include "engine/thermography/camera_profile.h"
#include "engine/thermography/face_pixels.h"
#include "engine/thermography/face_temperature.h"
#include "engine/thermography/region_statistics.h"

#include <optional>
#include <span>
#include <vector>

namespace bask {

/// Returns the options for a rig: small objects a metre away have few pixels, which is part of the
/// uncertainty.
inline FacePixelOptions rigPixels(const SightUncertainty& sight = {}) {
    FacePixelOptions options;
    options.minPixels = 5;
    options.sight = sight;
    return options;
}

/// A face's surroundings with their standard uncertainties.
struct KnownFace {
    FaceSurroundings surroundings;
    double emittanceUncertainty = 0.0;
    double roomUncertainty_K = 0.0;
    std::vector<SurfaceUncertainty> surfaces; ///< one for each of surroundings.surfaces
};

/// An object that a thermal camera reads.
struct ReadObject {
    PlacedPlate plate;
    KnownFace front, back; ///< the camera sees one of them
};

/// What the camera told too much (K) of an object at a known temperature.
struct CameraZero {
    double offset_K = 0.0;
    double standardUncertainty_K = 0.0;
    double apparent_K = 0.0; ///< at which it was found
};

/// An object's temperature, and where the picture told it.
struct ObjectReading {
    FaceReading face;
    FacePixels seen;
    RegionStatistics region;
};

/// Reads the objects from a picture. `zeros` has one for each object; of one that is empty the camera's own
/// accuracy is not part of the uncertainty. `sinceShutter_s`: since the last shutter event. One result for
/// each object; errors: those of facePixels, regionStatistics and readFace. Throws std::invalid_argument for
/// a picture of another size than the camera's, or another number of zeros.
std::vector<Result<ObjectReading>>
readObjects(const BandRadiance& band, const ThermalPicture& picture, const PixelRays& rays, const Pose& X_WC,
            std::span<const ReadObject> objects, std::span<const PlacedPlate> screens,
            std::span<const std::optional<CameraZero>> zeros, const ThermalCameraUncertainty& camera,
            double sinceShutter_s, const FacePixelOptions& options = {});

/// Returns the zero of an object that is at `known_K` (standard uncertainty `uncertainty_K`) while the camera
/// shows `apparent_K` (of the mean over pixels and frames: `standardError_K`).
CameraZero zeroAt(const BandRadiance& band, const FaceSurroundings& face, double known_K,
                  double uncertainty_K, double apparent_K, double standardError_K);

} // namespace bask
