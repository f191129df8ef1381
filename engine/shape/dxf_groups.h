#pragma once
// Checks the groups of a DXF and keeps only those that draw outlines, before dxflib reads them. dxflib trusts
// counts, never returns from a line of 1024 characters, and does not report what it could not read.

#include "engine/base/result.h"

#include <map>
#include <string>
#include <string_view>

namespace bask {

/// The text for dxflib, and what was left out of it.
struct CleanDxf {
    std::string text;                    ///< ASCII DXF of the kinds below, ending in EOF
    std::map<std::string, int> left_out; ///< number of entities of other kinds, by kind (rare kinds as "...")
    int invisible = 0;                   ///< number of entities marked invisible (group 60)
};

/// Rewrites $INSUNITS, layers, blocks, LINE, ARC, CIRCLE, ELLIPSE, LWPOLYLINE, POLYLINE and VERTEX (no
/// meshes), SPLINE and INSERT with the groups that define their shape: finite numbers, names in capitals of
/// at most 255 bytes, and correct counts. Reads up to EOF. Errors, with the line: DxfBinary, DxfCutOff (no
/// EOF), DxfDamaged (an impossible group code or name; a spline of degree 0 or above 15, with decreasing
/// knots, weights that are not positive or counts that do not fit), ContourNotANumber, ContourNotFinite (or
/// beyond 1e15), FileTooLarge (above 300 000 entities or 2 million values).
Result<CleanDxf> cleanDxf(std::string_view bytes, const std::string& where);

} // namespace bask
