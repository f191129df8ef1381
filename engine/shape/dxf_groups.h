#pragma once
// A DXF's groups, checked and cut down to what draws outlines, before dxflib may see them: it takes counts on
// trust, never comes back from a line of 1024 characters, and says nothing of what it could not read.

#include "engine/base/result.h"

#include <map>
#include <string>
#include <string_view>

namespace bask {

/// What is handed to dxflib, and what was not.
struct CleanDxf {
    std::string text;                    ///< ASCII DXF of the kinds below, ending in EOF
    std::map<std::string, int> left_out; ///< entities of other kinds, counted by kind (rare ones as ...)
    int invisible = 0;                   ///< entities marked invisible (group 60)
};

/// Writes $INSUNITS, layers, blocks, LINE, ARC, CIRCLE, ELLIPSE, LWPOLYLINE, POLYLINE and VERTEX (no meshes),
/// SPLINE and INSERT anew, with the groups that shape them: finite numbers, names in capitals of at most 255
/// bytes, and counts that are true. Reads up to EOF. Errors, with the line: DxfBinary, DxfCutOff (no EOF),
/// DxfDamaged (a group code or a name that cannot be; a spline of degree 0 or above 15, with falling knots,
/// weights that are not positive or counts that do not fit), ContourNotANumber, ContourNotFinite (or beyond
/// 1e15), FileTooLarge (above 300 000 entities or 2 million values).
Result<CleanDxf> cleanDxf(std::string_view bytes, const std::string& where);

} // namespace bask
