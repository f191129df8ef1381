#include "engine/thermography/thermal_picture.h"

#include "engine/base/message_code.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace bask {

bool isConstant(const ThermalPicture& picture) {
    return std::ranges::adjacent_find(picture.T_K, std::not_equal_to<>()) == picture.T_K.end();
}

Result<PictureRange> pictureRange(const ThermalPicture& picture) {
    const auto isOut = [](double T_K) { return !std::isfinite(T_K); };
    if (const auto first = std::ranges::find_if(picture.T_K, isOut); first != picture.T_K.end()) {
        const auto index = static_cast<int>(first - picture.T_K.begin());
        return Error{MessageCode::ThermalPixelsOut,
                     {},
                     {std::to_string(std::ranges::count_if(picture.T_K, isOut)),
                      std::to_string(index % picture.width), std::to_string(index / picture.width)}};
    }
    const auto [min, max] = std::ranges::minmax(picture.T_K);
    const double sum = std::accumulate(picture.T_K.begin(), picture.T_K.end(), 0.0);
    return PictureRange{min, max, sum / static_cast<double>(picture.T_K.size())};
}

} // namespace bask
