// The board that is held before a simulated camera calibrates it.

#include "engine/simulation/board_script.h"

#include "engine/calibration/camera_calibration.h"
#include "engine/calibration/projection.h"
#include "engine/simulation/simulated_camera.h"
#include "tests/engine/calibration/calibration_samples.h"

namespace bask {
namespace {

// Catches: boards drawn mirrored or in the wrong pattern, views too oblique or outside of the picture, views
// that tell no focal length, edges that pull the corners.
TEST(BoardScript, AViewOfEachKindOfBoardCalibratesTheCamera) {
    for (const std::string text :
         {"chessboard:9x6:0.025", "charuco:5x7:0.04:0.03:4X4_50", "charuco:8x6:0.03:0.022:5X5_100:legacy"}) {
        const Board board = *parseBoard(text);
        SimulatedCameraConfig config;
        config.isWallLimited = false;
        SimulatedCamera camera(config);
        camera.observe({10.0, Pose(Eigen::Translation3d(0, 0, 0.1)), Pose::Identity()});
        camera.setBoard(board);
        std::vector<CalibrationView> views;
        for (int k = 0; k < kBoardViews; ++k) { // each while it is still
            camera.observe({10.0 + stillTime_s(k) + config.delay_s, Pose(Eigen::Translation3d(0, 0, 0.1)),
                            Pose::Identity()});
            const auto frame = camera.newest();
            ASSERT_TRUE(frame);
            if (auto view = findBoard((*frame)->picture, board, text))
                views.push_back({std::to_string(k), *view});
        }
        EXPECT_GE(views.size(), 0.9 * kBoardViews) << text;
        const auto calibration = calibrateCamera(views, board, config.camera.width, config.camera.height, 5);
        ASSERT_TRUE(calibration) << text;
        EXPECT_FALSE(calibration->reasonAgainst()) << text;
        EXPECT_NEAR(calibration->camera.fx, config.camera.fx, 0.005 * config.camera.fx) << text;
        EXPECT_NEAR(calibration->camera.fy, config.camera.fy, 0.005 * config.camera.fy) << text;
    }
}

// Catches: a board that jumps, that is not still when it should be, or whose views leave the picture, for
// boards and pictures of any proportions.
TEST(BoardScript, MovesSteadilyAndStaysInThePicture) {
    for (const std::string text :
         {"chessboard:9x6:0.025", "chessboard:20x3:0.2", "charuco:3x9:0.004:0.003:4X4_50"})
        for (const auto& [width, height] : {std::pair(1280, 720), {480, 640}}) {
            const Board board = *parseBoard(text);
            CameraModel camera = usualCamera();
            camera.width = width;
            camera.height = height;
            camera.cx = 0.5 * width;
            camera.cy = 0.5 * height;
            const double ofFirst = board.kind == BoardKind::Chessboard ? board.square_m : 0.0;
            const Eigen::Vector2d first(ofFirst, ofFirst); // from the pattern's upper left
            Eigen::AlignedBox2d seen;
            for (int k = 0; k < kBoardViews; ++k) {
                const Pose X_CB = boardPoseAt(board, camera, stillTime_s(k));
                EXPECT_TRUE(X_CB.isApprox(scriptedBoardPose(board, camera, k)));
                EXPECT_TRUE(X_CB.isApprox(boardPoseAt(board, camera, stillTime_s(k) + 0.49 * kBoardStill_s)));
                for (int corner = 0; corner < cornerCount(board); ++corner) {
                    const Eigen::Vector2d p = cornerOf(board, corner) + first;
                    const Eigen::Vector3d p_C = X_CB * Eigen::Vector3d(p.x(), p.y(), 0.0);
                    EXPECT_TRUE(isInPicture(camera, p_C)) << text << ' ' << k;
                    seen.extend(test::shown(camera, p_C));
                }
            }
            EXPECT_GT(seen.volume(), 0.5 * width * height) << text << " corners of the picture are visited";
            Pose last = boardPoseAt(board, camera, 0.0);
            for (double t = 0.0; t < stillTime_s(kBoardViews + 1); t += 0.01) {
                const Pose now = boardPoseAt(board, camera, t);
                ASSERT_LT((now.translation() - last.translation()).norm(), 0.1 * now.translation().norm());
                ASSERT_LT(Eigen::AngleAxisd(now.linear() * last.linear().transpose()).angle(), 0.05);
                last = now;
            }
        }
}

} // namespace
} // namespace bask
