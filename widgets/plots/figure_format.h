#pragma once
// The kinds of file that figures for reports are drawn to.

#include <array>

namespace bask {

/// Letters stay letters in SVG and PDF; a PDF has the glyphs that it needs in it.
enum class FigureFormat { Png, Svg, Pdf };
inline constexpr std::array kFigureFormats{FigureFormat::Png, FigureFormat::Svg, FigureFormat::Pdf};

constexpr const char* figureEnding(FigureFormat format) {
    return format == FigureFormat::Png ? ".png" : format == FigureFormat::Svg ? ".svg" : ".pdf";
}

} // namespace bask
