#include "engine/thermography/face_thermometer.h"

#include <cmath>
#include <stdexcept>
#include <utility>

namespace bask {
namespace {

Result<ObjectReading> readObject(const BandRadiance& band, const ThermalPicture& picture,
                                 const ReadObject& object, FacePixels seen,
                                 const std::optional<CameraZero>& zero,
                                 const ThermalCameraUncertainty& camera, double sinceShutter_s,
                                 int minPixels) {
    const auto region = regionStatistics(picture, seen.pixels, minPixels);
    if (!region)
        return region.error();
    const KnownFace& known = seen.isFront ? object.front : object.back;
    ReadingUncertainty uncertainty;
    uncertainty.pixels_K = region->standardError_K;
    uncertainty.emittance = known.emittanceUncertainty;
    uncertainty.T_env_K = known.roomUncertainty_K;
    uncertainty.surfaces = known.surfaces;
    double apparent_K = region->mean_K;
    if (zero) {
        apparent_K -= zero->offset_K;
        uncertainty.gain = camera.gain;
        uncertainty.gainAbout_K = zero->apparent_K - zero->offset_K;
        uncertainty.offset_K = std::hypot(camera.offset_K, zero->standardUncertainty_K);
        uncertainty.drift_K = camera.drift_K_min * sinceShutter_s / 60.0;
    }
    auto face = readFace(band, known.surroundings, apparent_K, uncertainty);
    if (!face)
        return face.error();
    return ObjectReading{std::move(*face), std::move(seen), *region};
}

} // namespace

std::vector<Result<ObjectReading>>
readObjects(const BandRadiance& band, const ThermalPicture& picture, const PixelRays& rays, const Pose& X_WC,
            std::span<const ReadObject> objects, std::span<const PlacedPlate> screens,
            std::span<const std::optional<CameraZero>> zeros, const ThermalCameraUncertainty& camera,
            double sinceShutter_s, const FacePixelOptions& options) {
    if (picture.width != rays.camera().width || picture.height != rays.camera().height)
        throw std::invalid_argument("readObjects: the picture has another size than the camera");
    if (zeros.size() != objects.size())
        throw std::invalid_argument("readObjects: one zero an object");
    std::vector<PlacedPlate> plates;
    for (const ReadObject& object : objects)
        plates.push_back(object.plate);
    std::vector<Result<FacePixels>> seen = facePixels(rays, X_WC, plates, screens, options);
    std::vector<Result<ObjectReading>> out;
    for (std::size_t i = 0; i < objects.size(); ++i) {
        if (seen[i])
            out.push_back(readObject(band, picture, objects[i], std::move(*seen[i]), zeros[i], camera,
                                     sinceShutter_s, options.minPixels));
        else
            out.emplace_back(seen[i].error());
    }
    return out;
}

CameraZero zeroAt(const BandRadiance& band, const FaceSurroundings& face, double known_K,
                  double uncertainty_K, double apparent_K, double standardError_K) {
    return {apparent_K - apparentTemperature(band, face, known_K), std::hypot(uncertainty_K, standardError_K),
            apparent_K};
}

} // namespace bask
