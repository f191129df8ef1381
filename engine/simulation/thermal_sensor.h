#pragma once
// What a thermal camera makes of the radiance before it: blur, noise, errors of gain and offset, drift
// between shutter events, and the cold ring of its own lens.

#include "engine/simulation/area_paint.h"
#include "engine/thermography/band_radiance.h"
#include "engine/thermography/thermal_picture.h"

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace bask {

/// How a thermal camera errs. Each is a standard deviation, drawn once from the seed unless said otherwise.
struct ThermalSensorErrors {
    double noise_K = 0.05; ///< of a pixel in each frame, for a black body at 300 K
    double gain = 0.01;    ///< relative to the distance from the camera's own temperature
    double offset_K = 1.0;
    double shutterOffset_K = 0.05;  ///< drawn at each shutter event
    double drift_K_min = 0.03;      ///< drawn at each shutter event, from then on
    double narcissus_K = 0.2;       ///< by how much the picture's corners are off; the middle is not
    double pattern_K = 0.02;        ///< of each pixel
    double blur_px = 0.6;           ///< the lens's spot; not drawn
    double shutterPeriod_s = 180.0; ///< not drawn
    double shutter_s = 0.5;         ///< how long an event takes; not drawn
    std::uint64_t seed = 1;
};

/// A part of a picture; right and bottom are beyond its last pixels.
struct PixelBox {
    int left = 0, top = 0, right = 0, bottom = 0;
};

/// Not thread-safe.
class ThermalSensor {
public:
    /// `own_K`: the camera's own temperature, where its gain has no effect.
    ThermalSensor(const BandRadiance& band, const ThermalSensorErrors& errors, int width, int height,
                  double own_K);

    /// Returns the apparent temperatures for a picture of radiances, W/(m2 sr). `number` selects the noise.
    /// Outside of the `parts`, which lie in the picture, it is as warm as the camera.
    ThermalPicture caught(const GreyCanvas& radiance, double time_s, std::uint64_t number,
                          std::span<const PixelBox> parts) const;
    /// Returns whether the shutter is closed: a camera then gives no new picture.
    bool isShut(double time_s) const;
    /// Returns when the shutter opened last; empty before its first event.
    std::optional<double> opened_s(double time_s) const;

private:
    double offset_K(double time_s) const;

    const BandRadiance& m_band;
    ThermalSensorErrors m_errors;
    double m_own_K;
    double m_gain = 0.0;
    std::vector<float> m_fixed_K; ///< offset of each pixel that does not change
};

} // namespace bask
