// Robot base and camera by the robot's own motion: right, honest about its uncertainty, and no answer where
// the motion tells none.

#include "engine/calibration/hand_eye.h"

#include "engine/base/message_code.h"
#include "tests/engine/calibration/rig_scene.h"

#include <functional>

namespace bask {
namespace {

/// A robot whose hand carries the standard layout's end-effector markers before a camera 0.6 m away.
struct Cell {
    test::RigScene scene;
    Pose X_RC = poseFromRotationVector({0.4, -0.7, 0.5}, {-1.7, 0.4, 0.3});
    Pose X_EP = poseFromRotationVector({0.01, -0.02, 0.05}, {0.1, -0.2, 0.3});
    double robot_m = 0.0, robot_rad = 0.0; ///< standard deviations of its errors

    /// `moved`: of the markers' frame, about the middle of the camera's picture.
    HandEyeView view(const Pose& moved, std::mt19937& random) const {
        std::normal_distribution<double> normal;
        const auto vector = [&](double deviation) {
            return Eigen::Vector3d(deviation * normal(random), deviation * normal(random),
                                   deviation * normal(random));
        };
        test::RigScene seen = scene;
        seen.X_CE = test::facingCamera({0, 0, 0.6}, {0.3, 0, 0}) * moved;
        HandEyeView view{X_RC * seen.X_CE * X_EP.inverse(), {seen.frame(random)}};
        Vector6d error;
        error << vector(robot_m), vector(robot_rad);
        view.X_RE = displaced(view.X_RE, error);
        return view;
    }

    std::vector<HandEyeView> views(int count, std::mt19937& random) const {
        std::uniform_real_distribution<double> any(-1.0, 1.0);
        std::vector<HandEyeView> result;
        for (int k = 0; k < count; ++k)
            result.push_back(
                view(poseFromRotationVector({0.1 * any(random), 0.08 * any(random), 0.1 * any(random)},
                                            {0.5 * any(random), 0.5 * any(random), 0.8 * any(random)}),
                     random));
        return result;
    }
};

double normalised(const HandEye& found, const Cell& cell, Mounting mounting) {
    Eigen::VectorXd d(12);
    d << displacementBetween(found.X_RC, cell.X_RC), displacementBetween(found.X_EP, cell.X_EP);
    const int n = mounting == Mounting::Sought ? 12 : 6;
    return d.head(n).dot(found.covariance.topLeftCorner(n, n).ldlt().solve(d.head(n)));
}

// Catches: frames or their order taken another way: exact corners give both poses back.
TEST(HandEye, ExactCornersGiveBothPosesBack) {
    Cell cell;
    cell.scene.corner_px = 0.0;
    std::mt19937 random(1);
    const auto found =
        calibrateHandEye(cell.views(8, random), cell.scene.layout, cell.scene.camera, Mounting::Sought);
    ASSERT_TRUE(found) << describe(found.error());
    EXPECT_TRUE(found->X_RC.isApprox(cell.X_RC, 1e-7)) << found->X_RC.matrix();
    EXPECT_TRUE(found->X_EP.isApprox(cell.X_EP, 1e-7)) << found->X_EP.matrix();
    EXPECT_LT(found->rms_px, 1e-5);
}

// Catches: a covariance that is not honest for corner noise, or for a robot whose own errors (0.5 mm, 0.1
// degrees) are larger than the corners', with the mounting sought or known.
TEST(HandEye, CovarianceIsHonest) {
    struct Case {
        const char* name;
        Mounting mounting;
        double robot_m, robot_rad;
    };
    for (const Case& c : {Case{"sought, good robot", Mounting::Sought, 0.0, 0.0},
                          Case{"sought, poor robot", Mounting::Sought, 5e-4, radFromDeg(0.1)},
                          Case{"known, good robot", Mounting::Known, 0.0, 0.0},
                          Case{"known, poor robot", Mounting::Known, 5e-4, radFromDeg(0.1)}}) {
        Cell cell;
        cell.robot_m = c.robot_m;
        cell.robot_rad = c.robot_rad;
        if (c.mounting == Mounting::Known)
            cell.X_EP = Pose::Identity();
        const double bound = c.mounting == Mounting::Sought ? 21.026 : test::kChiSquare6At95;
        constexpr int kTrials = 40;
        std::mt19937 random(2);
        int within = 0;
        double squares_m2 = 0.0, sigma = 0.0, robot_m = 0.0, robot_rad = 0.0;
        for (int k = 0; k < kTrials; ++k) {
            const auto found =
                calibrateHandEye(cell.views(15, random), cell.scene.layout, cell.scene.camera, c.mounting);
            ASSERT_TRUE(found) << describe(found.error());
            within += normalised(*found, cell, c.mounting) < bound;
            squares_m2 += (found->X_RC.translation() - cell.X_RC.translation()).squaredNorm() / kTrials;
            robot_m += found->robot_m / kTrials;
            robot_rad += found->robot_rad / kTrials;
            sigma += found->covariance.topLeftCorner<3, 3>().trace() / kTrials;
        }
        EXPECT_GE(within, kTrials * 85 / 100) << c.name;
        EXPECT_LT(std::sqrt(squares_m2), 1.3 * std::sqrt(sigma)) << c.name;
        EXPECT_NEAR(robot_rad, c.robot_rad, 0.2 * c.robot_rad + 2e-4) << c.name;
        // At the markers: turns about E's origin move them by 6 cm times the angle.
        EXPECT_NEAR(robot_m, c.robot_m, 0.2 * c.robot_m + 1e-4) << c.name;
    }
}

// Catches: one wrong pose of the robot, or one picture taken on the way, that spoils all; and silence about
// it.
TEST(HandEye, AWrongViewIsLeftOutAndNamed) {
    Cell cell;
    std::mt19937 random(3);
    auto views = cell.views(15, random);
    views[4].X_RE.translation().z() += 0.02;
    views[9].X_RE = views[8].X_RE;
    views[11].frames.clear();
    const auto found = calibrateHandEye(views, cell.scene.layout, cell.scene.camera, Mounting::Sought);
    ASSERT_TRUE(found) << describe(found.error());
    for (std::size_t k = 0; k < views.size(); ++k)
        EXPECT_EQ(found->views[k].isUsed, k != 4 && k != 9 && k != 11) << k;
    EXPECT_EQ(found->remarks.size(), 2u);
    EXPECT_TRUE(test::says(found->remarks, MessageCode::HandEyeViewLeftOut, "5"));
    EXPECT_TRUE(test::says(found->remarks, MessageCode::HandEyeViewLeftOut, "10"));
    EXPECT_NEAR(found->views[4].difference.distance_m, 0.02, 0.003);
    EXPECT_LT(normalised(*found, cell, Mounting::Sought), 33.0);
}

std::vector<HandEyeView> viewsBy(const Cell& cell, const std::function<Pose(double)>& motion) {
    std::mt19937 random(4);
    std::vector<HandEyeView> views;
    for (int k = 0; k < 12; ++k)
        views.push_back(cell.view(motion(std::sin(1.3 * k)), random));
    return views;
}

// Catches: numbers for what the motion cannot tell. Pure translation and turns about one axis leave the
// camera's place open along at least one direction; with a known mounting they do not.
TEST(HandEye, MotionsThatTellNothingAreNamed) {
    Cell cell;
    const auto translation = [](double s) {
        return poseFromRotationVector({0.1 * s, 0.08 * s * s, 0.05 * (1 - s)}, Eigen::Vector3d::Zero());
    };
    const auto oneAxis = [](double s) {
        return poseFromRotationVector({0.1 * s, 0.08 * s * s, 0.05 * (1 - s)}, {0.5 * s, 0, 0});
    };
    const auto codeOf = [&](const auto& motion) {
        return calibrateHandEye(viewsBy(cell, motion), cell.scene.layout, cell.scene.camera, Mounting::Sought)
            .error()
            .code();
    };
    EXPECT_EQ(codeOf(translation), MessageCode::HandEyeNoTurn);
    EXPECT_EQ(codeOf(oneAxis), MessageCode::HandEyeOneAxis);
    cell.X_EP = Pose::Identity();
    for (const std::function<Pose(double)>& motion : {std::function<Pose(double)>(translation), {oneAxis}}) {
        const auto found =
            calibrateHandEye(viewsBy(cell, motion), cell.scene.layout, cell.scene.camera, Mounting::Known);
        ASSERT_TRUE(found) << describe(found.error());
        EXPECT_LT(normalised(*found, cell, Mounting::Known), 22.5);
        EXPECT_TRUE(found->X_EP.isApprox(Pose::Identity()));
    }
}

// Catches: a calibration from too few views or from views that have nothing to do with the robot's poses.
TEST(HandEye, RefusesWhatGivesNoCalibration) {
    Cell cell;
    cell.X_EP = Pose::Identity();
    std::mt19937 random(5);
    auto views = cell.views(12, random);
    for (std::size_t k = 2; k < views.size(); ++k)
        views[k].frames.clear();
    const auto solve = [&](Mounting mounting) {
        return calibrateHandEye(views, cell.scene.layout, cell.scene.camera, mounting);
    };
    EXPECT_EQ(solve(Mounting::Sought).error().code(), MessageCode::HandEyeViewsFew);
    EXPECT_TRUE(solve(Mounting::Known));
    views.clear();
    EXPECT_EQ(solve(Mounting::Known).error().code(), MessageCode::HandEyeViewsFew);
    views = cell.views(12, random);
    const auto others = cell.views(12, random);
    for (std::size_t k = 0; k < views.size(); ++k)
        views[k].X_RE = others[k].X_RE;
    const auto found = solve(Mounting::Sought);
    EXPECT_FALSE(found) << found->rms_px;
}

// Catches: a place by many frames from one pose told as sure as if nothing were wrong with all of them alike.
TEST(HandEye, ByOnePoseIsHonestAboutWhatItsFramesHaveInCommon) {
    Cell cell;
    cell.X_EP = Pose::Identity();
    std::mt19937 random(11);
    std::normal_distribution<double> lasting(0.0, kLastingCorner_px);
    constexpr int kTrials = 100, kFrames = 30;
    int within = 0;
    for (int trial = 0; trial < kTrials; ++trial) {
        HandEyeView view = cell.view(Pose::Identity(), random);
        test::RigScene seen = cell.scene;
        seen.X_CE = cell.X_RC.inverse() * view.X_RE;
        view.frames = seen.frames(kFrames, random);
        for (std::size_t m = 0; m < view.frames[0].size(); ++m)
            for (std::size_t k = 0; k < 4; ++k) {
                const Eigen::Vector2d off(lasting(random), lasting(random));
                for (MarkerFrame& frame : view.frames)
                    frame[m].corners_px[k] += off;
            }
        const auto found =
            calibrateHandEye(std::span(&view, 1), cell.scene.layout, cell.scene.camera, Mounting::Known);
        ASSERT_TRUE(found) << describe(found.error());
        within += normalised(*found, cell, Mounting::Known) < test::kChiSquare6At95 ? 1 : 0;
    }
    EXPECT_GE(within, 88 * kTrials / 100);
}

// Catches: markers that contradict one another, told as not seen.
TEST(HandEye, SaysWhyNoViewHasAPose) {
    Cell cell;
    std::mt19937 random(12);
    const auto views = cell.views(4, random);
    MarkerLayout wrong = cell.scene.layout;
    for (PlacedMarker& marker : wrong.markers) // each elsewhere than the others say
        if (marker.part == Part::EndEffector)
            marker.X_PM = Pose(Eigen::Translation3d(0.03 * marker.id, -0.02 * marker.id, 0)) * marker.X_PM;
    EXPECT_EQ(calibrateHandEye(views, wrong, cell.scene.camera, Mounting::Known).error().code(),
              MessageCode::MarkersDisagree);
}

// Catches: frames of one pose that count as one, or whose number is not in the residuals' weights.
TEST(HandEye, FramesOfAPoseAreAveraged) {
    Cell cell;
    std::mt19937 random(7);
    auto views = cell.views(10, random);
    const auto single = calibrateHandEye(views, cell.scene.layout, cell.scene.camera, Mounting::Sought);
    for (HandEyeView& view : views) {
        test::RigScene seen = cell.scene;
        seen.X_CE = cell.X_RC.inverse() * view.X_RE * cell.X_EP;
        view.frames = seen.frames(16, random);
    }
    const auto averaged = calibrateHandEye(views, cell.scene.layout, cell.scene.camera, Mounting::Sought);
    ASSERT_TRUE(single && averaged);
    const auto deviation = [](const HandEye& h) {
        return std::sqrt(h.covariance.topLeftCorner<3, 3>().trace());
    };
    EXPECT_NEAR(deviation(*single) / deviation(*averaged), 4.0, 1.5);
    EXPECT_NEAR(single->rms_px / averaged->rms_px, 4.0, 1.0);
    EXPECT_LT(normalised(*averaged, cell, Mounting::Sought), 33.0);
}

// Catches: a verification that is blind, or that blames a good calibration: at a new pose markers are where
// the robot has them, within what is expected; a camera pushed by 5 mm is told.
TEST(HandEye, TheCheckTellsAPushedCamera) {
    Cell cell;
    std::mt19937 random(6);
    const auto found =
        calibrateHandEye(cell.views(15, random), cell.scene.layout, cell.scene.camera, Mounting::Sought);
    ASSERT_TRUE(found) << describe(found.error());
    int within = 0;
    for (const HandEyeView& view : cell.views(20, random)) {
        const auto check = checkHandEye(*found, view, cell.scene.layout, cell.scene.camera);
        ASSERT_TRUE(check);
        within += check->difference.distance_m < 1.5 * check->expected.position_m &&
                  check->difference.angle_rad < 1.5 * check->expected.angle_rad;
    }
    EXPECT_GE(within, 18);
    cell.X_RC.translation().x() += 5e-3;
    const auto pushed = checkHandEye(*found, cell.views(1, random)[0], cell.scene.layout, cell.scene.camera);
    ASSERT_TRUE(pushed);
    EXPECT_NEAR(pushed->difference.distance_m, 5e-3, 2e-3);
    EXPECT_GT(pushed->difference.distance_m, pushed->expected.position_m);
}

} // namespace
} // namespace bask
