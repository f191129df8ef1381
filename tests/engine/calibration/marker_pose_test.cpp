// The pose of a square, and when its mirror image is as good.

#include "engine/calibration/marker_pose.h"

#include "tests/engine/calibration/calibration_samples.h"

namespace bask {
namespace {

std::array<Eigen::Vector2d, 4> cornersAt(const Pose& X_CM, double side_m, const CameraModel& camera) {
    const double h = 0.5 * side_m;
    std::array<Eigen::Vector2d, 4> corners;
    const Eigen::Vector3d square[] = {{-h, h, 0}, {h, h, 0}, {h, -h, 0}, {-h, -h, 0}};
    for (std::size_t k = 0; k < 4; ++k)
        corners[k] = test::shown(camera, X_CM * square[k]);
    return corners;
}

/// A marker that faces the camera, turned about its own axes then.
Pose facing(const Eigen::Vector3d& p_m, const Eigen::Vector3d& turn_rad) {
    return poseFromRotationVector(p_m, {std::numbers::pi, 0, 0}) *
           poseFromRotationVector(Eigen::Vector3d::Zero(), turn_rad);
}

// Catches: axes, units and distortion taken another way; the pose of exact corners is exact.
TEST(MarkerPose, ExactCornersGiveThePoseBack) {
    const CameraModel camera = test::sampleCamera();
    for (const Eigen::Vector3d& turn :
         {Eigen::Vector3d(0.6, 0, 0), Eigen::Vector3d(-0.3, 0.7, 1.2), Eigen::Vector3d(0.5, -0.4, -2.5)}) {
        const Pose X_CM = facing({0.1, -0.08, 0.6}, turn);
        const auto poses = markerPoses(cornersAt(X_CM, 0.05, camera), 0.05, camera);
        ASSERT_TRUE(poses);
        EXPECT_TRUE(poses->best.X_CM().isApprox(X_CM, 1e-5)) << poses->best.X_CM().matrix();
        EXPECT_LT(poses->best.rms_px, 1e-3);
        ASSERT_TRUE(poses->second);
        EXPECT_GT(poses->second->rms_px, poses->best.rms_px);
        EXPECT_FALSE(poses->isAmbiguous);
    }
}

// Catches: a pose told for sure that is a guess, and doubt where there is none. A marker of 20 mm at 1.5 m is
// 13 px wide: its mirror image is as good. One of 100 mm at 0.4 m, tilted, has none.
TEST(MarkerPose, SaysWhenTheMirrorImageIsAsGood) {
    const CameraModel camera = test::sampleCamera();
    const auto far = markerPoses(cornersAt(facing({0, 0, 1.5}, {0.3, 0.2, 0}), 0.02, camera), 0.02, camera);
    ASSERT_TRUE(far);
    EXPECT_TRUE(far->isAmbiguous);
    const auto near = markerPoses(cornersAt(facing({0, 0, 0.4}, {0.5, 0.2, 0}), 0.1, camera), 0.1, camera);
    ASSERT_TRUE(near);
    EXPECT_FALSE(near->isAmbiguous);
}

// Catches: doubt that is not told when corners are noisy: of 200 wrong choices of the mirrored pose nearly
// all are called ambiguous.
TEST(MarkerPose, WrongChoicesAreCalledAmbiguous) {
    const CameraModel camera = test::sampleCamera();
    std::mt19937 random(11);
    std::normal_distribution<double> noise(0.0, 0.2);
    int wrong = 0, untold = 0, told = 0;
    for (int k = 0; k < 400; ++k) {
        const Pose X_CM = facing({0, 0, 1.2}, {0.25 * std::cos(0.7 * k), 0.25 * std::sin(0.7 * k), 0.1 * k});
        auto corners = cornersAt(X_CM, 0.03, camera);
        for (Eigen::Vector2d& corner : corners)
            corner += Eigen::Vector2d(noise(random), noise(random));
        const auto poses = markerPoses(corners, 0.03, camera);
        ASSERT_TRUE(poses);
        const double angle =
            Eigen::AngleAxisd(X_CM.linear().transpose() * poses->best.X_CM().linear()).angle();
        if (poses->isAmbiguous)
            ++told;
        if (angle > 0.3) {
            ++wrong;
            untold += poses->isAmbiguous ? 0 : 1;
        }
    }
    EXPECT_GT(wrong, 10) << "the case is no test otherwise";
    EXPECT_LE(untold, wrong / 10);
    EXPECT_LT(told, 400);
}

// Catches: a pose from corners that are no square's, or a crash.
TEST(MarkerPose, RefusesWhatIsNoSquare) {
    const CameraModel camera = test::sampleCamera();
    const Eigen::Vector2d p(100, 100), d(10, 10);
    EXPECT_FALSE(markerPoses({p, p, p, p}, 0.05, camera));
    const auto line = markerPoses({p, p + d, p + 2 * d, p + 3 * d}, 0.05, camera);
    EXPECT_TRUE(!line || line->best.rms_px > 1.0);
    const double nan = std::nan("");
    EXPECT_FALSE(markerPoses({Eigen::Vector2d(nan, nan), p, p, p}, 0.05, camera));
}

} // namespace
} // namespace bask
