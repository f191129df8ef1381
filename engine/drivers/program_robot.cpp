#include "engine/drivers/program_robot.h"

#include "engine/base/message_code.h"
#include "engine/base/translated.h"
#include "engine/base/units.h"
#include "engine/drivers/driver_catalogue.h"
#include "engine/drivers/driver_make.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

namespace bask {
namespace {

using Kind = ProgramRequest::Kind;

constexpr double kMetre_mm = 1000.0;
constexpr double kHaltAgain_s = 0.2, kStandsWithin_s = 5.0;
constexpr double kToStop_s = 0.5; ///< what a velocity that has ended may go on for
constexpr double kKnown_s = 0.5;  ///< from an older place no velocity is planned
constexpr double kBehind = 0.5;   ///< share of a step that a robot on its way may be off

/// Of the axes' units, mm and degrees, in one of the program's.
double unitOf(const AxisSpec& axis) {
    return axis.coordinate < kThetaX ? kMetre_mm : degFromRad(1.0);
}

std::vector<int> coordinatesOf(const std::vector<AxisSpec>& axes) {
    std::vector<int> out;
    out.reserve(axes.size());
    for (const AxisSpec& axis : axes)
        out.push_back(axis.coordinate);
    return out;
}

} // namespace

ProgramRobot::ProgramRobot(ByteLink& link, const Clock& clock, AxisMap map, MotionGuard guard, bool mustHome)
    : m_talk(link, clock, ProgramRole::Robot), m_clock(clock),
      m_planner(std::move(map),
                [this, guard = std::move(guard)](const Vector6d& target) {
                    return isWithinLimits(target) && guard(target);
                }),
      m_mustHome(mustHome) {}

void ProgramRobot::work() {
    const auto taken = [this](const ProgramLine& line, const ProgramRequest* asked) { take(line, asked); };
    switch (m_talk.work(taken)) {
    case ProgramTalk::Turn::Closed:
        m_planner.forget();
        return;
    case ProgramTalk::Turn::Opened:
        begin();
        return;
    case ProgramTalk::Turn::Open:
        break;
    }
    if (m_isHalted && m_clock.now_s() - m_stopped_s > kHaltAgain_s) {
        tellStop();
    } else if (!m_isHalted) {
        move();
    }
}

void ProgramRobot::tellStop() {
    m_stopped_s = m_clock.now_s();
    m_talk.send(Kind::Stop);
}

/// Nothing is known of one that has started: it is told to stand.
void ProgramRobot::begin() {
    m_planner.forget();
    m_state.reset();
    m_at.clear();
    m_order.clear();
    m_rates.clear();
    m_ratesUntil_s = -1e300;
    m_step.reset();
    m_spanFrom.clear();
    m_isHalted = true;
    m_halted_s = m_stopped_s = 1e300; // until it has said hello
    m_isHomed = m_isHomeAsked = m_isHomingStopped = false;
    m_hasRestarted = m_hasRestarted || m_wasLive; // it may count its place anew
    m_refused.clear();
}

void ProgramRobot::take(const ProgramLine& line, const ProgramRequest* asked) {
    if (const auto* hello = std::get_if<ProgramHello>(&line.what))
        takeHello(*hello);
    else if (const auto* state = std::get_if<ProgramRobotState>(&line.what))
        takeState(*state, m_talk.measuredAt_s(line, asked), asked != nullptr);
    else if (const auto* refusal = std::get_if<ProgramRefusal>(&line.what))
        takeRefusal(asked->kind, refusal->words);
}

void ProgramRobot::takeHello(const ProgramHello& hello) {
    const std::vector<AxisSpec>& axes = m_planner.map().axes();
    for (const int axis : hello.axes) {
        const auto found = std::ranges::find(axes, axis, &AxisSpec::coordinate);
        if (found != axes.end())
            m_order.push_back(static_cast<std::size_t>(found - axes.begin()));
    }
    if (m_order.size() != hello.axes.size() || m_order.size() != axes.size())
        return m_talk.refuse("it moves " + coordinateNames(hello.axes) + ", and the rig's axes are " +
                             coordinateNames(coordinatesOf(axes)));
    m_halted_s = m_clock.now_s();
    tellStop(); // before anything else
}

void ProgramRobot::takeState(const ProgramRobotState& state, double at_s, bool isAsked) {
    if (state.position.size() != m_order.size())
        return m_talk.complain("a position of " + std::to_string(state.position.size()) +
                               " axes instead of " + std::to_string(m_order.size()));
    m_at.resize(m_order.size());
    // As the planner rounds: at a limit it is not beyond it.
    for (std::size_t i = 0; i < m_order.size(); ++i) {
        const double position = state.position[i] * unitOf(m_planner.map().axes()[m_order[i]]);
        m_at[m_order[i]] = std::round(position * 1000.0) / 1000.0;
    }
    m_at_s = at_s;
    m_state = state;
    m_wasLive = true;
    if (!state.alarm.empty())
        m_planner.forget();
    if (m_isHomeAsked && !state.isMoving && at_s > m_homeSent_s && !m_talk.isWaitingFor(Kind::Home)) {
        m_isHomeAsked = false;
        m_isHomed = state.isSure;
        m_spanFrom.clear();
        if (m_isHomed) {
            m_elsewhere.reset();
            m_isHomingStopped = m_hasRestarted = false;
        }
    }
    checkPlace();
    if (m_isHalted && !state.isMoving && isAsked && at_s > m_stopped_s && !m_talk.isWaitingFor(Kind::Stop))
        m_isHalted = false;
}

/// It may be anywhere between where it was and where its command brings it; at rest it stays.
void ProgramRobot::checkPlace() {
    if (m_isHomeAsked) {
        m_spanFrom.clear();
        return;
    }
    if (!m_spanFrom.empty())
        if (const double error = outside(m_at, m_spanFrom, m_spanTo); error > kElsewhere) {
            m_elsewhere = error;
            m_spanFrom.clear();
            (void)halt();
            return;
        }
    // By the time of the measurement, which may be old; once, so that creeping is seen.
    const double end_s = std::max(m_ratesUntil_s, m_step ? m_stepSent_s + m_step->time_s : m_ratesUntil_s);
    const bool isResting = !m_state->isMoving && m_at_s > end_s + kToStop_s;
    if (m_spanFrom.empty() || (isResting && !m_isResting)) {
        m_spanFrom = m_spanTo = m_at;
        m_step.reset();
    }
    m_isResting = isResting;
}

void ProgramRobot::takeRefusal(Kind kind, const std::string& words) {
    m_refused = words;
    m_planner.forget();
    if (kind == Kind::Home)
        m_isHomeAsked = false;
    if (kind == Kind::Velocity || kind == Kind::Step)
        (void)halt();
}

void ProgramRobot::move() {
    if (!m_talk.isLive() || m_at.empty() || m_isHomeAsked || keepsFromTwist().code != MessageCode::None)
        return;
    if (m_clock.now_s() - m_at_s > kKnown_s)
        return;
    // One at a time, or they would queue up.
    const bool takesVelocities = m_talk.hello()->takesVelocities;
    if (m_talk.isWaitingFor(takesVelocities ? Kind::Velocity : Kind::Step))
        return;
    if (takesVelocities)
        sendVelocity();
    else
        sendStep();
}

/// From where it is by now, as it was told to move.
void ProgramRobot::sendVelocity() {
    const double now_s = m_clock.now_s();
    if (std::exchange(m_isTwistNew, false))
        m_planner.renew();
    std::vector<double> from = m_at;
    const double since_s = std::clamp(std::min(now_s, m_ratesUntil_s) - m_at_s, 0.0, StepPlanner::kLongest_s);
    for (std::size_t i = 0; i < m_rates.size(); ++i)
        from[i] += since_s * m_rates[i];
    const auto plan = m_planner.next(from, now_s);
    if (!plan) {
        if (m_planner.isRefused() && now_s < m_ratesUntil_s)
            (void)halt();
        return;
    }
    std::vector<double> reach = plan->to;
    m_rates.resize(from.size());
    for (std::size_t i = 0; i < from.size(); ++i) {
        m_rates[i] = (plan->to[i] - from[i]) / plan->time_s;
        reach[i] += kToStop_s * m_rates[i];
    }
    m_ratesUntil_s = now_s + plan->time_s;
    m_talk.sendVelocity(ownUnits(m_rates), plan->time_s);
    allow(from);
    allow(reach);
}

/// From the end of the last one if that is on its way there, so that the robot need not stand between them.
void ProgramRobot::sendStep() {
    const double now_s = m_clock.now_s();
    const bool isOn = isOnItsWay();
    if (m_step && !isOn && m_state->isMoving)
        return;
    const auto plan = m_planner.next(isOn ? m_step->to : m_at, now_s);
    if (!plan)
        return;
    m_step = plan;
    m_stepSent_s = now_s;
    m_talk.sendStep(ownUnits(plan->to), plan->time_s);
    m_spanFrom = m_spanTo = m_at;
    allow(plan->from);
    allow(plan->to);
}

/// About as far on its way as it should be.
bool ProgramRobot::isOnItsWay() const {
    if (!m_step || m_at_s < m_stepSent_s)
        return false;
    const double share = std::clamp((m_at_s - m_stepSent_s) / m_step->time_s, 0.0, 1.0);
    for (std::size_t i = 0; i < m_at.size(); ++i) {
        const double way = m_step->to[i] - m_step->from[i];
        if (std::abs(m_at[i] - m_step->from[i] - share * way) > StepPlanner::kSlack + kBehind * std::abs(way))
            return false;
    }
    return true;
}

void ProgramRobot::allow(const std::vector<double>& place) {
    if (m_spanFrom.empty())
        m_spanFrom = m_spanTo = place;
    for (std::size_t i = 0; i < place.size(); ++i) {
        const auto [min, max] = std::minmax({m_spanFrom[i], m_spanTo[i], place[i]});
        m_spanFrom[i] = min;
        m_spanTo[i] = max;
    }
}

std::vector<double> ProgramRobot::ownUnits(const std::vector<double>& positions) const {
    std::vector<double> out;
    for (const std::size_t axis : m_order)
        out.push_back(positions[axis] / unitOf(m_planner.map().axes()[axis]));
    return out;
}

bool ProgramRobot::isWithinLimits(const Vector6d& target) const {
    if (!m_talk.hello())
        return false;
    const std::vector<AxisSpec>& axes = m_planner.map().axes();
    const std::vector<double> positions = m_planner.map().positions(target);
    for (std::size_t i = 0; i < axes.size(); ++i) {
        const auto& [min, max] = m_talk.hello()->limits[static_cast<std::size_t>(axes[i].coordinate)];
        const double own = positions[i] / unitOf(axes[i]);
        if (own < min || own > max)
            return false;
    }
    return true;
}

RobotReach ProgramRobot::reach() const {
    RobotReach out;
    if (!m_talk.hello())
        return out;
    const std::vector<AxisSpec>& axes = m_planner.map().axes();
    std::vector<double> first, last;
    for (const AxisSpec& axis : axes) {
        const auto& [min, max] = m_talk.hello()->limits[static_cast<std::size_t>(axis.coordinate)];
        first.push_back(min * unitOf(axis));
        last.push_back(max * unitOf(axis));
    }
    const Vector6d a = m_planner.map().coordinates(first), b = m_planner.map().coordinates(last);
    for (const AxisSpec& axis : axes) { // an axis may be reversed
        out.lower[axis.coordinate] = std::min(a[axis.coordinate], b[axis.coordinate]);
        out.upper[axis.coordinate] = std::max(a[axis.coordinate], b[axis.coordinate]);
    }
    return out;
}

bool ProgramRobot::isMoving() const {
    const double now_s = m_clock.now_s();
    const bool isCommanded = m_talk.isWaitingFor(Kind::Step) || m_talk.isWaitingFor(Kind::Velocity) ||
                             now_s < m_ratesUntil_s || (m_step && now_s < m_stepSent_s + m_step->time_s);
    return (m_state && m_state->isMoving) || isCommanded || m_isHomeAsked || m_isHalted;
}

bool ProgramRobot::isPlaceSure() const {
    return m_state && m_state->isSure && !m_elsewhere && !m_isHomingStopped && !m_hasRestarted &&
           (m_isHomed || !m_mustHome);
}

Message ProgramRobot::alarm() const {
    if (m_state && !m_state->alarm.empty())
        return {MessageCode::RobotReports, {m_state->alarm}};
    if (!m_refused.empty())
        return {MessageCode::ProgramRefuses, {m_talk.name(), m_refused}};
    if (m_talk.isSlow())
        return {MessageCode::RobotSlow, {formatNumber(ProgramTalk::kSlow_s)}};
    if (m_isHalted && m_state && m_state->isMoving && m_clock.now_s() - m_halted_s > kStandsWithin_s)
        return {MessageCode::RobotReports, {"it says that it moves, although it was told to stop"}};
    if (m_hasRestarted)
        return {MessageCode::RobotRestarted, {}};
    if (m_elsewhere)
        return {MessageCode::RobotElsewhere, {formatNumber(*m_elsewhere, 2), formatNumber(kElsewhere)}};
    if (!isPlaceSure())
        return {MessageCode::RobotPlaceUnsure, {}};
    return {};
}

/// A retreat with a place that is not sure is better than objects before the heat.
Message ProgramRobot::keepsFromTwist() const {
    const Message what = alarm();
    const bool isOfPlace =
        what.code == MessageCode::RobotElsewhere || what.code == MessageCode::RobotRestarted ||
        what.code == MessageCode::RobotPlaceUnsure || what.code == MessageCode::ProgramRefuses;
    return m_isRetreating && isOfPlace ? Message{} : what;
}

DeviceStatus ProgramRobot::status() const {
    DeviceStatus out = m_talk.status();
    if (out.problem.code == MessageCode::None && m_planner.isRefused())
        out.problem = {MessageCode::RobotStepOutside, {}};
    return out;
}

// What it refused keeps no object before the heat.
void ProgramRobot::setRetreating(bool isRetreating) {
    m_isRetreating = isRetreating;
    if (isRetreating)
        m_refused.clear();
}

Result<RobotState> ProgramRobot::state() {
    if (!m_talk.isLive() || m_at.empty())
        return m_talk.error();
    return RobotState{m_at_s, m_planner.map().coordinates(m_at), isMoving(), isPlaceSure(), alarm()};
}

Result<void> ProgramRobot::setTwist(const Vector6d& twist, double validFor_s) {
    if (!twist.allFinite() || !std::isfinite(validFor_s))
        throw std::invalid_argument("ProgramRobot: a twist is not finite");
    if (!m_talk.isLive())
        return m_talk.error();
    if (const Message what = keepsFromTwist(); what.code != MessageCode::None) {
        Error error;
        error.message = what;
        return error;
    }
    if (twist.isZero(0.0))
        return isMoving() ? halt() : Result<void>();
    m_planner.setTwist(twist, validFor_s, m_clock.now_s());
    m_isTwistNew = true;
    return {};
}

Result<void> ProgramRobot::halt() {
    m_planner.forget();
    // One that stands is left alone: a fault halts it again and again, and it could not be homed.
    if (m_talk.isLive() && !isMoving())
        return {};
    const bool wasHalted = std::exchange(m_isHalted, true);
    m_ratesUntil_s = -1e300;
    m_rates.clear();
    m_step.reset();
    if (std::exchange(m_isHomeAsked, false)) { // what it had found by then is no place
        m_isHomed = false;
        m_isHomingStopped = true;
    }
    if (!wasHalted) { // it is said again until it stands
        m_halted_s = m_clock.now_s();
        tellStop();
    }
    return m_talk.isLive() ? Result<void>() : Result<void>(m_talk.error());
}

Result<void> ProgramRobot::home() {
    if (!m_talk.isLive())
        return m_talk.error();
    if (!m_talk.hello()->canHome)
        return Error(MessageCode::RobotCannotHome, m_talk.name());
    if (isMoving())
        return Error(MessageCode::CommandNotNow, m_talk.name(), {"home", "moving"});
    m_planner.forget();
    m_refused.clear();
    m_isHomeAsked = true;
    m_homeSent_s = m_clock.now_s();
    m_isHomed = false;
    m_spanFrom.clear();
    m_talk.send(Kind::Home);
    return {};
}

Result<void> ProgramRobot::clearAlarm() {
    if (!m_talk.isLive())
        return m_talk.error();
    m_refused.clear();
    m_elsewhere.reset();
    m_isHomingStopped = m_hasRestarted = false;
    m_spanFrom.clear();
    m_talk.send(Kind::Clear);
    if (m_mustHome && !m_isHomed)
        return Error(MessageCode::RobotPlaceUnsure, m_talk.name());
    return {};
}

RobotDriver programRobotDriver() {
    RobotDriver driver;
    driver.key = "program";
    driver.name = QT_TRANSLATE_NOOP("bask::Device", "Program of your own");
    driver.link = DriverLink::Program;
    driver.usualAxes = {{'X', 0, false, 0.0}, {'Y', 1, false, 0.0}, {'Z', 2, false, 0.0},
                        {'A', 3, false, 0.0}, {'B', 4, false, 0.0}, {'C', 5, false, 0.0}};
    driver.canHome = true;
    driver.make = [](DriverLinks& links, const RobotDeviceSpec& spec, const AxisMap& axes,
                     MotionGuard mayGo) -> MadeDevice<Robot> {
        return std::make_unique<ProgramRobot>(links.program(ProgramRole::Robot), links.clock(), axes,
                                              std::move(mayGo), spec.mustHome.value_or(false));
    };
    return driver;
}

} // namespace bask
