#pragma once
// Outlines from a DXF drawing. dxflib stays in dxf_drawing.cpp.

#include "engine/shape/outline_file.h"

#include <string>

namespace bask {

/// Reads the outlines of an ASCII DXF of any version, arranged, in one region: LINE, ARC, CIRCLE, ELLIPSE,
/// LWPOLYLINE and POLYLINE with bulges, SPLINE with weights or through fit points, and INSERT of nested
/// blocks, with scale, mirror, rotation, columns and rows. Seen from above: z is ignored, and tilted entities
/// are left out. Curves are flattened to `tolerance_m` (> 0) and to 1/4000 of their size. Pieces whose ends
/// are within a millionth of the drawing's extent are joined.
///
/// Lengths are in the unit of $INSUNITS, or in millimetres if it names none from nm to km (warning
/// DxfUnitless). What the operator does not see is ignored: layers that are off or frozen, invisible
/// entities, paper space (warning DxfHidden). In a block, layer 0 is the layer of its copy. Entities that
/// draw no curve in the plane are left out: texts, dimensions, hatches, points, solids, meshes, copies of
/// missing blocks (warning ElementsUnread).
///
/// Errors: those of readFileBytes (at most 32 MiB) and of cleanDxf; DxfBlockInItself; NoOutline; FileTooLarge
/// (above 500 000 points, 2000 outlines, 100 000 pieces or copies of blocks, or blocks more than 32 deep);
/// ContourNotFinite for a block scaled beyond 1e15, or a curve beyond the range of numbers.
Result<OutlineFile> readDxfOutlines(const std::string& path, double tolerance_m);

/// Like readDxfOutlines, from the bytes of a file; `where` names them in errors.
Result<OutlineFile> dxfOutlines(const std::string& bytes, const std::string& where, double tolerance_m);

} // namespace bask
