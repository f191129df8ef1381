#include "engine/drivers/grbl_robot.h"

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

constexpr double kFirstReply_s = 3.0; // an Arduino that resets on opening takes up to 2 s
constexpr double kSilence_s = 1.0;
constexpr double kResetTime_s = 2.0;
constexpr double kHomingTime_s = 120.0; // Grbl tells nothing while it homes
constexpr double kRestPoll_s = 0.2, kMotionPoll_s = 0.05;
constexpr double kReply_s = 0.4; // a report that has not come by then is asked for anew
constexpr double kSlow_s = 2.0;
constexpr double kHoldAgain_s = 0.3; // the byte may be lost
constexpr double kMinStopInterval_s = 0.05;
constexpr double kHoldTime_s = 1.0; // to slow down in
constexpr double kFenceAfter_s = 0.5, kFenceTime_s = 5.0;
constexpr double kNote_s = 5.0;
constexpr double kSetUpPause_s = 1.0;
constexpr double kNextTime_s = 5.0;  // an order that cannot begin by then is dropped
constexpr char kMarkLine[] = "F7\n"; // moves nothing, and what somebody moves by it later is slow

constexpr double kFollows = 3.0; // a step may take so many times its own time

/// From rest to rest.
double timeOf(double way, double speed, double acceleration) {
    const double ramps = speed * speed / acceleration;
    return ramps < way ? way / speed + speed / acceleration : 2.0 * std::sqrt(way / acceleration);
}

std::string wordsOr(std::string words, const char* otherwise) {
    return words.empty() ? otherwise : words;
}

} // namespace

GrblRobot::GrblRobot(ByteLink& link, const Clock& clock, AxisMap map, MotionGuard guard,
                     std::optional<bool> mustHome)
    : m_link(link), m_keeper(link), m_clock(clock), m_planner(std::move(map), std::move(guard)),
      m_mustHome(mustHome) {}

void GrblRobot::work() {
    const double now_s = m_clock.now_s();
    if (!isLinkOpen(now_s))
        return;
    listen(now_s);
    watch(now_s);
    if (!m_keeper.isOpen())
        return;
    act(now_s);
    ask(now_s);
}

// --- The link ---

bool GrblRobot::isLinkOpen(double now_s) {
    switch (m_keeper.work(now_s)) {
    case LinkKeeper::Found::Opened:
        begin(now_s);
        return true;
    case LinkKeeper::Found::Open:
        return true;
    case LinkKeeper::Found::Lost:
        lose(m_keeper.problem(), now_s);
        return false;
    case LinkKeeper::Found::Closed:
        break;
    }
    if (m_link.problem().code != MessageCode::None)
        m_problem = m_link.problem();
    if (m_linkState == LinkState::Closed)
        m_linkState = LinkState::Opening;
    return false;
}

void GrblRobot::begin(double now_s) {
    if (m_linkState == LinkState::Closed)
        m_linkState = LinkState::Opening;
    m_splitter.clear();
    m_lastGarbage.clear();
    m_isSetUp = false;
    m_signature.clear();
    m_setUpFrom_s = m_linesFrom_s = now_s + kSettle_s;
    m_isPlaceToCheck = m_wasLive;
    m_isMarkToCheck = m_isMarked;
    if (!m_isMarked) // nobody can tell whether it has restarted
        m_isHomed = m_isConfirmed = false;
}

void GrblRobot::lose(const Message& why, double now_s) {
    if (m_linkState == LinkState::Live)
        m_linkState = LinkState::Lost;
    m_problem = why;
    if (why.code == MessageCode::LinkByHand) // whatever a person does there
        m_isHomed = m_isConfirmed = false;
    const bool isHoming = m_status.state == GrblState::Home || (m_line && m_line->kind == Kind::Home);
    if (isHoming || m_homeStop_s) { // nobody could stop it any more
        doubtPlace();
        m_isMarked = false;
        m_link.write(std::string(1, grbl::kReset));
    }
    m_status = {};
    m_homeStop_s.reset();
    m_runStop_s.reset();
    m_keeper.close(now_s);
    m_asked_s.reset();
    m_reset_s.reset();
    m_next.reset();
    dropMotion();
}

/// Lines that were sent are lost, or cannot be known of any more.
void GrblRobot::dropMotion() {
    m_planner.forget();
    m_line.reset();
    m_fence_s.reset();
    m_step.reset();
    m_isHalting = m_isIdleSeen = false;
}

void GrblRobot::watch(double now_s) {
    const double since_s = m_keeper.silence_s(std::max(m_heard_s, m_reset_s.value_or(m_heard_s)), now_s);
    double allowed_s = m_linkState == LinkState::Live ? kSilence_s : kFirstReply_s;
    if (m_line && m_line->kind == Kind::Home)
        allowed_s = kHomingTime_s;
    else if (m_reset_s)
        allowed_s = kFirstReply_s;
    if (since_s > allowed_s) {
        const bool isOther = m_lastReply_s < m_keeper.opened_s() && !m_lastGarbage.empty();
        lose(isOther ? Message{MessageCode::DeviceOther, {m_link.name(), m_lastGarbage}}
                     : Message{MessageCode::DeviceSilent, {m_link.name(), formatNumber(since_s, 2)}},
             now_s);
        return;
    }
    workStops(now_s);
    const double unanswered_s = m_line ? m_keeper.silence_s(m_line->sent_s, now_s) : 0.0;
    if (unanswered_s > kSlow_s && m_line->kind != Kind::Home && !m_isSlow) {
        m_isSlow = true;
        m_planner.forget();
        if (m_line->kind == Kind::Jog)
            stopJog();
    }
    if (m_reset_s && m_keeper.silence_s(*m_reset_s, now_s) > kResetTime_s) {
        if (!m_homeStop_s)
            m_reset_s.reset();
        m_next.reset();
        m_isSlow = true;
    }
    if (m_fence_s && now_s - *m_fence_s > kFenceTime_s)
        m_fence_s.reset();
    if (m_next && m_keeper.silence_s(m_nextFrom_s, now_s) > kNextTime_s) {
        m_next.reset();
        note({MessageCode::RobotOpening, {}}, now_s);
    }
}

void GrblRobot::ask(double now_s) {
    if (now_s - m_keeper.opened_s() < kSettle_s || (m_asked_s && now_s - *m_asked_s < kReply_s))
        return;
    const double since_s = now_s - m_lastAsk_s;
    if (since_s < (isMoving() || m_isHalting || m_runStop_s ? kMotionPoll_s : kRestPoll_s))
        return;
    // Not shortly before a step ends, so that its end is seen at once.
    if (m_step && !m_isHalting && now_s < m_step->end_s && now_s > m_step->end_s - kMotionPoll_s)
        return;
    if (m_isHalting && (!m_fence_s || m_status.state == GrblState::Jog))
        m_link.write(std::string(1, grbl::kJogCancel));
    m_link.write(std::string(1, grbl::kStatus));
    m_asked_s = m_lastAsk_s = now_s;
}

// --- What it is told ---

bool GrblRobot::isResting() const {
    return m_status.state == GrblState::Idle || m_status.state == GrblState::Alarm;
}

bool GrblRobot::maySend(double now_s) const {
    return !m_line && !m_fence_s && !m_reset_s && !m_runStop_s && !m_isHalting && now_s >= m_linesFrom_s;
}

void GrblRobot::send(Kind kind, const std::string& line, double now_s) {
    m_link.write(line);
    m_line = Pending{kind, now_s};
    m_wasRunReset = m_wasRunReset && kind != Kind::Jog && kind != Kind::Home;
    m_isIdleSeen = false;
}

void GrblRobot::act(double now_s) {
    sendFence(now_s);
    if (!maySend(now_s))
        return;
    if (m_next && (m_next == Kind::Unlock || isIdentified())) {
        const Kind next = *std::exchange(m_next, std::nullopt);
        send(next, next == Kind::Home ? "$H\n" : "$X\n", now_s);
        if (next == Kind::Home) {
            m_spanFrom.clear();
            m_isHomed = false; // until it has ended well
        }
    } else if (isSetUpDue()) {
        setUp(now_s);
    } else if (isIdentified() && m_isIdleSeen && m_linkState == LinkState::Live) {
        if (!m_isMarked && m_takesMark && isPlaceSure())
            send(Kind::Mark, kMarkLine, now_s);
        else if (keepsFromTwist().code == MessageCode::None)
            sendStep(now_s);
    }
}

/// Another device is asked for nothing but its name.
bool GrblRobot::isSetUpDue() const {
    return !m_isSetUp || m_signature.empty() || (!isOther() && (m_areUnitsDue || m_isMarkToCheck));
}

/// A line may be lost on the way, or dropped by 0x85, and no ok come: the report of a `$G` behind it tells.
void GrblRobot::sendFence(double now_s) {
    const bool isDue = m_line && !m_fence_s && now_s - m_line->sent_s > kFenceAfter_s;
    if (!isDue || m_status.state != GrblState::Idle || m_lastReply_s <= m_line->sent_s)
        return;
    m_link.write("$G\n");
    m_fence_s = now_s;
}

void GrblRobot::setUp(double now_s) {
    if (now_s < m_setUpFrom_s || m_lastReply_s < m_keeper.opened_s() || !isResting())
        return;
    m_setUpFrom_s = now_s + kSetUpPause_s;
    if (!m_isSetUp || m_areUnitsDue)
        send(Kind::Settings, "$$\n", now_s);
    else if (m_signature.empty())
        send(Kind::Version, "$I\n", now_s);
    else
        send(Kind::Modes, "$G\n", now_s);
}

void GrblRobot::sendStep(double now_s) {
    const auto plan = m_planner.next(m_at, now_s);
    if (m_planner.isRefused())
        note({MessageCode::RobotStepOutside, {}}, now_s);
    if (!plan)
        return;
    std::vector<GrblTarget> targets;
    const auto& axes = m_planner.map().axes();
    for (std::size_t i = 0; i < axes.size(); ++i)
        targets.push_back({axes[i].letter, plan->from[i], plan->to[i]});
    const auto line = grblJogLine(targets, plan->time_s);
    if (!line)
        return note(line.error().message, now_s);
    m_spanFrom = plan->from;
    m_spanTo = plan->to;
    m_step = Step{*plan, now_s + plan->time_s + kStepMargin_s};
    send(Kind::Jog, *line, now_s);
    m_lastAsk_s = now_s; // an answer at once would be of before
}

void GrblRobot::stopJog() {
    if (m_step)
        m_step->isCancelled = true;
    if (m_isHalting || !m_keeper.isOpen())
        return;
    m_link.write(std::string(1, grbl::kJogCancel));
    m_isHalting = true; // goes on until it is idle and owes no answer: this byte may have overtaken a line
}

/// Only where it stands: in motion it would lose its place.
void GrblRobot::reset(std::optional<Kind> then, double now_s) {
    m_link.write(std::string(1, grbl::kReset));
    m_reset_s = m_nextFrom_s = now_s;
    m_next = then;
}

// --- For the engine ---

Error GrblRobot::notLive() const {
    if (m_problem.code == MessageCode::None)
        return Error(MessageCode::RobotOpening, m_link.name());
    Error error;
    error.message = m_problem;
    return error;
}

bool GrblRobot::isMoving() const {
    const bool isSlowing = (m_status.state == GrblState::Hold && m_status.part == 1) ||
                           (m_status.state == GrblState::Door && m_status.part.value_or(0) >= 2);
    return m_step || isSlowing || m_status.state == GrblState::Jog || m_status.state == GrblState::Run ||
           m_status.state == GrblState::Home || m_next == Kind::Home ||
           (m_line && m_line->kind == Kind::Home);
}

bool GrblRobot::isPlaceSure() const {
    return m_isSetUp && !m_isMarkToCheck && (m_isHomed || m_isConfirmed) && !m_hasRestarted && !m_elsewhere &&
           !m_isPlaceInDoubt && !isHomingDue();
}

Message GrblRobot::keepsFromMoving() const {
    if (m_alarm == kNotTold)
        return {MessageCode::RobotAlarm, {"?", "the controller does not tell which"}};
    if (m_alarm)
        return {MessageCode::RobotAlarm,
                {std::to_string(*m_alarm), wordsOr(grblAlarmWords(*m_alarm), "not known to Bask")}};
    if (!m_pausedBy.empty())
        return {MessageCode::RobotHeld, {m_pausedBy}};
    if (m_isSlow)
        return {MessageCode::RobotSlow, {formatNumber(kSlow_s)}};
    if (m_refused)
        return refusal(*m_refused);
    return {};
}

Message GrblRobot::alarm() const {
    if (Message what = keepsFromMoving(); what.code != MessageCode::None)
        return what;
    if (m_hasRestarted)
        return {MessageCode::RobotRestarted, {}};
    if (m_elsewhere)
        return {MessageCode::RobotElsewhere, {formatNumber(*m_elsewhere, 2), formatNumber(kElsewhere)}};
    if (m_isStepLate)
        return {MessageCode::RobotStepLate, {}};
    if (!isPlaceSure())
        return {MessageCode::RobotPlaceUnsure, {}};
    return {};
}

Message GrblRobot::refusal(int error) {
    return {MessageCode::RobotRefused,
            {std::to_string(error), wordsOr(grblErrorWords(error), "not known to Bask")}};
}

void GrblRobot::note(const Message& message, double now_s) {
    m_note = message;
    m_noteUntil_s = now_s + kNote_s;
}

DeviceStatus GrblRobot::status() const {
    DeviceStatus out;
    out.link = m_linkState;
    if (m_linkState != LinkState::Live)
        out.problem = m_problem;
    else if (m_clock.now_s() < m_noteUntil_s)
        out.problem = m_note;
    out.lastReply_s = m_lastReply_s;
    out.replyTime_s = m_replyTime_s;
    out.rate_Hz = m_rate_Hz;
    out.identity = m_identity;
    if (!m_signature.empty())
        out.signature = m_signature;
    out.discarded = m_discarded;
    return out;
}

Result<RobotState> GrblRobot::state() {
    if (m_linkState != LinkState::Live)
        return notLive();
    return RobotState{m_at_s, m_planner.map().coordinates(m_at), isMoving(), isPlaceSure(), alarm()};
}

Result<void> GrblRobot::setTwist(const Vector6d& twist, double validFor_s) {
    if (!twist.allFinite() || !std::isfinite(validFor_s))
        throw std::invalid_argument("GrblRobot: a twist is not finite");
    if (m_linkState != LinkState::Live)
        return notLive();
    if (const Message what = keepsFromTwist(); what.code != MessageCode::None) {
        Error error;
        error.message = what;
        return error;
    }
    if (twist.isZero(0.0))
        return halt();
    m_planner.setTwist(twist, validFor_s, m_clock.now_s());
    return {};
}

std::optional<RobotLag> GrblRobot::lagAt(double speed_m_s, double rotation_rad_s, double validFor_s) const {
    RobotLag lag;
    lag.mean_m_s = speed_m_s;
    double worst = kFollows;
    for (const AxisSpec& axis : m_planner.map().axes()) {
        const std::size_t i = grbl::kLetters.find(axis.letter);
        const bool turns = axis.coordinate >= kThetaX;
        const double speed = turns ? degFromRad(rotation_rad_s) : 1000.0 * speed_m_s;
        if (i >= grbl::kLetters.size() || !(speed > 0.0 && m_maxRate[i] > 0.0 && m_acceleration[i] > 0.0))
            continue;
        const double longest_s = turns ? StepPlanner::kMaxTurn_rad / rotation_rad_s : StepPlanner::kLongest_s;
        const double planned_s = std::min({validFor_s, StepPlanner::kLongest_s, longest_s});
        const double way = speed * planned_s, reached = std::min(speed, m_maxRate[i] / 60.0);
        const double taken_s = std::max(timeOf(way, reached, m_acceleration[i]), planned_s);
        if (!turns)
            lag.mean_m_s = std::min(lag.mean_m_s, 1e-3 * way / taken_s);
        if (taken_s <= worst * planned_s)
            continue;
        worst = taken_s / planned_s;
        lag.planned_s = planned_s;
        lag.taken_s = taken_s;
        const bool isByRate = way / reached > 0.5 * taken_s;
        lag.setting = '$' + std::to_string((isByRate ? 110 : 120) + i) + '=' +
                      formatNumber(isByRate ? m_maxRate[i] : m_acceleration[i]);
    }
    return lag.setting.empty() ? std::nullopt : std::optional(lag);
}

Result<void> GrblRobot::halt() {
    const double now_s = m_clock.now_s();
    m_planner.forget();
    if (m_next == Kind::Home)
        m_next.reset();
    const bool isHoming = m_status.state == GrblState::Home || (m_line && m_line->kind == Kind::Home);
    if (isHoming || m_homeStop_s)
        stopHoming(now_s);
    else if (m_step || m_status.state == GrblState::Jog)
        stopJog();
    else if (m_status.state == GrblState::Run)
        stopRun(now_s);
    if (m_linkState != LinkState::Live)
        return notLive();
    return {};
}

/// By a reset, since nothing else ends it; its place is lost.
void GrblRobot::stopHoming(double now_s) {
    doubtPlace();
    if (m_homeStop_s && now_s - m_stopAgain_s < kMinStopInterval_s)
        return;
    m_link.write(std::string(1, grbl::kReset));
    m_stopAgain_s = now_s;
    if (m_homeStop_s)
        return;
    m_line.reset();
    m_next.reset();
    m_homeStop_s = m_reset_s = now_s;
}

/// A start-up block, or lines of somebody else: held first, so that it keeps its place, then reset.
void GrblRobot::stopRun(double now_s) {
    if (m_runStop_s || m_reset_s || !m_keeper.isOpen())
        return;
    if (m_wasRunReset)
        return reset(std::nullopt, now_s); // a start-up block runs after each reset but one in motion
    m_link.write(std::string(1, grbl::kHold));
    m_runStop_s = m_stopAgain_s = now_s;
    m_spanFrom.clear(); // it is where that has led
}

void GrblRobot::workStops(double now_s) {
    const bool isDue = now_s - m_stopAgain_s > kHoldAgain_s;
    if (m_homeStop_s && isDue) {
        m_link.write(std::string(1, grbl::kReset));
        m_stopAgain_s = now_s;
    }
    if (!m_runStop_s)
        return;
    const bool isPaused = m_status.state == GrblState::Hold && m_status.part.value_or(0) == 0;
    const bool isLate = now_s - *m_runStop_s > kHoldTime_s;
    if (m_status.state == GrblState::Alarm || (isLate && m_status.state == GrblState::Idle)) {
        m_runStop_s.reset();
    } else if (isPaused || isLate) {
        m_runStop_s.reset();
        m_wasRunReset = true;
        reset(std::nullopt, now_s);
    } else if (isDue && m_status.state == GrblState::Run) {
        m_link.write(std::string(1, grbl::kHold));
        m_stopAgain_s = now_s;
    }
}

Result<void> GrblRobot::home() {
    if (m_linkState != LinkState::Live)
        return notLive();
    if (!m_canHome.value_or(true))
        return Error(MessageCode::RobotCannotHome, m_link.name());
    const bool isInAlarm = m_status.state == GrblState::Alarm;
    const bool isOwed = m_line && !(isInAlarm && m_line->kind != Kind::Home); // an alarm may keep the answer
    if (!isResting() || m_step || m_isHalting || m_reset_s || m_runStop_s || isOwed || m_next)
        return Error(MessageCode::CommandNotNow, m_link.name(), {"home", m_status.word});
    m_planner.forget();
    if (isInAlarm) { // in some it tells what it is only after a reset; it homes when it has told
        reset(Kind::Home, m_clock.now_s());
        return {};
    }
    if (!isIdentified())
        return Error(MessageCode::RobotOpening, m_link.name());
    m_next = Kind::Home;
    m_nextFrom_s = m_clock.now_s();
    return {};
}

// What it refused, or was late with, keeps no object before the heat.
void GrblRobot::setRetreating(bool isRetreating) {
    m_isRetreating = isRetreating;
    if (!isRetreating)
        return;
    m_refused.reset();
    m_isStepLate = false;
    m_isSlow = m_isSlow && (m_line || m_fence_s);
}

Result<void> GrblRobot::clearAlarm() {
    if (m_linkState != LinkState::Live)
        return notLive();
    if (m_reset_s || m_next)
        return {};
    switch (alarm().code) {
    case MessageCode::RobotAlarm:
        reset(Kind::Unlock, m_clock.now_s());
        return {};
    case MessageCode::RobotHeld:
        if (!clearHold())
            return Error(MessageCode::RobotHeld, m_link.name(), {m_pausedBy});
        return {};
    case MessageCode::RobotSlow:
        if (m_line || m_fence_s)
            return Error(MessageCode::RobotSlow, m_link.name(), {formatNumber(kSlow_s)});
        m_isSlow = false;
        return {};
    case MessageCode::RobotRefused:
        m_refused.reset();
        return {};
    case MessageCode::RobotStepLate:
        m_isStepLate = false;
        return {};
    default:
        return clearDoubt();
    }
}

/// False where it cannot be cleared from here.
bool GrblRobot::clearHold() {
    const int part = m_status.part.value_or(0);
    switch (m_status.state) {
    case GrblState::Hold:
    case GrblState::Door:
        if (part != 0)
            return false; // slows down, or the door is open
        [[fallthrough]];
    case GrblState::Check:
    case GrblState::Sleep:
    case GrblState::Tool:
        reset(std::nullopt, m_clock.now_s());
        break;
    default:
        break; // released at its own panel
    }
    m_pausedBy.clear();
    return true;
}

/// A person has confirmed its place.
Result<void> GrblRobot::clearDoubt() {
    m_hasRestarted = false;
    m_elsewhere.reset();
    m_isConfirmed = true;
    if (isHomingDue()) // the doubt stays: grblHAL may still tell that it was homed before
        return Error(MessageCode::RobotPlaceUnsure, m_link.name());
    m_isPlaceInDoubt = false;
    return {};
}

RobotDriver grblDriver() {
    RobotDriver driver;
    driver.key = "grbl";
    driver.name = QT_TRANSLATE_NOOP("bask::Device", "Grbl or grblHAL (G-code)");
    driver.serial = {115200, 8, 'N', 1};
    driver.usualAxes = RobotDeviceSpec().axes;
    driver.canHome = true;
    driver.make = [](DriverLinks& links, const RobotDeviceSpec& spec, const AxisMap& axes,
                     MotionGuard mayGo) -> MadeDevice<Robot> {
        return std::make_unique<GrblRobot>(links.serial(), links.clock(), axes, std::move(mayGo),
                                           spec.mustHome);
    };
    return driver;
}

} // namespace bask
