#pragma once
// View factors of any two shapes by two dumb ways of its own, both over the visible parts of the faces:
// Lambert's law over the two areas, and the double contour integral of the logarithm. Nothing is shared with
// the engine but the shapes.

#include "engine/base/pose.h"
#include "engine/shape/shape.h"

namespace bask::test {

/// F21 by tensor Gauss quadrature over both visible areas, `nodes` a dimension and smooth stretch. Good when
/// the faces keep apart by about the size of a stretch: compare two counts of nodes.
double areaViewFactor(const Shape& source, const Shape& object, const Pose& X_SO, int nodes);

/// F21 = -1/(2 pi A2) loop loop ln|s2 - s1| ds2.ds1 with panels no longer than `panel_m` of ten Gauss points
/// on both outlines: good to about 1e-12 of the perimeter squared over the area when the outlines keep apart
/// by `panel_m`.
double contourViewFactor(const Shape& source, const Shape& object, const Pose& X_SO, double panel_m);

} // namespace bask::test
