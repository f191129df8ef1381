#pragma once
// The paper's own expressions for the interaction matrix, for comparison with the exact gradient. All are
// rows of dF21/dx, without the factor lambda1.

#include "engine/base/pose.h"

#include <functional>

namespace bask::test {

/// The closed expressions for two parallel circles and three translations: source radius `r1`, object radius
/// `r2`, object's centre `p`. Their double integral is taken by the trapezoidal rule with `points` a circle,
/// which converges exponentially.
Eigen::Vector3d paperTranslationRow(double r1, double r2, const Eigen::Vector3d& p, int points = 512);

/// The approximation for six degrees of freedom: forward differences of `viewFactorAt` by the six
/// coordinates.
Vector6d paperForwardDifferences(const std::function<double(const Vector6d&)>& viewFactorAt,
                                 const Vector6d& coordinates, double step_m, double step_rad);

} // namespace bask::test
