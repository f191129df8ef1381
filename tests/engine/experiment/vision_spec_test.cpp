// Markers and calibrations in an experiment's file: they survive it, and what cannot be is refused where it
// stands.

#include "engine/base/message_code.h"
#include "engine/experiment/experiment_file.h"
#include "engine/model/experiment.h"

#include <gtest/gtest.h>

#include <cmath>

namespace bask {
namespace {

const std::string kVisionExamples = BASK_EXAMPLES;

Experiment calibrated() {
    Experiment e = readExperiment(kVisionExamples + "/two-circles.json").value();
    e.vision = VisionSpec();
    e.vision.dictionary = "5X5_100";
    e.vision.markers = {{Part::Source, 3, 0.05, {0.13, 0.13, 0.0, 0.0, 0.0, 0.1}},
                        {Part::EndEffector, 10, 0.04123456789, {0.0, 0.0, 0.02, 0.0, 0.0, 0.0}},
                        {Part::Base, 20, 0.06, Vector6d::Zero()}};
    CameraModel& camera = e.vision.camera.emplace();
    camera.width = 1280;
    camera.height = 720;
    camera.fx = 1001.23456789;
    camera.fy = 999.5;
    camera.cx = 640.25;
    camera.cy = 359.0;
    camera.distortion = {-0.1, 0.05, 1e-4, -2e-4, 0.0};
    camera.rms_px = 0.21;
    camera.deviations = {0.5, 0.5, 0.7, 0.6, 0.01, 0.02, 1e-4, 1e-4, 0.1};
    camera.board = "charuco:5x7:0.04:0.02:6X6_250";
    e.vision.cameraDate = "2026-11-21T10:00:00Z";
    e.vision.cameraPose = Vector6d{0.0, -0.5, 0.6, -2.3, 0.01, 0.02};
    e.vision.cameraPoseDate = "2026-11-21T11:00:00Z";
    e.vision.sourcePoseDate = "2026-11-21T11:00:01Z";
    return e;
}

Experiment readBack(const Experiment& e) {
    const auto read = experimentFromJson(experimentToJson(e), "text", {});
    EXPECT_TRUE(read) << (read ? "" : describe(read.error()));
    return read ? *read : Experiment();
}

// Catches a field that is written and not read, read and not written, or rounded.
TEST(VisionSpec, SurvivesItsFile) {
    Experiment e = calibrated();
    EXPECT_EQ(readBack(e), e);
    e.simulation.sourcePose = Vector6d{0.001, 0.002, 0.0, 0.0, 0.0, 0.01};
    e.simulation.camera.model = e.vision.camera;
    e.simulation.camera.model->rms_px.reset();
    e.simulation.camera.model->deviations.clear();
    e.simulation.camera.model->board.clear();
    e.simulation.camera.pose = Vector6d{0.1, -0.4, 0.5, -2.2, 0.0, 0.0};
    e.simulation.camera.noise_grey = 3.5;
    e.simulation.camera.blur_px = 0.0;
    e.simulation.camera.lightFall = 0.5;
    e.simulation.camera.rate_Hz = 15.0;
    e.simulation.camera.delay_s = 0.05;
    EXPECT_EQ(readBack(e), e);
    SimulatedThermalCameraSpec& thermal = e.simulation.thermalCamera.emplace();
    thermal.pose = Vector6d{0.1, -0.2, 1.2, 3.1, 0.0, 0.0};
    EXPECT_EQ(readBack(e), e);
    thermal.calibration.pose = Vector6d{0.11, -0.2, 1.2, 3.1, 0.0, 0.01};
    thermal.calibration.poseDate = "2026-11-20T22:45:00Z";
    thermal.calibration.poseUncertainty_m = 0.000123456789;
    thermal.calibration.lens = CameraModel{256, 192, 235.0, 236.0, 127.5, 95.5, {}, {}, {}, {}, {}};
    thermal.calibration.lensDate = "2026-11-19T22:45:00Z";
    EXPECT_EQ(readBack(e), e);
}

TEST(VisionSpec, IsLeftOutOfFilesOfRigsWithoutOne) {
    Experiment e = calibrated();
    e.vision = VisionSpec();
    EXPECT_EQ(experimentToJson(e).find("vision"), std::string::npos);
    EXPECT_EQ(readBack(e), e);
}

struct Refusal {
    const char* what;
    void (*spoil)(Experiment&);
    MessageCode code;
    const char* where;
};

// Catches what would make the tracker or the simulated camera throw later on.
TEST(VisionSpec, ThatCannotBeIsRefusedWhereItStands) {
    using E = Experiment&;
    const Refusal refusals[] = {
        {"dictionary", [](E e) { e.vision.dictionary = "9X9_1"; }, MessageCode::ValueUnknown,
         "vision.dictionary"},
        {"id twice", [](E e) { e.vision.markers[1].id = 3; }, MessageCode::MarkerListedTwice,
         "vision.markers[1].id"},
        {"id beyond", [](E e) { e.vision.markers[0].id = 100; }, MessageCode::ValueOutOfRange,
         "vision.markers[0].id"},
        {"no side", [](E e) { e.vision.markers[2].side_m = 0.0; }, MessageCode::ValueOutOfRange,
         "vision.markers[2].side_mm"},
        {"pose", [](E e) { e.vision.markers[2].pose[0] = NAN; }, MessageCode::ValueOutOfRange,
         "vision.markers[2].pose.x_cm"},
        {"focal length", [](E e) { e.vision.camera->fx = -1.0; }, MessageCode::ValueNotPositive,
         "vision.camera.fx_px"},
        {"width", [](E e) { e.vision.camera->width = 100'000; }, MessageCode::ValueOutOfRange,
         "vision.camera.width_px"},
        {"three coefficients", [](E e) { e.vision.camera->distortion.resize(3); },
         MessageCode::DistortionUnusable, "vision.camera.distortion"},
        {"camera's place", [](E e) { (*e.vision.cameraPose)[2] = 99.0; }, MessageCode::ValueOutOfRange,
         "vision.camera_pose.z_cm"},
        {"true camera", [](E e) { e.simulation.camera.model.emplace(); }, MessageCode::ValueOutOfRange,
         "simulation.camera.model.width_px"},
        // a gigabyte and a minute for each picture
        {"true camera too large",
         [](E e) {
             e.simulation.camera.model = e.vision.camera;
             e.simulation.camera.model->width = 16384;
         },
         MessageCode::ValueOutOfRange, "simulation.camera.model.width_px"},
        {"rate", [](E e) { e.simulation.camera.rate_Hz = 0.0; }, MessageCode::ValueOutOfRange,
         "simulation.camera.rate_Hz"},
        {"followed by a camera that is not calibrated",
         [](E e) {
             e.source.tracked = true;
             e.vision.cameraPose.reset();
         },
         MessageCode::SourceNotFollowed, "source.tracked"},
    };
    for (const Refusal& refusal : refusals) {
        Experiment e = calibrated();
        ASSERT_TRUE(validate(e));
        refusal.spoil(e);
        const auto valid = validate(e);
        ASSERT_FALSE(valid) << refusal.what;
        EXPECT_EQ(valid.error().code(), refusal.code) << describe(valid.error());
        EXPECT_EQ(valid.error().where, refusal.where) << refusal.what;
    }
}

TEST(VisionSpec, WithUnknownKeysOrWordsIsRefused) {
    const std::string text = experimentToJson(calibrated());
    const auto with = [&](const std::string& from, const std::string& to) {
        std::string changed = text;
        const std::size_t at = changed.find(from);
        EXPECT_NE(at, std::string::npos) << from;
        return experimentFromJson(changed.replace(at, from.size(), to), "text", {});
    };
    const auto part = with("\"end_effector\"", "\"hand\"");
    ASSERT_FALSE(part);
    EXPECT_EQ(part.error().code(), MessageCode::ValueUnknown);
    EXPECT_EQ(part.error().where, "text: vision.markers[1].part");
    const auto key = with("\"camera_pose_date\"", "\"camera_pose_day\"");
    ASSERT_FALSE(key);
    EXPECT_EQ(key.error().code(), MessageCode::JsonUnknownKey);
    const auto number = with("\"rms_px\": 0.21", "\"rms_px\": \"good\"");
    ASSERT_FALSE(number);
    EXPECT_EQ(number.error().where, "text: vision.camera.rms_px");
}

// Catches a source that is said to be followed by a camera that does not know where it stands.
TEST(VisionSpec, FollowsTheSourceWithMarkersCameraAndPlaceOnly) {
    EXPECT_TRUE(calibrated().vision.followsSource());
    VisionSpec vision = calibrated().vision;
    vision.markers.erase(vision.markers.begin());
    EXPECT_FALSE(vision.followsSource());
    vision = calibrated().vision;
    vision.camera.reset();
    EXPECT_FALSE(vision.followsSource());
}

} // namespace
} // namespace bask
