// The reactions of the servo loop to the findings of the safety monitor, by the alarm table.

#include "engine/base/message_code.h"
#include "engine/runtime/servo_loop.h"

#include <algorithm>
#include <cmath>

namespace bask {
namespace {

// A robot that has lost its position can still move off the source, and one that refused a step, or was late
// with one, may accept another; a robot in an alarm or paused cannot move.
bool allowsRetreat(const Message& alarm) {
    return alarm.code == MessageCode::RobotPlaceUnsure || alarm.code == MessageCode::RobotRestarted ||
           alarm.code == MessageCode::RobotElsewhere || alarm.code == MessageCode::RobotRefused ||
           alarm.code == MessageCode::ProgramRefuses || alarm.code == MessageCode::RobotSlow ||
           alarm.code == MessageCode::RobotStepLate;
}

/// Returns the problem; None for a device that is not set up.
Message wrong(const Message& problem) {
    return problem.code == MessageCode::RigIncomplete ? Message{} : problem;
}

} // namespace

std::optional<CameraOpinion> ServoLoop::opinion(std::size_t object) const {
    const ObjectThermometer* const byCamera = m_readings.byCamera();
    const CameraSample& sample = m_latest.objects[object].camera;
    if (byCamera == nullptr || m_experiment.objects[object].readBy != ReadBy::Both || std::isnan(sample.T_K))
        return std::nullopt;
    const CameraThermometer& camera = byCamera->camera();
    const SensorChannels& sensors = m_readings.sensors();
    const double contact_K = sensors.told_K(object, m_clock.now_s());
    return CameraOpinion{contact_K,
                         sensors.toldTime_s(object),
                         sample.T_K,
                         sample.uncertainty_K,
                         camera.reflected_K(object),
                         camera.explainingEmittance(object, contact_K)};
}

SafetyObservation ServoLoop::observe() const {
    const SensorChannels& sensors = m_readings.sensors();
    SafetyObservation seen;
    seen.now_s = m_clock.now_s();
    seen.sinceTick_s = m_tick_s ? seen.now_s - *m_tick_s : 0.0;
    for (std::size_t i = 0; i < sensors.size(); ++i) {
        ObservedObject object;
        object.age_s = sensors.age_s(i, seen.now_s);
        object.isInvalid = sensors.lastInvalid(i);
        object.isKnown = object.isInvalid || std::isfinite(object.age_s);
        object.isLost = !sensors.fresh(i, seen.now_s);
        object.fault = sensors.lastFault(i);
        object.reason = sensors.lastReason(i);
        object.opinion = opinion(i);
        if (m_readings.byCamera() != nullptr && m_experiment.objects[i].readBy == ReadBy::Both)
            object.unchecked = m_readings.byCamera()->camera().reason(i);
        object.jump = sensors.jump(i);
        object.largestRate_K_s = sensors.largestRate_K_s(i);
        if (m_latest.objects[i].valid)
            object.measured_K = m_latest.objects[i].measured_K;
        const double ofCamera_K = m_latest.objects[i].camera.uncertainty_K;
        if (m_experiment.objects[i].readBy == ReadBy::Camera && std::isfinite(ofCamera_K))
            object.uncertainty_K = ofCamera_K;
        object.viewFactor = m_latest.objects[i].viewFactor;
        object.target_K = m_experiment.objects[i].target_K;
        if (const HeatBounds* bounds = sensors.bounds(i))
            object.max_K = bounds->max_K();
        seen.objects.push_back(object);
    }
    seen.thermometerProblem = wrong(m_readings.thermometerProblem());
    if (const ObjectThermometer* byCamera = m_readings.byCamera())
        seen.cameraProblem = byCamera->cameraProblem();
    seen.robotProblem = wrong(m_readings.robotProblem());
    seen.robotAlarm = m_readings.robot().alarm;
    seen.isPlaceSure = m_readings.robot().isPlaceSure;
    if (seen.robotProblem.code == MessageCode::None && m_readings.geometry()) {
        seen.robotLag = m_motion.lag();
        seen.longestRetreat_m = m_retreat.longest_m();
    }
    const bool isTelling = m_readings.answers().hasRobot &&
                           m_readings.robotProblem().code == MessageCode::None &&
                           !m_motion.isHoming(); // Grbl is silent while homing
    seen.robotAge_s = isTelling ? seen.now_s - m_readings.robot().time_s : 0.0;
    seen.sourceProblem = wrong(m_readings.sourceProblem());
    seen.source_K = m_readings.source_K();
    const bool hasSource = m_readings.sourceProblem().code != MessageCode::RigIncomplete;
    seen.sourceAge_s = hasSource ? seen.now_s - m_readings.sourceRead_s() : 0.0;
    seen.sourceStrength = m_readings.sourceStrength();
    seen.asked_K = m_heat.asked_K();
    seen.readBack_K = m_devices.source.setPoint_K();
    seen.isManual = m_devices.source.isManual();
    seen.isSourceSwitched = m_devices.isReal;
    seen.hasWatchdog = m_devices.source.hasWatchdog();
    seen.isControlled = (m_state == RunState::Running || m_state == RunState::Settled) &&
                        m_control.compromise().code == MessageCode::None;
    seen.isHeatUnwanted = m_state == RunState::Stopping || m_state == RunState::Fault;
    seen.heatOffProblem = wrong(m_heat.offProblem());
    seen.guardProblem = m_devices.source.guardProblem();
    seen.isSourceDark = m_heat.isSourceDark();
    seen.isSourcePoseLost = !m_readings.isSourceSeen() && m_readings.wasSourceSeen();
    seen.diskFree_MB = m_diskFree_MB;
    return seen;
}

void ServoLoop::watch() {
    const SafetyObservation seen = observe();
    const SafetyChanges changes = m_safety.watch(seen);
    m_readings.sensors().advance(seen.sinceTick_s, m_safety.powers_K_s(seen));
    for (const SafetyFinding& finding : changes.ended)
        tellEnd(finding);
    for (const SafetyFinding& finding : changes.raised) {
        using Condition = SafetyCondition;
        if (m_runOn && finding.condition == Condition::HeatNotOff) // it has not ended as meant
            m_outcome = "fault";
        if (finding.condition == Condition::NotWarming || finding.condition == Condition::SensorNotOnObject ||
            finding.condition == Condition::SensorsSwapped)
            m_readings.sensors().doubt(finding.object);
        if (const auto other = m_safety.swappedWith(finding.object);
            other && finding.condition == Condition::SensorsSwapped)
            m_readings.sensors().doubt(*other);
        react(finding);
    }
    watchHeatInFault();
    watchLoss();
}

void ServoLoop::watchLoss() {
    if (m_safety.isLost() && (m_state == RunState::Running || m_state == RunState::Settled)) {
        holdFor(*m_safety.lost());
    } else if (m_safety.isLostTooLong() && m_state == RunState::Holding) {
        const SafetyFinding& lost = *m_safety.lost();
        std::vector<MessageArg> args{formatNumber(m_experiment.safety.pauseLimit_s)};
        const bool isSensor = alarmEntry(lost.condition).isOfObject;
        if (isSensor)
            args.push_back(m_experiment.objects[lost.object].name);
        event(isSensor ? MessageCode::EventSensorLostTooLong : MessageCode::EventSourceLostTooLong,
              std::move(args));
        stopWith(latched(lost)); // also in a hold by a person: nobody sees how hot the object is
    } else if (const SafetyFinding* lost = m_safety.lostSensor();
               lost != nullptr && m_safety.isLostTooLong() && isHeatedManually()) {
        stopWith(latched(*lost));
    }
}

void ServoLoop::react(const SafetyFinding& finding) {
    switch (alarmEntry(finding.condition).reaction) {
    case SafetyReaction::Note:
        return event(finding.message);
    case SafetyReaction::Hold:
        event(finding.message);
        return holdFor(finding);
    case SafetyReaction::Stop:
        return stopWith(latched(finding));
    case SafetyReaction::Retreat:
        return retreatFor(finding);
    case SafetyReaction::Halt:
        noteRefusedRetreat(finding.message);
        return faultWith(latched(finding));
    }
}

void ServoLoop::tellEnd(const SafetyFinding& finding) {
    const AlarmEntry& row = alarmEntry(finding.condition);
    const SensorChannels& sensors = m_readings.sensors();
    const bool isBelieved =
        !row.isOfObject || (sensors.isTrusted(finding.object) && sensors.jump(finding.object).inARow == 0);
    if (row.isLoss && row.isOfObject && isBelieved)
        event(MessageCode::EventSensorBack, {m_experiment.objects[finding.object].name});
    else if (row.isLoss && isBelieved)
        event(MessageCode::EventSourcePoseBack);
    else
        event(messageAbout(MessageCode::EventAlarmOver, finding.message));
    m_faults.noteOver(finding);
}

void ServoLoop::refusedByRobot(const Message& reason) {
    noteRefusedRetreat(reason);
    faultWith(latched(SafetyFinding{SafetyCondition::RobotAlarm, 0, reason}));
}

/// After a refused retreat no other one begins by itself: it would be refused, too.
void ServoLoop::noteRefusedRetreat(const Message& problem) {
    const bool isRefusal =
        problem.code == MessageCode::RobotRefused || problem.code == MessageCode::ProgramRefuses;
    if (m_state == RunState::Stopping && isRefusal)
        m_retreat.setRefused(true);
}

void ServoLoop::holdFor(const SafetyFinding& finding) {
    if (m_motion.isMoving()) {
        if (!m_motion.isHoming()) // if homing were stopped, it would lose its position
            m_motion.breakOff();
    } else if (m_state == RunState::Running || m_state == RunState::Settled) {
        m_state = RunState::Holding;
        m_pausedBySafety = true;
        m_motion.standStill();
        event(messageAbout(MessageCode::EventHeldFor, finding.message));
    }
}

void ServoLoop::addFault(LatchedFault fault) {
    const Message message = fault.message;
    if (m_faults.add(std::move(fault)))
        event(message);
}

void ServoLoop::fault(Message reason) {
    faultWith(latchedFault(std::move(reason)));
}

void ServoLoop::faultWith(LatchedFault reason) {
    if (m_runOn && m_state != RunState::Stopping)
        event(messageAbout(MessageCode::EventStoppedFor, reason.message));
    addFault(std::move(reason));
    if (m_state != RunState::Fault)
        endRun("fault");
    m_state = RunState::Fault;
}

void ServoLoop::stopFor(Message reason) {
    stopWith(latchedFault(std::move(reason)));
}

void ServoLoop::stopWith(LatchedFault reason) {
    if (!running())
        return faultWith(std::move(reason));
    const Message ended = messageAbout(MessageCode::EventStoppedFor, reason.message);
    addFault(std::move(reason));
    if (m_state != RunState::Stopping)
        (void)stopBy(ended);
}

void ServoLoop::retreatFor(const SafetyFinding& finding) {
    // in a fault the robot stands still until its motion was announced
    if (running() || m_state == RunState::Fault)
        return stopWith(latched(finding));
    addFault(latched(finding));
    beginRetreat();
}

void ServoLoop::reportSuspended(double slept_s) {
    const std::string time = formatNumber(slept_s, 3);
    event(MessageCode::EventSuspended, {time});
    if (running() || m_heat.isOn() || m_heat.asked_K() || m_motion.isMoving() ||
        !m_motion.rates().isZero(0.0))
        stopFor({MessageCode::SafetySuspended, {time}});
}

const SafetyFinding* ServoLoop::hot() const {
    const auto found = std::ranges::find_if(m_safety.active(), [](const SafetyFinding& finding) {
        return alarmEntry(finding.condition).reaction == SafetyReaction::Retreat;
    });
    return found == m_safety.active().end() ? nullptr : &*found;
}

Message ServoLoop::keepsFromRetreat() const {
    for (const SafetyFinding& finding : m_safety.active())
        if (finding.condition == SafetyCondition::RobotLost ||
            finding.condition == SafetyCondition::RobotSlow ||
            (finding.condition == SafetyCondition::RobotAlarm && !allowsRetreat(finding.message)))
            return finding.message;
    if (!m_readings.answers().hasRobot)
        return {MessageCode::CommandNotNow, {verbArg(CommandVerb::Retreat), "Connecting"}};
    if (m_motion.isHoming())
        return {MessageCode::CommandNotNow, {verbArg(CommandVerb::Retreat), "Homing"}};
    return {};
}

void ServoLoop::watchHeatInFault() {
    const SafetyFinding* const cause = hot();
    m_retreat.setRefused(m_retreat.isRefused() && cause != nullptr);
    const bool isWanted = m_state == RunState::Fault && cause != nullptr && !m_retreat.isRefused() &&
                          !m_retreat.isAway() && m_readings.robot().isPlaceSure &&
                          keepsFromRetreat().code == MessageCode::None;
    if (!m_retreat.announce(isWanted))
        return;
    event(messageAbout(MessageCode::EventRetreatFor, cause->message));
    beginRetreat();
}

std::optional<PendingAction> ServoLoop::pending() const {
    if (m_retreat.announced_s() && hot() != nullptr)
        return PendingAction{
            {MessageCode::ActionRetreat, {}}, hot()->message, *m_retreat.announced_s() - m_clock.now_s()};
    std::optional<PendingAction> next;
    const auto take = [&](MessageCode action, const Message& cause, double in_s) {
        if (!next || in_s < next->in_s)
            next = PendingAction{{action, {}}, cause, std::max(0.0, in_s)};
    };
    if (m_safety.isLost() && m_state == RunState::Holding)
        take(MessageCode::ActionEndRun, m_safety.lost()->message, m_safety.lostTooLongIn_s());
    if (m_safety.lostSensor() != nullptr && isHeatedManually())
        take(MessageCode::ActionHeatOff, m_safety.lostSensor()->message, m_safety.lostTooLongIn_s());
    const bool isRun = running() && m_state != RunState::Stopping;
    for (const auto& [finding, in_s] : m_safety.delayed()) {
        const SafetyReaction reaction = alarmEntry(finding.condition).reaction;
        if (reaction == SafetyReaction::Hold && isRun && m_state != RunState::Holding)
            take(MessageCode::ActionHold, finding.message, in_s);
        else if (reaction >= SafetyReaction::Stop && isRun)
            take(MessageCode::ActionEndRun, finding.message, in_s);
        else if (reaction >= SafetyReaction::Stop && isHeatedManually())
            take(MessageCode::ActionHeatOff, finding.message, in_s);
    }
    return next;
}

Message ServoLoop::remedy() const {
    if (m_state == RunState::Fault) {
        if (hot() != nullptr && !m_retreat.isAway() && keepsFromRetreat().code == MessageCode::None)
            return {MessageCode::RemedyRetreat, {}};
        if (const SafetyFinding* finding = m_safety.forbidsReset())
            return messageAbout(MessageCode::RemedyWait, finding->message);
        return {MessageCode::RemedyReset, {}};
    }
    if (m_state == RunState::Holding) {
        if (const SafetyFinding* finding = m_safety.forbidsResume())
            return messageAbout(MessageCode::RemedyStop, finding->message);
        if (m_pausedBySafety)
            return {MessageCode::RemedyResume, {}};
    }
    return {};
}

} // namespace bask
