#pragma once
// The kinds of file that figures for reports are drawn to.

#include <array>

namespace bask {

/// In SVG and PDF text stays text; a PDF contains the glyphs that it needs.
enum class FigureFormat { Png, Svg, Pdf };
inline constexpr std::array kFigureFormats{FigureFormat::Png, FigureFormat::Svg, FigureFormat::Pdf};

constexpr const char* figureEnding(FigureFormat format) {
    return format == FigureFormat::Png ? ".png" : format == FigureFormat::Svg ? ".svg" : ".pdf";
}

} // namespace bask
