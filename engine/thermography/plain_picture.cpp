#include "engine/thermography/plain_picture.h"

#include "engine/base/message_code.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <numeric>
#include <span>

namespace bask {
namespace {

using Numbers = std::span<const unsigned short>;

constexpr int kGrey = 0x80; // U and V without a colour

int highByte(unsigned short number) {
    return number >> 8;
}

double shareOf(std::size_t part, std::size_t whole) {
    return whole == 0 ? 0.0 : static_cast<double>(part) / static_cast<double>(whole);
}

double greyShare(Numbers numbers) {
    return shareOf(static_cast<std::size_t>(std::ranges::count(numbers, kGrey, highByte)), numbers.size());
}

/// Calls `each` with the numbers of every row.
template <class Each> void forRows(Numbers numbers, int width, Each each) {
    const auto columns = static_cast<std::size_t>(width);
    for (std::size_t first = 0; first + columns <= numbers.size(); first += columns)
        each(numbers.subspan(first, columns));
}

/// Whether in many places one pixel differs from both of its neighbours, and they do not differ.
bool alternates(Numbers numbers, int width) {
    constexpr int kApart = 2; // of the high byte: 8 K with steps of 1/64 K
    constexpr double kMany = 0.1;
    std::size_t alternating = 0, looked = 0;
    forRows(numbers, width, [&](Numbers row) {
        for (std::size_t k = 0; k + 2 < row.size(); ++k, ++looked) {
            const int left = highByte(row[k]), middle = highByte(row[k + 1]), right = highByte(row[k + 2]);
            alternating += std::abs(left - right) <= 1 && std::abs(left - middle) >= kApart &&
                                   std::abs(right - middle) >= kApart
                               ? 1
                               : 0;
        }
    });
    return shareOf(alternating, looked) > kMany;
}

bool lookLikeTemperatures(Numbers numbers, const ThermalProfile& profile) {
    constexpr double kInRange = 0.9, kSmooth = 0.8, kSmooth_K = 2.0;
    std::size_t inRange = 0, smooth = 0, pairs = 0;
    forRows(numbers, profile.width, [&](Numbers row) {
        double before_K = 0.0;
        for (std::size_t k = 0; k < row.size(); ++k) {
            const double T_K = profile.temperature_K(row[k]);
            inRange += T_K >= profile.min_K && T_K <= profile.max_K ? 1 : 0;
            if (k > 0) {
                ++pairs;
                smooth += std::abs(T_K - before_K) <= kSmooth_K ? 1 : 0;
            }
            before_K = T_K;
        }
    });
    return shareOf(inRange, numbers.size()) >= kInRange && shareOf(smooth, pairs) >= kSmooth;
}

/// Whether all high bytes are grey, and some pixels lie at either end of the low byte: black is 16 in many
/// YUYV pictures, white 235.
bool fillsTheByte(Numbers numbers) {
    constexpr int kEnd = 32;
    constexpr double kSome = 0.002;
    std::array<std::size_t, 256> counted{};
    for (const unsigned short number : numbers) {
        if (highByte(number) != kGrey)
            return false;
        ++counted[number & 0xFFU];
    }
    const std::size_t low = std::accumulate(counted.begin(), counted.begin() + kEnd, std::size_t{0});
    const std::size_t high = std::accumulate(counted.end() - kEnd, counted.end(), std::size_t{0});
    return shareOf(std::min(low, high), numbers.size()) >= kSome;
}

} // namespace

PlainPicture plainPicture(const CountPicture& counts, const ThermalProfile& profile) {
    constexpr double kNearlyAll = 0.95;
    if (profile.pixelFormat != "YUYV" || profile.isBigEndian)
        return PlainPicture::No;
    if (alternates(counts.counts, counts.width))
        return PlainPicture::Yes;
    if (greyShare(counts.counts) < kNearlyAll)
        return PlainPicture::No;
    const bool isExchanged =
        greyShare(counts.above) < kNearlyAll && lookLikeTemperatures(counts.above, profile);
    return isExchanged || fillsTheByte(counts.counts) ? PlainPicture::Yes : PlainPicture::Perhaps;
}

Message plainPictureDoubt(const ThermalProfile& profile) {
    return {MessageCode::ThermalPlainDoubt,
            {temperatureArg(profile.temperature_K(kGrey << 8)),
             temperatureArg(profile.temperature_K((kGrey << 8) + 0xFF))}};
}

} // namespace bask
