#pragma once
// Gauss-Legendre rules, and how many points an integrand needs.

#include <span>

namespace bask {

inline constexpr int kMaxGaussPoints = 16;

/// Gauss-Legendre nodes and weights on [0, 1], 1 <= n <= kMaxGaussPoints.
struct GaussRule {
    std::span<const double> nodes;
    std::span<const double> weights;
};
GaussRule gaussRule(int n);

/// Returns the log of the sum of the semi-axes of the ellipse about [-1, 1] that contains every point within
/// `distance` of the centre; 0 if there is none. The error of a rule of n points is about exp(-2 n times
/// this).
double ellipseExponent(double distance);

/// Returns the number of points (1 to kMaxGaussPoints) with which a panel of half length 1 has a relative
/// error of exp(-exponent), for a field that is smooth within `distance` of its centre.
int gaussOrder(double distance, double exponent);

/// Returns the least distance at which gaussOrder() takes `n` points or fewer.
double gaussDistance(int n, double exponent);

} // namespace bask
