#include "widgets/common/colour_map.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace bask {

namespace {

/// Viridis (matplotlib, CC0) at 16 even fractions, linear in between.
constexpr std::array<QRgb, 16> kViridis{
    0xff440154, 0xff481a6c, 0xff472f7d, 0xff414487, 0xff39568c, 0xff31688e, 0xff2a788e, 0xff23888e,
    0xff1f988b, 0xff22a884, 0xff35b779, 0xff54c568, 0xff7ad151, 0xffa5db36, 0xffd2e21b, 0xfffde725};

int mixed(int a, int b, double t) {
    return static_cast<int>(std::lround(a + (b - a) * t));
}

} // namespace

QColor unknownColour(bool dark) {
    return dark ? QColor(0x6b, 0x72, 0x7a) : QColor(0xb4, 0xb9, 0xbf);
}

QColor mapColour(double fraction, bool dark) {
    if (std::isnan(fraction))
        return unknownColour(dark);
    const double min = dark ? 0.16 : 0.0;
    const double max = dark ? 1.0 : 0.9;
    const double place = (min + (max - min) * std::clamp(fraction, 0.0, 1.0)) * (kViridis.size() - 1);
    const auto i = std::min(static_cast<std::size_t>(place), kViridis.size() - 2);
    const double t = place - static_cast<double>(i);
    const QRgb a = kViridis[i];
    const QRgb b = kViridis[i + 1];
    return QColor(mixed(qRed(a), qRed(b), t), mixed(qGreen(a), qGreen(b), t), mixed(qBlue(a), qBlue(b), t));
}

NiceRange niceRange(double min, double max, int steps) {
    if (!(std::isfinite(min) && std::isfinite(max)))
        return {};
    if (min > max)
        std::swap(min, max);
    if (max - min < 1e-9 * std::max(1.0, std::abs(max)))
        max = min + 1.0;
    const double raw = (max - min) / std::max(1, steps);
    const double decade = std::pow(10.0, std::floor(std::log10(raw)));
    double step = 10.0 * decade;
    for (const double factor : {1.0, 2.0, 5.0})
        if (factor * decade >= raw * (1.0 - 1e-9)) {
            step = factor * decade;
            break;
        }
    return {std::floor(min / step + 1e-9) * step, std::ceil(max / step - 1e-9) * step, step};
}

} // namespace bask
