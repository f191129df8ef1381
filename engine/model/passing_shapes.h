#pragma once
// Whether two flat shapes occupy one place, which plates cannot.

#include "engine/base/pose.h"
#include "engine/shape/shape.h"

namespace bask {

/// How two flat shapes share their place: not at all or touching, a part of it in one plane, or so that
/// nobody can have meant it.
enum class Passage { None, Overlap, Through };

/// Returns how two shapes, each in the xy-plane of its frame, share their place. In one plane they overlap
/// where they share more than a hundredth of the smaller's area, and are in one place from nine tenths on
/// (Through). Where their planes meet they cross (Through) along more than a hundredth of the side of a
/// square as large as the smaller. One shape in the hole of the other, or through it, shares nothing. Curved
/// outlines are taken as polygons of 120 points.
Passage passageOf(const Shape& one, const Pose& X_WOne, const Shape& other, const Pose& X_WOther);

} // namespace bask
