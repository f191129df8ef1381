#include "engine/thermography/thermal_board.h"

#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <cmath>

namespace bask {
namespace {

GreyPicture enlarged(const GreyPicture& picture, int factor) {
    const cv::Mat1b small(picture.height, picture.width, const_cast<std::uint8_t*>(picture.values.data()));
    GreyPicture out{picture.width * factor, picture.height * factor, {}};
    out.values.resize(static_cast<std::size_t>(out.width) * static_cast<std::size_t>(out.height));
    cv::Mat1b large(out.height, out.width, out.values.data());
    cv::resize(small, large, large.size(), 0.0, 0.0, cv::INTER_CUBIC);
    return out;
}

} // namespace

GreyPicture greyPicture(const ThermalPicture& picture) {
    constexpr std::size_t kLeftOut = 100; // one in so many, at either end
    std::vector<double> sorted;
    std::ranges::copy_if(picture.T_K, std::back_inserter(sorted), [](double T) { return std::isfinite(T); });
    double low = 0.0, high = 0.0;
    if (!sorted.empty()) {
        std::ranges::sort(sorted);
        low = sorted[sorted.size() / kLeftOut];
        high = sorted[sorted.size() - 1 - sorted.size() / kLeftOut];
    }
    const double span = std::max(high - low, 1e-9);
    GreyPicture out{picture.width, picture.height, {}};
    out.values.reserve(picture.T_K.size());
    for (const double T : picture.T_K)
        out.values.push_back(
            std::isnan(T) ? 128
                          : static_cast<std::uint8_t>(std::clamp(255.0 * (T - low) / span, 0.0, 255.0)));
    return out;
}

ThermalBoard findThermalBoard(const GreyPicture& picture, const Board& board, const std::string& where) {
    constexpr int kFine_px = 640, kMaxFactor = 4;
    const int factor = std::clamp((kFine_px + picture.width - 1) / picture.width, 1, kMaxFactor);
    const GreyPicture fine = enlarged(picture, factor);
    GreyPicture inverted = fine;
    for (std::uint8_t& value : inverted.values)
        value = static_cast<std::uint8_t>(255 - value);
    ThermalBoard found{findBoard(fine, board, where), board};
    if (!found.view)
        found.view = findBoard(inverted, board, where);
    if (!found.view) {
        found.seen = boardSeen(fine, board);
        if (!found.seen)
            found.seen = boardSeen(inverted, board);
        return found;
    }
    for (Eigen::Vector2d& corner : found.view->corners_px)
        corner = (corner.array() + 0.5) / factor - 0.5;
    return found;
}

} // namespace bask
