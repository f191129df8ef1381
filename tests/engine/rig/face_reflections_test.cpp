// What faces reflect in the camera's band, against rays: an uneven source, neighbours and shade.

#include "engine/rig/face_reflections.h"

#include "engine/base/units.h"
#include "engine/experiment/experiment_file.h"
#include "engine/model/experiment_rig.h"
#include "engine/rig/camera_thermometer.h"
#include "engine/rig/rig_setup.h"
#include "engine/thermography/region_statistics.h"
#include "tests/engine/rig/traced_faces.h"

#include <gtest/gtest.h>

#include <cmath>

namespace bask {
namespace {

constexpr int kRays = 400000;

/// Three disks, of which the second and the third hang lower and tilted beside the first and take its light,
/// a source that is colder towards its rim, and a fixture.
Experiment unevenExperiment(double emittance) {
    Experiment experiment = readExperiment(BASK_EXAMPLES "/thermal-camera.json").value();
    experiment.source.uneven.profile = {{0.0, 1.0, 0.0}, {0.05, 0.9, 0.0}, {0.1, 0.6, 0.0}};
    const std::vector<std::pair<double, Vector6d>> disks{
        {0.02, Vector6d{{0.0, 0.0, 0.02, 0.0, 0.0, 0.0}}},
        {0.02, Vector6d{{0.03, 0.0, 0.0, 0.0, radFromDeg(-35.0), 0.0}}},
        {0.015, Vector6d{{-0.03, 0.01, 0.0, 0.0, radFromDeg(30.0), 0.0}}}};
    for (std::size_t i = 0; i < disks.size(); ++i) {
        ObjectSpec& object = experiment.objects[i];
        object.shape = Disk{disks[i].first};
        object.mounting = disks[i].second;
        object.material.emittance = object.material.absorptance = emittance;
    }
    PlateSpec plate;
    plate.name = "plate";
    plate.shape = Disk{0.01};
    plate.pose = Vector6d{{0.0, -0.03, -0.01, 0.0, 0.0, 0.0}};
    experiment.fixtures.push_back(plate);
    experiment.start = Vector6d{{0.01, 0.0, 0.08, 0.0, 0.0, 0.0}};
    return experiment;
}

double profileAt_K(const Experiment& experiment, double r_m, double source_K) {
    const auto& profile = experiment.source.uneven.profile;
    double ratio = profile.back().temperatureRatio;
    for (std::size_t k = 0; k + 1 < profile.size(); ++k)
        if (r_m >= profile[k].radius_m && r_m <= profile[k + 1].radius_m)
            ratio = std::lerp(profile[k].temperatureRatio, profile[k + 1].temperatureRatio,
                              (r_m - profile[k].radius_m) / (profile[k + 1].radius_m - profile[k].radius_m));
    return experiment.environment_K + ratio * (source_K - experiment.environment_K);
}

/// The rig as rays see it: the objects first, whose fronts are below, the source, the fixtures.
test::TracedScene traced(const Experiment& experiment, const std::vector<double>& objects_K,
                         double source_K) {
    test::TracedScene scene{{}, experiment.environment_K};
    const Pose X_RE = poseFromCoordinates(experiment.start);
    const auto constant = [](double T_K) { return [T_K](double) { return T_K; }; };
    for (std::size_t i = 0; i < experiment.objects.size(); ++i) {
        const ObjectSpec& object = experiment.objects[i];
        scene.disks.push_back({std::get<Disk>(object.shape).radius_m,
                               X_RE * poseFromCoordinates(object.mounting), object.material.emittance,
                               constant(objects_K[i]), constant(objects_K[i])});
    }
    scene.disks.push_back(
        {std::get<Disk>(experiment.source.shape).radius_m, poseFromCoordinates(experiment.source.pose),
         experiment.source.emittance,
         [experiment, source_K](double r_m) { return profileAt_K(experiment, r_m, source_K); },
         constant(experiment.environment_K), true});
    for (const PlateSpec& fixture : experiment.fixtures)
        scene.disks.push_back({std::get<Disk>(fixture.shape).radius_m,
                               X_RE * poseFromCoordinates(fixture.pose), 1.0,
                               constant(experiment.environment_K), constant(experiment.environment_K)});
    return scene;
}

const std::vector<double> kObjects_K{kelvinFromCelsius(40.0), kelvinFromCelsius(75.0),
                                     kelvinFromCelsius(60.0)};

ReflectionMoment momentOf(const Experiment& experiment, double source_K) {
    ReflectionMoment moment{poseFromCoordinates(experiment.start),
                            poseFromCoordinates(experiment.source.pose),
                            {source_K, 1.0},
                            {experiment.environment_K, 0.3},
                            {}};
    for (const double T_K : kObjects_K)
        moment.objects.push_back({T_K, 0.5});
    return moment;
}

double receivedBand(const KnownFace& face) {
    return thermalBand().radiance(reflectedTemperature(thermalBand(), face.surroundings));
}

} // namespace

// Catches a source taken as even, light that another object or a fixture takes, and neighbours' own radiation
// left out: each is several times the tolerance.
TEST(FaceReflections, AreThoseThatRaysFind) {
    const double room = thermalBand().radiance(kelvinFromCelsius(25.0));
    for (const double emittance : {0.9, 0.5}) {
        const Experiment experiment = unevenExperiment(emittance);
        const double source_K = kelvinFromCelsius(230.0); // not that of the set point
        FaceReflections reflections(reflectingRig(experiment), bandOf({}));
        ASSERT_TRUE(reflections.exchange());
        const auto faces = reflections.at(momentOf(experiment, source_K), std::vector(6, true));
        const test::TracedScene scene = traced(experiment, kObjects_K, source_K);
        for (std::size_t f = 0; f < 6; ++f) {
            const auto rays = test::receivedBy(scene, f % 3, f >= 3, thermalBand(), kRays, 17 + f);
            const double above = rays.mean - room;
            EXPECT_NEAR(receivedBand(faces[f]) - room, above, 4.0 * rays.standardError + 0.015 * above)
                << "face " << f << ", emittance " << emittance;
        }
    }
}

// The uncertainty of the source's temperature is that of all its rings together.
TEST(FaceReflections, StateWhatTheSourceIsKnownTo) {
    Experiment experiment = unevenExperiment(0.6);
    experiment.source.emittanceUncertainty = 0.02;
    const double source_K = kelvinFromCelsius(200.0), T_app_K = kelvinFromCelsius(60.0);
    FaceReflections reflections(reflectingRig(experiment), bandOf({}));
    const auto solved = [&](double at_K) {
        const auto faces = reflections.at(momentOf(experiment, at_K), std::vector(6, true));
        return faceTemperature(thermalBand(), faces[0].surroundings, T_app_K)->T_K;
    };
    const auto faces = reflections.at(momentOf(experiment, source_K), std::vector(6, true));
    ReadingUncertainty uncertainty;
    uncertainty.surfaces = faces[0].surfaces;
    for (SurfaceUncertainty& surface : uncertainty.surfaces)
        surface.viewFactor = surface.emittance = 0.0;
    for (std::size_t p = 1; p < uncertainty.surfaces.size(); ++p)
        uncertainty.surfaces[p].T_K = 0.0; // neighbours
    EXPECT_EQ(faces[0].surfaces[0].emittance, 0.02);
    const auto reading = estimateFace(thermalBand(), faces[0].surroundings, T_app_K, uncertainty);
    ASSERT_TRUE(reading);
    const double slope = 0.5 * (solved(source_K + 1.0) - solved(source_K - 1.0));
    EXPECT_NEAR(reading->fromSurfaces_K, std::abs(slope), 0.03 * std::abs(slope));
}

// Catches a picture of the simulated camera whose reflections are not those of the true rig.
TEST(FaceReflections, AreInTheSimulatedPictureAsRaysFindThem) {
    const Experiment experiment = unevenExperiment(0.6);
    SimulatedRigConfig config = simulatedRigConfig(experiment);
    ThermalSensorErrors& errors = config.thermalCamera->errors;
    errors.noise_K = 1e-3;
    errors.gain = errors.offset_K = errors.shutterOffset_K = errors.drift_K_min = errors.narcissus_K = 0.0;
    errors.pattern_K = errors.blur_px = 0.0;
    for (const bool isFront : {true, false}) {
        config.thermalCamera->X_RC = isFront ? lookingAt({0.0, -0.22, 0.03}, {0.0, 0.0, 0.09})
                                             : lookingAt({0.0, -0.1, 0.4}, {0.0, 0.0, 0.09});
        SimulatedRig rig(config);
        rig.simulatedHeatSource().setHeatedTo(473.15);
        for (int k = 0; k < 60; ++k) {
            ASSERT_TRUE(rig.heatSource().keepHeating(473.15, 10.0));
            rig.advance(0.5);
        }
        const std::vector<double> objects_K = rig.trueTemperatures_K();
        const double source_K = rig.heatSource().read()->value_K;
        const auto frame = rig.thermalCamera()->newest().value();
        const test::TracedScene scene = traced(experiment, objects_K, source_K);
        const PixelRays rays(config.thermalCamera->camera);
        std::vector<PlacedPlate> plates,
            screens{{experiment.source.shape, poseFromCoordinates(experiment.source.pose)}};
        for (std::size_t i = 0; i < 3; ++i)
            plates.push_back({experiment.objects[i].shape, scene.disks[i].X_R});
        screens.push_back({experiment.fixtures[0].shape, scene.disks[4].X_R});
        const auto pixels = facePixels(rays, config.thermalCamera->X_RC, plates, screens, rigPixels());
        int seen = 0;
        for (std::size_t i = 0; i < 3; ++i) {
            if (!pixels[i] || pixels[i]->isFront != isFront)
                continue;
            ++seen;
            const auto region = regionStatistics(frame->frame.picture, pixels[i]->pixels, 5);
            ASSERT_TRUE(region);
            const auto received = test::receivedBy(scene, i, !isFront, thermalBand(), kRays, 5 + i);
            const double eps = experiment.objects[i].material.emittance;
            const double apparent_K = thermalBand().temperature(eps * thermalBand().radiance(objects_K[i]) +
                                                                (1.0 - eps) * received.mean);
            // The picture is 0.1 s older, and the reflected radiance is even over a face here.
            EXPECT_NEAR(region->mean_K, apparent_K, 0.25)
                << "object " << i << (isFront ? ", front" : ", back");
            EXPECT_GT(std::abs(apparent_K - objects_K[i]), 0.3);
        }
        EXPECT_GE(seen, 2);
    }
}

} // namespace bask
