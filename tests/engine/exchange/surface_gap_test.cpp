// Gaps between spheres, whose distances are known.

#include "engine/exchange/surface_gap.h"

#include <gtest/gtest.h>

#include <stdexcept>

namespace bask::test {
namespace {

/// Minus the distance from a centre.
std::shared_ptr<const Field> cone(const Eigen::Vector3d& centre) {
    auto field = std::make_shared<Field>();
    field->axes = {{kX, -1.0, 0.05, 41}, {kY, -1.0, 0.05, 41}, {kZ, -1.0, 0.05, 41}};
    for (int k = 0; k < 41; ++k)
        for (int j = 0; j < 41; ++j)
            for (int i = 0; i < 41; ++i)
                field->values.push_back(
                    -(Eigen::Vector3d(field->axes[0].at(i), field->axes[1].at(j), field->axes[2].at(k)) -
                      centre)
                         .norm());
    return field;
}

struct Spheres {
    std::vector<std::shared_ptr<const Field>> fields;
    std::vector<Isosurface> surfaces;

    void add(const Eigen::Vector3d& centre, double radius) {
        fields.push_back(cone(centre));
        surfaces.push_back(isosurfaces(*fields.back(), {-radius}).front());
    }
    std::optional<SurfaceGap> gap() const { return widestGap(fields, surfaces); }
};

// Catches: another pair, ends on the wrong surface, a distance from corner to corner instead of to the
// surface.
TEST(SurfaceGap, isBetweenTheTwoFarthestApart) {
    Spheres spheres;
    spheres.add({-0.6, 0.0, 0.0}, 0.2);
    spheres.add({0.0, 0.0, 0.0}, 0.3);
    spheres.add({0.6, 0.1, 0.0}, 0.25);
    const auto gap = spheres.gap();
    ASSERT_TRUE(gap);
    EXPECT_EQ(gap->first, 0U);
    EXPECT_EQ(gap->second, 2U);
    const Eigen::Vector3d between(1.2, 0.1, 0.0);
    EXPECT_NEAR(gap->distance(), between.norm() - 0.45, 0.01);
    EXPECT_NEAR((gap->from - Eigen::Vector3d(-0.6, 0.0, 0.0)).norm(), 0.2, 0.01);
    EXPECT_NEAR((gap->to - Eigen::Vector3d(0.6, 0.1, 0.0)).norm(), 0.25, 0.01);
    EXPECT_GT((gap->to - gap->from).normalized().dot(between.normalized()), 0.98);
}

// Catches: a gap of a part of a step between surfaces that cross, and none between one and another inside it.
TEST(SurfaceGap, thereIsNoneWhereTheyMeet) {
    Spheres crossing;
    crossing.add({-0.2, 0.0, 0.0}, 0.3);
    crossing.add({0.21, 0.03, 0.0}, 0.3);
    EXPECT_FALSE(crossing.gap());
    Spheres inside;
    inside.add({0.0, 0.0, 0.0}, 0.3);
    inside.add({0.1, 0.0, 0.0}, 0.7);
    ASSERT_TRUE(inside.gap());
    EXPECT_NEAR(inside.gap()->distance(), 0.3, 0.01);
}

// Catches: a crash on a surface that is not there.
TEST(SurfaceGap, anEmptySurfaceHasNone) {
    Spheres spheres;
    spheres.add({0.0, 0.0, 0.0}, 0.3);
    spheres.add({0.0, 0.0, 0.0}, 9.0);
    EXPECT_TRUE(spheres.surfaces[1].empty());
    EXPECT_FALSE(spheres.gap());
    spheres.fields.pop_back();
    EXPECT_THROW(static_cast<void>(spheres.gap()), std::invalid_argument);
}

} // namespace
} // namespace bask::test
