#include "engine/thermography/frame_decoder.h"

#include "engine/base/message_code.h"
#include "engine/thermography/plain_picture.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace bask {
namespace {

constexpr std::size_t kBytesPerPixel = 2;

unsigned short numberAt(std::string_view bytes, std::size_t pixel, bool isBigEndian) {
    const auto first = static_cast<unsigned char>(bytes[kBytesPerPixel * pixel]);
    const auto second = static_cast<unsigned char>(bytes[kBytesPerPixel * pixel + 1]);
    return static_cast<unsigned short>(isBigEndian ? first << 8 | second : second << 8 | first);
}

} // namespace

Result<ThermalFrame> frameOfTemperatures(ThermalPicture picture, const std::optional<ThermalProfile>& profile,
                                         const std::string& where) {
    if (isConstant(picture))
        return Error{MessageCode::ThermalPictureConstant, where};
    ThermalFrame out;
    if (profile) {
        constexpr double kInfinity = std::numeric_limits<double>::infinity();
        std::size_t outside = 0, high = 0;
        for (double& T_K : picture.T_K) {
            if (T_K < profile->min_K)
                T_K = -kInfinity;
            else if (T_K > profile->max_K)
                T_K = kInfinity;
            outside += std::isinf(T_K) ? 1 : 0;
            high += profile->warnAbove_K && T_K > *profile->warnAbove_K ? 1 : 0;
        }
        if (2 * outside > picture.T_K.size())
            return Error{MessageCode::ThermalNotTemperatures,
                         where,
                         {std::to_string(100 * outside / picture.T_K.size()), temperatureArg(profile->min_K),
                          temperatureArg(profile->max_K), profile->name}};
        if (high > 0)
            out.warnings.push_back(
                {MessageCode::ThermalHighRange,
                 {std::to_string(high), temperatureArg(*profile->warnAbove_K), profile->name}});
    }
    out.picture = std::move(picture);
    return out;
}

Result<ThermalFrame> frameOfCounts(const CountPicture& counts, const ThermalProfile& profile,
                                   const std::string& where) {
    const int largest = (1 << profile.bits) - 1;
    ThermalPicture picture{counts.width, counts.height, {}};
    picture.T_K.reserve(counts.counts.size());
    for (std::size_t k = 0; k < counts.counts.size(); ++k) {
        const int number = counts.counts[k];
        if (number > largest)
            return Error{MessageCode::ThermalBitsOver,
                         where,
                         {std::to_string(number), std::to_string(k % static_cast<std::size_t>(counts.width)),
                          std::to_string(k / static_cast<std::size_t>(counts.width)),
                          std::to_string(profile.bits)}};
        picture.T_K.push_back(number == largest ? std::numeric_limits<double>::infinity()
                                                : profile.temperature_K(number));
    }
    if (isConstant(picture))
        return Error{MessageCode::ThermalPictureConstant, where};
    const PlainPicture plain = plainPicture(counts, profile);
    if (plain == PlainPicture::Yes)
        return Error{MessageCode::ThermalPlainPicture, where, {profile.name}};
    auto frame = frameOfTemperatures(std::move(picture), profile, where);
    if (frame && plain == PlainPicture::Perhaps)
        frame->warnings.push_back(plainPictureDoubt(profile));
    return frame;
}

Result<FramesOfBytes> framesOfBytes(std::uint64_t bytes, const ThermalProfile& profile,
                                    const std::string& where) {
    if (bytes == 0)
        return Error{MessageCode::FileEmpty, where};
    const auto [usual, longer] = profile.frameSizes();
    const bool isUsual = bytes % usual == 0, isLonger = bytes % longer == 0;
    if (bytes == usual || bytes == longer)
        return FramesOfBytes{1, static_cast<std::size_t>(bytes)};
    if (isUsual && isLonger && usual != longer)
        return Error{MessageCode::ThermalFramesEither,
                     where,
                     {std::to_string(bytes / usual), profile.name, std::to_string(bytes / longer)}};
    if (isUsual || isLonger) {
        const std::size_t size = isUsual ? usual : longer;
        return FramesOfBytes{static_cast<std::size_t>(bytes / size), size};
    }
    std::string words = std::to_string(usual);
    if (longer != usual)
        words += " / " + std::to_string(longer);
    return Error{MessageCode::ThermalFrameSize, where, {profile.name, words, std::to_string(bytes)}};
}

Result<ThermalFrame> frameOfBytes(std::string_view bytes, const ThermalProfile& profile,
                                  const std::string& where) {
    const auto frames = framesOfBytes(bytes.size(), profile, where);
    if (!frames)
        return frames.error();
    if (frames->count != 1)
        return Error{MessageCode::ThermalFramesSeveral,
                     where,
                     {std::to_string(frames->count), profile.name, std::to_string(frames->frameBytes)}};
    const auto width = static_cast<std::size_t>(profile.width);
    CountPicture counts{profile.width, profile.height, {}};
    const std::size_t first = static_cast<std::size_t>(profile.skipTop) * width;
    const std::size_t pixels = static_cast<std::size_t>(profile.height) * width;
    counts.above.reserve(first);
    for (std::size_t k = 0; k < first; ++k)
        counts.above.push_back(numberAt(bytes, k, profile.isBigEndian));
    counts.counts.reserve(pixels);
    for (std::size_t k = 0; k < pixels; ++k)
        counts.counts.push_back(numberAt(bytes, first + k, profile.isBigEndian));
    return frameOfCounts(counts, profile, where);
}

} // namespace bask
