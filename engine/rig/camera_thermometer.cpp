#include "engine/rig/camera_thermometer.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace bask {
namespace {

constexpr double kKept_s = 5.0;          // of moments, longer than any frame is under way
constexpr double kSinceShutter_s = 90.0; // when a shutter closed last is not told: half of a usual period

/// Small objects a metre away have few pixels; that is part of the uncertainty.
FacePixelOptions fewPixels() {
    FacePixelOptions options;
    options.minPixels = 5;
    return options;
}

} // namespace

CameraThermometer::CameraThermometer(CameraThermometerSetup setup, ThermalCamera& camera, Robot& robot,
                                     HeatSource& source)
    : m_setup(std::move(setup)), m_camera(camera), m_robot(robot), m_source(source), m_rays(m_setup.camera),
      m_zeros(m_setup.objects.size()), m_readings(m_setup.objects.size()), m_reasons(m_setup.objects.size()) {
}

std::optional<double> CameraThermometer::seenSource_K() {
    m_wasHeated = m_wasHeated || m_source.heating();
    if (m_setup.hasShutter && !m_source.heating())
        return m_setup.environment_K;
    const auto reading = m_source.read();
    return reading && reading->valid ? std::optional(reading->value_K) : std::nullopt;
}

Vector6d CameraThermometer::placeAt(double time_s) const {
    for (std::size_t k = m_moments.size(); k-- > 1;) {
        const Moment &a = m_moments[k - 1], &b = m_moments[k];
        if (time_s >= a.time_s)
            return a.q + std::clamp((time_s - a.time_s) / (b.time_s - a.time_s), 0.0, 1.0) * (b.q - a.q);
    }
    return m_moments.front().q;
}

const CameraThermometer::Moment& CameraThermometer::nearest(double time_s) const {
    return *std::ranges::min_element(m_moments, {},
                                     [&](const Moment& moment) { return std::abs(moment.time_s - time_s); });
}

std::vector<ReadObject> CameraThermometer::objectsAt(const Vector6d& q, double source_K) const {
    constexpr double kEmittance = 0.01, kRoom_K = 0.3, kSource_K = 1.0, kViewFactor = 0.005;
    const Eigen::VectorXd F = m_setup.geometry->viewFactorsFast(q);
    const Pose X_RE = poseFromCoordinates(q);
    std::vector<ReadObject> out;
    for (std::size_t i = 0; i < m_setup.objects.size(); ++i) {
        const ObjectSpec& object = m_setup.objects[i];
        const double emittance = object.material.emittance, room_K = m_setup.environment_K;
        const double seen = std::clamp(F[static_cast<Eigen::Index>(i)], 0.0, 1.0);
        ReadObject read;
        read.plate = {object.shape, X_RE * poseFromCoordinates(object.mounting)};
        read.front = {{emittance, {{seen, source_K, m_setup.sourceEmittance}}, room_K},
                      kEmittance,
                      kRoom_K,
                      {{kViewFactor, kSource_K, kEmittance}}};
        read.back = {{emittance, {}, room_K}, kEmittance, kRoom_K, {}};
        out.push_back(std::move(read));
    }
    return out;
}

std::vector<PlacedPlate> CameraThermometer::screensAt(const Vector6d& q) const {
    const Pose X_RE = poseFromCoordinates(q);
    std::vector<PlacedPlate> out{{m_setup.source, m_setup.geometry->X_RS()}};
    for (const PlateSpec& fixture : m_setup.fixtures)
        out.push_back({fixture.shape, X_RE * poseFromCoordinates(fixture.pose)});
    for (const PlateSpec& shield : m_setup.shields)
        out.push_back({shield.shape, poseFromCoordinates(shield.pose)});
    return out;
}

Result<std::vector<Reading>> CameraThermometer::read() {
    constexpr double kAsCold_K = 10.0; // how far a camera that is not yet zeroed may be off
    constexpr double kKnown_K = 0.1;   // how well the objects' temperature is known then
    const auto state = m_robot.state();
    if (!state)
        return state.error();
    const Moment now{state->time_s, state->coordinates, state->isPlaceSure, seenSource_K()};
    if (!m_moments.empty() && now.time_s <= m_moments.back().time_s)
        m_moments.pop_back();
    m_moments.push_back(now);
    while (m_moments.size() > 2 && m_moments[1].time_s < now.time_s - kKept_s)
        m_moments.pop_front();
    const auto newest = m_camera.newest();
    if (!newest)
        return newest.error();
    const ThermalCameraFrame& frame = **newest;
    if (frame.number == m_number)
        return m_readings;
    m_number = frame.number;
    const Moment& then = nearest(frame.time_s);
    const Vector6d q = placeAt(frame.time_s);
    const std::vector<ReadObject> objects = objectsAt(q, then.source_K.value_or(m_setup.environment_K));
    const std::vector<PlacedPlate> screens = screensAt(q);
    const auto readAll = [&] {
        return readObjects(thermalBand(), frame.frame.picture, m_rays, m_setup.X_RC, objects, screens,
                           m_zeros, {}, kSinceShutter_s, fewPixels());
    };
    auto read = readAll();
    bool isZeroed = false;
    for (std::size_t i = 0; i < read.size(); ++i) {
        if (m_zeros[i] || m_wasHeated || !then.isPlaceSure || !read[i] ||
            std::abs(read[i]->region.mean_K - m_setup.environment_K) > kAsCold_K)
            continue;
        const KnownFace& face = read[i]->seen.isFront ? objects[i].front : objects[i].back;
        m_zeros[i] = zeroAt(thermalBand(), face.surroundings, m_setup.environment_K, kKnown_K,
                            read[i]->region.mean_K, read[i]->region.standardError_K);
        isZeroed = true;
    }
    if (isZeroed)
        read = readAll();
    for (std::size_t i = 0; i < read.size(); ++i) {
        m_reasons[i] = read[i] ? Message{} : read[i].error().message;
        const bool isUsable =
            read[i] && m_zeros[i] && then.isPlaceSure && (then.source_K || !read[i]->seen.isFront);
        m_readings[i] = isUsable ? Reading{frame.time_s, read[i]->face.T_K, true, SensorFault::None,
                                           read[i]->face.standardUncertainty_K}
                                 : Reading{frame.time_s, 0.0, false, SensorFault::Other};
    }
    return m_readings;
}

} // namespace bask
