#include "engine/thermography/frame_picture_file.h"

#include "engine/media/media.h"

#include <opencv2/imgcodecs.hpp>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace bask {
namespace {

std::string encoded(const CountPicture& counts, const char* ending, const std::vector<int>& options) {
    const cv::Mat image(counts.height, counts.width, CV_16U,
                        const_cast<unsigned short*>(counts.counts.data()));
    std::vector<unsigned char> bytes;
    if (!pictureCodecs().encode(ending, image, bytes, options))
        throw std::runtime_error("the picture cannot be encoded");
    return {bytes.begin(), bytes.end()};
}

} // namespace

CountPicture countsOfPicture(const ThermalPicture& picture, const ThermalProfile& profile) {
    if (picture.width != profile.width || picture.height != profile.height)
        throw std::invalid_argument("countsOfPicture: the picture has another size than the profile");
    // A profile is linear, so two of its numbers give its inverse.
    const double zero_K = profile.temperature_K(0.0), step_K = profile.temperature_K(1.0) - zero_K;
    const double largest = static_cast<double>((1 << profile.bits) - 1);
    CountPicture out{picture.width, picture.height, {}};
    out.counts.reserve(picture.T_K.size());
    for (const double T_K : picture.T_K) {
        const double number = std::isnan(T_K) ? 0.0 : (T_K - zero_K) / step_K;
        out.counts.push_back(static_cast<unsigned short>(std::lround(std::clamp(number, 0.0, largest))));
    }
    return out;
}

std::string pngOfCounts(const CountPicture& counts) {
    return encoded(counts, ".png", {cv::IMWRITE_PNG_COMPRESSION, 6});
}

std::string tiffOfCounts(const CountPicture& counts) {
    constexpr int kLzw = 5;
    return encoded(counts, ".tif", {cv::IMWRITE_TIFF_COMPRESSION, kLzw});
}

} // namespace bask
