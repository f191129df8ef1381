// One sampling period of the servo loop: read, watch, control, record.

#include "engine/base/message_code.h"
#include "engine/control/velocity_solve.h"
#include "engine/runtime/servo_loop.h"

#include <algorithm>
#include <cmath>
#include <exception>
#include <limits>

namespace bask {
namespace {

constexpr double kSettledAfter_s = 30.0; ///< all objects within the band for this long is "settled"
constexpr double kTooNear = 0.8; ///< of the clearance: the source has come nearer, or the robot obeys late
constexpr double kHeatPeriods = 3.0; ///< heat goes off by itself after this many periods
// A source that has moved by less is taken to lie still: less than the resolution of the sensors in any F.
constexpr double kTrifle_m = 2e-4;
constexpr double kTrifle_rad = 2e-3;
constexpr double kHomingStarts_s = 2.0; ///< from being asked for
constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

} // namespace

void ServoLoop::tick() {
    try {
        look();
        watch();
        m_tick_s = m_clock.now_s();
        if (m_state == RunState::Running || m_state == RunState::Settled)
            control();
        else if (m_state == RunState::Stopping)
            retreat();
        else if (m_state == RunState::Fault && !m_isHoming)
            makeSafe();
        else if (isByHand())
            goOn();
        if (m_state == RunState::Holding || isHeatedByHand())
            keepHeating();
        else if (m_state != RunState::Running && m_state != RunState::Settled)
            keepOff();
        trace();
        if (m_isCooling && isCold()) {
            event(MessageCode::EventCold);
            endCooling();
        }
        updateReadiness();
    } catch (const std::exception& exception) {
        fault({MessageCode::ReasonInternalFault, {exception.what()}});
    }
}

void ServoLoop::look() {
    readSensors();
    readSourcePose();
    readRobotAndSource();
}

void ServoLoop::readSensors() {
    const auto readings = m_devices.thermometer.read();
    if (readings)
        m_sensors.add(*readings);
    m_hasThermometer = m_hasThermometer || readings;
    m_thermometerProblem = problemOf(readings, m_hasThermometer);
    m_sampleTime_s = m_clock.now_s();
    takeReadings();
}

void ServoLoop::takeReadings() {
    const double now_s = m_clock.now_s();
    m_latest.objects.resize(m_sensors.size());
    const std::vector<double> truth = m_devices.truth ? m_devices.truth() : std::vector<double>();
    for (std::size_t i = 0; i < m_sensors.size(); ++i) {
        ObjectSample& object = m_latest.objects[i];
        const bool fresh = m_sensors.fresh(i, now_s);
        object.valid = fresh && !m_sensors.lastInvalid(i);
        object.measured_K = object.valid ? m_sensors.measured_K(i) : kNaN;
        const auto estimate = fresh ? m_sensors.estimate(i) : std::nullopt;
        // After a reading that dropped out the estimate is carried on to now.
        object.estimated_K =
            estimate ? estimate->temperature_K + estimate->rate_K_s * m_sensors.age_s(i, now_s) : kNaN;
        object.rate_K_s = estimate ? estimate->rate_K_s : kNaN;
        object.target_K = m_experiment.objects[i].target_K;
        object.true_K = i < truth.size() ? truth[i] : kNaN;
        object.lambda1 = i < m_belief.size() ? m_belief[i].lambda1 : kNaN;
        object.lambda2 = i < m_belief.size() ? m_belief[i].lambda2 : kNaN;
    }
}

void ServoLoop::readSourcePose() {
    if (!m_experiment.source.tracked || m_devices.tracker == nullptr)
        return;
    const auto reading = m_devices.tracker->read();
    if (!reading || !reading->valid || !reading->X_RS.matrix().allFinite() || !facesObjects(reading->X_RS))
        return;
    m_sourceSeen_s = reading->seen_s; // not time_s: a prediction is no sight
    m_sourceReading = *reading;
    const Pose moved = m_geometry->X_RS().inverse() * reading->X_RS;
    if (moved.translation().norm() < kTrifle_m && Eigen::AngleAxisd(moved.linear()).angle() < kTrifle_rad)
        return;
    m_geometry = m_geometry->withSourceAt(reading->X_RS);
    m_latest.source = coordinatesFromPose(reading->X_RS);
    if (m_controller)
        m_controller->setGeometry(m_geometry);
}

// A source that has all of them behind it is none that was moved but one mismeasured: to get off it the robot
// would go down to where it truly is.
bool ServoLoop::facesObjects(const Pose& X_RS) const {
    const Pose X_SE = X_RS.inverse() * poseFromCoordinates(m_coordinates);
    return std::ranges::any_of(m_experiment.objects, [&](const ObjectSpec& object) {
        return (X_SE * object.mounting.head<3>()).z() > 0.0;
    });
}

void ServoLoop::readRobotAndSource() {
    const auto robot = m_devices.robot.state();
    m_hasRobot = m_hasRobot || robot;
    m_robotProblem = problemOf(robot, m_hasRobot);
    if (robot) {
        m_robot = *robot;
        m_isHomingSeen = m_isHomingSeen || robot->moving;
        const bool mayBegin = !m_isHomingSeen && m_clock.now_s() - m_homingSince_s < kHomingStarts_s;
        m_isHoming = m_isHoming && (robot->moving || mayBegin);
        m_coordinates = robot->coordinates;
        m_latest.coordinates = m_coordinates;
        readViewFactors();
    }
    const auto source = m_devices.source.read();
    m_hasSource = m_hasSource || source;
    m_sourceProblem = problemOf(source, m_hasSource);
    m_source_K.reset();
    if (!source || !source->valid)
        return;
    m_sourceRead_s = m_devices.source.isByHand() ? m_clock.now_s() : source->time_s;
    m_source_K = source->value_K;
    m_latest.source_K = source->value_K;
    const SourceSpec& spec = m_experiment.source;
    const double T3 = environment_K();
    m_sourceStrength = netSourcePower_W_m2(spec.model, source->value_K, spec.emittance, T3) /
                       netSourcePower_W_m2(spec.model, spec.temperature_K, spec.emittance, T3);
}

void ServoLoop::readViewFactors() {
    // Inside of the source no object can be: a robot that says so has its axes' origins wrong.
    if (m_devices.isReal && m_geometry->lowestPoint_m(m_coordinates) <= 0.0) {
        m_robot.isPlaceSure = false;
        for (ObjectSample& object : m_latest.objects)
            object.viewFactor = kNaN;
        return;
    }
    const Eigen::VectorXd F = m_geometry->viewFactorsFast(m_coordinates);
    for (std::size_t i = 0; i < m_latest.objects.size(); ++i)
        m_latest.objects[i].viewFactor = F[static_cast<Eigen::Index>(i)];
}

SafetyObservation ServoLoop::observe() const {
    SafetyObservation seen;
    seen.now_s = m_clock.now_s();
    seen.sinceTick_s = m_tick_s ? seen.now_s - *m_tick_s : 0.0;
    for (std::size_t i = 0; i < m_sensors.size(); ++i) {
        ObservedObject object;
        object.age_s = m_sensors.age_s(i, seen.now_s);
        object.isInvalid = m_sensors.lastInvalid(i);
        object.isKnown = object.isInvalid || std::isfinite(object.age_s);
        object.isLost = !m_sensors.fresh(i, seen.now_s);
        object.fault = m_sensors.lastFault(i);
        object.jump = m_sensors.jump(i);
        object.largestRate_K_s = m_sensors.largestRate_K_s(i);
        if (m_latest.objects[i].valid)
            object.measured_K = m_latest.objects[i].measured_K;
        object.viewFactor = m_latest.objects[i].viewFactor;
        if (const HeatBounds* bounds = m_sensors.bounds(i))
            object.most_K = bounds->max_K();
        seen.objects.push_back(object);
    }
    const auto wrong = [](const Message& problem) { // not that there is none
        return problem.code == MessageCode::RigIncomplete ? Message{} : problem;
    };
    seen.thermometerProblem = wrong(m_thermometerProblem);
    seen.robotProblem = wrong(m_robotProblem);
    seen.robotAlarm = m_robot.alarm;
    seen.isPlaceSure = m_robot.isPlaceSure;
    const bool isTelling =
        m_hasRobot && m_robotProblem.code == MessageCode::None && !m_isHoming; // then Grbl is silent
    seen.robotAge_s = isTelling ? seen.now_s - m_robot.time_s : 0.0;
    seen.sourceProblem = wrong(m_sourceProblem);
    seen.source_K = m_source_K;
    seen.sourceAge_s = m_sourceProblem.code == MessageCode::RigIncomplete ? 0.0 : seen.now_s - m_sourceRead_s;
    seen.sourceStrength = m_sourceStrength;
    seen.asked_K = m_asked_K;
    seen.readBack_K = m_devices.source.setPoint_K();
    seen.isByHand = m_devices.source.isByHand();
    seen.isSourceSwitched = m_devices.isReal;
    seen.hasWatchdog = m_devices.source.hasWatchdog();
    seen.isHeatUnwanted = m_state == RunState::Stopping || m_state == RunState::Fault;
    seen.heatOffProblem = wrong(m_heatOffProblem);
    seen.guardProblem = m_devices.source.guardProblem();
    seen.isSourceDark = isSourceDark();
    seen.isSourcePoseLost = !sourceSeen() && m_sourceSeen_s >= 0.0;
    seen.diskFree_MB = m_diskFree_MB;
    return seen;
}

void ServoLoop::watch() {
    const SafetyObservation seen = observe();
    const SafetyChanges changes = m_safety.watch(seen);
    m_sensors.advance(seen.sinceTick_s, m_safety.powers_K_s(seen));
    for (const SafetyFinding& finding : changes.ended)
        tellEnd(finding);
    for (const SafetyFinding& finding : changes.raised) {
        if (finding.condition == SafetyCondition::NotWarming)
            m_sensors.doubt(finding.object);
        react(finding);
    }
    watchHeatInFault();
    if (m_safety.isLost() && (m_state == RunState::Running || m_state == RunState::Settled)) {
        holdFor(*m_safety.lost());
    } else if (m_safety.isLostTooLong() && m_state == RunState::Holding) {
        const SafetyFinding& lost = *m_safety.lost();
        std::vector<MessageArg> args{formatNumber(m_experiment.safety.heldLimit_s)};
        const bool isSensor = alarmEntry(lost.condition).isOfObject;
        if (isSensor)
            args.push_back(m_experiment.objects[lost.object].name);
        event(isSensor ? MessageCode::EventSensorLostTooLong : MessageCode::EventSourceLostTooLong,
              std::move(args));
        stopWith(latched(*m_safety.lost())); // whoever holds: nobody sees how hot the object is
    } else if (const SafetyFinding* lost = m_safety.lostSensor();
               lost != nullptr && m_safety.isLostTooLong() && isHeatedByHand()) {
        stopWith(latched(*lost));
    }
}

void ServoLoop::react(const SafetyFinding& finding) {
    const Message& message = finding.message;
    switch (alarmEntry(finding.condition).reaction) {
    case SafetyReaction::Note:
        return event(message.code, message.args);
    case SafetyReaction::Hold:
        event(message.code, message.args);
        return holdFor(finding);
    case SafetyReaction::Stop:
        return stopWith(latched(finding));
    case SafetyReaction::Retreat:
        return retreatFor(finding);
    case SafetyReaction::Halt:
        noteRefusedRetreat(message);
        return faultWith(latched(finding));
    }
}

/// Another retreat by itself would be refused, too.
void ServoLoop::noteRefusedRetreat(const Message& problem) {
    if (m_state == RunState::Stopping && problem.code == MessageCode::RobotRefused)
        m_isRetreatRefused = true;
}

void ServoLoop::tellEnd(const SafetyFinding& finding) {
    const AlarmEntry& row = alarmEntry(finding.condition);
    if (row.isLoss && row.isOfObject)
        event(MessageCode::EventSensorBack, {m_experiment.objects[finding.object].name});
    else if (row.isLoss)
        event(MessageCode::EventSourcePoseBack);
    else {
        const Message over = messageAbout(MessageCode::EventAlarmOver, finding.message);
        event(over.code, over.args);
    }
}

void ServoLoop::keepHeating() {
    const double validFor_s = kHeatPeriods * m_experiment.sampling.period_s;
    const auto result = m_devices.source.keepHeating(*heatSetPoint_K(), validFor_s);
    if (!result)
        return stopWith(latched(SafetyFinding{SafetyCondition::SourceLost, 0, result.error().message}));
    m_asked_K = *heatSetPoint_K();
    m_heatOffProblem = {};
}

bool ServoLoop::isHeatedByHand() const {
    return m_handHeat_K && (isByHand() || m_state == RunState::Armed);
}

void ServoLoop::keepOff() {
    if (m_heatOffProblem.code != MessageCode::None || m_devices.source.heating())
        switchHeatOff();
}

void ServoLoop::control() {
    keepHeating();
    if (m_state != RunState::Running && m_state != RunState::Settled)
        return; // the heat source is lost and the retreat has begun: its velocity stands
    const bool known = std::ranges::all_of(m_latest.objects, [](const ObjectSample& object) {
        return std::isfinite(object.estimated_K) && std::isfinite(object.rate_K_s);
    });
    if (!known || !(m_sourceStrength > 0.0)) {
        standStill();
        return;
    }
    Observation observation;
    observation.time_s = m_clock.now_s() - m_startTime_s;
    observation.coordinates = m_coordinates;
    observation.sourceStrength = m_sourceStrength;
    observation.lastRates = m_rates;
    for (const ObjectSample& object : m_latest.objects)
        observation.objects.push_back({object.estimated_K, object.rate_K_s});
    const ControlOutput output = m_controller->step(observation, m_experiment.sampling.period_s);

    m_belief = output.belief;
    m_latest.smallestSingularValue = output.smallestSingularValue;
    m_latest.limits = output.limits;
    if (m_geometry->lowestPoint_m(m_coordinates) < kTooNear * m_experiment.robot.clearance_m)
        backOff();
    else
        move(output.rates);
    noteSettling();
    noteCompromise(output);
}

void ServoLoop::backOff() {
    const Vector6d goal = poseOffSource(*m_geometry, m_coordinates);
    m_latest.limits.add(Limit::Clearance);
    move(velocityTowards(*m_geometry, m_coordinates, goal, m_experiment.sampling.period_s, m_rates).rates);
}

void ServoLoop::move(const Vector6d& rates) {
    move(rates, kVelocityPeriods * m_experiment.sampling.period_s);
}

void ServoLoop::move(const Vector6d& rates, double validFor_s) {
    m_rates = rates;
    m_latest.twist.head<3>() = rates.head<3>();
    m_latest.twist.tail<3>() = rotationAxes(m_coordinates) * rates.tail<3>();
    if (const auto result = m_devices.robot.setTwist(m_latest.twist, validFor_s); !result) {
        noteRefusedRetreat(result.error().message);
        faultWith(latched(SafetyFinding{SafetyCondition::RobotAlarm, 0, result.error().message}));
    }
}

void ServoLoop::standStill() {
    // A dead link is known already; the velocity then expires in the robot.
    (void)m_devices.robot.halt();
    m_rates.setZero();
    m_latest.twist.setZero();
    m_latest.limits = {}; // nothing is held back
}

void ServoLoop::noteSettling() {
    const double now_s = m_clock.now_s();
    if (!allWithinBand()) {
        m_withinBandSince_s = now_s;
        if (m_state == RunState::Settled)
            m_state = RunState::Running;
    } else if (m_state == RunState::Running && now_s - m_withinBandSince_s >= kSettledAfter_s) {
        m_state = RunState::Settled;
        event(MessageCode::EventSettled);
    }
}

void ServoLoop::noteCompromise(const ControlOutput& output) {
    m_compromise.clear();
    for (std::size_t i = 0; i < output.compromise_K.size(); ++i) {
        const double error_K = output.compromise_K[i] - m_experiment.objects[i].target_K;
        m_compromise.push_back({m_experiment.objects[i].name, error_K});
    }
    if (!m_compromise.empty() && !m_compromiseTold) {
        event(MessageCode::EventCompromise, {MessageArg::differences(m_compromise)});
        m_compromiseTold = true;
    }
}

bool ServoLoop::isSourceDark() const {
    constexpr double kDark_K = 10.0; // over the room
    const bool isCool = m_source_K && *m_source_K < m_experiment.environment_K + kDark_K;
    return !m_asked_K && (!m_devices.isReal || isCool);
}

bool ServoLoop::isCold() const {
    constexpr double kCold_K = 313.15;
    constexpr double kOverRoom_K = 5.0;
    const bool isHeatOff = !m_asked_K && (m_devices.source.isByHand() || heatState() == HeatState::Off);
    const bool areApart = isSourceDark() || isAway(); // before a hot source they go on warming
    return isHeatOff && areApart && std::ranges::all_of(m_latest.objects, [&](const ObjectSample& object) {
               return object.estimated_K < std::max(kCold_K, environment_K() + kOverRoom_K);
           });
}

void ServoLoop::trace() {
    if (!m_runOn && !m_isCooling)
        return;
    m_latest.time_s = m_clock.now_s() - m_startTime_s;
    m_record.samples.push_back(m_latest);
}

} // namespace bask
