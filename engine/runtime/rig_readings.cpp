#include "engine/runtime/rig_readings.h"

#include "engine/base/message_code.h"
#include "engine/base/words.h"
#include "engine/rig/rig_setup.h"
#include "engine/runtime/safety_monitor.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace bask {
namespace {

// A real robot's steps are rounded: when it moves along a limit, every second step would be outside, and not
// be sent.
constexpr double kMargin_m = 2e-5;
constexpr double kMargin_rad = 1e-4;
// A source that has moved by less counts as not moved: the effect on F is below the resolution of the
// sensors.
constexpr double kSourceStill_m = 2e-4;
constexpr double kSourceStill_rad = 2e-3;
constexpr double kSourceSame_K = 1.0; // the weights of an uneven source change by some 1e-4 of themselves
constexpr double kConnecting_s = 3.0;
constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

Experiment insideLimits(Experiment experiment) {
    RobotLimits& limits = experiment.robot;
    limits.clearance_m += kMargin_m;
    for (int k = 0; k < 6; ++k) {
        const double margin = k < 3 ? kMargin_m : kMargin_rad;
        if (limits.upper[k] - limits.lower[k] < 4.0 * margin)
            continue;
        limits.lower[k] += margin;
        limits.upper[k] -= margin;
    }
    return experiment;
}

} // namespace

RigReadings::RigReadings(const Experiment& experiment, const RigDevices& devices, const Clock& clock,
                         TraceSample& sample)
    : m_experiment(experiment), m_devices(devices), m_clock(clock), m_sample(sample),
      m_geometry(rigGeometry(devices.isReal ? insideLimits(experiment) : experiment)),
      m_sensors(experiment.objects.size(), experiment.sampling, sensorLimits(experiment)),
      m_coordinates(experiment.start), m_sourceRead_s(clock.now_s()) {
    m_answers.made_s = clock.now_s();
    m_sample.source = experiment.source.pose;
}

void RigReadings::read() {
    readSourcePose();
    readSensors();
    readRobot();
    readSource();
}

void RigReadings::readSensors() {
    if (m_devices.byCamera != nullptr && m_experiment.source.tracked)
        m_devices.byCamera->camera().setSource(
            wasSourceSeen() && isSourceSeen() ? std::optional(m_sourceReading.X_RS) : std::nullopt);
    const auto readings = m_devices.thermometer.read();
    if (readings)
        m_sensors.add(*readings);
    m_answers.hasThermometer = m_answers.hasThermometer || readings;
    m_thermometerProblem = problemOf(readings, m_answers.hasThermometer);
    if (readings && m_devices.byCamera != nullptr)
        m_thermometerProblem = m_devices.byCamera->contactProblem();
    m_sampleTime_s = m_clock.now_s();
    takeSensors();
}

void RigReadings::takeSensors() {
    const double now_s = m_clock.now_s();
    m_sample.objects.resize(m_sensors.size());
    const std::vector<double> truth = m_devices.truth ? m_devices.truth() : std::vector<double>();
    for (std::size_t i = 0; i < m_sensors.size(); ++i) {
        ObjectSample& object = m_sample.objects[i];
        const bool fresh = m_sensors.fresh(i, now_s);
        object.valid = fresh && !m_sensors.lastInvalid(i);
        object.measured_K = object.valid ? m_sensors.measured_K(i) : kNaN;
        const auto estimate = fresh ? m_sensors.estimate(i) : std::nullopt;
        // After a missing reading the estimate is extrapolated to now.
        object.estimated_K =
            estimate ? estimate->temperature_K + estimate->rate_K_s * m_sensors.age_s(i, now_s) : kNaN;
        object.rate_K_s = estimate ? estimate->rate_K_s : kNaN;
        object.target_K = m_experiment.objects[i].target_K;
        object.true_K = i < truth.size() ? truth[i] : kNaN;
        if (m_devices.byCamera != nullptr)
            object.camera = m_devices.byCamera->camera().sample(i);
    }
}

void RigReadings::readSourcePose() {
    if (!m_experiment.source.tracked || m_devices.tracker == nullptr)
        return;
    const auto reading = m_devices.tracker->read();
    if (!reading || !reading->valid || !reading->X_RS.matrix().allFinite() || !facesObjects(reading->X_RS))
        return;
    m_sourceSeen_s = reading->seen_s; // not time_s, because a prediction is not a sight
    m_sourceReading = *reading;
    const Pose moved = m_geometry->X_RS().inverse() * reading->X_RS;
    if (moved.translation().norm() < kSourceStill_m &&
        Eigen::AngleAxisd(moved.linear()).angle() < kSourceStill_rad)
        return;
    m_geometry = m_geometry->withSourceAt(reading->X_RS);
    m_sample.source = coordinatesFromPose(reading->X_RS);
}

// A measured pose with all objects behind the source is wrong: to move off the source, the robot would move
// towards where the source truly is.
bool RigReadings::facesObjects(const Pose& X_RS) const {
    const Pose X_SE = X_RS.inverse() * poseFromCoordinates(m_coordinates);
    return std::ranges::any_of(m_experiment.objects, [&](const ObjectSpec& object) {
        return (X_SE * object.mounting.head<3>()).z() > 0.0;
    });
}

void RigReadings::readRobot() {
    const auto robot = m_devices.robot.state();
    m_isRobotTelling = robot.ok();
    m_answers.hasRobot = m_answers.hasRobot || robot;
    m_robotProblem = problemOf(robot, m_answers.hasRobot);
    if (!robot)
        return;
    m_robot = *robot;
    m_coordinates = robot->coordinates;
    m_sample.coordinates = m_coordinates;
    readViewFactors();
}

void RigReadings::readViewFactors() {
    // No object can be inside the source: a robot that reports this has wrong axis origins.
    if (m_devices.isReal && m_geometry->lowestPoint_m(m_coordinates) <= -m_geometry->floor_m()) {
        m_robot.isPlaceSure = false;
        for (ObjectSample& object : m_sample.objects)
            object.viewFactor = object.unshadedViewFactor = kNaN;
        return;
    }
    const Eigen::VectorXd F = m_geometry->viewFactorsFast(m_coordinates);
    if (m_geometry->mayShade())
        m_geometry->unshadedViewFactors(m_coordinates, m_unshaded);
    else
        m_unshaded = F;
    for (std::size_t i = 0; i < m_sample.objects.size(); ++i) {
        m_sample.objects[i].viewFactor = F[static_cast<Eigen::Index>(i)];
        m_sample.objects[i].unshadedViewFactor = m_unshaded[static_cast<Eigen::Index>(i)];
    }
}

void RigReadings::readSource() {
    const auto source = m_devices.source.read();
    m_answers.hasSource = m_answers.hasSource || source;
    m_sourceProblem = problemOf(source, m_answers.hasSource);
    m_source_K.reset();
    if (!source || !source->valid)
        return;
    m_sourceRead_s = m_devices.source.isManual() ? m_clock.now_s() : source->time_s;
    m_source_K = source->value_K;
    m_sample.source_K = source->value_K;
    const SourceSpec& spec = m_experiment.source;
    const double T3 = environment_K();
    if (!m_geometry->isSourceEven() && std::abs(source->value_K - m_geometry->source_K()) > kSourceSame_K) {
        m_geometry = m_geometry->withSourceTemperature(source->value_K);
        if (m_isRobotTelling)
            readViewFactors();
    }
    m_sourceStrength = netSourcePower_W_m2(spec.model, source->value_K, spec.emittance, T3) /
                       surroundingsOf(m_experiment, T3).netSourcePower_W_m2;
}

double RigReadings::sourceAge_s() const {
    return m_sample.source_K > 0.0 ? m_clock.now_s() - m_sourceRead_s
                                   : std::numeric_limits<double>::infinity();
}

double RigReadings::environment_K() const {
    return m_sensors.zeroing() ? m_sensors.zeroing()->environment_K : m_experiment.environment_K;
}

bool RigReadings::isSourceSeen() const {
    constexpr double kUnseen_s = 3.0; // a hand in front of the marker is not a loss
    constexpr double kUnseenPeriods = 3.0;
    const double max_s = std::max(kUnseen_s, kUnseenPeriods * m_experiment.sampling.period_s);
    return !m_experiment.source.tracked || m_clock.now_s() - m_sourceSeen_s <= max_s;
}

std::optional<SourceTracking> RigReadings::tracking() const {
    if (!m_experiment.source.tracked)
        return std::nullopt;
    const PoseReading& reading = m_sourceReading;
    SourceTracking tracking;
    tracking.isSeen = reading.valid && isSourceSeen();
    tracking.isPredicted = reading.predicted;
    tracking.age_s = m_clock.now_s() - reading.seen_s;
    tracking.latency_s = reading.latency_s;
    tracking.position_m = reading.position_m;
    tracking.angle_rad = reading.angle_rad;
    return tracking;
}

bool RigReadings::isAwaited(bool hasAnswered) const {
    return m_devices.isReal && !hasAnswered && m_clock.now_s() - m_answers.made_s <= kConnecting_s;
}

bool RigReadings::isConnecting() const {
    return isAwaited(m_answers.hasThermometer) || isAwaited(m_answers.hasRobot) ||
           isAwaited(m_answers.hasSource);
}

std::vector<Message> RigReadings::missing() const {
    std::vector<Message> out;
    for (const Message& problem : {m_robotProblem, m_thermometerProblem, m_sourceProblem})
        if (problem.code == MessageCode::RigIncomplete)
            out.push_back(problem);
    return out;
}

Result<void> RigReadings::requireFreshSensor(std::size_t object) const {
    if (!m_sensors.isTrusted(object)) {
        const Message why = distrust(object);
        return Error(why.code, {}, why.args);
    }
    if (m_sensors.fresh(object, m_clock.now_s()))
        return {};
    Message why = noReading(object);
    return Error(why.code, {}, std::move(why.args));
}

Result<void> RigReadings::requireFreshSensors() const {
    for (std::size_t i = 0; i < m_sensors.size(); ++i)
        if (auto fresh = requireFreshSensor(i); !fresh)
            return fresh;
    return {};
}

Message RigReadings::noReading(std::size_t object) const {
    const std::string& name = m_experiment.objects[object].name;
    if (const Message& reason = m_sensors.lastReason(object); reason.code != MessageCode::None)
        return {MessageCode::SafetyCameraCannotRead, {name, reason}};
    return {MessageCode::ReasonSensorInvalid, {name}};
}

Message RigReadings::distrust(std::size_t object) const {
    const std::string& name = m_experiment.objects[object].name;
    const MessageArg told = roundedTemperatureArg(m_sensors.told_K(object, m_clock.now_s()));
    if (!m_sensors.isDistrusted(object))
        return {MessageCode::ReasonSensorDoubted, {name, told}};
    const HeatBounds* const bounds = m_sensors.bounds(object);
    const bool isPossible = bounds->contain(m_sensors.told_K(object, m_clock.now_s()), 0.0);
    return {isPossible ? MessageCode::ReasonSensorUndecided : MessageCode::ReasonSensorDistrusted,
            {name, told, roundedTemperatureArg(bounds->min_K()), roundedTemperatureArg(bounds->max_K())}};
}

bool RigReadings::allWithinBand() const {
    return !m_sample.objects.empty() && std::ranges::all_of(m_sample.objects, [](const ObjectSample& object) {
        return std::abs(object.estimated_K - object.target_K) <= kSettledBand_K; // false for NaN
    });
}

MessageArg RigReadings::objectsOffTarget() const {
    std::vector<ObjectKelvin> off;
    for (std::size_t i = 0; i < m_sample.objects.size(); ++i) {
        const double error_K = m_sample.objects[i].estimated_K - m_sample.objects[i].target_K;
        if (!(std::abs(error_K) <= kSettledBand_K))
            off.push_back({m_experiment.objects[i].name, error_K});
    }
    return MessageArg::differences(std::move(off));
}

} // namespace bask
