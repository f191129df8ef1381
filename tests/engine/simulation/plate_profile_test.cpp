// The profile of a source's plate in pictures of the simulated camera.

#include "engine/thermography/plate_profile.h"

#include "engine/base/message_code.h"
#include "engine/calibration/projection.h"
#include "engine/simulation/simulated_camera.h"
#include "engine/simulation/simulated_thermal_camera.h"
#include "engine/thermography/usual_thermal_camera.h"
#include "tests/support/told_shares.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace bask {
namespace {

constexpr double kAround_K = 298.15, kPlate_m = 0.1, kMiddle_K = 473.15;

constexpr int kSteps = 10;

/// Colder towards its rim, in steps, by 20 K.
double plateAt_K(double r_m) {
    const double step = (std::floor(kSteps * r_m / kPlate_m) + 0.5) / kSteps;
    return kMiddle_K - 20.0 * step * step;
}

/// A plate of disks on one another, each with a temperature of its own, under an object beside its middle.
struct PlateScene {
    SimulatedThermalCameraConfig config;
    ThermalMoment moment;

    explicit PlateScene(double emittance, std::uint64_t seed) {
        constexpr double kHigher_m = 2.5e-4; // so that the painter knows their order
        const auto& profiles = shippedThermalProfiles();
        config.profile = *std::ranges::find(profiles, "p2-pro", &ThermalProfile::name);
        config.camera = usualThermalLens(config.profile);
        config.X_RC = lookingAt({0.1, 0.05, 0.5}, {0.0, 0.0, 0.0});
        config.environment_K = kAround_K;
        config.errors.seed = seed;
        for (int k = kSteps; k > 0; --k) {
            const double r_m = kPlate_m * k / kSteps;
            Pose X_SP = Pose::Identity();
            X_SP.translation().z() = kHigher_m * (kSteps - k);
            config.source.push_back({Disk{r_m}, X_SP, emittance});
            moment.source_K.push_back(plateAt_K(r_m - 1e-4));
        }
        config.objects = {{Disk{0.02}, Pose::Identity()}};
        moment.X_RE.translation() = Eigen::Vector3d(0.03, 0.0, 0.05);
        moment.objects = {{310.0, {0.9, {}, kAround_K}, {0.9, {}, kAround_K}}};
    }

    std::vector<PlateView> views() {
        SimulatedThermalCamera camera(config);
        for (const double time_s : {1.0, 2.0}) {
            moment.time_s = time_s;
            camera.observe(moment);
        }
        return {{camera.newest().value()->frame.picture, {{config.objects[0].shape, moment.X_RE}}}};
    }

    /// The camera is not zeroed.
    ReadingUncertainty uncertainty() const {
        ReadingUncertainty out;
        out.gain = config.errors.gain;
        out.gainAbout_K = kAround_K;
        out.offset_K = 1.0;
        return out;
    }

    Result<PlateProfile> profile(std::span<const PlateView> pictures, const ShareDone& done = {}) const {
        return plateProfile(thermalBand(), PixelRays(config.camera), config.X_RC,
                            {Disk{kPlate_m}, Pose::Identity()}, pictures,
                            {config.source.front().emittance, {}, kAround_K}, uncertainty(), {}, done);
    }
};

} // namespace

TEST(PlateProfile, FollowsAPlateThatIsColderTowardsItsRim) {
    double squares = 0.0, worst = 0.0;
    int rings = 0;
    for (std::uint64_t seed = 1; seed <= 10; ++seed) {
        PlateScene scene(0.9, seed);
        const auto found = scene.profile(scene.views());
        ASSERT_TRUE(found) << describe(found.error());
        EXPECT_TRUE(found->remarks.empty() == (found->rings.size() == 20));
        ASSERT_GE(found->rings.size(), 18U);
        double last_m = 0.0;
        for (const PlateRing& ring : found->rings) {
            EXPECT_GT(ring.radius_m, last_m);
            last_m = ring.radius_m;
            const double off_K = ring.T_K - plateAt_K(ring.radius_m);
            squares += std::pow(off_K / ring.standardUncertainty_K, 2);
            ++rings;
            // The camera's gain and offset are the same for all rings.
            const PlateRing& first = found->rings.front();
            const double shape_K =
                (ring.T_K - first.T_K) - (plateAt_K(ring.radius_m) - plateAt_K(first.radius_m));
            worst = std::max(worst, std::abs(shape_K));
            EXPECT_LT(ring.ownUncertainty_K, ring.standardUncertainty_K);
        }
    }
    RecordProperty("rms_of_stated_uncertainty", std::to_string(std::sqrt(squares / rings)));
    RecordProperty("largest_error_of_shape_K", std::to_string(worst));
    EXPECT_LT(std::sqrt(squares / rings), 1.6); // ten cameras with one gain and offset each
    EXPECT_LT(worst, 1.0);
}

TEST(PlateProfile, SaysHowLittleABareMetalPlateTells) {
    PlateScene scene(0.25, 3);
    const auto pictures = scene.views();
    ReadingUncertainty uncertainty = scene.uncertainty();
    uncertainty.emittance = 0.02;
    const auto found =
        plateProfile(thermalBand(), PixelRays(scene.config.camera), scene.config.X_RC,
                     {Disk{kPlate_m}, Pose::Identity()}, pictures, {0.25, {}, kAround_K}, uncertainty);
    ASSERT_TRUE(found) << describe(found.error());
    for (const PlateRing& ring : found->rings) {
        EXPECT_GT(ring.standardUncertainty_K, 5.0);
        EXPECT_LT(std::abs(ring.T_K - plateAt_K(ring.radius_m)), 3.0 * ring.standardUncertainty_K);
    }
}

TEST(PlateProfile, LeavesOutHiddenAndDeadPixels) {
    PlateScene scene(0.9, 4);
    auto pictures = scene.views();
    const auto found = scene.profile(pictures);
    ASSERT_TRUE(found);
    const Eigen::Vector2d pixel =
        shownAt(Lens(scene.config.camera),
                Eigen::Vector3d(scene.config.X_RC.inverse() * Eigen::Vector3d(-0.05, 0.0, 0.0)));
    pictures.front()
        .picture.T_K[static_cast<std::size_t>(std::lround(pixel.y()) * 256 + std::lround(pixel.x()))] =
        std::numeric_limits<double>::quiet_NaN();
    const auto dead = scene.profile(pictures);
    ASSERT_TRUE(dead);
    const auto pixelsOf = [](const PlateProfile& profile) {
        int sum = 0;
        for (const PlateRing& ring : profile.rings)
            sum += ring.pixels;
        return sum;
    };
    EXPECT_EQ(pixelsOf(*found) - pixelsOf(*dead), 1);
    pictures.front().covers.push_back(
        {Disk{0.06}, poseFromRotationVector({0.0, 0.0, 0.01}, {0.0, 0.0, 0.0})});
    const auto rim = scene.profile(pictures);
    ASSERT_TRUE(rim);
    EXPECT_GT(rim->rings.front().radius_m, 0.055);
    EXPECT_GE(rim->remarks.size(), 10U);
    EXPECT_EQ(rim->remarks.front().code, MessageCode::PlateProfileRingUnseen);
}

TEST(PlateProfile, TellsItsShareWithEachPicture) {
    PlateScene scene(0.9, 6);
    const std::vector<PlateView> pictures(3, scene.views().front());
    test::ToldShares shares;
    ASSERT_TRUE(scene.profile(pictures, shares.told()));
    EXPECT_EQ(shares.shares(), (std::vector<double>{1.0 / 3.0, 2.0 / 3.0, 1.0}));
}

TEST(PlateProfile, RefusesWhatShowsNoPlate) {
    PlateScene scene(0.9, 5);
    auto pictures = scene.views();
    pictures.front().covers.push_back({Disk{0.3}, poseFromRotationVector({0.0, 0.0, 0.01}, {0.0, 0.0, 0.0})});
    EXPECT_EQ(scene.profile(pictures).error().code(), MessageCode::ThermalFaceHidden);
    scene.config.X_RC = lookingAt({0.1, 0.0, -0.5}, {0.0, 0.0, 0.0}); // its back
    EXPECT_EQ(scene.profile(pictures).error().code(), MessageCode::ThermalFaceHidden);
    EXPECT_THROW((void)scene.profile({}), std::invalid_argument);
    pictures.front().picture = {8, 8, std::vector<double>(64, 300.0)};
    EXPECT_THROW((void)scene.profile(pictures), std::invalid_argument);
}

TEST(PlateProfile, IsWrittenAsAFileForAnExperiment) {
    PlateProfile profile;
    profile.rings = {{0.01, 473.15, 1.25, 0.1, 50}, {0.09, 460.65, 1.0, 0.1, 500}};
    EXPECT_EQ(radialProfileCsv(profile, 473.15, 298.15),
              "radius_mm,temperature_ratio,temperature_degC,standard_uncertainty_K\n"
              "10.000,1.000000,200.000,1.250\n90.000,0.928571,187.500,1.000\n");
    EXPECT_THROW((void)radialProfileCsv(profile, 298.15, 298.15), std::invalid_argument);
}

} // namespace bask
