#pragma once
// The effect of lens and sensor on a sharp picture: blur, uneven light, noise, eight bits.

#include "engine/shape/marker.h"
#include "engine/simulation/area_paint.h"

#include <cstdint>

namespace bask {

/// How the brightness of a picture is degraded.
struct PictureQuality {
    double noise_grey = 0.0; ///< standard deviation of a pixel, of 255
    double blur_px = 0.0;    ///< standard deviation of the lens's spot
    double lightFall = 0.0;  ///< how much darker the lower right corner is than the upper left, 0..1
    std::uint64_t seed = 1;
};

/// Not thread-safe.
class PictureSensor {
public:
    PictureSensor(const PictureQuality& quality, int width);

    /// Returns the degraded picture. `number` selects the noise: the same number gives the same picture.
    GreyPicture caught(const GreyCanvas& canvas, std::uint64_t number);

private:
    using Row = std::vector<float>;

    Row& blurredRow(int y); ///< blurred horizontally only; the newest few are stored
    void blurAcross(const GreyCanvas& canvas, int y);
    void blurDown(int y);
    void finish(int y, int height, std::uint64_t number, std::uint8_t* to) const;

    PictureQuality m_quality;
    Row m_spot;  ///< weights of the blur
    Row m_noise; ///< rows of pictures use parts of it
    Row m_padded, m_sum;
    std::vector<Row> m_across;
};

} // namespace bask
