#pragma once
// Where one circle, seen from a point, passes behind or in front of another one.

#include <Eigen/Core>

#include <array>
#include <cstddef>

namespace bask {

/// A trigonometric polynomial of degree two on the unit circle.
struct Conic {
    double mean, c1, s1, c2, s2;
};

/// Points of the unit circle.
struct ConicRoots {
    std::array<Eigen::Vector2d, 8> at;
    std::size_t count = 0;
};

/// Returns where the polynomial changes its sign, to rounding.
ConicRoots rootsOf(const Conic& f);

} // namespace bask
