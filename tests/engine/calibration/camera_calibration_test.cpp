// Cameras from views: exact ones, real ones, and views that tell too little.

#include "engine/calibration/camera_calibration.h"

#include "engine/base/message_code.h"
#include "tests/engine/calibration/calibration_samples.h"

#include <cmath>

namespace bask {
namespace {

/// Views of a board from all sides, its corners wrong by `noise_px`.
std::vector<CalibrationView> views(const CameraModel& camera, const Board& board, int count,
                                   double noise_px) {
    std::mt19937 random(3);
    std::normal_distribution<double> noise(0.0, 1.0);
    std::vector<CalibrationView> result;
    for (int k = 0; k < count; ++k) {
        const double a = 2.4 * k;
        const Pose X_CB = poseFromRotationVector(
            {-0.1 + 0.08 * std::cos(1.7 * a), -0.07 + 0.05 * std::sin(a), 0.35 + 0.01 * k},
            {0.5 * std::cos(a), 0.5 * std::sin(a), 0.1 * k});
        CalibrationView view{"view " + std::to_string(k), {}};
        for (int corner = 0; corner < cornerCount(board); ++corner) {
            const Eigen::Vector2d p = cornerOf(board, corner);
            view.board.corners.push_back(corner);
            view.board.corners_px.push_back(test::shown(camera, X_CB * Eigen::Vector3d(p.x(), p.y(), 0)) +
                                            noise_px * Eigen::Vector2d(noise(random), noise(random)));
        }
        result.push_back(view);
    }
    return result;
}

const Board kBoard = *parseBoard("chessboard:9x6:0.025");

// Catches: parameters in another order, or another formula than camera_model.h says.
TEST(CameraCalibration, ExactViewsGiveTheCameraBack) {
    const CameraModel truth = test::sampleCamera();
    const auto result = calibrateCamera(views(truth, kBoard, 12, 0.0), kBoard, 1280, 720, 5);
    ASSERT_TRUE(result) << describe(result.error());
    EXPECT_NEAR(result->camera.fx, truth.fx, 0.01);
    EXPECT_NEAR(result->camera.fy, truth.fy, 0.01);
    EXPECT_NEAR(result->camera.cx, truth.cx, 0.01);
    EXPECT_NEAR(result->camera.cy, truth.cy, 0.01);
    for (std::size_t k = 0; k < 4; ++k)
        EXPECT_NEAR(result->camera.distortion[k], truth.distortion[k], 2e-3) << k;
    EXPECT_LT(*result->camera.rms_px, 1e-3);
    EXPECT_EQ(result->camera.width, 1280);
    EXPECT_EQ(result->camera.board, "chessboard:9x6:0.025");
}

// Catches: standard deviations and residuals that are not what they are called. The estimate lies within four
// of its standard deviations; residuals are distances (noise of 0.3 px a coordinate gives 0.42), held-out
// ones no smaller.
TEST(CameraCalibration, SaysHowSureItIs) {
    const CameraModel truth = test::sampleCamera();
    const auto result = calibrateCamera(views(truth, kBoard, 15, 0.3), kBoard, 1280, 720, 5);
    ASSERT_TRUE(result);
    const CameraModel& camera = result->camera;
    ASSERT_EQ(camera.deviations.size(), 9U);
    const double errors[] = {camera.fx - truth.fx, camera.fy - truth.fy, camera.cx - truth.cx,
                             camera.cy - truth.cy};
    for (std::size_t k = 0; k < 4; ++k) {
        EXPECT_LT(std::abs(errors[k]), 4.0 * camera.deviations[k]) << k;
        EXPECT_LT(camera.deviations[k], 10.0) << k;
    }
    EXPECT_NEAR(*camera.rms_px, 0.42, 0.02);
    ASSERT_EQ(camera.views.size(), 15U);
    double sum = 0.0;
    for (const ViewResidual& view : camera.views)
        sum += view.rms_px * view.rms_px / 15.0;
    EXPECT_NEAR(std::sqrt(sum), *camera.rms_px, 1e-6);
    EXPECT_EQ(camera.views[2].name, "view 2");
    ASSERT_TRUE(result->heldOut_px);
    EXPECT_GE(*result->heldOut_px, *camera.rms_px);
    EXPECT_LT(*result->heldOut_px, 1.2 * *camera.rms_px);
    EXPECT_NEAR(*result->heldOut_m(0.5), *result->heldOut_px * 0.5 / 1001.5, 1e-5);
    EXPECT_NEAR(result->focalDeviation(), camera.deviations[0] / camera.fx, 1e-3);
}

// Catches: results worse than those published for these pictures.
TEST(CameraCalibration, AgreesWithWhatIsPublished) {
    const auto calibrated = [](const std::vector<std::string>& paths, const char* text) {
        std::vector<CalibrationView> found;
        for (const std::string& path : paths)
            found.push_back({path, *findBoard(test::greyOf(path), *parseBoard(text), path)});
        return *calibrateCamera(found, *parseBoard(text), 640, 480, 5);
    };
    const auto left = calibrated(test::chessboardViews(), "chessboard:9x6:0.025");
    EXPECT_LE(*left.camera.rms_px, 0.25);
    EXPECT_NEAR(left.camera.fx, 535.9, 0.01 * 535.9);
    EXPECT_NEAR(left.camera.fy, 535.9, 0.01 * 535.9);
    EXPECT_NEAR(left.camera.cx, 342.28, 3.0);
    EXPECT_NEAR(left.camera.cy, 235.57, 3.0);
    EXPECT_LT(*left.heldOut_px, 0.3);
    const auto charuco = calibrated(test::charucoViews(), "charuco:5x7:0.04:0.02:6X6_250");
    EXPECT_LE(*charuco.camera.rms_px, 0.25);
    EXPECT_NEAR(charuco.camera.fx, 452.51, 0.02 * 452.51);
    EXPECT_NEAR(charuco.camera.fy, 456.77, 0.02 * 456.77);
    EXPECT_FALSE(left.reasonAgainst());
    EXPECT_FALSE(charuco.reasonAgainst());
    EXPECT_FALSE(charuco.heldOut_px) << "four views are too few to hold some out";
}

TEST(CameraCalibration, TakesEightCoefficients) {
    CameraModel truth = test::sampleCamera();
    truth.distortion = {0.4, 0.1, 0.001, -0.0005, 0.02, 0.6, 0.05, 0.01};
    const auto result = calibrateCamera(views(truth, kBoard, 15, 0.0), kBoard, 1280, 720, 8);
    ASSERT_TRUE(result) << describe(result.error());
    EXPECT_EQ(result->camera.distortion.size(), 8U);
    EXPECT_EQ(result->camera.deviations.size(), 12U);
    EXPECT_NEAR(result->camera.fx, truth.fx, 1.0);
    EXPECT_LT(*result->camera.rms_px, 0.01);
}

// Catches: a camera from views that tell none, or a crash. A board that is always parallel to the picture
// does not tell the focal length: the deviation says so.
TEST(CameraCalibration, TooLittleIsSaid) {
    const CameraModel truth = test::sampleCamera();
    EXPECT_EQ(calibrateCamera({}, kBoard, 1280, 720, 5).error().code(), MessageCode::ViewsTooFew);
    EXPECT_EQ(calibrateCamera(views(truth, kBoard, 2, 0.1), kBoard, 1280, 720, 5).error().code(),
              MessageCode::ViewsTooFew);
    std::vector<CalibrationView> flat = views(truth, kBoard, 6, 0.0);
    std::mt19937 random(5);
    std::normal_distribution<double> noise(0.0, 0.2);
    for (CalibrationView& view : flat)
        for (std::size_t k = 0; k < view.board.corners.size(); ++k) {
            const Eigen::Vector2d p = cornerOf(kBoard, view.board.corners[k]);
            view.board.corners_px[k] =
                Eigen::Vector2d(300, 200) + 2000.0 * p + Eigen::Vector2d(noise(random), noise(random));
        }
    const auto parallel = calibrateCamera(flat, kBoard, 1280, 720, 5);
    if (parallel) // OpenCV 4.6 has a camera for them, 4.10 none
        EXPECT_EQ(parallel->reasonAgainst().value().code, MessageCode::ViewsStraightOn);
    else
        EXPECT_EQ(parallel.error().code(), MessageCode::CalibrationFailed);
    for (CalibrationView& view : flat)
        for (Eigen::Vector2d& p : view.board.corners_px)
            p = Eigen::Vector2d(5, 5);
    const auto nothing = calibrateCamera(flat, kBoard, 1280, 720, 5);
    EXPECT_TRUE(!nothing || nothing->reasonAgainst());
}

// Catches: a camera that is offered though it is a guess.
TEST(CameraCalibration, SaysWhyACameraIsNotToBeUsed) {
    CameraCalibration good{test::sampleCamera(), {}, 0.5, 0.5};
    good.camera.rms_px = 1.0;
    good.camera.deviations.assign(9, 2.0);
    EXPECT_FALSE(good.reasonAgainst());
    CameraCalibration parallel = good;
    parallel.turn_rad = 0.03;
    EXPECT_EQ(parallel.reasonAgainst().value().code, MessageCode::ViewsParallel);
    CameraCalibration unsure = good;
    unsure.camera.deviations[1] = 110.0; // of 1003
    EXPECT_EQ(unsure.reasonAgainst().value().code, MessageCode::CalibrationUncertain);
    CameraCalibration contradicted = good;
    contradicted.camera.rms_px = 4.0; // of 1280
    EXPECT_EQ(contradicted.reasonAgainst().value().code, MessageCode::CalibrationContradicts);
}

// Catches: progress that does not end, and a cancelled calibration that goes on or hands out half a result.
TEST(CameraCalibration, TellsItsProgressAndStopsBetweenFits) {
    const auto some = views(test::sampleCamera(), kBoard, 8, 0.2);
    std::vector<int> done;
    const auto whole = calibrateCamera(some, kBoard, 1280, 720, 5, {}, [&](int count, int of) {
        done.push_back(count);
        EXPECT_EQ(of, 6);
    });
    EXPECT_EQ(done, (std::vector<int>{1, 2, 3, 4, 5, 6}));
    ASSERT_TRUE(whole);
    std::stop_source stop;
    done.clear();
    const auto cancelled = calibrateCamera(some, kBoard, 1280, 720, 5, stop.get_token(), [&](int count, int) {
        done.push_back(count);
        if (count == 2)
            stop.request_stop();
    });
    ASSERT_FALSE(cancelled);
    EXPECT_EQ(cancelled.error().code(), MessageCode::CalibrationCancelled);
    EXPECT_EQ(done.size(), 2U);
}

// Catches: a bad view that nobody points at, and good ones that are accused.
TEST(CameraCalibration, ABadViewStandsOut) {
    auto some = views(test::sampleCamera(), kBoard, 15, 0.2);
    const auto good = calibrateCamera(some, kBoard, 1280, 720, 5);
    ASSERT_TRUE(good);
    EXPECT_TRUE(viewsStandingOut(good->camera.views).empty());
    std::mt19937 random(9);
    std::normal_distribution<double> blur(0.0, 1.5);
    for (Eigen::Vector2d& p : some[6].board.corners_px)
        p += Eigen::Vector2d(blur(random), blur(random));
    const auto bad = calibrateCamera(some, kBoard, 1280, 720, 5);
    ASSERT_TRUE(bad);
    EXPECT_EQ(viewsStandingOut(bad->camera.views), std::vector<std::size_t>{6});
    EXPECT_TRUE(viewsStandingOut({{"1", 0.1}, {"2", 0.1}, {"3", 9.0}}).empty()) << "three tell no usual";
}

// Catches: a verdict that is not in millimetres at the distance asked for, names the wrong one of two causes,
// or is better than held-out views and the focal length allow.
TEST(CameraCalibration, IsJudgedAtADistance) {
    CameraCalibration result;
    result.camera = test::sampleCamera();
    result.camera.rms_px = 0.3;
    result.camera.deviations = {0.5, 0.5, 0.5, 0.5, 0, 0, 0, 0, 0};
    result.camera.views.resize(20);
    result.tilt_rad = result.turn_rad = 0.6;
    result.heldOut_px = 0.3;
    EXPECT_EQ(judged(result, 0.6).verdict, Verdict::Good);
    EXPECT_EQ(judged(result, 0.6).reason, (Message{MessageCode::CameraGood, {"0.18", "0.6", "0.6"}}));
    EXPECT_EQ(judged(result, 2.5).verdict, Verdict::Usable) << "2.5 mm along the line of sight";
    EXPECT_EQ(judged(result, 2.5).reason.code, MessageCode::CameraFocalUncertain);
    EXPECT_EQ(judged(result, 7.0).verdict, Verdict::Redo);
    result.camera.views[3].rms_px = 2.0;
    EXPECT_EQ(judged(result, 2.5).reason.code, MessageCode::CameraMisfits) << "a view stands out";
    result.heldOut_px = 3.0;
    EXPECT_EQ(judged(result, 0.6).verdict, Verdict::Usable);
    EXPECT_EQ(judged(result, 0.6).reason.code, MessageCode::CameraMisfits);
    result.heldOut_px.reset();
    EXPECT_EQ(judged(result, 0.6).verdict, Verdict::Redo);
    EXPECT_EQ(judged(result, 0.6).reason, (Message{MessageCode::CameraUnchecked, {"20", "5"}}));
    result.heldOut_px = 0.3;
    result.tilt_rad = 0.1;
    EXPECT_EQ(judged(result, 0.6).verdict, Verdict::Redo);
    EXPECT_EQ(judged(result, 0.6).reason.code, MessageCode::ViewsStraightOn);
}

} // namespace
} // namespace bask
