#pragma once
// The kinds of file that figures for reports are drawn to, and their size on paper.

#include <array>

namespace bask {

/// In SVG and PDF text stays text; a PDF contains the glyphs that it needs.
enum class FigureFormat { Png, Svg, Pdf };
inline constexpr std::array kFigureFormats{FigureFormat::Png, FigureFormat::Svg, FigureFormat::Pdf};

constexpr const char* figureEnding(FigureFormat format) {
    return format == FigureFormat::Png ? ".png" : format == FigureFormat::Svg ? ".svg" : ".pdf";
}

/// One and two columns of usual journals.
inline constexpr double kOneColumn_mm = 89.0, kTwoColumns_mm = 183.0;
inline constexpr double kNarrowest_mm = 60.0, kWidest_mm = 400.0;

/// A figure has one size on paper, whatever it is written to; its letters have 7 to 9 points at any width.
struct FigureLayout {
    double width_mm = kTwoColumns_mm;
    bool hasHeading = true; ///< without title and note; then the corner tells whether the rig is simulated

    bool operator==(const FigureLayout&) const = default;
};

inline constexpr int kFigureDots = 300; ///< pixels an inch of paper

} // namespace bask
