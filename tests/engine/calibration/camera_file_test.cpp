// Cameras as files: those of other tools, the round trip, and what is damaged or hostile.

#include "engine/calibration/camera_file.h"

#include "engine/base/message_code.h"
#include "tests/engine/calibration/calibration_samples.h"

#include <opencv2/core/persistence.hpp>

namespace bask {
namespace {

CameraModel calibrated(std::size_t coefficients) {
    CameraModel camera = test::sampleCamera();
    camera.distortion.resize(coefficients, 1.0 / 3.0);
    camera.rms_px = 0.1;
    camera.deviations.assign(4 + coefficients, 2e-17);
    camera.views = {{"a \"b\".png", 0.25}, {"folder/c, d [e].png", 1.0}};
    camera.board = "chessboard:9x6:0.025";
    return camera;
}

// Catches: files of other tools that are not read. The numbers are those that stand in the files.
TEST(CameraFile, ReadsThoseOfOtherTools) {
    const auto left = readCamera(test::viewPath("left_intrinsics.yml"));
    ASSERT_TRUE(left) << describe(left.error());
    EXPECT_EQ(left->width, 640);
    EXPECT_EQ(left->height, 480);
    EXPECT_DOUBLE_EQ(left->fx, 535.91573396163199);
    EXPECT_DOUBLE_EQ(left->cy, 235.57082909788173);
    ASSERT_EQ(left->distortion.size(), 5U);
    EXPECT_DOUBLE_EQ(left->distortion[4], 0.23839153080878486);
    EXPECT_DOUBLE_EQ(left->rms_px.value(), 0.39259098975581364);
    const auto params = readCamera(test::markersPath("tutorial_camera_params.yml"));
    ASSERT_TRUE(params) << describe(params.error());
    EXPECT_EQ(params->width, 0) << "the file says none";
    EXPECT_DOUBLE_EQ(params->fy, 628.156);
    EXPECT_DOUBLE_EQ(params->distortion[3], 0.00336531);
    for (const char* name : {"tutorial_camera_charuco.yml", "screen_board_camera.yml"})
        EXPECT_TRUE(readCamera(test::markersPath(name))) << name;
}

// Catches: a ROS file that only camera_info_manager's own writer would pass; PyYAML's lists stand in lines of
// their own.
TEST(CameraFile, ReadsRos) {
    const auto camera =
        cameraFromYaml("# a comment\r\nimage_width: 640\r\nimage_height: 480\r\n"
                       "camera_name: 'narrow # stereo'\r\ncamera_matrix:\r\n  rows: 3\r\n  cols: 3\r\n"
                       "  data:\r\n  - 500.5\r\n  - 0\r\n  - 320\r\n  - 0\r\n  - +501\r\n  - 240.0\r\n"
                       "  - 0\r\n  - 0\r\n  - 1\r\ndistortion_model: plumb_bob\r\n"
                       "distortion_coefficients:\r\n  rows: 1\r\n  cols: 5\r\n"
                       "  data: [-0.1, 2e-2, 0, 0,\r\n    .5]\r\n",
                       "ros");
    ASSERT_TRUE(camera) << describe(camera.error());
    EXPECT_EQ(camera->width, 640);
    EXPECT_EQ(camera->fx, 500.5);
    EXPECT_EQ(camera->fy, 501.0);
    EXPECT_EQ(camera->distortion, (std::vector<double>{-0.1, 0.02, 0, 0, 0.5}));
}

// Catches: a digit lost on the way, in either kind of file.
TEST(CameraFile, ComesBackAsItWasWritten) {
    for (const std::size_t coefficients : {5U, 8U}) {
        const CameraModel camera = calibrated(coefficients);
        for (const std::string& text : {openCvYaml(camera), rosYaml(camera, "bask")}) {
            const auto back = cameraFromYaml(text, "");
            ASSERT_TRUE(back) << describe(back.error()) << text;
            EXPECT_EQ(back->fx, camera.fx);
            EXPECT_EQ(back->cy, camera.cy);
            EXPECT_EQ(back->width, camera.width);
            EXPECT_EQ(back->distortion, camera.distortion);
        }
        const auto back = cameraFromYaml(openCvYaml(camera), "");
        EXPECT_EQ(back->rms_px, camera.rms_px);
        EXPECT_EQ(back->deviations, camera.deviations);
        EXPECT_EQ(back->board, camera.board);
        ASSERT_EQ(back->views.size(), 2U);
        EXPECT_EQ(back->views[0].name, "a b.png") << "quotes are left out";
        EXPECT_EQ(back->views[1].name, camera.views[1].name);
        EXPECT_EQ(back->views[1].rms_px, 1.0);
    }
}

// Catches: an empty matrix, which neither Bask nor ROS reads, of a lens without distortion
// (usualThermalLens).
TEST(CameraFile, ALensWithoutDistortionComesBackWithCoefficientsOfZero) {
    CameraModel camera = calibrated(5);
    camera.distortion.clear();
    camera.deviations.clear();
    for (const std::string& text : {openCvYaml(camera), rosYaml(camera, "bask")}) {
        const auto back = cameraFromYaml(text, "");
        ASSERT_TRUE(back) << describe(back.error()) << text;
        EXPECT_EQ(back->fx, camera.fx);
        EXPECT_EQ(back->distortion, std::vector<double>(5, 0.0));
    }
}

// Catches: YAML that OpenCV itself does not read.
TEST(CameraFile, IsReadByOpenCv) {
    const CameraModel camera = calibrated(8);
    const cv::FileStorage file(openCvYaml(camera), cv::FileStorage::READ | cv::FileStorage::MEMORY);
    cv::Mat matrix, distortion, deviations;
    file["camera_matrix"] >> matrix;
    file["distortion_coefficients"] >> distortion;
    file["standard_deviations"] >> deviations;
    EXPECT_EQ(file.getFirstTopLevelNode().name(), "camera_matrix");
    ASSERT_EQ(matrix.size(), cv::Size(3, 3));
    EXPECT_EQ(matrix.at<double>(1, 1), camera.fy);
    ASSERT_EQ(distortion.total(), 8U);
    EXPECT_EQ(distortion.at<double>(7), camera.distortion[7]);
    EXPECT_EQ(deviations.total(), 12U);
    EXPECT_EQ(static_cast<double>(file["rms"]), 0.1);
    EXPECT_EQ(static_cast<int>(file["image_width"]), 1280);
    EXPECT_EQ(static_cast<double>(file["per_view_reprojection_errors"][1]), 1.0);
    EXPECT_EQ(static_cast<std::string>(file["views"][1]), camera.views[1].name);
}

// Catches: a camera that is none, taken or refused without its reason.
TEST(CameraFile, RefusesInWords) {
    const std::string good = openCvYaml(test::sampleCamera());
    const auto with = [&](const std::string& from, const std::string& to) {
        std::string text = good;
        const auto at = text.find(from);
        EXPECT_NE(at, std::string::npos) << from;
        return text.replace(at, from.size(), to);
    };
    const std::pair<std::string, MessageCode> cases[] = {
        {"", MessageCode::JsonMissingKey},
        {"\xEF\xBB\xBF{[}", MessageCode::JsonMissingKey},
        {with("camera_matrix", "matrix"), MessageCode::JsonMissingKey},
        {with("distortion_coefficients", "distortion"), MessageCode::JsonMissingKey},
        {with("data: [ 1000", "data: [ .Nan"), MessageCode::NumbersUnusable},
        {with("data: [ 1000", "data: [ 1e999"), MessageCode::NumbersUnusable},
        {with("data: [ 1000", "data: [ 1,000"), MessageCode::CameraMatrixUnusable},
        {with("data: [ 1000", "data: [ -1000"), MessageCode::CameraMatrixUnusable},
        {with("data: [ 1000", "data: [ 0"), MessageCode::CameraMatrixUnusable},
        {with("-0.21", "-0.21, 1, 1"), MessageCode::DistortionUnusable},
        {with("image_width: 1280", "image_width: 0"), MessageCode::ValueOutOfRange},
        {with("image_width: 1280", "image_width: 4000000000"), MessageCode::ValueOutOfRange},
        {with("image_width: 1280", "image_width: 12.5"), MessageCode::NumbersUnusable},
        {good + "distortion_model: equidistant\n", MessageCode::ValueUnknown},
        {test::textOf(test::viewPath("intrinsics.yml")),
         MessageCode::JsonMissingKey}, // two cameras, M1 and M2
    };
    ASSERT_TRUE(cameraFromYaml(good, ""));
    for (const auto& [text, code] : cases) {
        const auto camera = cameraFromYaml(text, "x.yml");
        ASSERT_FALSE(camera) << text;
        EXPECT_EQ(camera.error().code(), code) << describe(camera.error());
        EXPECT_EQ(camera.error().where, "x.yml");
    }
    EXPECT_EQ(readCamera("/nowhere/c.yml").error().code(), MessageCode::FileNotFound);
}

// Catches: a file that crashes, hangs or fills the memory: cut anywhere, deep, endless, binary.
TEST(CameraFile, HostileTextIsHarmless) {
    const std::string good = openCvYaml(calibrated(5));
    for (std::size_t length = 0; length < good.size(); ++length)
        (void)cameraFromYaml(good.substr(0, length), "");
    std::string deep, binary;
    for (int k = 0; k < 2000; ++k)
        deep += std::string(static_cast<std::size_t>(k), ' ') + "a:\n";
    std::mt19937 random(7);
    for (int k = 0; k < 100'000; ++k)
        binary += static_cast<char>(random() % 256);
    for (const std::string& text :
         {deep, binary, std::string(1 << 20, '['), std::string(1 << 20, '\n'), std::string(1 << 20, '"'),
          "camera_matrix:\n" + std::string(1 << 20, ' ') + "- 1\n",
          std::string(
              "camera_matrix: !!opencv-matrix\n  rows: 2000000000\n  cols: 2000000000\n  data: [ 1 ]\n")})
        EXPECT_FALSE(cameraFromYaml(text, ""));
}

} // namespace
} // namespace bask
