#include "widgets/thermal/thermal_colours.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace bask {
namespace {

constexpr int kSteps = 256;
using ColourTable = std::array<QRgb, kSteps>;

/// Inferno (matplotlib, CC0) as polynomials of sixth degree, within 2 % of its table.
QRgb inferno(double t) {
    constexpr double kTerms[3][7] = {
        {0.000218940, 0.106513419, 11.602493082, -41.703996131, 77.162935699, -71.319428245, 25.131126225},
        {0.001651005, 0.563956437, -3.972853966, 17.436398882, -33.402358942, 32.626064264, -12.242668952},
        {-0.019480898, 3.932712389, -15.942394106, 44.354145199, -81.807309257, 73.209519858, -23.070325003}};
    int channels[3];
    for (int k = 0; k < 3; ++k) {
        double sum = 0.0;
        for (int power = 6; power >= 0; --power)
            sum = sum * t + kTerms[k][power];
        channels[k] = static_cast<int>(std::lround(255.0 * std::clamp(sum, 0.0, 1.0)));
    }
    return qRgb(channels[0], channels[1], channels[2]);
}

QRgb grey(double t) {
    const int value = static_cast<int>(std::lround(12.0 + 233.0 * t));
    return qRgb(value, value, value);
}

ColourTable tableOf(QRgb (*colour)(double)) {
    ColourTable table{};
    for (int i = 0; i < kSteps; ++i)
        table[static_cast<std::size_t>(i)] = colour(i / (kSteps - 1.0));
    return table;
}

const ColourTable& colourTable(ThermalPalette palette) {
    static const ColourTable kInfernos = tableOf(inferno), kGreys = tableOf(grey);
    return palette == ThermalPalette::Grey ? kGreys : kInfernos;
}

QRgb colourIn(const ColourTable& table, double fraction) {
    const double place = std::clamp(fraction, 0.0, 1.0) * (kSteps - 1) + 0.5;
    return table[static_cast<std::size_t>(place)];
}

} // namespace

QRgb thermalRgb(double fraction, ThermalPalette palette) {
    return colourIn(colourTable(palette), fraction);
}

QRgb thermalRgb(double T_K, const ThermalLook& look) {
    if (look.isotherm && look.isotherm->marks(T_K))
        return kIsothermRgb;
    return thermalRgb((T_K - look.range.min_K) / (look.range.max_K - look.range.min_K), look.palette);
}

ThermalImage thermalImage(const ThermalPicture& picture, const ThermalLook& look) {
    ThermalImage out{QImage(picture.width, picture.height, QImage::Format_RGB32)};
    const ColourTable& table = colourTable(look.palette);
    const double perKelvin = 1.0 / (look.range.max_K - look.range.min_K);
    for (int row = 0; row < picture.height; ++row) {
        auto* line = reinterpret_cast<QRgb*>(out.image.scanLine(row));
        for (int column = 0; column < picture.width; ++column) {
            const double T_K = picture.at(column, row);
            if (std::isfinite(T_K)) {
                line[column] = look.isotherm && look.isotherm->marks(T_K)
                                   ? kIsothermRgb
                                   : colourIn(table, (T_K - look.range.min_K) * perKelvin);
            } else if (std::isnan(T_K)) {
                line[column] = kNoValueRgbs[(row + column) % 2];
                ++out.withoutValue;
            } else {
                line[column] = T_K > 0.0 ? kSaturatedRgb : kBelowRgb;
                ++(T_K > 0.0 ? out.saturated : out.below);
            }
        }
    }
    return out;
}

} // namespace bask
