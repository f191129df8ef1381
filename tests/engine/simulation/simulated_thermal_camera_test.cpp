// The simulated thermal camera, and what the thermometry makes of its pictures.

#include "engine/simulation/simulated_thermal_camera.h"

#include "engine/base/message_code.h"
#include "engine/base/units.h"
#include "engine/simulation/simulated_camera.h"
#include "engine/thermography/face_thermometer.h"
#include "engine/thermography/frame_picture_file.h"
#include "engine/thermography/usual_thermal_camera.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace bask {
namespace {

constexpr double kRoom_K = 298.15;

const ThermalProfile& profileNamed(const std::string& name) {
    for (const ThermalProfile& profile : shippedThermalProfiles())
        if (profile.name == name)
            return profile;
    throw std::out_of_range(name);
}

/// A disk of 3 cm that hangs over a source and shows its heated face to a camera beside it.
SimulatedThermalCameraConfig oneDisk() {
    SimulatedThermalCameraConfig config;
    config.profile = profileNamed("lepton-3.5");
    config.camera = usualThermalLens(config.profile);
    config.X_RC = lookingAt({0.25, 0.0, -0.05}, {0.0, 0.0, 0.15});
    config.objects = {{Disk{0.03}}};
    config.environment_K = kRoom_K;
    return config;
}

FaceSurroundings face(double emittance, double F, double source_K, double sourceEmittance = 0.25) {
    return {emittance, {{F, source_K, sourceEmittance}}, kRoom_K};
}

ThermalMoment momentOf(double time_s, double T_K, const FaceSurroundings& front) {
    ThermalMoment moment;
    moment.time_s = time_s;
    moment.X_RE.translation().z() = 0.15;
    moment.objects = {{T_K, front, FaceSurroundings{front.emittance, {}, kRoom_K}}};
    return moment;
}

/// The mean of some frames' pictures, 0.2 s apart.
ThermalPicture meanPicture(SimulatedThermalCamera& camera, ThermalMoment moment, int frames) {
    ThermalPicture mean;
    camera.observe(moment);
    for (int k = 0; k < frames; ++k) {
        moment.time_s += 0.2;
        camera.observe(moment);
        const ThermalPicture& picture = camera.newest().value()->frame.picture;
        if (k == 0)
            mean = picture;
        else
            for (std::size_t i = 0; i < mean.T_K.size(); ++i)
                mean.T_K[i] += (picture.T_K[i] - mean.T_K[i]) / (k + 1);
    }
    return mean;
}

double hottest(const ThermalPicture& picture) {
    return *std::ranges::max_element(picture.T_K);
}

// Catches a picture for the studies that leaves out what is read, or shows it without noise.
TEST(SimulatedThermalCamera, ItsPictureOfTheObjectsOnlyTellsThemAsTheWholeOne) {
    SimulatedThermalCameraConfig config = oneDisk();
    SimulatedThermalCamera whole(config);
    config.showsObjectsOnly = true;
    SimulatedThermalCamera part(config);
    const ThermalMoment moment = momentOf(0.0, kRoom_K + 40.0, face(0.9, 0.2, 473.15));
    for (SimulatedThermalCamera* camera : {&whole, &part})
        camera->observe(moment);
    const ThermalPicture ofWhole = whole.newest().value()->frame.picture;
    const ThermalPicture ofPart = part.newest().value()->frame.picture;
    const PixelRays rays(config.camera);
    const std::vector<PlacedPlate> disks{{config.objects[0].shape, moment.X_RE * config.objects[0].X_EO}};
    const std::vector<int> pixels = facePixels(rays, config.X_RC, disks, {}, rigPixels())[0].value().pixels;
    ASSERT_GT(pixels.size(), 20U);
    const auto a = regionStatistics(ofWhole, pixels, 5), b = regionStatistics(ofPart, pixels, 5);
    ASSERT_TRUE(a && b);
    EXPECT_NEAR(b->mean_K, a->mean_K, 0.05);
    EXPECT_NEAR(b->standardError_K, a->standardError_K, 0.5 * a->standardError_K);
    EXPECT_NE(ofPart.T_K[static_cast<std::size_t>(pixels[0])],
              ofWhole.T_K[static_cast<std::size_t>(pixels[0])]);
    EXPECT_NEAR(ofPart.T_K.front(), kRoom_K, 0.02);
    EXPECT_EQ(ofPart.T_K.front(), ofPart.T_K[1]);
}

// Number of the issue: below 60 % of 16 bits a pixel, without loss, as PNG and as TIFF.
TEST(SimulatedThermalCamera, ItsPicturesAreStoredWithoutLossInLittleRoom) {
    for (const ThermalProfile& profile : shippedThermalProfiles()) {
        SimulatedThermalCameraConfig config = oneDisk();
        config.profile = profile;
        config.camera = usualThermalLens(profile);
        SimulatedThermalCamera camera(config);
        ThermalMoment moment = momentOf(1.0, 320.0, face(0.9, 0.3, 473.15));
        camera.observe(moment);
        moment.time_s = 2.0;
        camera.observe(moment);
        const ThermalPicture picture = camera.newest().value()->frame.picture;
        const CountPicture counts = countsOfPicture(picture, profile);
        const std::string png = pngOfCounts(counts);
        EXPECT_LT(static_cast<double>(png.size()),
                  0.6 * 2.0 * static_cast<double>(profile.width) * profile.height)
            << profile.name;
        for (const std::string& bytes : {png, tiffOfCounts(counts)})
            EXPECT_EQ(frameOfImage(bytes, profile, "stored").value().picture, picture) << profile.name;
    }
}

TEST(SimulatedThermalCamera, TellsItsBytesAsEveryProfileReadsThem) {
    for (const ThermalProfile& profile : shippedThermalProfiles()) {
        ThermalPicture picture{profile.width, profile.height, {}};
        for (int k = 0; k < profile.width * profile.height; ++k)
            picture.T_K.push_back(280.0 + 0.0031 * k);
        const auto read = frameOfBytes(bytesOfFrame(picture, profile), profile, "test");
        ASSERT_TRUE(read) << profile.name;
        for (std::size_t k = 0; k < picture.T_K.size(); ++k)
            ASSERT_NEAR(read->picture.T_K[k], picture.T_K[k], 0.51 * profile.scale);
    }
}

TEST(SimulatedThermalCamera, GivesNoNewFrameWhileItsShutterIsClosed) {
    SimulatedThermalCamera camera(oneDisk());
    int none = 0;
    std::uint64_t number = 0;
    for (int k = 0; k < 40; ++k) {
        camera.observe(momentOf(178.0 + 0.12 * k, 330.0 + 0.1 * k, face(0.9, 0.3, 473.15)));
        const auto frame = camera.newest();
        ASSERT_TRUE(frame);
        const double time_s = (*frame)->time_s;
        none += (*frame)->number == number && k > 1 ? 1 : 0;
        EXPECT_TRUE(time_s < 180.0 || time_s >= 180.5) << time_s;
        EXPECT_EQ((*frame)->shutter_s, time_s < 180.0 ? 0.5 : 180.5);
        number = (*frame)->number;
    }
    EXPECT_GE(none, 4); // half a second
    EXPECT_LE(none, 5);
}

TEST(SimulatedThermalCamera, GivesNoPictureBeforeItSeesAnythingAndWithoutItsPlug) {
    SimulatedThermalCamera camera(oneDisk());
    EXPECT_EQ(camera.newest().error().code(), MessageCode::CameraLost);
    camera.observe(momentOf(1.0, 300.0, face(0.9, 0.3, 473.15)));
    EXPECT_TRUE(camera.newest());
    camera.setUnplugged(true);
    EXPECT_EQ(camera.newest().error().code(), MessageCode::CameraLost);
}

TEST(SimulatedThermalCamera, DeliversWhatWasThereWhenItsFrameWasTaken) {
    SimulatedThermalCameraConfig config = oneDisk();
    config.delay_s = 0.3;
    SimulatedThermalCamera camera(config);
    for (int k = 0; k <= 10; ++k) {
        camera.observe(momentOf(0.1 * k, 300.0 + k, face(1.0, 0.0, 473.15)));
        const auto frame = camera.newest();
        ASSERT_TRUE(frame);
        const double time_s = (*frame)->time_s;
        EXPECT_LE(time_s, std::max(0.0, 0.1 * k - 0.3) + 1e-9);
        // Its temperature was 300 K + 10 K/s then.
        const double offset_K = (*frame)->frame.picture.at(40, 119) - kRoom_K; // of a pixel of the room
        EXPECT_NEAR(hottest((*frame)->frame.picture) - offset_K, std::max(300.0 + 10.0 * time_s, kRoom_K),
                    1.5);
    }
}

/// One static object before a hot source, read after the camera was zeroed on it in the cold room.
struct Trial {
    double true_K = 0.0, read_K = 0.0, stated_K = 0.0, withoutReflection_K = 0.0;
    double emittance = 0.0, F = 0.0;
    double byEmittance_K = 0.0; ///< what of the stated uncertainty comes from it, two sigma
    bool isUsable = false;
};

/// From where to where a trial is drawn.
struct Range {
    double min = 0.0, max = 0.0;
};
struct TrialRanges {
    Range emittance{0.6, 0.95}, F{0.0, 0.9}, source_K{423.15, 573.15};
};

Trial trial(std::uint64_t seed, const TrialRanges& ranges = {}) {
    std::mt19937_64 random(seed);
    const auto between = [&](double a, double b) { return std::uniform_real_distribution(a, b)(random); };
    const auto within = [&](const Range& range) {
        return range.min < range.max ? between(range.min, range.max) : range.min;
    };
    std::normal_distribution<double> normal;
    constexpr double kEmittanceKnown = 0.01; // +-0.02 are two of these
    constexpr double kSourceKnown_K = 1.0, kRoomKnown_K = 0.3, kZeroKnown_K = 0.05;
    SimulatedThermalCameraConfig config = oneDisk();
    config.errors.seed = seed;
    SimulatedThermalCamera camera(config);

    Trial out;
    out.emittance = within(ranges.emittance);
    out.true_K = between(303.15, 323.15);
    const double F = within(ranges.F);
    const FaceSurroundings believed = face(out.emittance, F, within(ranges.source_K));
    out.F = believed.surfaces[0].viewFactor;
    FaceSurroundings truth = believed;
    truth.emittance = std::min(1.0, believed.emittance + kEmittanceKnown * normal(random));
    truth.surfaces[0].T_K += kSourceKnown_K * normal(random);
    // The picture's room is the true one, so it is the belief that is off.
    FaceSurroundings stated = believed;
    stated.T_env_K += kRoomKnown_K * normal(random);

    const PixelRays rays(config.camera);
    const auto object = [&](const FaceSurroundings& front) {
        ReadObject read;
        read.plate = {Disk{0.03}, momentOf(0.0, 300.0, believed).X_RE};
        read.front = {front, kEmittanceKnown, kRoomKnown_K, {}};
        for (std::size_t p = 0; p < front.surfaces.size(); ++p)
            read.front.surfaces.push_back({0.0, kSourceKnown_K, 0.0});
        read.back = {{front.emittance, {}, front.T_env_K}, kEmittanceKnown, kRoomKnown_K, {}};
        return read;
    };
    const auto reading = [&](const ThermalPicture& picture, const FaceSurroundings& front,
                             const std::optional<CameraZero>& zero, double sinceShutter_s) {
        const std::vector<ReadObject> objects{object(front)};
        return readObjects(thermalBand(), picture, rays, config.X_RC, objects, {}, std::vector{zero},
                           {0.01, 0.07, 0.03}, sinceShutter_s)
            .front();
    };
    // Zeroed with the heat off: the face and all that it reflects are as cold as the room.
    const FaceSurroundings cold{believed.emittance, {}, kRoom_K};
    const ThermalPicture before = meanPicture(camera, momentOf(10.0, kRoom_K, cold), 10);
    const auto first = reading(before, cold, std::nullopt, 0.0);
    if (!first)
        return out;
    const CameraZero zero = zeroAt(thermalBand(), cold, kRoom_K + kZeroKnown_K * normal(random), kZeroKnown_K,
                                   first->region.mean_K, first->region.standardError_K);
    const double sinceShutter_s = between(1.0, 170.0);
    const ThermalPicture after = meanPicture(camera, momentOf(360.0 + sinceShutter_s, out.true_K, truth), 2);
    const auto read = reading(after, stated, zero, sinceShutter_s);
    const auto plain = reading(after, {believed.emittance, {}, stated.T_env_K}, zero, sinceShutter_s);
    if (!read || !plain)
        return out;
    out.isUsable = true;
    out.read_K = read->face.T_K;
    out.stated_K = 2.0 * read->face.standardUncertainty_K;
    out.byEmittance_K = 2.0 * read->face.fromEmittance_K;
    out.withoutReflection_K = plain->face.T_K;
    return out;
}

// What can be reached: at F 0.9 and 300 degC an emittance known to +-0.02 alone makes +-2.3 K at emittance
// 0.9;
// +-0.6 K would ask for one known to +-0.005. By an integral of Planck's law apart from this program.
TEST(ThermalReading, HangsOnTheEmittanceTheMoreTheFaceSees) {
    const std::pair<FaceSurroundings, double> cases[]{{face(0.9, 0.3, kelvinFromCelsius(200.0)), 7.3},
                                                      {face(0.9, 0.9, kelvinFromCelsius(200.0)), 53.1},
                                                      {face(0.9, 0.3, kelvinFromCelsius(300.0)), 28.1},
                                                      {face(0.9, 0.9, kelvinFromCelsius(300.0)), 115.4}};
    for (const auto& [seen, dT_K] : cases) {
        const double T_K = kelvinFromCelsius(40.0);
        const double apparent_K = apparentTemperature(thermalBand(), seen, T_K);
        EXPECT_NEAR(faceTemperature(thermalBand(), seen, apparent_K)->sensitivities.byEmittance, dT_K, 0.06);
    }
}

/// Up to which view factor two sigma of a face of emittance 0.9 at 40 degC stay below 0.6 K, halfway between
/// two shutter events of the simulated camera.
double sureUpTo(double source_K) {
    const ReadingUncertainty known{.gain = 0.01,
                                   .gainAbout_K = kRoom_K,
                                   .offset_K = std::hypot(0.07, 0.05),
                                   .drift_K = 0.03 * 1.5,
                                   .emittance = 0.01,
                                   .T_env_K = 0.3,
                                   .surfaces = {{0.0, 1.0, 0.0}}};
    double F = 0.0;
    for (;; F += 0.001) {
        const FaceSurroundings seen = face(0.9, F, source_K);
        const double apparent_K = apparentTemperature(thermalBand(), seen, kelvinFromCelsius(40.0));
        if (F > 0.9 || 2.0 * readFace(thermalBand(), seen, apparent_K, known)->standardUncertainty_K > 0.6)
            return F;
    }
}

// By the same derivation apart from this program; docs/model.md has them.
TEST(ThermalReading, IsKnownToSixTenthsOfAKelvinUpToAViewFactor) {
    EXPECT_NEAR(sureUpTo(kelvinFromCelsius(150.0)), 0.74, 0.01);
    EXPECT_NEAR(sureUpTo(kelvinFromCelsius(200.0)), 0.47, 0.01);
    EXPECT_NEAR(sureUpTo(kelvinFromCelsius(250.0)), 0.33, 0.01);
    EXPECT_NEAR(sureUpTo(kelvinFromCelsius(300.0)), 0.25, 0.01);
}

// The usual pose, for which the issue states what other tools do wrong: F 0.3, source of 200 degC, emittance
// 0.9.
TEST(ThermalReading, IsKnownToSixTenthsOfAKelvinInTheUsualPose) {
    const TrialRanges usual{{0.9, 0.9}, {0.3, 0.3}, {473.15, 473.15}};
    constexpr int kScenes = 100;
    int within = 0;
    double plain_K = 0.0;
    for (std::uint64_t seed = 1; seed <= kScenes; ++seed) {
        const Trial one = trial(seed, usual);
        ASSERT_TRUE(one.isUsable) << seed;
        EXPECT_LT(one.stated_K, 0.6) << seed;
        within += std::abs(one.read_K - one.true_K) <= one.stated_K ? 1 : 0;
        plain_K += (one.withoutReflection_K - one.true_K) / kScenes;
    }
    EXPECT_GE(within, 90); // of 95.4
    EXPECT_NEAR(plain_K, 2.27, 0.2) << "what the room taken for the reflection makes wrong";
}

// Within the stated two sigma in 93 to 97 % of 500 scenes. At emittance 0.9 two sigma are below 0.6 K up to F
// 0.3; beyond that all but what the emittance makes stays below 0.7 K in nine of ten (see above).
TEST(ThermalReading, LiesWithinItsStatedUncertaintyAsOftenAsItSays) {
    constexpr std::uint64_t kScenes = 500;
    int usable = 0, within = 0;
    double squares = 0.0, plainSquares = 0.0;
    std::vector<double> stated,
        otherwise; // at emittance 0.9 and F up to 0.3; at any F, without the emittance
    for (std::uint64_t seed = 1; seed <= kScenes; ++seed) {
        const Trial one = trial(seed);
        if (!one.isUsable)
            continue;
        ++usable;
        within += std::abs(one.read_K - one.true_K) <= one.stated_K ? 1 : 0;
        squares += std::pow(one.read_K - one.true_K, 2);
        plainSquares += std::pow(one.withoutReflection_K - one.true_K, 2);
        if (one.emittance > 0.88 && one.emittance < 0.92 && one.F < 0.3)
            stated.push_back(one.stated_K);
        if (one.emittance > 0.88 && one.emittance < 0.92)
            otherwise.push_back(std::sqrt(std::pow(one.stated_K, 2) - std::pow(one.byEmittance_K, 2)));
    }
    const double share = static_cast<double>(within) / usable;
    std::ranges::sort(stated);
    std::ranges::sort(otherwise);
    const double rms_K = std::sqrt(squares / usable), plain_K = std::sqrt(plainSquares / usable);
    RecordProperty("percent_within_two_sigma", std::to_string(100.0 * share));
    RecordProperty("rms_K", std::to_string(rms_K));
    RecordProperty("rms_K_without_the_reflection", std::to_string(plain_K));
    RecordProperty("median_two_sigma_K_at_emittance_0.9", std::to_string(stated[stated.size() / 2]));
    EXPECT_GE(usable, 0.95 * static_cast<double>(kScenes));
    EXPECT_GE(share, 0.93);
    EXPECT_LE(share, 0.97);
    EXPECT_GT(plain_K, 5.0 * rms_K);
    EXPECT_LT(stated[stated.size() / 2], 0.6);
    RecordProperty("largest_two_sigma_K_without_the_emittance", std::to_string(otherwise.back()));
    EXPECT_LT(otherwise[otherwise.size() * 9 / 10], 0.7);
}

} // namespace
} // namespace bask
