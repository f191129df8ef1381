#pragma once
// Gauss-Legendre rules and how many points a field needs.

#include <span>

namespace bask {

inline constexpr int kMaxGaussPoints = 16;

/// Gauss-Legendre nodes and weights on [0, 1], 1 <= n <= kMaxGaussPoints.
struct GaussRule {
    std::span<const double> nodes;
    std::span<const double> weights;
};
GaussRule gaussRule(int n);

/// log of the sum of the semi-axes of the ellipse about [-1, 1] that holds every point within `distance` of
/// the centre; 0 when none does. A rule of n points errs by about exp(-2 n times this).
double ellipseExponent(double distance);

/// Points (1 to kMaxGaussPoints) that a panel of half length 1 needs to err by exp(-exponent), relatively,
/// for a field that is smooth within `distance` of its centre.
int gaussOrder(double distance, double exponent);

} // namespace bask
