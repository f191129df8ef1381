#include "engine/simulation/simulated_rig.h"

#include <Eigen/LU>

#include <algorithm>
#include <cmath>

namespace bask {

MountedObjects mountedObjects(const SimulatedRigConfig& config) {
    std::vector<MountedContour> objects;
    for (const SimulatedObject& object : config.objects)
        objects.push_back({RadiatingContour(object.shape), poseFromCoordinates(object.mounting)});
    return MountedObjects(std::move(objects), config.screens, poseFromCoordinates(config.sourcePose));
}

ThermalPlant thermalPlant(const SimulatedRigConfig& config, const MountedObjects& objects) {
    std::vector<PlantObject> plates;
    std::vector<FaceMaterial> fronts;
    for (const SimulatedObject& object : config.objects) {
        plates.push_back({object.material, config.environment_K, shapeCharacteristicLength(object.shape)});
        fronts.push_back({object.material.emittance, object.material.absorptance});
    }
    return {std::move(plates), config.sourceModel, config.environment_K, config.air,
            Neighbours(objects, fronts)};
}

SimulatedSourceFace::SimulatedSourceFace(const SimulatedRigConfig& config)
    : m_emission(config.sourceEmission),
      m_source(m_emission.isEven()
                   ? RadiatingSource(RadiatingContour(config.source))
                   : RadiatingSource(config.sourceTerms, m_emission.factors(config.sourceTemperature_K))),
      m_source_K(config.sourceTemperature_K) {}

bool SimulatedSourceFace::setTemperature(double source_K) {
    if (m_emission.isEven() || source_K == m_source_K)
        return false;
    m_source_K = source_K;
    m_source = m_source.withFactors(m_emission.factors(source_K));
    return true;
}

SimulatedRig::SimulatedRig(const SimulatedRigConfig& config)
    : m_config(config), m_objects(mountedObjects(config)), m_plant(thermalPlant(config, m_objects)),
      m_robot(config.robot, m_clock), m_thermometer(config.thermometer, m_clock),
      m_source(config.sourceTemperature_K, config.environment_K, m_clock), m_tracker(config.tracker, m_clock),
      m_camera(config.camera), m_face(config), m_X_RS(poseFromCoordinates(config.sourcePose)) {
    if (config.thermalCamera) {
        m_thermalCamera.emplace(*config.thermalCamera);
        m_backs = m_objects.turnedOver(m_X_RS);
        m_betweenFaces = faceViewFactors(m_objects);
    }
    m_F.assign(m_objects.size(), 0.0);
    m_isHot.assign(m_objects.size(), false);
    m_thermometer.observe(trueTemperatures_K());
    m_tracker.observe(m_X_RS);
    showCameras();
}

std::vector<double> SimulatedRig::trueTemperatures_K() const {
    std::vector<double> out;
    for (std::size_t i = 0; i < m_plant.size(); ++i)
        out.push_back(m_plant.temperature_K(i));
    return out;
}

RigCondition SimulatedRig::condition() const {
    return {m_clock.now_s(), trueTemperatures_K(), m_source.heatedTo_K(), m_robot.coordinates(),
            m_thermometer.offsets_K()};
}

void SimulatedRig::use(const RigCondition& condition) {
    m_clock.advanceTo(condition.time_s);
    for (std::size_t i = 0; i < std::min(condition.objects_K.size(), m_plant.size()); ++i)
        if (std::isfinite(condition.objects_K[i]))
            m_plant.warm(i, condition.objects_K[i] - m_plant.temperature_K(i));
    m_thermometer.useOffsets(condition.sensorOffsets_K);
    if (condition.source_K)
        m_source.setHeatedTo(*condition.source_K);
    if (condition.coordinates)
        m_robot.placeAt(*condition.coordinates);
    m_thermometer.observe(trueTemperatures_K());
    m_tracker.observe(m_X_RS);
    showCameras();
}

void SimulatedRig::advance(double dt_s) {
    const int steps = std::max(1, static_cast<int>(std::ceil(dt_s / kStep_s - 1e-9)));
    const double start_s = m_clock.now_s();
    for (int i = 0; i < steps; ++i)
        step(i + 1 == steps ? start_s + dt_s : start_s + dt_s * (i + 1) / steps);
}

void SimulatedRig::step(double until_s) {
    const double dt_s = until_s - m_clock.now_s();
    m_robot.advance(dt_s);
    const bool open = m_source.heating();
    if (open && !m_heated)
        m_heatedSince_s = m_clock.now_s();
    m_heated = open;
    if (open && !m_config.sourceMotion.empty())
        moveSource(poseFromCoordinates(
            valueAt(m_config.sourceMotion, until_s - m_heatedSince_s, m_config.sourcePose)));
    seeSource();
    const double J = open ? netSourcePower_W_m2(m_config.sourceModel, m_source.temperature_K(),
                                                m_config.sourceEmittance, m_config.environment_K)
                          : 0.0;
    m_plant.advance(dt_s, m_F, J);
    for (std::size_t i = 0; i < m_isHot.size(); ++i)
        if (m_isHot[i])
            m_plant.warm(i, kHot_K_s * dt_s);
    m_source.advance(dt_s);
    m_clock.advanceTo(until_s);
    m_thermometer.observe(trueTemperatures_K());
    m_tracker.observe(m_X_RS);
    showCameras();
}

void SimulatedRig::moveSource(const Pose& X_RS) {
    const bool isSame = X_RS.matrix() == m_X_RS.matrix();
    m_X_RS = X_RS;
    if (isSame || m_config.screens.shields.empty())
        return;
    m_objects.setSourceAt(X_RS);
    m_backs.setSourceAt(X_RS);
    m_computedAt.reset(); // end-effector and source may have moved as one, but not the shields
}

void SimulatedRig::showCameras() {
    m_camera.observe({m_clock.now_s(), poseFromCoordinates(m_robot.coordinates()), m_X_RS});
    if (m_thermalCamera)
        m_thermalCamera->observe(thermalMoment());
}

ThermalMoment SimulatedRig::thermalMoment() const {
    const double room_K = m_config.environment_K, source_K = m_heated ? m_source.temperature_K() : room_K;
    ThermalMoment moment{m_clock.now_s(), poseFromCoordinates(m_robot.coordinates()), m_X_RS, {}, {}};
    for (const auto& plate : m_thermalCamera->config().source)
        moment.source_K.push_back(plate.temperature.at_K(source_K, room_K));
    const std::size_t N = m_objects.size();
    const std::vector<double> received = bandRadiances(source_K);
    for (std::size_t i = 0; i < N; ++i) {
        const double emittance = m_config.objects[i].material.emittance;
        const auto face = [&](double radiance) {
            return FaceSurroundings{emittance, {}, m_thermalCamera->band().temperature(radiance)};
        };
        moment.objects.push_back({std::clamp(m_plant.temperature_K(i), kMinBand_K, kMaxBand_K),
                                  face(received[i]), face(received[N + i])});
    }
    return moment;
}

/// What falls on the faces in the thermal camera's band, fronts and then backs, as the radiance that all
/// around would have to have: of the source as its terms radiate, of the other faces by the net-radiation
/// method, and of the room.
std::vector<double> SimulatedRig::bandRadiances(double source_K) const {
    const BandRadiance& band = m_thermalCamera->band();
    const double room_K = m_config.environment_K, room = band.radiance(room_K);
    const SourceEmission& emission = m_face.emission();
    std::vector<double> brighter; // than the room, of each term
    if (emission.isEven())
        brighter = {m_config.sourceEmittance * (band.radiance(source_K) - room)};
    for (const EmissionTerm& term : emission.terms) {
        // At the edge of a ring the radiance falls by what two temperatures about that of the edge differ by.
        const auto at_K = [&](double rises) {
            PartTemperature part = term.temperature;
            part.ratio += term.rise ? rises * term.rise->ratio : 0.0;
            part.offset_K += term.rise ? rises * term.rise->offset_K : 0.0;
            return part.at_K(source_K, room_K);
        };
        const double outside = term.rise ? band.radiance(at_K(0.5)) : room;
        brighter.push_back(term.emittance * (band.radiance(at_K(-0.5)) - outside));
    }
    const std::size_t N = m_objects.size();
    const auto count = static_cast<Eigen::Index>(2 * N);
    const Pose X_SE = m_X_RS.inverse() * poseFromCoordinates(m_robot.coordinates());
    const bool isComputed = m_computedAt && X_SE.matrix() == m_computedAt->matrix(); // by seeSource()
    const RadiatingSource source = m_face.source().withFactors(brighter);
    Eigen::VectorXd received(count), emitted(count), reflectance(count);
    for (std::size_t f = 0; f < 2 * N; ++f) {
        const std::size_t i = f % N;
        const auto k = static_cast<Eigen::Index>(f);
        const double emittance = m_config.objects[i].material.emittance;
        const double T_K = std::clamp(m_plant.temperature_K(i), kMinBand_K, kMaxBand_K);
        const bool isKnown = f < N && emission.isEven() && isComputed;
        const MountedObjects& faces = f < N ? m_objects : m_backs;
        received[k] = isKnown ? m_F[i] * brighter.front()
                      : source_K > room_K
                          ? faces.viewFactorValue(source, i, X_SE, m_config.viewFactorTolerance)
                          : 0.0;
        emitted[k] = emittance * (band.radiance(T_K) - room);
        reflectance[k] = 1.0 - emittance;
    }
    if (m_betweenFaces.size() > 0) {
        const Eigen::MatrixXd A = Eigen::MatrixXd::Identity(count, count) -
                                  m_betweenFaces * reflectance.asDiagonal().toDenseMatrix();
        received = A.partialPivLu().solve(received + m_betweenFaces * emitted).eval();
    }
    std::vector<double> out;
    for (const double above : received)
        out.push_back(room + above);
    return out;
}

void SimulatedRig::seeSource() {
    const Pose X_SE = m_X_RS.inverse() * poseFromCoordinates(m_robot.coordinates());
    const bool isOther = m_face.setTemperature(m_source.temperature_K());
    if (!isOther && m_computedAt && X_SE.matrix() == m_computedAt->matrix())
        return;
    for (std::size_t i = 0; i < m_objects.size(); ++i)
        m_F[i] = m_objects.viewFactorValue(m_face.source(), i, X_SE, m_config.viewFactorTolerance);
    m_computedAt = X_SE;
}

} // namespace bask
