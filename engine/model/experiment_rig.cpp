#include "engine/model/experiment_rig.h"

#include "engine/model/uneven_source.h"
#include "engine/thermography/usual_thermal_camera.h"

namespace bask {

std::vector<MountedContour> mountedContours(const Experiment& experiment) {
    std::vector<MountedContour> objects;
    for (const ObjectSpec& object : experiment.objects)
        objects.push_back({RadiatingContour(object.shape), poseFromCoordinates(object.mounting)});
    return objects;
}

Screens screensOf(const Experiment& experiment) {
    Screens screens;
    for (const PlateSpec& fixture : experiment.fixtures)
        screens.fixtures.push_back({RadiatingContour(fixture.shape), poseFromCoordinates(fixture.pose)});
    for (const PlateSpec& shield : experiment.shields)
        screens.shields.push_back({RadiatingContour(shield.shape), poseFromCoordinates(shield.pose)});
    return screens;
}

std::vector<std::string> takerNames(const Experiment& experiment) {
    std::vector<std::string> names;
    for (const ObjectSpec& object : experiment.objects)
        names.push_back(object.name);
    for (const PlateSpec& fixture : experiment.fixtures)
        names.push_back(fixture.name);
    for (const PlateSpec& shield : experiment.shields)
        names.push_back(shield.name);
    return names;
}

SilhouetteScene silhouetteScene(const Experiment& experiment) {
    SilhouetteScene scene;
    for (const ObjectSpec& object : experiment.objects)
        scene.objects.push_back({object.shape, poseFromCoordinates(object.mounting)});
    for (const PlateSpec& fixture : experiment.fixtures)
        scene.fixtures.push_back({fixture.shape, poseFromCoordinates(fixture.pose)});
    const Pose X_RS = poseFromCoordinates(experiment.source.pose);
    scene.fixed.push_back({experiment.source.shape, X_RS});
    for (const SourcePartSpec& part : experiment.source.uneven.parts)
        scene.fixed.push_back({part.shape, X_RS * poseFromCoordinates(part.pose)});
    for (const PlateSpec& shield : experiment.shields)
        scene.fixed.push_back({shield.shape, poseFromCoordinates(shield.pose)});
    return scene;
}

std::optional<PlacedThermalCamera> believedThermalCamera(const Experiment& experiment, bool simulated) {
    const auto profile = thermalProfile(experiment, simulated);
    if (!profile)
        return std::nullopt;
    const ThermalCalibration calibration = thermalCalibration(experiment, simulated);
    PlacedThermalCamera camera{calibration.lens.value_or(usualThermalLens(*profile)), {}, {}};
    if (calibration.pose) {
        camera.X_RC = poseFromCoordinates(*calibration.pose);
        camera.sight = calibration.poseUncertainty_m ? SightUncertainty{*calibration.poseUncertainty_m, 0.0}
                                                     : kTypedSight;
    } else if (simulated) {
        camera.X_RC = trueThermalPose(experiment);
    }
    return camera;
}

Pose trueThermalPose(const Experiment& experiment) {
    const auto& camera = experiment.simulation.thermalCamera;
    return camera && camera->pose ? poseFromCoordinates(*camera->pose) : usualThermalPose();
}

namespace {

std::shared_ptr<const RigGeometry> geometryWith(const Experiment& experiment,
                                                const std::vector<FaceMaterial>& fronts) {
    const SourceSpec& source = experiment.source;
    std::vector<Shape> shapes;
    std::vector<Vector6d> mountings;
    for (const ObjectSpec& object : experiment.objects) {
        shapes.push_back(object.shape);
        mountings.push_back(object.mounting);
    }
    auto even =
        std::make_shared<RigGeometry>(source.shape, shapes, mountings, experiment.robot,
                                      poseFromCoordinates(source.pose), fronts, screensOf(experiment));
    if (source.uneven.isEven())
        return even;
    UnevenSource uneven = unevenSource(experiment, source.uneven, source.emittance);
    return even->withSource(std::move(uneven.terms), std::move(uneven.emission), source.temperature_K);
}

} // namespace

std::shared_ptr<const RigGeometry> rigGeometry(const Experiment& experiment) {
    std::vector<FaceMaterial> fronts;
    for (const ObjectSpec& object : experiment.objects)
        fronts.push_back({object.material.emittance, object.material.absorptance});
    return geometryWith(experiment, fronts);
}

std::shared_ptr<const RigGeometry> rigGeometryWithoutExchange(const Experiment& experiment) {
    return geometryWith(experiment, {});
}

Surroundings surroundingsOf(const Experiment& experiment, double environment_K) {
    const SourceSpec& source = experiment.source;
    Surroundings surroundings =
        surroundingsOf(source.model, source.temperature_K, source.emittance, environment_K);
    surroundings.air = experiment.air;
    return surroundings;
}

Surroundings surroundingsOf(const Experiment& experiment) {
    return surroundingsOf(experiment, experiment.environment_K);
}

HeatRates heatRates(const ObjectSpec& object, const Surroundings& surroundings) {
    return heatRates(object.material, surroundings, shapeCharacteristicLength(object.shape));
}

HeatRates startRates(const ObjectSpec& object, const Surroundings& surroundings) {
    const HeatRates nominal = heatRates(object, surroundings);
    if (!object.estimatedRates)
        return nominal;
    HeatRates rates = *object.estimatedRates;
    rates.air = nominal.air.scaled(rates.lambda2 / nominal.lambda2);
    return rates;
}

} // namespace bask
