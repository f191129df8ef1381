// `bask thermal-pose`: its figures and exit codes, on frames of the simulated camera.

#include "app/commands/command_line.h"
#include "engine/calibration/camera_file.h"
#include "engine/experiment/experiment_file.h"
#include "engine/rig/rig_setup.h"
#include "engine/simulation/simulated_thermal_camera.h"
#include "tests/support/captured_command.h"

#include <QFile>
#include <QTemporaryDir>

#include <nlohmann/json.hpp>

#include <fstream>
#include <numbers>

namespace bask {
namespace {

using Json = nlohmann::json;
using test::Captured;

/// Frames of the three-object example at five poses of the robot, with the files that the command reads.
class ThermalPoseCommand : public ::testing::Test {
protected:
    void SetUp() override {
        const auto experiment = readExperiment(example());
        ASSERT_TRUE(experiment);
        SimulatedThermalCameraConfig config = *simulatedRigConfig(*experiment).thermalCamera;
        profile = config.profile.name;
        trueCameraPose = config.X_RC;
        SimulatedThermalCamera camera(config);
        write("camera.yml", openCvYaml(config.camera));
        Json list{{"camera_pose", {{"z_cm", 112.0}, {"theta_x_deg", 178.0}, {"x_cm", 2.0}}}};
        for (int k = 0; k < 5; ++k) {
            const int column = k % 2, row = k / 2;
            const double x_cm = 4.0 * column, y_cm = 3.0 * row - 3.0, z_cm = 10.0 + 5.0 * k,
                         turn_deg = 4.0 * k;
            ThermalMoment moment;
            moment.X_RE = poseFromCoordinates(
                {0.01 * x_cm, 0.01 * y_cm, 0.01 * z_cm, 0.0, turn_deg * std::numbers::pi / 180.0, 0.0});
            moment.source_K.assign(config.source.size(), 400.0);
            moment.objects.assign(config.objects.size(),
                                  {318.15, {0.9, {}, config.environment_K}, {0.9, {}, config.environment_K}});
            for (const double time_s : {1.0, 2.0}) {
                moment.time_s = 2.0 * k + time_s;
                camera.observe(moment);
            }
            const std::string name = "frame" + std::to_string(k) + ".raw";
            write(name, bytesOfFrame(camera.newest().value()->frame.picture, config.profile));
            list["frames"].push_back(
                {{"file", name},
                 {"pose", {{"x_cm", x_cm}, {"y_cm", y_cm}, {"z_cm", z_cm}, {"theta_y_deg", turn_deg}}}});
        }
        write("frames.json", list.dump());
    }

    static std::string example() { return BASK_EXAMPLES "/thermal-camera.json"; }
    QString path(const char* name) const { return folder.filePath(name); }
    void write(const std::string& name, const std::string& bytes) const {
        std::ofstream(folder.filePath(QString::fromStdString(name)).toStdString(), std::ios::binary) << bytes;
    }
    Captured run(const QString& list) const {
        return test::captured(thermalPoseCommand,
                              {QString::fromStdString(example()), list, "--camera", path("camera.yml"),
                               "--profile", QString::fromStdString(profile), "--json"});
    }

    QTemporaryDir folder;
    std::string profile;
    Pose trueCameraPose = Pose::Identity();
};

} // namespace

TEST_F(ThermalPoseCommand, tellsThePoseAsJson) {
    const Captured done = run(path("frames.json"));
    ASSERT_EQ(done.code, kExitDone) << done.err;
    const Json told = Json::parse(done.out);
    EXPECT_EQ(told["verdict"], "good");
    EXPECT_LT(told["verdict_mm"].get<double>(), 1.0);
    EXPECT_LT(told["rms_px"].get<double>(), 0.05);
    EXPECT_EQ(told["covariance"].size(), 6U);
    EXPECT_EQ(told["points"].size(), 5U);
    EXPECT_NEAR(told["camera_pose"]["x_cm"].get<double>(), 100.0 * trueCameraPose.translation().x(), 0.1);
    EXPECT_NEAR(told["camera_pose"]["z_cm"].get<double>(), 100.0 * trueCameraPose.translation().z(), 0.1);
}

TEST_F(ThermalPoseCommand, refusesAListThatDoesNotFit) {
    write("list.json", R"({"camera_pose": {}, "frames": [{"file": "frame0.raw"}]})");
    EXPECT_EQ(run(path("list.json")).code, kExitBadInput);
    write("list.json", R"({"camera_pose": {}, "frames": [{"file": "none.raw", "pose": {}}]})");
    EXPECT_EQ(run(path("list.json")).code, kExitBadInput);
    EXPECT_EQ(run(path("missing.json")).code, kExitBadInput);
}

TEST_F(ThermalPoseCommand, hasNoPoseOfOneFrame) {
    write("list.json", R"({"camera_pose": {"z_cm": 112, "theta_x_deg": 178}, "frames": [
        {"file": "frame0.raw", "pose": {"y_cm": -3, "z_cm": 10}}]})");
    const Captured done = run(path("list.json"));
    EXPECT_EQ(done.code, kExitNegative) << done.err;
    EXPECT_TRUE(done.out.empty());
}

} // namespace bask
