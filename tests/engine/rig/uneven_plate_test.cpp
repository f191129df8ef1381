// The plate of an uneven experiment on the simulated rig, measured in its picture.

#include "engine/base/units.h"
#include "engine/experiment/experiment_file.h"
#include "engine/rig/rig_setup.h"
#include "engine/thermography/plate_profile.h"

#include <gtest/gtest.h>

#include <cmath>

namespace bask {
namespace {

/// A plate that is black and colder towards its rim, with the objects out of the way.
Experiment unevenPlate(std::uint64_t seed) {
    Experiment experiment = readExperiment(BASK_EXAMPLES "/thermal-camera.json").value();
    experiment.source.emittance = 0.9;
    experiment.simulation.seed = seed;
    experiment.simulation.sourceUneven.emplace().profile = {
        {0.0, 1.0, 0.0}, {0.04, 1.02, 0.0}, {0.07, 0.95, 0.0}, {0.1, 0.8, -3.0}};
    experiment.start = Vector6d{{0.2, 0.2, 0.3, 0.0, 0.0, 0.0}};
    experiment.simulation.thermalCamera->pose =
        coordinatesFromPose(lookingAt({-0.1, -0.05, 0.5}, {0.0, 0.0, 0.0}));
    return experiment;
}

double trueAt_K(const Experiment& experiment, double r_m, double source_K) {
    const auto& profile = experiment.simulation.sourceUneven->profile;
    for (std::size_t k = 0; k + 1 < profile.size(); ++k)
        if (r_m <= profile[k + 1].radius_m) {
            const double share =
                (r_m - profile[k].radius_m) / (profile[k + 1].radius_m - profile[k].radius_m);
            return experiment.environment_K +
                   std::lerp(profile[k].temperatureRatio, profile[k + 1].temperatureRatio, share) *
                       (source_K - experiment.environment_K) +
                   std::lerp(profile[k].temperatureOffset_K, profile[k + 1].temperatureOffset_K, share);
        }
    return source_K;
}

} // namespace

// Catches a simulated picture of one even plate: the rim is 38 K colder than the middle.
TEST(UnevenPlate, IsMeasuredInTheSimulatedPictureWithinWhatIsStated) {
    double squares = 0.0, worst_K = 0.0;
    int rings = 0;
    for (std::uint64_t seed = 1; seed <= 8; ++seed) {
        const Experiment experiment = unevenPlate(seed);
        SimulatedRig rig(simulatedRigConfig(experiment));
        for (int k = 0; k < 120; ++k) {
            ASSERT_TRUE(rig.heatSource().keepHeating(473.15, 10.0));
            rig.advance(1.0);
        }
        const double source_K = rig.heatSource().read()->value_K;
        const SimulatedThermalCameraConfig& config = rig.simulatedThermalCamera()->config();
        ReadingUncertainty uncertainty;
        uncertainty.gain = 0.01;
        uncertainty.gainAbout_K = experiment.environment_K;
        uncertainty.offset_K = 1.0; // it is not zeroed
        const std::vector<PlateView> views{{rig.thermalCamera()->newest().value()->frame.picture, {}}};
        const auto found =
            plateProfile(thermalBand(), PixelRays(config.camera), config.X_RC,
                         {experiment.source.shape, poseFromCoordinates(experiment.source.pose)}, views,
                         {experiment.source.emittance, {}, experiment.environment_K}, uncertainty);
        ASSERT_TRUE(found) << describe(found.error());
        ASSERT_GE(found->rings.size(), 15U);
        const double first_K =
            found->rings.front().T_K - trueAt_K(experiment, found->rings.front().radius_m, source_K);
        for (const PlateRing& ring : found->rings) {
            const double off_K = ring.T_K - trueAt_K(experiment, ring.radius_m, source_K);
            EXPECT_LT(std::abs(off_K), 3.0 * ring.standardUncertainty_K) << seed << ", " << ring.radius_m;
            squares += std::pow(off_K / ring.standardUncertainty_K, 2);
            worst_K = std::max(worst_K, std::abs(off_K - first_K));
            ++rings;
        }
    }
    RecordProperty("rms_of_stated_uncertainty", std::to_string(std::sqrt(squares / rings)));
    RecordProperty("largest_error_of_shape_K", std::to_string(worst_K));
    EXPECT_LT(std::sqrt(squares / rings), 1.6); // eight cameras with one gain and offset each
    EXPECT_LT(worst_K, 1.5);
}

// Parts are seen where they are, and what is between them is as cold as the room.
TEST(UnevenPlate, ShowsPartsWithTheirOwnTemperatures) {
    Experiment experiment = unevenPlate(3);
    Unevenness& uneven = *experiment.simulation.sourceUneven;
    uneven.profile.clear();
    SourcePartSpec part;
    part.shape = Disk{0.03};
    part.pose[0] = 0.05;
    part.emittance = 0.95;
    uneven.parts = {part, part};
    uneven.parts[1].pose[0] = -0.05;
    uneven.parts[1].temperatureRatio = 0.5;
    experiment.simulation.thermalCamera->pose =
        coordinatesFromPose(lookingAt({0.0, 0.0, 0.5}, {0.0, 0.0, 0.0}));
    ASSERT_TRUE(validate(experiment)) << describe(validate(experiment).error());
    SimulatedRigConfig config = simulatedRigConfig(experiment);
    ASSERT_EQ(config.thermalCamera->source.size(), 2U);
    SimulatedRig rig(config);
    for (int k = 0; k < 60; ++k) {
        ASSERT_TRUE(rig.heatSource().keepHeating(473.15, 10.0));
        rig.advance(0.5);
    }
    const double source_K = rig.heatSource().read()->value_K;
    const ThermalPicture& picture = rig.thermalCamera()->newest().value()->frame.picture;
    const auto apparent_K = [&](double x_m) {
        const Eigen::Vector3d p = config.thermalCamera->X_RC.inverse() * Eigen::Vector3d(x_m, 0.0, 0.0);
        const CameraModel& lens = config.thermalCamera->camera;
        const int u = static_cast<int>(std::lround(lens.cx + lens.fx * p.x() / p.z()));
        const int v = static_cast<int>(std::lround(lens.cy + lens.fy * p.y() / p.z()));
        return picture.T_K[static_cast<std::size_t>(v) * static_cast<std::size_t>(picture.width) +
                           static_cast<std::size_t>(u)];
    };
    const auto expected_K = [&](double T_K) {
        return apparentTemperature(thermalBand(), {0.95, {}, experiment.environment_K}, T_K);
    };
    const double half_K = experiment.environment_K + 0.5 * (source_K - experiment.environment_K);
    EXPECT_NEAR(apparent_K(0.05), expected_K(source_K), 6.0); // 1 % of gain, 1 K of offset
    EXPECT_NEAR(apparent_K(-0.05), expected_K(half_K), 4.0);
    EXPECT_NEAR(apparent_K(0.0), experiment.environment_K, 3.5);
}

} // namespace bask
