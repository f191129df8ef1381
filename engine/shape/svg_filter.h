#pragma once
// Simplifies an SVG drawing so that QtSvg draws all of it and does nothing else.
//
// QtSvg (6.4) reads SVG Tiny: it takes mm and % for pixels, stops at a nested <svg>, does not know <symbol>,
// applies a style sheet only to what follows it, opens pictures, asks for fonts where there may be no
// display, and recurses until the stack is full. Therefore a drawing is copied, element by element, into one
// that has only groups, shapes, <use> without recursion, plain numbers, and its style sheets first. QtSvg
// still handles paths, transforms, colours and CSS.

#include "engine/base/result.h"

#include <Eigen/Geometry>

#include <string>
#include <vector>

namespace bask {

struct PlainSvg {
    /// UTF-8; the root has no size: one user unit is one unit of the drawing.
    std::string xml;
    Eigen::Affine2d toPixels;        ///< user units to CSS pixels (1/96 in), y down
    std::string unit;                ///< unit of the drawing's width or height; "px" if it has none
    std::vector<std::string> unread; ///< visible elements that were left out, each name once
};

/// Limits of a drawing; a drawing beyond them is refused.
inline constexpr int kMaxSvgElements = 150'000; ///< in the file
inline constexpr int kMaxSvgDrawn = 150'000;    ///< after `<use>` has multiplied them
inline constexpr int kMaxSvgLevels = 256;       ///< of nesting, `<use>` included

/// Makes the plain drawing. Errors: XmlBroken, XmlTooDeep, NotSvg, SvgSizeUnusable, DrawingTooFull (the
/// limits above, and what Qt's readers cannot process in a second: attributes, entities, style sheets, path
/// data; see svg_filter.cpp), and those of svg_survey for what is damaged. What lies more than four `<use>`
/// deep after 256 of them is left out, as by QtSvg. Opens no other file.
Result<PlainSvg> plainSvg(const std::string& bytes, const std::string& where);

} // namespace bask
