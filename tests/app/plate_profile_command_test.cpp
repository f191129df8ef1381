// `bask plate-profile`: from frames of the simulated camera to a file that an experiment reads.

#include "app/commands/command_line.h"
#include "engine/base/units.h"
#include "engine/calibration/camera_file.h"
#include "engine/experiment/experiment_file.h"
#include "engine/rig/rig_setup.h"
#include "engine/simulation/simulated_camera.h"
#include "engine/simulation/simulated_thermal_camera.h"
#include "engine/thermography/usual_thermal_camera.h"
#include "tests/support/captured_command.h"

#include <QFile>
#include <QTemporaryDir>

#include <nlohmann/json.hpp>

#include <cmath>
#include <fstream>

namespace bask {
namespace {

using Json = nlohmann::json;
using test::Captured;

constexpr double kAround_K = 298.15, kMiddle_K = 473.15, kPlate_m = 0.1;
constexpr int kSteps = 10;

/// Colder towards its rim, in steps, by 20 K.
double plateAt_K(double r_m) {
    const double step = (std::floor(kSteps * r_m / kPlate_m) + 0.5) / kSteps;
    return kMiddle_K - 20.0 * step * step;
}

/// Three frames of a black plate of disks on one another, and the files that the command reads.
class PlateProfileCommand : public ::testing::Test {
protected:
    void SetUp() override {
        auto read = readExperiment(BASK_EXAMPLES "/thermal-camera.json");
        ASSERT_TRUE(read);
        experiment = *read;
        experiment.source.emittance = 0.9;
        write("experiment.json", experimentToJson(experiment));

        SimulatedThermalCameraConfig config;
        config.profile = findThermalProfile("p2-pro").value();
        config.camera = usualThermalLens(config.profile);
        const Pose X_RS = poseFromCoordinates(experiment.source.pose);
        config.X_RC = X_RS * lookingAt({0.1, 0.05, 0.5}, {0.0, 0.0, 0.0});
        config.environment_K = kAround_K;
        ThermalMoment moment;
        for (int k = kSteps; k > 0; --k) {
            constexpr double kHigher_m = 2.5e-4; // so that the painter knows their order
            const double r_m = kPlate_m * k / kSteps;
            Pose X_SP = Pose::Identity();
            X_SP.translation().z() = kHigher_m * (kSteps - k);
            config.source.push_back({Disk{r_m}, X_RS * X_SP, experiment.source.emittance});
            moment.source_K.push_back(plateAt_K(r_m - 1e-4));
        }
        SimulatedThermalCamera camera(config);
        for (int k = 0; k < 3; ++k) {
            for (const double time_s : {1.0, 2.0}) {
                moment.time_s = 2.0 * k + time_s;
                camera.observe(moment);
            }
            write("frame" + std::to_string(k) + ".raw",
                  bytesOfFrame(camera.newest().value()->frame.picture, config.profile));
        }
        write("camera.yml", openCvYaml(config.camera));
        Json pose{{"verdict", "good"}}; // as `bask thermal-pose --json` has other keys, too
        const Vector6d q = coordinatesFromPose(config.X_RC);
        for (int k = 0; k < 3; ++k) {
            pose["camera_pose"][std::string(1, "xyz"[k]) + "_cm"] = 100.0 * q[k];
            pose["camera_pose"][std::string("theta_") + "xyz"[k] + "_deg"] = degFromRad(q[3 + k]);
        }
        write("pose.json", pose.dump());
    }

    QString path(const char* name) const { return folder.filePath(name); }
    void write(const std::string& name, const std::string& bytes) const {
        std::ofstream(folder.filePath(QString::fromStdString(name)).toStdString(), std::ios::binary) << bytes;
    }
    Captured run(const QStringList& more = {}, const char* experimentName = "experiment.json") const {
        return test::captured(plateProfileCommand,
                              QStringList{path(experimentName), path("frame0.raw"), path("frame1.raw"),
                                          path("frame2.raw"), "--camera", path("camera.yml"), "--pose",
                                          path("pose.json"), "--profile", "p2-pro"} +
                                  more);
    }

    QTemporaryDir folder;
    Experiment experiment;
};

} // namespace

// Catches: a file that the experiment does not read back, and ratios that are not those of the plate.
TEST_F(PlateProfileCommand, MeasuresAProfileThatTheExperimentReads) {
    const Captured done = run({"--json", "-o", path("plate.csv")});
    ASSERT_EQ(done.code, kExitDone) << done.err;
    const Json told = Json::parse(done.out);
    Json changed = Json::parse(experimentToJson(experiment));
    changed["source"]["profile_file"] = "plate.csv";
    write("measured.json", changed.dump());
    const auto read = readExperiment(path("measured.json").toStdString());
    ASSERT_TRUE(read) << describe(read.error());
    const std::vector<ProfilePoint>& points = read->source.uneven.profile;
    ASSERT_EQ(points.size(), told["rings"].size());
    ASSERT_GE(points.size(), 15U);
    double first_K = 0.0;
    for (std::size_t k = 0; k < points.size(); ++k) {
        const Json& ring = told["rings"][k];
        EXPECT_NEAR(points[k].radius_m, 1e-3 * ring["radius_mm"].get<double>(), 1e-6);
        EXPECT_NEAR(points[k].temperatureRatio, ring["temperature_ratio"].get<double>(), 1e-6);
        const double T_K = kAround_K + points[k].temperatureRatio * (kMiddle_K - kAround_K);
        const double off_K = T_K - plateAt_K(points[k].radius_m);
        EXPECT_LT(std::abs(off_K), 3.0 * ring["standard_uncertainty_K"].get<double>()) << k;
        first_K = k == 0 ? off_K : first_K;
        EXPECT_LT(std::abs(off_K - first_K), 1.0) << k << ": gain and offset are the same for all rings";
    }
}

// Catches a simulated rig whose picture is that of an even plate: from its own uneven source, over its
// picture, to a profile that is as uneven.
TEST_F(PlateProfileCommand, MeasuresTheUnevenSourceOfTheSimulatedRig) {
    const std::vector<ProfilePoint> truth{
        {0.0, 1.0, 0.0}, {0.04, 1.02, 0.0}, {0.07, 0.95, 0.0}, {0.1, 0.8, 0.0}};
    Experiment rigged = experiment;
    rigged.simulation.sourceUneven.emplace().profile = truth;
    rigged.start = Vector6d{{0.2, 0.2, 0.3, 0.0, 0.0, 0.0}}; // out of the view
    const Pose X_RC = lookingAt({-0.1, -0.05, 0.5}, {0.0, 0.0, 0.0});
    rigged.simulation.thermalCamera->pose = coordinatesFromPose(X_RC);
    SimulatedRig rig(simulatedRigConfig(rigged));
    for (int frame = 0; frame < 3; ++frame) {
        for (int k = 0; k < 120; ++k) {
            ASSERT_TRUE(rig.heatSource().keepHeating(kMiddle_K, 10.0));
            rig.advance(0.5);
        }
        write("frame" + std::to_string(frame) + ".raw",
              bytesOfFrame(rig.thermalCamera()->newest().value()->frame.picture,
                           rig.thermalCamera()->profile()));
    }
    const double own_K = rig.heatSource().read()->value_K;
    Json pose;
    const Vector6d q = coordinatesFromPose(X_RC);
    for (int k = 0; k < 3; ++k) {
        pose["camera_pose"][std::string(1, "xyz"[k]) + "_cm"] = 100.0 * q[k];
        pose["camera_pose"][std::string("theta_") + "xyz"[k] + "_deg"] = degFromRad(q[3 + k]);
    }
    write("pose.json", pose.dump());
    const Captured done =
        run({"--json", "-o", path("plate.csv"), "--temperature", QString::number(celsiusFromKelvin(own_K))});
    ASSERT_EQ(done.code, kExitDone) << done.err;
    const Json told = Json::parse(done.out);
    ASSERT_GE(told["rings"].size(), 15U);
    double low = 2.0, high = 0.0;
    for (const Json& ring : told["rings"]) {
        const double r_m = 1e-3 * ring["radius_mm"].get<double>();
        std::size_t k = 0;
        while (k + 2 < truth.size() && truth[k + 1].radius_m < r_m)
            ++k;
        const double ratio =
            std::lerp(truth[k].temperatureRatio, truth[k + 1].temperatureRatio,
                      (r_m - truth[k].radius_m) / (truth[k + 1].radius_m - truth[k].radius_m));
        const double told_K = ring["temperature_degC"].get<double>();
        EXPECT_NEAR(told_K, celsiusFromKelvin(kAround_K + ratio * (own_K - kAround_K)),
                    3.0 * ring["standard_uncertainty_K"].get<double>())
            << r_m;
        low = std::min(low, ring["temperature_ratio"].get<double>());
        high = std::max(high, ring["temperature_ratio"].get<double>());
    }
    EXPECT_GT(high - low, 0.15);
    Json changed = Json::parse(experimentToJson(experiment));
    changed["source"]["profile_file"] = "plate.csv";
    write("measured.json", changed.dump());
    EXPECT_TRUE(readExperiment(path("measured.json").toStdString()));
}

TEST_F(PlateProfileCommand, TellsTheRingsInWords) {
    const Captured done = run({"--temperature", "190"});
    ASSERT_EQ(done.code, kExitDone) << done.err;
    EXPECT_NE(done.out.find(" mm: "), std::string::npos) << done.out;
    EXPECT_NE(done.out.find(", ratio 1.0"), std::string::npos) << "hotter than its sensor: " << done.out;
}

// Catches: temperatures of a bare metal plate that pass for measured ones.
TEST_F(PlateProfileCommand, HasNoProfileOfBareMetal) {
    experiment.source.emittance = 0.25;
    write("bare.json", experimentToJson(experiment));
    const Captured done = run({"-o", path("plate.csv")}, "bare.json");
    EXPECT_EQ(done.code, kExitNegative);
    EXPECT_NE(done.err.find("paint the face black"), std::string::npos) << done.err;
    EXPECT_FALSE(QFile::exists(path("plate.csv")));
}

TEST_F(PlateProfileCommand, HasNoProfileOfAPlateThatIsNotSeen) {
    write("pose.json", R"({"camera_pose": {"z_cm": 50}})"); // it looks up
    EXPECT_EQ(run().code, kExitNegative);
}

TEST_F(PlateProfileCommand, RefusesInputThatDoesNotFit) {
    EXPECT_EQ(run({"--temperature", "20"}).code, kExitBadInput);
    EXPECT_EQ(run({"--temperature", "hot"}).code, kExitBadInput);
    EXPECT_EQ(run({}, "missing.json").code, kExitBadInput);
    EXPECT_EQ(test::captured(plateProfileCommand, {path("experiment.json"), path("frame0.raw")}).code,
              kExitBadInput);
    write("mine.csv", "a,b\n1,2\n");
    EXPECT_EQ(run({"-o", path("mine.csv")}).code, kExitBadInput);
    EXPECT_EQ(run({"-o", path("camera.yml")}).code, kExitBadInput);
    CameraModel lens = readCamera(path("camera.yml").toStdString()).value();
    const std::string lensFile = openCvYaml(lens);
    lens.width = 160;
    write("camera.yml", openCvYaml(lens));
    EXPECT_EQ(run().code, kExitBadInput);
    write("camera.yml", lensFile);
    experiment.source.uneven.parts.emplace_back().shape = Disk{0.05};
    write("parts.json", experimentToJson(experiment));
    const Captured parts = run({}, "parts.json");
    EXPECT_EQ(parts.code, kExitBadInput);
    EXPECT_NE(parts.err.find("one disk"), std::string::npos) << parts.err;
    write("pose.json", "{}");
    const Captured poseless = run();
    EXPECT_EQ(poseless.code, kExitBadInput);
    EXPECT_NE(poseless.err.find("camera_pose"), std::string::npos) << poseless.err;
}

} // namespace bask
