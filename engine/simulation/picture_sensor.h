#pragma once
// What lens and sensor make of a sharp picture: blur, uneven light, noise, eight bits.

#include "engine/shape/marker.h"
#include "engine/simulation/area_paint.h"

#include <cstdint>

namespace bask {

/// As a picture's brightness suffers.
struct PictureQuality {
    double noise_grey = 0.0; ///< standard deviation of a pixel, of 255
    double blur_px = 0.0;    ///< standard deviation of the lens's spot
    double lightFall = 0.0;  ///< how much darker the lower right corner is than the upper left, 0..1
    std::uint64_t seed = 1;
};

/// One thread.
class PictureSensor {
public:
    PictureSensor(const PictureQuality& quality, int width);

    /// `number` chooses the noise: the same again gives the same picture.
    GreyPicture caught(const GreyCanvas& canvas, std::uint64_t number);

private:
    using Row = std::vector<float>;

    Row& blurredRow(int y); ///< across only; the newest few are kept
    void blurAcross(const GreyCanvas& canvas, int y);
    void blurDown(int y);
    void finish(int y, int height, std::uint64_t number, std::uint8_t* to) const;

    PictureQuality m_quality;
    Row m_spot;  ///< weights of the blur
    Row m_noise; ///< rows of pictures take pieces of it
    Row m_padded, m_sum;
    std::vector<Row> m_across;
};

} // namespace bask
