#pragma once
// The glow of a heat source in the picture, from its middle to its rim, for any outline; private to
// widgets/scene.

#include <Eigen/Geometry>

#include <vector>

namespace bask {

/// Returns an outline and its holes, each closed, as one closed chain that goes to every hole and back the
/// same way: by the even-odd rule its inside is the face.
std::vector<Eigen::Vector2d> chained(const std::vector<std::vector<Eigen::Vector2d>>& rings);

Eigen::AlignedBox2d boxOf(const std::vector<Eigen::Vector2d>& outline);

/// Glow on `n` x `n` cells of `box`, rows of growing y: 0 outside the outline and at its rim, 1 where it is
/// farthest from it. The height of a soap film blown up over the outline (Poisson's equation), so that a disk
/// of radius R has 1 - r^2 / R^2 and no outline has creases. An outline narrower than a cell stays 0.
std::vector<double> sourceGlow(const std::vector<Eigen::Vector2d>& outline, const Eigen::AlignedBox2d& box,
                               int n);

/// Returns where the line through `at` along the axis (0: x at a given y, 1: y at a given x) enters and
/// leaves the outline, ascending; an even number.
std::vector<double> outlineCrossings(const std::vector<Eigen::Vector2d>& outline, int axis, double at);

} // namespace bask
