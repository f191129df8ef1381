#pragma once
// Two faces in one plane: apart they do not see each other, one over the other they have no view factor.

#include "engine/base/pose.h"
#include "engine/shape/shape.h"

namespace bask {

/// Whether the object at X_SO, taken to lie in the source's plane, covers part of the source. Shared edges
/// are no overlap, and neither is an object in a hole of the source, or round the source; outlines are looked
/// at in 512 places or more.
bool overlapInPlane(const Shape& source, const Shape& object, const Pose& X_SO);

} // namespace bask
