// Principal axes against closed forms.

#include "engine/shape/principal_axes.h"
#include "tests/engine/shape/shape_samples.h"

#include <algorithm>

namespace bask {
namespace {

using Eigen::Vector2d;

// Catches products of inertia lost, the two axes exchanged, and digits lost far from the origin.
TEST(PrincipalAxes, OfATurnedRectangleFarAway) {
    const double angle = 0.4, a = 0.06, b = 0.02; // sides
    const Vector2d along(std::cos(angle), std::sin(angle)), across(-along.y(), along.x()), at(7.0, -3.0);
    const auto axes = principalAxes({{at, at + a * along, at + a * along + b * across, at + b * across}});
    EXPECT_LT((axes.centroid_m - at - 0.5 * a * along - 0.5 * b * across).norm(), 1e-12);
    EXPECT_NEAR(axes.major_m, a / std::sqrt(12.0), 1e-12);
    EXPECT_NEAR(axes.minor_m, b / std::sqrt(12.0), 1e-12);
    EXPECT_LT((axes.major - along).norm(), 1e-9);
}

// Catches axes that turn with the rounding of an outline that has none of its own.
TEST(PrincipalAxes, OfADiskLieAlongX) {
    const auto axes = principalAxes({test::ellipse(0.03, 0.03, 5000)});
    EXPECT_NEAR(axes.major_m, 0.015, 1e-7);
    EXPECT_NEAR(axes.minor_m, 0.015, 1e-7);
    EXPECT_EQ(axes.major, Vector2d(1.0, 0.0));
}

// Catches a hole that is added or left out.
TEST(PrincipalAxes, OfARingLeaveItsHoleOut) {
    auto hole = test::ellipse(0.02, 0.02, 5000, {0.005, 0.0});
    std::ranges::reverse(hole);
    const auto axes = principalAxes({test::ellipse(0.04, 0.04, 5000), hole});
    // By the parallel axes: areas 16 and -4, second moments r^2 / 4 about their own centres.
    const double x = -4 * 0.005 / 12;
    EXPECT_NEAR(axes.centroid_m.x(), x, 1e-7);
    const double xx = (16 * 4e-4 - 4 * (1e-4 + 0.005 * 0.005)) / 12 - x * x;
    const double yy = (16 * 4e-4 - 4 * 1e-4) / 12;
    EXPECT_NEAR(axes.major_m, std::sqrt(yy), 1e-7);
    EXPECT_NEAR(axes.minor_m, std::sqrt(xx), 1e-7);
    EXPECT_LT(std::abs(axes.major.x()), 1e-6);
}

} // namespace
} // namespace bask
