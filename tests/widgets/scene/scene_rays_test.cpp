#include "widgets/scene/scene_rays.h"

#include <gtest/gtest.h>

#include <numbers>

namespace bask {
namespace {

Isosurface triangleAt(double z_m) {
    Isosurface surface;
    surface.points = {{0, 0, z_m}, {1, 0, z_m}, {0, 1, z_m}};
    surface.triangles = {{0, 1, 2}};
    return surface;
}

// Catches: hits behind the viewer, beside the triangle, or not the nearest.
TEST(SceneRays, meetTheNearestTriangleInFront) {
    Isosurface surface = triangleAt(0.2);
    surface.points.insert(surface.points.end(), {{0, 0, 0.5}, {1, 0, 0.5}, {0, 1, 0.5}});
    surface.triangles.push_back({3, 5, 4}); // the other way round
    const Eigen::Vector3d down = -Eigen::Vector3d::UnitZ();
    EXPECT_NEAR(*distanceTo(surface, {{0.2, 0.2, 1.0}, down}), 0.5, 1e-12);
    EXPECT_NEAR(*distanceTo(surface, {{0.2, 0.2, 0.4}, down}), 0.2, 1e-12);
    EXPECT_FALSE(distanceTo(surface, {{0.2, 0.2, 0.1}, down}));
    EXPECT_FALSE(distanceTo(surface, {{0.6, 0.6, 1.0}, down}));
    EXPECT_FALSE(distanceTo(surface, {{-0.1, 0.5, 0.5}, Eigen::Vector3d::UnitX()})) << "edge on";
}

TEST(SceneRays, meetTheCutWithinTheBox) {
    const Box box(Eigen::Vector3d(-1, -1, 0), Eigen::Vector3d(1, 1, 2));
    const Eigen::Vector3d direction = Eigen::Vector3d(0, 1, -1).normalized();
    EXPECT_NEAR(*distanceToCut(box, 2, 0.5, {{0, -1, 1.5}, direction}), std::numbers::sqrt2, 1e-12);
    EXPECT_FALSE(distanceToCut(box, 2, 0.5, {{0, 0.5, 1.5}, direction})) << "beside the box";
    EXPECT_FALSE(distanceToCut(box, 0, 0.5, {{0, 0, 1}, direction})) << "along the plane";
    EXPECT_TRUE(distanceToCut(box, 2, 2.0, {{0, -1, 3}, direction})) << "on the box's face";
}

// Catches: corners out of order, which would cross, or missing.
TEST(SceneRays, aPlaneCutsABoxInAPolygon) {
    const Box box(Eigen::Vector3d(-1, -1, -1), Eigen::Vector3d(1, 1, 1));
    EXPECT_EQ(planeInBox(box, Eigen::Vector3d::UnitZ(), 0.3).size(), 4U);
    const auto hexagon = planeInBox(box, Eigen::Vector3d(1, 1, 1).normalized(), 0.0);
    ASSERT_EQ(hexagon.size(), 6U);
    for (std::size_t i = 0; i < 6; ++i)
        EXPECT_NEAR((hexagon[i] - hexagon[(i + 1) % 6]).norm(), std::numbers::sqrt2, 1e-12);
    EXPECT_TRUE(planeInBox(box, Eigen::Vector3d::UnitX(), 1.5).empty());
    EXPECT_EQ(edgesOf(box).size(), 24U);
    EXPECT_EQ(sidesOf(hexagon).size(), 12U);
}

} // namespace
} // namespace bask
