#include "engine/radiation/neighbours.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

namespace bask {
namespace {

constexpr double kRadius_m = 0.015;
constexpr double kApart_m = 0.02;
const Pose kTurned(Eigen::AngleAxisd(std::numbers::pi, Eigen::Vector3d::UnitX()));

Pose liftedBy(double z) {
    return Pose(Eigen::Translation3d(0.0, 0.0, z));
}

RadiatingContour disk() {
    return RadiatingContour(Disk{kRadius_m});
}

/// View factor between equal coaxial disks.
double betweenDisks() {
    const double x = 2.0 + std::pow(kApart_m / kRadius_m, 2);
    return 0.5 * (x - std::sqrt(x * x - 4.0));
}

} // namespace

// Catches a face on the wrong side, a missing reflection, rows taken for columns.
TEST(Neighbours, TwoFrontsThatFaceEachOtherHaveTheClosedForm) {
    const MountedObjects objects({{disk(), kTurned}, {disk(), liftedBy(kApart_m)}});
    const double e1 = 0.9, e2 = 0.6, a1 = 0.5, a2 = 0.8, f = betweenDisks();
    const Neighbours neighbours(objects, {{e1, a1}, {e2, a2}});
    ASSERT_TRUE(neighbours.exchange());
    const Eigen::Vector2d excess_K4(3e9, 1e9);
    const double all = 1.0 - f * f * (1.0 - e1) * (1.0 - e2);
    const Eigen::Vector2d expected(f * (e2 * excess_K4[1] + (1.0 - e2) * f * e1 * excess_K4[0]) / all,
                                   f * (e1 * excess_K4[0] + (1.0 - e1) * f * e2 * excess_K4[1]) / all);
    EXPECT_LT((neighbours.gains_K4(excess_K4) - expected).norm(), 1e-4 * expected.norm());

    const Eigen::Vector2d F(0.3, 0.1);
    const double ofSource = 1.0 - f * f * (1.0 - a1) * (1.0 - a2);
    const Eigen::Vector2d received((F[0] + f * (1.0 - a2) * F[1]) / ofSource,
                                   (F[1] + f * (1.0 - a1) * F[0]) / ofSource);
    EXPECT_LT((neighbours.withReflections(F) - received).norm(), 1e-4);
}

// The far one's front sees the near one's adiabatic back, which gives back what it gets.
TEST(Neighbours, AnAdiabaticBackGivesBackWhatFallsOnIt) {
    const MountedObjects objects({{disk(), Pose::Identity()}, {disk(), liftedBy(kApart_m)}});
    const double e = 0.7, a = 0.6, f2 = std::pow(betweenDisks(), 2);
    const Neighbours neighbours(objects, {{e, a}, {e, a}});
    ASSERT_TRUE(neighbours.exchange());
    const Eigen::VectorXd gains_K4 = neighbours.gains_K4(Eigen::Vector2d(3e9, 1e9));
    EXPECT_NEAR(gains_K4[0], 0.0, 1.0);
    EXPECT_NEAR(gains_K4[1], 1e9 * f2 * e / (1.0 - f2 * (1.0 - e)), 1e5);
    const Eigen::MatrixXd received = neighbours.withReflections(Eigen::Vector2d(0.3, 0.1));
    EXPECT_NEAR(received(0), 0.3, 1e-12);
    EXPECT_NEAR(received(1), 0.1 / (1.0 - f2 * (1.0 - a)), 1e-5);
}

TEST(Neighbours, ObjectsInOnePlaneExchangeNothing) {
    const Pose aside(Eigen::Translation3d(0.04, 0.0, 0.0));
    const MountedObjects objects({{disk(), Pose::Identity()}, {disk(), aside}});
    const Neighbours neighbours(objects, {{}, {}});
    EXPECT_FALSE(neighbours.exchange());
    const Eigen::Vector2d F(0.3, 0.1);
    EXPECT_EQ(neighbours.withReflections(F), F);
    EXPECT_TRUE(neighbours.gains_K4(F).isZero(0.0));
}

// Three of different shape, area and tilt, the middle one between the others. Catches a mirror image, an area
// of the wrong face, and one that radiates through another.
TEST(Neighbours, WhatOneGivesTheOtherIsWhatItGets) {
    const RadiatingContour lobed(
        FourierContour({{0.002, 0.001}, {0.0, 0.0}, {0.001, 0.002}, {0.02, 0.0}, {0.0, 0.0}}));
    const MountedObjects objects(
        {{lobed, poseFromRotationVector({-0.03, 0.0, 0.0}, {0.1, -0.9, 0.3})},
         {disk(), poseFromRotationVector({0.0, 0.005, 0.02}, {0.2, 0.1, 0.0})},
         {RadiatingContour(Disk{0.02}), poseFromRotationVector({0.03, 0.0, 0.01}, {-0.2, 0.8, 0.5})}});
    const std::vector<FaceMaterial> fronts{{0.9, 0.9}, {0.5, 0.5}, {0.7, 0.7}};
    const Neighbours neighbours(objects, fronts);
    ASSERT_TRUE(neighbours.exchange());
    Eigen::Matrix3d given;
    for (int j = 0; j < 3; ++j)
        given.col(j) = neighbours.gains_K4(Eigen::Vector3d::Unit(j));
    for (std::size_t i = 0; i < 3; ++i)
        given.row(static_cast<Eigen::Index>(i)) *= fronts[i].emittance * objects[i].contour.area_m2();
    EXPECT_LT((given - given.transpose()).norm(), 1e-4 * given.norm());
    EXPECT_GT(given(0, 2) / objects[0].contour.area_m2(), 0.01);
    EXPECT_TRUE((given.array() >= 0.0).all());
}

TEST(Neighbours, NeedOneMaterialForEachObject) {
    EXPECT_THROW(Neighbours(MountedObjects({{disk(), Pose::Identity()}}), {}), std::invalid_argument);
}

} // namespace bask
