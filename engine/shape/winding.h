#pragma once
// Measures how often an outline goes round the area that it encloses.

#include "engine/shape/fourier_contour.h"

namespace bask {

/// Returns the share of the enclosed area that the contour does not go round exactly once counter-clockwise:
/// 0 for a simple contour, 1 for a circle traced twice. Uses 400 lines; accurate to about 0.2 %, in a few
/// milliseconds.
double unevenShare(const FourierContour& contour);

/// The largest unevenShare that is accepted: a truncated outline may cross itself a little, but a real one
/// does not go round twice.
inline constexpr double kMaxUneven = 0.01;

} // namespace bask
