#pragma once
// The temperature of a face from the apparent temperature that a thermal camera tells, with the reflections
// of source, neighbours and room, and with its uncertainty.

#include "engine/base/result.h"
#include "engine/thermography/band_radiance.h"

#include <vector>

namespace bask {

/// A hot surface that a face sees and reflects: a part of the source, or a neighbour. What it does not emit
/// it reflects of the room: L_p = eps_p L(T_p) + (1 - eps_p) L(T_env).
struct ReflectedSurface {
    double viewFactor = 0.0; ///< from the face to the surface, with shade; 0 to 1
    double T_K = 0.0;
    double emittance = 1.0; ///< in the camera's band; 0 to 1
};

/// A diffuse gray face as a camera sees it. Of the sky above it `surfaces` take their view factors, the room
/// takes the rest. The back of an object, which sees no source, has no surfaces.
struct FaceSurroundings {
    double emittance = 0.9; ///< in the camera's band; above 0, at most 1
    std::vector<ReflectedSurface> surfaces;
    double T_env_K = 0.0; ///< of the room, which is black
};

/// Returns the apparent temperature T_app (K) of a face at `T_K`: the black body of the same radiance,
///   L(T_app) = eps L(T) + (1 - eps) [sum over p of F_p L_p + (1 - sum over p of F_p) L(T_env)].
/// Throws std::invalid_argument for a face, a surface or a temperature out of its range, and for view factors
/// that add up to more than 1 + 1e-6.
double apparentTemperature(const BandRadiance& band, const FaceSurroundings& face, double T_K);

/// The derivatives of a face's temperature by all that it is computed from.
struct FaceSensitivities {
    double byApparent = 0.0;  ///< dT / dT_app, K/K
    double byEmittance = 0.0; ///< dT / d eps, K
    double byRoom = 0.0;      ///< dT / dT_env, K/K
    // One for each surface:
    std::vector<double> byViewFactor;       ///< dT / dF_p, K
    std::vector<double> bySurface;          ///< dT / dT_p, K/K
    std::vector<double> bySurfaceEmittance; ///< dT / d eps_p, K
};

struct FaceTemperature {
    double T_K = 0.0;
    FaceSensitivities sensitivities;
};

/// Solves the equation of apparentTemperature for the face's temperature. Throws as that does. Error:
/// ThermalReflectionBrighter if the reflection alone is as bright as what the camera saw, or only a
/// temperature outside of the band's range explains it.
Result<FaceTemperature> faceTemperature(const BandRadiance& band, const FaceSurroundings& face,
                                        double T_app_K);

/// Returns the temperature of the black body as bright as what a face reflects, K.
double reflectedTemperature(const BandRadiance& band, const FaceSurroundings& face);

/// Returns the emittance with which a face at `T_K` looks like `T_app_K`, whatever `face` says of it; NaN if
/// the face is as warm as what it reflects. Outside of 0 to 1 no face explains it.
double explainingEmittance(const BandRadiance& band, const FaceSurroundings& face, double T_app_K,
                           double T_K);

/// Returns the standard uncertainty of a value known to lie within +-`limit`, evenly likely (GUM 4.3.7).
double standardOfLimits(double limit);

/// Standard uncertainties of a ReflectedSurface.
struct SurfaceUncertainty {
    double viewFactor = 0.0;
    double T_K = 0.0;
    double emittance = 0.0;
};

/// Standard uncertainties of all that goes into a reading, by the rules of the GUM. They count as independent
/// of one another.
struct ReadingUncertainty {
    double pixels_K = 0.0;    ///< type A: of the mean over the pixels, RegionStatistics::standardError_K
    double gain = 0.0;        ///< of the camera, relative to the distance from `gainAbout_K`
    double gainAbout_K = 0.0; ///< where the camera was zeroed, so that its gain has no effect
    double offset_K = 0.0;    ///< of the camera
    double drift_K = 0.0;     ///< of the camera since its shutter closed last
    double emittance = 0.0;   ///< of the face
    double T_env_K = 0.0;     ///< of the room
    std::vector<SurfaceUncertainty> surfaces; ///< one for each surface
};

/// A reading with what each cause adds to its combined standard uncertainty, K.
struct FaceReading {
    double T_K = 0.0;
    double standardUncertainty_K = 0.0; ///< of all causes; twice that is the stated +-
    FaceSensitivities sensitivities;
    // Contributions, not negative; the squares add up to that of standardUncertainty_K.
    double fromPixels_K = 0.0, fromGain_K = 0.0, fromOffset_K = 0.0, fromDrift_K = 0.0;
    double fromEmittance_K = 0.0, fromRoom_K = 0.0;
    double fromViewFactors_K = 0.0, fromSurfaces_K = 0.0, fromSurfaceEmittances_K = 0.0;
};

/// The largest combined standard uncertainty of a thermometer, K. Bare metal (emittance 0.04) is far above it
/// in any room, painted faces are far below; at twice that, +-10 K, no limit of temperature can be watched.
inline constexpr double kMaxReadingUncertainty_K = 5.0;

/// Returns the face's temperature with its uncertainty, however large. Throws as faceTemperature does, and
/// unless there is one SurfaceUncertainty for each surface and no uncertainty is negative or NaN. Errors:
/// those of faceTemperature.
Result<FaceReading> estimateFace(const BandRadiance& band, const FaceSurroundings& face, double T_app_K,
                                 const ReadingUncertainty& uncertainty);
/// The same of a face that is used as a thermometer. Error: also ThermalFaceUnusable where the uncertainty is
/// above kMaxReadingUncertainty_K.
Result<FaceReading> readFace(const BandRadiance& band, const FaceSurroundings& face, double T_app_K,
                             const ReadingUncertainty& uncertainty);

} // namespace bask
