#pragma once
// The temperature of a source's plate over its radius, from thermal pictures of what is seen of it.

#include "engine/base/share_done.h"
#include "engine/thermography/face_pixels.h"
#include "engine/thermography/face_temperature.h"
#include "engine/thermography/thermal_picture.h"

#include <span>
#include <string>
#include <vector>

namespace bask {

/// A picture of the plate, and what may hide it: objects, fixtures, shields.
struct PlateView {
    ThermalPicture picture;
    std::vector<PlacedPlate> covers;
};

struct PlateProfileOptions {
    FacePixelOptions pixels; ///< `minPixels` is for each ring of a picture
    int maxRings = 20;
};

/// A ring about the plate's origin.
struct PlateRing {
    double radius_m = 0.0; ///< the mean of its pixels' radii
    double T_K = 0.0;
    double standardUncertainty_K = 0.0; ///< of all causes
    /// The part of it that other rings do not share: noise, and what pictures differ by.
    double ownUncertainty_K = 0.0;
    int pixels = 0; ///< of all pictures
};

struct PlateProfile {
    std::vector<PlateRing> rings; ///< by growing radius
    std::vector<Message> remarks; ///< PlateProfileRingUnseen
};

/// Returns the profile of a plate's hot face, that towards +z of O, in rings of equal width: R / `maxRings`,
/// but 1.5 pixels at least. Pixels near the plate's edge and those that are dead, saturated or hidden are
/// left out. `face`: what the plate emits and reflects; `uncertainty`: of that and of the camera (`pixels_K`
/// is not used). X_WC as in facePixels. Errors: those of facePixels (the hot face turned away:
/// ThermalFaceHidden) and of faceTemperature; PlateProfilePixelsFew if no ring is seen. Throws as these do,
/// and std::invalid_argument without pictures, for pictures of another size, and for less than one ring.
/// `done` is told the share of the pictures.
Result<PlateProfile> plateProfile(const BandRadiance& band, const PixelRays& rays, const Pose& X_WC,
                                  const PlacedPlate& plate, std::span<const PlateView> views,
                                  const FaceSurroundings& face, const ReadingUncertainty& uncertainty,
                                  const PlateProfileOptions& options = {}, const ShareDone& done = {});

/// Returns the profile as a CSV file for `source.profile_file` of an experiment: radius_mm, temperature_ratio
/// and, for people, the temperature and its standard uncertainty. The ratio is
/// (T - environment) / (own - environment), with the temperature that the source's own sensor tells. Throws
/// std::invalid_argument unless that is above the environment's.
std::string radialProfileCsv(const PlateProfile& profile, double own_K, double environment_K);

} // namespace bask
