#pragma once
// Colours of a thermal picture: from cold to hot, and for pixels that tell no temperature.

#include "engine/thermography/thermal_picture.h"
#include "widgets/thermal/thermal_range.h"

#include <QColor>
#include <QImage>

#include <optional>

namespace bask {

enum class ThermalPalette {
    Inferno, ///< even steps of temperature look like even steps
    Grey,
};

/// A temperature that is marked in the picture.
struct Isotherm {
    double T_K = 0.0;
    double halfBand_K = 0.0; ///< pixels this near to it are marked; 0: all above it
    bool operator==(const Isotherm&) const = default;

    bool marks(double pixel_K) const {
        return halfBand_K > 0.0 ? pixel_K >= T_K - halfBand_K && pixel_K <= T_K + halfBand_K : pixel_K > T_K;
    }
};

/// How temperatures are drawn.
struct ThermalLook {
    ThermalPalette palette = ThermalPalette::Inferno;
    ThermalRange range;
    std::optional<Isotherm> isotherm;
    bool operator==(const ThermalLook&) const = default;
};

// Not in either palette. Pixels without a value are two greys in turn, like a chessboard.
inline constexpr QRgb kIsothermRgb = 0xff8cff3c;
inline constexpr QRgb kSaturatedRgb = 0xffff4df0;
inline constexpr QRgb kBelowRgb = 0xff3d8bff;
inline constexpr QRgb kNoValueRgbs[] = {0xff50575e, 0xff8f979e};

/// Returns the colour of a fraction of the range, clamped to 0..1.
QRgb thermalRgb(double fraction, ThermalPalette palette);
/// Returns the colour of a pixel that tells a temperature.
QRgb thermalRgb(double T_K, const ThermalLook& look);

/// A picture in colours, and how many of its pixels tell no temperature.
struct ThermalImage {
    QImage image; ///< one pixel each
    int saturated = 0, below = 0, withoutValue = 0;
};

ThermalImage thermalImage(const ThermalPicture& picture, const ThermalLook& look);

} // namespace bask
