// The map from pixels to the plane of the objects.

#include "engine/shape/picture_plane.h"

#include <gtest/gtest.h>

namespace bask {
namespace {

// Catches pixels counted from their corners instead of their centres, and y pointing down.
TEST(PicturePlane, ScaledPutsTheOriginAtTheLowerLeftCorner) {
    const PicturePlane plane = PicturePlane::scaled(2.0, 100);
    EXPECT_LT((*plane.toMetres({-0.5, 99.5})).norm(), 1e-12);
    EXPECT_LT((*plane.toMetres({19.5, 79.5}) - Eigen::Vector2d(0.01, 0.01)).norm(), 1e-12);
    EXPECT_DOUBLE_EQ(plane.pixel_m(), 0.5e-3);
}

// Catches a homography that is only affine, or whose corners are taken in another order.
TEST(PicturePlane, ASquareGivesBackTheMapThatItWasSeenBy) {
    const auto seen = [](double x, double y) { // metres to pixels, y down
        const double w = 1.0 + 2.0 * x - 1.5 * y;
        return Eigen::Vector2d((300.0 + 4000.0 * x + 500.0 * y) / w, (700.0 + 300.0 * x - 3800.0 * y) / w);
    };
    const double side_m = 0.05;
    const auto plane = PicturePlane::ofSquare(
        {seen(0.0, side_m), seen(side_m, side_m), seen(side_m, 0.0), seen(0.0, 0.0)}, side_m);
    ASSERT_TRUE(plane);
    for (const Eigen::Vector2d& p : {Eigen::Vector2d(0.2, 0.1), {-0.1, 0.05}, {0.03, -0.2}})
        EXPECT_LT((*plane->toMetres(seen(p.x(), p.y())) - p).norm(), 1e-9);
}

// Catches points beyond the horizon that come back on the other side.
TEST(PicturePlane, RefusesTheHorizonAndCornersOutOfOrder) {
    const auto plane =
        PicturePlane::ofSquare({Eigen::Vector2d(140, 100), {160, 100}, {200, 160}, {100, 160}}, 1.0);
    ASSERT_TRUE(plane);
    EXPECT_TRUE(plane->toMetres({150, 300}));
    EXPECT_FALSE(plane->toMetres({150, 20}));
    EXPECT_FALSE(PicturePlane::ofSquare({Eigen::Vector2d(0, 0), {0, 9}, {9, 9}, {9, 0}}, 1.0)) << "mirrored";
    EXPECT_FALSE(PicturePlane::ofSquare({Eigen::Vector2d(0, 0), {9, 0}, {2, 2}, {0, 9}}, 1.0)) << "a dart";
    EXPECT_FALSE(PicturePlane::ofSquare({Eigen::Vector2d(1, 1), {1, 1}, {1, 1}, {1, 1}}, 1.0));
}

} // namespace
} // namespace bask
