#include "engine/calibration/picture_outline.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace bask {
namespace {

CameraModel cameraOf(std::vector<double> distortion = {}) {
    CameraModel camera;
    camera.width = 160;
    camera.height = 120;
    camera.fx = camera.fy = 200.0;
    camera.cx = 79.5;
    camera.cy = 59.5;
    camera.distortion = std::move(distortion);
    return camera;
}

Pose at(double x, double y, double z, double turn_rad = 0.0) {
    return poseFromRotationVector({x, y, z}, {0.0, turn_rad, 0.0});
}

double areaOf(const std::vector<Eigen::Vector2d>& ring) {
    double twice = 0.0;
    for (std::size_t k = 0; k < ring.size(); ++k) {
        const Eigen::Vector2d &a = ring[k], &b = ring[(k + 1) % ring.size()];
        twice += a.x() * b.y() - a.y() * b.x();
    }
    return 0.5 * std::abs(twice);
}

TEST(PictureOutline, IsACircleOfADiskStraightOn) {
    for (const Eigen::Vector2d& p : outlineInPicture(cameraOf(), at(0.05, -0.02, 0.5), Disk{0.03}))
        EXPECT_NEAR((p - Eigen::Vector2d(99.5, 51.5)).norm(), 12.0, 1e-9);
}

TEST(PictureOutline, BendsAnEdgeAsTheLensDoes) {
    const CameraModel camera = cameraOf({-0.3, 0.1, 0.001, -0.002, 0.0});
    const Contour square{{{-0.1, -0.1}, {0.1, -0.1}, {0.1, 0.1}, {-0.1, 0.1}}};
    const Pose X_CO = at(0.02, 0.01, 0.5, 0.3);
    for (const Eigen::Vector2d& p : outlineInPicture(camera, X_CO, square)) {
        const auto ray = rayOf(Lens(camera), p);
        ASSERT_TRUE(ray);
        // Where the line of sight meets the plate.
        const Eigen::Vector3d n = X_CO.linear().col(2), direction(ray->x(), ray->y(), 1.0);
        const Eigen::Vector3d p_O =
            X_CO.inverse() * (n.dot(X_CO.translation()) / n.dot(direction) * direction);
        EXPECT_NEAR(p_O.cwiseAbs().maxCoeff(), 0.1, 1e-7);
    }
}

TEST(PictureOutline, IsCutOffOutsideOfThePicture) {
    const auto ring = outlineInPicture(cameraOf(), at(0.2, 0.0, 0.5), Disk{0.1}); // half of it
    ASSERT_FALSE(ring.empty());
    for (const Eigen::Vector2d& p : ring)
        EXPECT_LT(p.x(), 170.0);
    EXPECT_NEAR(areaOf(ring), 0.5 * std::numbers::pi * 40.0 * 40.0, 7.0 * 80.0);
    EXPECT_GT(areaOf(ring), 0.5 * std::numbers::pi * 40.0 * 40.0);
}

TEST(PictureOutline, IsEmptyBehindTheCameraAndBesideThePicture) {
    EXPECT_TRUE(outlineInPicture(cameraOf(), at(0.0, 0.0, -0.5), Disk{0.03}).empty());
    EXPECT_TRUE(outlineInPicture(cameraOf(), at(1.0, 0.0, 0.5), Disk{0.03}).empty());
    EXPECT_FALSE(outlineInPicture(cameraOf(), at(0.0, 0.0, 0.1, 1.5), Disk{0.3}).empty()); // partly behind
}

// Catches bounds by a wide margin that reach where Brown's formula shows what is outside as if it were
// inside.
TEST(PictureOutline, BoundsEndWhereTheLensTurnsBack) {
    constexpr double kTurn = 0.9759; // 1 - 3 * 0.35 r^2 = 0
    const CameraModel camera = cameraOf({-0.35, 0.0, 0.0, 0.0, 0.0});
    const Eigen::AlignedBox2d bounds = raysInPicture(camera, 1000.0);
    for (int axis = 0; axis < 2; ++axis) {
        EXPECT_NEAR(bounds.max()[axis], kTurn, 0.02);
        EXPECT_NEAR(bounds.min()[axis], -kTurn, 0.02);
    }
    EXPECT_NEAR(raysInPicture(cameraOf(), 20.0).max().x(), (80.0 + 20.0) / 200.0, 1e-7);
}

TEST(PictureOutline, RefusesACameraWithoutSize) {
    CameraModel camera = cameraOf();
    camera.width = 0;
    EXPECT_THROW(outlineInPicture(camera, at(0.0, 0.0, 0.5), Disk{0.03}), std::invalid_argument);
}

} // namespace
} // namespace bask
