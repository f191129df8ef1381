#pragma once
// Outlines from a DXF drawing. dxflib stays in dxf_drawing.cpp.

#include "engine/shape/outline_file.h"

#include <string>

namespace bask {

/// Outlines of an ASCII DXF of any version, arranged, in one region: LINE, ARC, CIRCLE, ELLIPSE, LWPOLYLINE
/// and POLYLINE with bulges, SPLINE with weights or through fit points, and INSERT of blocks in blocks, with
/// scale, mirror, turn, columns and rows. Seen from above: z is dropped, what is tilted is left out. Curves
/// are flattened to `tolerance_m` (> 0) and to 1/4000 of their size. Pieces whose ends lie within a millionth
/// of the drawing's extent are joined.
///
/// Lengths are of $INSUNITS, millimetres where it names none from nm to km (warning DxfUnitless). What the
/// operator does not see is not read: layers that are off or frozen, invisible entities, paper space (warning
/// DxfHidden). In a block, layer 0 is the layer of its copy. What draws no curve of the plane is left out:
/// texts, dimensions, hatches, points, solids, meshes, copies of missing blocks (warning ElementsUnread).
///
/// Errors: those of readFileBytes (at most 32 MiB) and of cleanDxf; DxfBlockInItself; NoOutline;
/// FileTooLarge (above 500 000 points, 2000 outlines, 100 000 pieces or copies of blocks, or blocks more
/// than 32 deep); ContourNotFinite for a block that is scaled beyond 1e15, or a curve beyond
/// what numbers hold.
Result<OutlineFile> readDxfOutlines(const std::string& path, double tolerance_m);

/// The same from a file's bytes; `where` names them in errors.
Result<OutlineFile> dxfOutlines(const std::string& bytes, const std::string& where, double tolerance_m);

} // namespace bask
