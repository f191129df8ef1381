#pragma once
// Outlines of an SVG drawing, as QtSvg paints them.

#include "engine/shape/outline_file.h"

#include <cstdint>
#include <string>

namespace bask {

inline constexpr double kSvgTolerance_m = 1e-5; ///< a suitable default: 0.01 mm

/// Limits of a drawing, beyond which it is refused; those for its elements are in svg_filter.h.
inline constexpr std::uintmax_t kLargestSvg = std::uintmax_t{16} << 20; ///< bytes
inline constexpr int kMaxSvgOutlines = 20'000;
inline constexpr int kMaxSvgPoints = 2'000'000;       ///< after flattening
inline constexpr int kMaxSvgPathParts = 32'767;       ///< in one path: QtSvg reads no more
inline constexpr double kLargestSvgOutline_m = 100.0; ///< farthest coordinate

/// Returns the outlines that a drawing paints, arranged, in metres of its width and height (1 px = 1/96 in),
/// with y up and the origin at the lower left corner of the page.
///
/// Curves become chords within `tolerance_m`, and within 1/10,000 of the outline's size where that is finer;
/// QtSvg's own arcs, circles and ellipses have errors of up to 0.03 % of their radius. A painted shape is one
/// region. A filled outline is closed; one that is only stroked is closed if its ends meet. The width of
/// strokes, clipping and masks are ignored; hidden, transparent and unpainted shapes are left out. Warnings:
/// SvgSizeInPixels, ElementsUnread (text, pictures, clipping). Errors: those of readFileBytes and plainSvg,
/// NoOutline, DrawingTooFull, PathTooLong, DrawingTooWide, ValueNotPositive (tolerance). Needs no
/// QGuiApplication and may run in any thread; opens no other file.
Result<OutlineFile> readSvgOutlines(const std::string& path, double tolerance_m = kSvgTolerance_m);

/// Like readSvgOutlines, from the bytes of a file; `where` is the place in the error.
Result<OutlineFile> svgOutlines(const std::string& bytes, const std::string& where,
                                double tolerance_m = kSvgTolerance_m);

} // namespace bask
