#pragma once
// Two faces in one plane. Side by side they do not see each other; if they overlap, the view factor is
// undefined.

#include "engine/base/pose.h"
#include "engine/shape/shape.h"

namespace bask {

/// Returns whether the object at X_SO, assumed to lie in the source's plane, covers part of the source.
/// Shared edges do not count as overlap, nor does an object in a hole of the source, or one around the
/// source. Each outline is checked at 512 points or more.
bool overlapInPlane(const Shape& source, const Shape& object, const Pose& X_SO);

} // namespace bask
