#pragma once
// Plates that pass through one another.

#include "engine/radiation/view_factor.h"

namespace bask {

/// Returns whether two plates at poses in the same frame pass through one another. Plates that only touch do
/// not, nor do plates in parallel planes. A Fourier outline is checked as a fine polygon.
bool platesCross(const RadiatingContour& a, const Pose& X_A, const RadiatingContour& b, const Pose& X_B);

} // namespace bask
