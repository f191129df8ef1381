#pragma once
// An SVG drawing made plain, so that QtSvg draws all of it and nothing else can happen.
//
// QtSvg (6.4) reads SVG Tiny: it takes mm and % for pixels, stops at a nested <svg>, knows no <symbol>,
// applies a style sheet only to what follows it, opens pictures, asks for fonts where there may be no
// display, and draws until the stack is full. So a drawing is copied, element by element, into one that has
// only groups, shapes, <use> without recursion, plain numbers, and its style sheets first. Paths, transforms,
// colours and CSS are left to QtSvg.

#include "engine/base/result.h"

#include <Eigen/Geometry>

#include <string>
#include <vector>

namespace bask {

struct PlainSvg {
    std::string xml;          ///< UTF-8; its root has no size: one user unit is one unit of its drawing
    Eigen::Affine2d toPixels; ///< user units to CSS pixels (1/96 in), y down
    std::string unit;         ///< of the drawing's width or height, "px" if it has none
    std::vector<std::string> unread; ///< elements left out that would be seen, once each
};

/// Limits on a drawing, beyond which it is refused.
inline constexpr int kMaxSvgElements = 150'000; ///< in the file
inline constexpr int kMaxSvgDrawn = 150'000;    ///< of them, after `<use>` has multiplied them
inline constexpr int kMaxSvgLevels = 256;       ///< of nesting, `<use>` included

/// Errors: XmlBroken, XmlTooDeep, NotSvg, SvgSizeUnusable, DrawingTooFull (the limits above, and what Qt's
/// readers cannot take in a second: attributes, entities, style sheets, path data; see svg_filter.cpp). A
/// recursive `<use>` is left out, as QtSvg leaves out what lies more than four `<use>` deep after 256 of
/// them. Opens nothing.
Result<PlainSvg> plainSvg(const std::string& bytes, const std::string& where);

} // namespace bask
