#include "engine/rig/rig_setup.h"

#include "engine/model/uneven_source.h"
#include "engine/thermography/usual_thermal_camera.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>
#include <random>

namespace bask {

std::vector<HeatRates> nominalRates(const Experiment& experiment, double environment_K) {
    const Surroundings surroundings = surroundingsOf(experiment, environment_K);
    std::vector<HeatRates> rates;
    for (const ObjectSpec& object : experiment.objects)
        rates.push_back(heatRates(object, surroundings));
    return rates;
}

const Material& trueMaterial(const ObjectSpec& object) {
    return object.simulatedMaterial ? *object.simulatedMaterial : object.material;
}

namespace {

double trueSourceEmittance(const Experiment& experiment) {
    return experiment.simulation.sourceEmittance.value_or(experiment.source.emittance);
}

} // namespace

Surroundings trueSurroundings(const Experiment& experiment, double source_K) {
    const SourceSpec& source = experiment.source;
    Surroundings surroundings =
        surroundingsOf(source.model, source_K, trueSourceEmittance(experiment), experiment.environment_K);
    surroundings.air = trueAir(experiment);
    return surroundings;
}

const Unevenness& trueUnevenness(const Experiment& experiment) {
    const std::optional<Unevenness>& simulated = experiment.simulation.sourceUneven;
    return simulated ? *simulated : experiment.source.uneven;
}

std::shared_ptr<const RigGeometry> trueRigGeometry(const Experiment& experiment) {
    Experiment truth = experiment;
    truth.source.uneven = trueUnevenness(experiment);
    truth.source.emittance = trueSourceEmittance(experiment);
    return rigGeometry(truth);
}

Air trueAir(const Experiment& experiment) {
    const SimulationSpec& simulation = experiment.simulation;
    return simulation.naturalConvection ? Air{std::nullopt, true} : Air{simulation.convection_W_m2K, false};
}

HeatRates trueRates(const ObjectSpec& object, const Surroundings& surroundings) {
    return heatRates(trueMaterial(object), surroundings, shapeCharacteristicLength(object.shape));
}

std::vector<HeatRates> trueRates(const Experiment& experiment) {
    const Surroundings surroundings = trueSurroundings(experiment, experiment.source.temperature_K);
    std::vector<HeatRates> rates;
    for (const ObjectSpec& object : experiment.objects)
        rates.push_back(trueRates(object, surroundings));
    return rates;
}

std::vector<HeatRates> estimatedRates(const Experiment& experiment, double environment_K) {
    const Surroundings surroundings = surroundingsOf(experiment, environment_K);
    std::vector<HeatRates> rates;
    const double range = std::log(experiment.controller.estimatedRateErrorFactor);
    std::mt19937_64 random(experiment.simulation.seed ^ 0x9e3779b97f4a7c15ULL);
    std::uniform_real_distribution<double> factor(-1.0, 1.0);
    for (const ObjectSpec& object : experiment.objects) {
        const double heating = std::exp(range * factor(random));
        const double cooling = std::exp(range * factor(random));
        const HeatRates start = startRates(object, surroundings);
        rates.push_back(object.estimatedRates ? start // known: not to be made wrong
                                              : start.scaled(heating, cooling));
    }
    return rates;
}

FeasibilityRequest feasibilityRequest(const Experiment& experiment) {
    FeasibilityRequest request;
    request.geometry = rigGeometry(experiment);
    request.rest = experiment.start;
    request.rates = nominalRates(experiment, experiment.environment_K);
    request.isAirKnown = experiment.air.isKnown();
    for (const ObjectSpec& object : experiment.objects) {
        request.names.push_back(object.name);
        request.targets_K.push_back(object.target_K);
    }
    return request;
}

JointVerdict jointVerdict(const Experiment& experiment) {
    return jointFeasibility(feasibilityRequest(experiment)).value();
}

namespace {

/// A rig without one gets one where objects are read by a camera: an experiment for real devices runs
/// simulated, too.
std::optional<SimulatedThermalCameraSpec> simulatedThermalCamera(const Experiment& experiment) {
    if (!thermalProfile(experiment, true))
        return std::nullopt;
    return experiment.simulation.thermalCamera.value_or(SimulatedThermalCameraSpec());
}

SimulatedCameraConfig simulatedCameraConfig(const Experiment& experiment) {
    const SimulatedCameraSpec& spec = experiment.simulation.camera;
    SimulatedCameraConfig config;
    if (spec.model)
        config.camera = *spec.model;
    if (spec.pose)
        config.X_RC = poseFromCoordinates(*spec.pose);
    config.markers = markerLayout(experiment.vision);
    config.source = experiment.source.shape;
    for (const ObjectSpec& object : experiment.objects)
        config.objects.push_back({object.shape, poseFromCoordinates(object.mounting)});
    config.frameRate_Hz = spec.rate_Hz;
    config.noise_grey = spec.noise_grey;
    config.blur_px = spec.blur_px;
    config.lightFall = spec.lightFall;
    config.delay_s = spec.delay_s;
    config.seed = experiment.simulation.seed;
    return config;
}

using HotPlate = SimulatedThermalCameraConfig::HotPlate;

/// The temperature of a profile at a radius, as rings are made of it: linear between its points.
PartTemperature temperatureAt(const std::vector<ProfilePoint>& profile, double radius_m) {
    const auto above = std::ranges::upper_bound(profile, radius_m, {}, &ProfilePoint::radius_m);
    const ProfilePoint& b = above == profile.end() ? profile.back() : *above;
    const ProfilePoint& a = above == profile.begin() ? b : *std::prev(above);
    const double share = b.radius_m > a.radius_m
                             ? std::clamp((radius_m - a.radius_m) / (b.radius_m - a.radius_m), 0.0, 1.0)
                             : 0.0;
    return {std::lerp(a.temperatureRatio, b.temperatureRatio, share),
            std::lerp(a.temperatureOffset_K, b.temperatureOffset_K, share)};
}

/// The source as a camera sees it: its plate, its parts, or the rings of its profile as disks that cover one
/// another, each as hot as in its middle.
std::vector<HotPlate> hotPlates(const Experiment& experiment) {
    constexpr int kShownRings = 40; // finer than the pixels
    const double emittance = trueSourceEmittance(experiment);
    const Shape& shape = experiment.source.shape;
    const Unevenness& uneven = trueUnevenness(experiment);
    if (uneven.isEven())
        return {{shape, Pose::Identity(), emittance}};
    std::vector<HotPlate> out;
    for (const SourcePartSpec& part : uneven.parts)
        out.push_back({part.shape,
                       poseFromCoordinates(part.pose),
                       part.emittance.value_or(emittance),
                       {part.temperatureRatio, part.temperatureOffset_K}});
    for (int k = uneven.profile.empty() ? 0 : kShownRings; k > 0; --k) {
        const double ring_m = shapeRadius(shape) / kShownRings;
        out.push_back({Disk{k * ring_m}, Pose::Identity(), emittance,
                       temperatureAt(uneven.profile, (k - 0.5) * ring_m)});
    }
    return out;
}

SimulatedThermalCameraConfig simulatedThermalCameraConfig(const Experiment& experiment) {
    const SimulatedThermalCameraSpec spec = simulatedThermalCamera(experiment).value();
    SimulatedThermalCameraConfig config;
    config.profile = findThermalProfile(spec.profile).value();
    config.camera = usualThermalLens(config.profile);
    config.X_RC = trueThermalPose(experiment);
    config.source = hotPlates(experiment);
    for (const ObjectSpec& object : experiment.objects)
        config.objects.push_back({object.shape, poseFromCoordinates(object.mounting)});
    for (const PlateSpec& fixture : experiment.fixtures)
        config.fixtures.push_back({fixture.shape, poseFromCoordinates(fixture.pose)});
    for (const PlateSpec& shield : experiment.shields)
        config.shields.push_back({shield.shape, poseFromCoordinates(shield.pose)});
    config.environment_K = experiment.environment_K;
    config.errors.noise_K = spec.noise_K;
    const ThermalCameraUncertainty& stated = config.profile.uncertainty;
    config.errors.gain = spec.gain.value_or(stated.gain);
    config.errors.offset_K = spec.offset_K;
    // What is stated is of a reading against its zero: two shutter events.
    config.errors.shutterOffset_K = stated.offset_K / std::numbers::sqrt2;
    config.errors.drift_K_min = stated.drift_K_min;
    config.errors.seed = experiment.simulation.seed;
    return config;
}

} // namespace

SimulatedRigConfig simulatedRigConfig(const Experiment& experiment) {
    const SimulationSpec& simulation = experiment.simulation;
    SimulatedRigConfig config;
    config.source = experiment.source.shape;
    config.sourceModel = experiment.source.model;
    config.sourceEmittance = trueSourceEmittance(experiment);
    if (const Unevenness& uneven = trueUnevenness(experiment); !uneven.isEven()) {
        UnevenSource source = unevenSource(experiment, uneven, config.sourceEmittance);
        config.sourceTerms = std::move(source.terms);
        config.sourceEmission = std::move(source.emission);
    }
    config.sourceTemperature_K = sourceSetPoint_K(experiment.source, 0.0);
    config.sourcePose = simulation.sourcePose.value_or(experiment.source.pose);
    config.sourceMotion = simulation.sourceMotion;
    config.environment_K = experiment.environment_K;
    config.air = trueAir(experiment);
    for (const ObjectSpec& object : experiment.objects)
        config.objects.push_back({object.shape, object.mounting, trueMaterial(object)});
    config.screens = screensOf(experiment);
    config.robot = {experiment.robot.free,
                    experiment.robot.lower,
                    experiment.robot.upper,
                    experiment.robot.maxSpeed_m_s,
                    experiment.robot.maxRotation_rad_s,
                    experiment.robot.maxAcceleration_m_s2,
                    experiment.robot.maxAngularAcceleration_rad_s2,
                    simulation.robotStep_m,
                    simulation.robotStep_rad,
                    experiment.start,
                    simulation.robotLatency_s};
    config.thermometer = {static_cast<int>(experiment.objects.size()),
                          simulation.sensorNoise_K,
                          simulation.sensorResolution_K,
                          simulation.sensorOffset_K,
                          simulation.sensorDelay_s,
                          simulation.seed,
                          simulation.sensorLag_s,
                          simulation.sensorDropout};
    config.tracker = {simulation.trackingNoise_m, simulation.trackingNoise_rad, simulation.trackingDelay_s,
                      simulation.seed};
    config.camera = simulatedCameraConfig(experiment);
    if (simulatedThermalCamera(experiment))
        config.thermalCamera = simulatedThermalCameraConfig(experiment);
    return config;
}

ReflectingRig reflectingRig(const Experiment& experiment) {
    constexpr double kEmittance = 0.01; // standard uncertainty, where the material does not state it
    const SourceSpec& source = experiment.source;
    ReflectingRig rig;
    rig.objects =
        MountedObjects(mountedContours(experiment), screensOf(experiment), poseFromCoordinates(source.pose));
    for (const ObjectSpec& object : experiment.objects) {
        const auto told = object.material.uncertainties.find("emittance");
        rig.emittances.push_back(object.material.emittance);
        rig.emittanceUncertainties.push_back(told == object.material.uncertainties.end() ? kEmittance
                                                                                         : told->second);
    }
    rig.sourceEmittanceUncertainty = source.emittanceUncertainty;
    if (source.uneven.isEven()) {
        rig.sourceTerms = {{RadiatingContour(source.shape)}};
        rig.emission = {source.model, source.emittance, experiment.environment_K};
        rig.emission.terms = {{source.emittance, {}}};
    } else {
        UnevenSource uneven = unevenSource(experiment, source.uneven, source.emittance);
        rig.sourceTerms = std::move(uneven.terms);
        rig.emission = std::move(uneven.emission);
    }
    return rig;
}

namespace {

CameraThermometerSetup cameraThermometerSetup(const Experiment& experiment, bool simulated) {
    const PlacedThermalCamera believed = believedThermalCamera(experiment, simulated).value();
    CameraThermometerSetup setup;
    setup.camera = believed.lens;
    setup.X_RC = believed.X_RC;
    setup.sight = believed.sight;
    setup.hasShutter = simulated;
    setup.objects = experiment.objects;
    setup.fixtures = experiment.fixtures;
    setup.shields = experiment.shields;
    setup.source = experiment.source.shape;
    setup.geometry = rigGeometry(experiment);
    setup.reflecting = reflectingRig(experiment);
    setup.environment_K = experiment.environment_K;
    setup.isSourceTracked = experiment.source.tracked;
    return setup;
}

std::unique_ptr<ObjectThermometer> objectThermometer(const Experiment& experiment, Thermometer& contact,
                                                     std::unique_ptr<CameraThermometer> camera) {
    std::vector<ReadBy> readBy;
    for (const ObjectSpec& object : experiment.objects)
        readBy.push_back(object.readBy);
    return std::make_unique<ObjectThermometer>(std::move(readBy), experiment.environment_K, contact,
                                               std::move(camera));
}

} // namespace

std::unique_ptr<CameraThermometer> cameraThermometer(const Experiment& experiment, SimulatedRig& rig) {
    if (rig.thermalCamera() == nullptr)
        return nullptr;
    return std::make_unique<CameraThermometer>(cameraThermometerSetup(experiment, true), *rig.thermalCamera(),
                                               rig.robot(), rig.heatSource(), rig.clock());
}

std::unique_ptr<ObjectThermometer> objectThermometer(const Experiment& experiment, SimulatedRig& rig) {
    auto camera = cameraThermometer(experiment, rig);
    return camera ? objectThermometer(experiment, rig.thermometer(), std::move(camera)) : nullptr;
}

std::unique_ptr<ObjectThermometer> objectThermometer(const Experiment& experiment, RealRig& rig,
                                                     const Clock& clock) {
    if (rig.thermalCamera() == nullptr)
        return nullptr;
    return objectThermometer(experiment, rig.thermometer(),
                             std::make_unique<CameraThermometer>(cameraThermometerSetup(experiment, false),
                                                                 *rig.thermalCamera(), rig.robot(),
                                                                 rig.heatSource(), clock));
}

} // namespace bask
