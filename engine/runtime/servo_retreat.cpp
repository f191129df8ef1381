// Every way from the heat: the retreat that ends a run, the one by the verb, and the one that is announced
// in a fault.

#include "engine/base/message_code.h"
#include "engine/control/velocity_solve.h"
#include "engine/runtime/servo_loop.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace bask {
namespace {

// A retreating robot that has not come nearer for so long will not: one may obey late and start slowly.
constexpr double kStill_s = 15.0;
constexpr double kStillPeriods = 3.0;
constexpr double kNearer = 1e-4; ///< m, rad: less is the jitter of what it tells
constexpr double kThere = 1e-3;  ///< m, rad: it is where it goes
constexpr double kNear = 5e-3;   ///< m, rad: it is as good as there, and stands
constexpr double kAnnounced_s = 10.0;

double farthest(const Vector6d& a, const Vector6d& b) {
    return (a - b).cwiseAbs().maxCoeff();
}

// Off the source a robot can go that has lost its place, and one that refused a step, or was late with one,
// may take another; one that is in an alarm or held cannot.
bool mayRetreatAllTheSame(const Message& alarm) {
    return alarm.code == MessageCode::RobotPlaceUnsure || alarm.code == MessageCode::RobotRestarted ||
           alarm.code == MessageCode::RobotElsewhere || alarm.code == MessageCode::RobotRefused ||
           alarm.code == MessageCode::RobotSlow;
}

} // namespace

void Approach::begin(double now_s) {
    m_nearer_s = now_s;
    m_left = std::numeric_limits<double>::infinity();
    m_isStill = false;
}

void Approach::add(double now_s, double left, double period_s) {
    if (left < m_left - kNearer) {
        m_left = left;
        m_nearer_s = now_s;
    }
    m_isStill = now_s - m_nearer_s >= std::max(kStill_s, kStillPeriods * period_s);
}

Message ServoLoop::keepsFromRetreat() const {
    for (const SafetyFinding& finding : m_safety.active())
        if (finding.condition == SafetyCondition::RobotLost ||
            finding.condition == SafetyCondition::RobotSlow ||
            (finding.condition == SafetyCondition::RobotAlarm && !mayRetreatAllTheSame(finding.message)))
            return finding.message;
    if (!m_hasRobot)
        return {MessageCode::CommandNotNow, {verbArg(CommandVerb::Retreat), "Connecting"}};
    if (m_isHoming)
        return {MessageCode::CommandNotNow, {verbArg(CommandVerb::Retreat), "Homing"}};
    return {};
}

Result<void> ServoLoop::retreatNow() {
    if (const Message reason = keepsFromRetreat(); reason.code != MessageCode::None)
        return Error(reason.code, {}, reason.args);
    command("retreat");
    if (m_state == RunState::Stopping)
        return {};
    if (running())
        return stop();
    event(MessageCode::EventRetreat);
    beginRetreat();
    return {};
}

void ServoLoop::beginRetreat() {
    m_state = RunState::Stopping;
    m_handHeat_K.reset();
    m_goal.reset();
    m_retreatAt_s.reset();
    m_retreatRaised = false;
    m_approach.begin(m_clock.now_s());
    m_devices.robot.setRetreating(true);
    switchHeatOff();
    retreat(); // at once: the last velocity must not go on sideways
}

void ServoLoop::stopFor(Message reason) {
    stopWith(latched(std::move(reason)));
}

void ServoLoop::stopWith(Latched reason) {
    if (!running()) {
        faultWith(std::move(reason));
        return;
    }
    const Message ended = messageAbout(MessageCode::EventStoppedFor, reason.message);
    addFault(std::move(reason));
    if (m_state != RunState::Stopping)
        (void)stopBy(ended);
}

void ServoLoop::retreatFor(const SafetyFinding& finding) {
    if (running() || m_state == RunState::Fault) // a fault stands still until it has said that it will move
        return stopWith(latched(finding));
    addFault(latched(finding));
    beginRetreat();
}

const SafetyFinding* ServoLoop::hot() const {
    const auto found = std::ranges::find_if(m_safety.active(), [](const SafetyFinding& finding) {
        return alarmEntry(finding.condition).reaction == SafetyReaction::Retreat;
    });
    return found == m_safety.active().end() ? nullptr : &*found;
}

bool ServoLoop::isAway() const {
    return farthest(poseOffSource(*m_geometry, m_coordinates), m_coordinates) <= kNear;
}

void ServoLoop::watchHeatInFault() {
    const SafetyFinding* const cause = hot();
    m_isRetreatRefused = m_isRetreatRefused && cause != nullptr;
    if (m_state != RunState::Fault || cause == nullptr || m_isRetreatRefused || isAway() ||
        !m_robot.isPlaceSure || keepsFromRetreat().code != MessageCode::None) {
        m_retreatAt_s.reset();
        return;
    }
    if (!m_retreatAt_s)
        m_retreatAt_s = m_clock.now_s() + kAnnounced_s;
    if (m_clock.now_s() < *m_retreatAt_s - 1e-9)
        return;
    const Message message = messageAbout(MessageCode::EventRetreatFor, cause->message);
    event(message.code, message.args);
    beginRetreat();
}

void ServoLoop::retreat() {
    // Off the source's plane first, then level: never sideways near the source. A robot that does not know
    // its place only goes off.
    const RobotLimits& limits = m_experiment.robot;
    const double now_s = m_clock.now_s();
    const double period_s = m_experiment.sampling.period_s;
    if (m_isHoming) // it takes no velocity until then
        return m_approach.begin(now_s);
    // A robot whose limits let it come no nearer is there as well.
    const auto isThere = [&](const Vector6d& goal) {
        const double left = farthest(goal, m_coordinates);
        m_approach.add(now_s, left, period_s);
        return left <= kThere || (m_approach.isStill() && (left <= kNear || m_rates.isZero(1e-9)));
    };
    Vector6d goal = poseOffSource(*m_geometry, m_coordinates);
    bool isOver = false;
    if (!m_retreatRaised && isThere(goal)) {
        m_retreatRaised = true;
        m_approach.begin(now_s);
    }
    if (m_retreatRaised) {
        goal = m_coordinates;
        for (int k = kThetaX; k <= kThetaZ; ++k)
            if (limits.free[static_cast<std::size_t>(k)] && m_robot.isPlaceSure)
                goal[k] = std::clamp(0.0, limits.lower[k], limits.upper[k]);
        isOver = isThere(goal);
    }
    if (isOver)
        return endRetreat();
    if (m_approach.isStill()) {
        m_isRetreatRefused = true; // by the robot: another one by itself would not move either
        const double left_m = (goal - m_coordinates).head<3>().norm();
        return fault({MessageCode::RobotDoesNotMove, {formatNumber(std::round(left_m * 1e3) * 0.1, 3)}});
    }
    const VelocitySolution way = velocityTowards(*m_geometry, m_coordinates, goal, period_s, m_rates);
    m_latest.limits = way.limits;
    move(way.rates);
}

void ServoLoop::endRetreat() {
    const bool isOfRun = m_runOn;
    const std::string outcome = m_faults.empty() ? m_outcome : "fault";
    trace();
    if (m_runOn)
        m_latest.time_s = m_clock.now_s() - m_startTime_s;
    endRun(outcome);
    if (!m_faults.empty())
        m_state = RunState::Fault;
    else
        m_state = isOfRun ? RunState::Stopped : RunState::NotReady;
}

std::optional<PendingAction> ServoLoop::pending() const {
    const double now_s = m_clock.now_s();
    if (m_retreatAt_s && hot() != nullptr)
        return PendingAction{{MessageCode::ActionRetreat, {}}, hot()->message, *m_retreatAt_s - now_s};
    std::optional<PendingAction> next;
    const auto take = [&](MessageCode action, const Message& cause, double in_s) {
        if (!next || in_s < next->in_s)
            next = PendingAction{{action, {}}, cause, std::max(0.0, in_s)};
    };
    if (m_safety.isLost() && m_state == RunState::Holding)
        take(MessageCode::ActionEndRun, m_safety.lost()->message, m_safety.lostTooLongIn_s());
    if (m_safety.lostSensor() != nullptr && isHeatedByHand())
        take(MessageCode::ActionHeatOff, m_safety.lostSensor()->message, m_safety.lostTooLongIn_s());
    const bool isRun = running() && m_state != RunState::Stopping;
    for (const auto& [finding, in_s] : m_safety.delayed()) {
        const SafetyReaction reaction = alarmEntry(finding.condition).reaction;
        if (reaction == SafetyReaction::Hold && isRun && m_state != RunState::Holding)
            take(MessageCode::ActionHold, finding.message, in_s);
        else if (reaction >= SafetyReaction::Stop && isRun)
            take(MessageCode::ActionEndRun, finding.message, in_s);
        else if (reaction >= SafetyReaction::Stop && isHeatedByHand())
            take(MessageCode::ActionHeatOff, finding.message, in_s);
    }
    return next;
}

Message ServoLoop::remedy() const {
    if (m_state == RunState::Fault) {
        if (hot() != nullptr && !isAway() && keepsFromRetreat().code == MessageCode::None)
            return {MessageCode::RemedyRetreat, {}};
        if (const SafetyFinding* finding = m_safety.forbidsReset())
            return messageAbout(MessageCode::RemedyWait, finding->message);
        return {MessageCode::RemedyReset, {}};
    }
    if (m_state == RunState::Holding) {
        if (const SafetyFinding* finding = m_safety.forbidsResume())
            return messageAbout(MessageCode::RemedyStop, finding->message);
        if (m_heldBySafety)
            return {MessageCode::RemedyResume, {}};
    }
    return {};
}

} // namespace bask
