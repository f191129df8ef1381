#include "engine/thermography/face_temperature.h"

#include "engine/base/message_code.h"

#include <cmath>
#include <limits>
#include <stdexcept>

namespace bask {
namespace {

bool isWithin(double value, double min, double max) {
    return value >= min && value <= max;
}

void requireFace(const FaceSurroundings& face) {
    constexpr double kRounding = 1e-6; // of view factors that fill all that a face sees
    bool isGood = face.emittance > 0.0 && face.emittance <= 1.0;
    double sum = 0.0;
    for (const ReflectedSurface& surface : face.surfaces) {
        isGood = isGood && isWithin(surface.viewFactor, 0.0, 1.0) && isWithin(surface.emittance, 0.0, 1.0);
        sum += surface.viewFactor;
    }
    if (!isGood || !(sum <= 1.0 + kRounding))
        throw std::invalid_argument("FaceSurroundings: emittances and view factors from 0 to 1, the face's "
                                    "emittance above 0, view factors of 1 at most together");
}

/// What falls on the face from everything around it, as a radiance.
double surroundingRadiance(const BandRadiance& band, const FaceSurroundings& face) {
    const double room = band.radiance(face.T_env_K);
    double sum = room;
    for (const ReflectedSurface& surface : face.surfaces)
        sum += surface.viewFactor * surface.emittance * (band.radiance(surface.T_K) - room);
    return sum;
}

FaceSensitivities sensitivitiesAt(const BandRadiance& band, const FaceSurroundings& face, double T_K,
                                  double T_app_K, double surrounding) {
    const double per = 1.0 / (face.emittance * band.derivative(T_K));
    const double reflected = (1.0 - face.emittance) * per;
    const double room = band.radiance(face.T_env_K);
    FaceSensitivities out;
    out.byApparent = band.derivative(T_app_K) * per;
    out.byEmittance = (surrounding - band.radiance(T_K)) * per;
    double roomShare = 1.0;
    for (const ReflectedSurface& surface : face.surfaces) {
        const double above = band.radiance(surface.T_K) - room;
        out.byViewFactor.push_back(-reflected * surface.emittance * above);
        out.bySurface.push_back(-reflected * surface.viewFactor * surface.emittance *
                                band.derivative(surface.T_K));
        out.bySurfaceEmittance.push_back(-reflected * surface.viewFactor * above);
        roomShare -= surface.viewFactor * surface.emittance;
    }
    out.byRoom = -reflected * roomShare * band.derivative(face.T_env_K);
    return out;
}

void requireUncertainty(const FaceSurroundings& face, const ReadingUncertainty& u) {
    bool isGood = u.surfaces.size() == face.surfaces.size();
    for (const double value : {u.pixels_K, u.gain, u.offset_K, u.drift_K, u.emittance, u.T_env_K})
        isGood = isGood && value >= 0.0;
    for (const SurfaceUncertainty& surface : u.surfaces)
        isGood = isGood && surface.viewFactor >= 0.0 && surface.T_K >= 0.0 && surface.emittance >= 0.0;
    if (!isGood || !(u.gain == 0.0 || u.gainAbout_K > 0.0))
        throw std::invalid_argument("ReadingUncertainty: one for each surface, none negative");
}

} // namespace

double apparentTemperature(const BandRadiance& band, const FaceSurroundings& face, double T_K) {
    requireFace(face);
    const double radiance =
        face.emittance * band.radiance(T_K) + (1.0 - face.emittance) * surroundingRadiance(band, face);
    return band.temperature(radiance);
}

Result<FaceTemperature> faceTemperature(const BandRadiance& band, const FaceSurroundings& face,
                                        double T_app_K) {
    requireFace(face);
    const double surrounding = surroundingRadiance(band, face);
    const double own = band.radiance(T_app_K) - (1.0 - face.emittance) * surrounding;
    const double T_K = band.temperature(own / face.emittance);
    if (!std::isfinite(T_K))
        return Error{MessageCode::ThermalReflectionBrighter,
                     {},
                     {temperatureArg(T_app_K), formatNumber(face.emittance)}};
    return FaceTemperature{T_K, sensitivitiesAt(band, face, T_K, T_app_K, surrounding)};
}

double reflectedTemperature(const BandRadiance& band, const FaceSurroundings& face) {
    return band.temperature(surroundingRadiance(band, face));
}

double explainingEmittance(const BandRadiance& band, const FaceSurroundings& face, double T_app_K,
                           double T_K) {
    const double surrounding = surroundingRadiance(band, face);
    const double own = band.radiance(T_K) - surrounding;
    return own == 0.0 ? std::numeric_limits<double>::quiet_NaN()
                      : (band.radiance(T_app_K) - surrounding) / own;
}

double standardOfLimits(double limit) {
    return limit / std::sqrt(3.0);
}

Result<FaceReading> estimateFace(const BandRadiance& band, const FaceSurroundings& face, double T_app_K,
                                 const ReadingUncertainty& u) {
    requireUncertainty(face, u);
    auto solved = faceTemperature(band, face, T_app_K);
    if (!solved)
        return solved.error();
    FaceReading out;
    out.T_K = solved->T_K;
    out.sensitivities = std::move(solved->sensitivities);
    const FaceSensitivities& by = out.sensitivities;
    out.fromPixels_K = by.byApparent * u.pixels_K;
    out.fromGain_K = by.byApparent * u.gain * std::abs(T_app_K - u.gainAbout_K);
    out.fromOffset_K = by.byApparent * u.offset_K;
    out.fromDrift_K = by.byApparent * u.drift_K;
    out.fromEmittance_K = std::abs(by.byEmittance) * u.emittance;
    out.fromRoom_K = std::abs(by.byRoom) * u.T_env_K;
    for (std::size_t p = 0; p < u.surfaces.size(); ++p) {
        const SurfaceUncertainty& of = u.surfaces[p];
        out.fromViewFactors_K = std::hypot(out.fromViewFactors_K, by.byViewFactor[p] * of.viewFactor);
        out.fromSurfaces_K = std::hypot(out.fromSurfaces_K, by.bySurface[p] * of.T_K);
        out.fromSurfaceEmittances_K =
            std::hypot(out.fromSurfaceEmittances_K, by.bySurfaceEmittance[p] * of.emittance);
    }
    for (const double part :
         {out.fromPixels_K, out.fromGain_K, out.fromOffset_K, out.fromDrift_K, out.fromEmittance_K,
          out.fromRoom_K, out.fromViewFactors_K, out.fromSurfaces_K, out.fromSurfaceEmittances_K})
        out.standardUncertainty_K = std::hypot(out.standardUncertainty_K, part);
    return out;
}

Result<FaceReading> readFace(const BandRadiance& band, const FaceSurroundings& face, double T_app_K,
                             const ReadingUncertainty& uncertainty) {
    auto out = estimateFace(band, face, T_app_K, uncertainty);
    if (out && !(out->standardUncertainty_K <= kMaxReadingUncertainty_K))
        return Error{MessageCode::ThermalFaceUnusable,
                     {},
                     {formatNumber(face.emittance), differenceArg(2.0 * out->standardUncertainty_K, 2),
                      differenceArg(2.0 * kMaxReadingUncertainty_K, 2)}};
    return out;
}

} // namespace bask
