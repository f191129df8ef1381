#include "engine/drivers/grbl_robot.h"

#include "engine/base/message_code.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

namespace bask {
namespace {

constexpr double kSettle_s = 0.2;     // what was under way when the link was opened is not heard
constexpr double kFirstReply_s = 3.0; // an Arduino that resets on opening takes up to 2 s
constexpr double kSilence_s = 1.0;
constexpr double kResetTime_s = 2.0;
constexpr double kHomingTime_s = 120.0; // Grbl tells nothing while it homes
constexpr double kRestPoll_s = 0.2, kMotionPoll_s = 0.05;
constexpr double kReply_s = 0.4; // a report that has not come by then is asked for anew
constexpr double kStepMargin_s = 0.01;
constexpr double kSlow_s = 2.0;
constexpr double kFenceAfter_s = 0.5, kFenceTime_s = 5.0;
constexpr double kQuiet_s = 0.5;
constexpr double kNote_s = 5.0;
constexpr double kSetUpPause_s = 1.0;
constexpr int kNotTold = -1;

std::string wordsOr(std::string words, const char* otherwise) {
    return words.empty() ? otherwise : words;
}

/// "1.1h" of "VER:1.1h.20190825:".
std::string versionIn(const std::string& report) {
    constexpr std::size_t kDate = 9;
    const std::string version = report.substr(4, report.find(':', 4) - 4);
    return version.size() > kDate && version[version.size() - kDate] == '.'
               ? version.substr(0, version.size() - kDate)
               : version;
}

Message refusal(int error) {
    return {MessageCode::RobotRefused,
            {std::to_string(error), wordsOr(grblErrorWords(error), "not known to Bask")}};
}

} // namespace

GrblRobot::GrblRobot(ByteLink& link, const Clock& clock, AxisMap map, MotionGuard guard, bool mustHome)
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
    m_opened_s = now_s;
    m_splitter.clear();
    m_lastGarbage.clear();
    m_offset.clear();
    m_isSetUp = false;
    m_setUpFrom_s = m_linesFrom_s = now_s + kSettle_s;
    m_isPlaceToCheck = m_wasLive;
}

void GrblRobot::lose(const Message& why, double now_s) {
    if (m_linkState == LinkState::Live)
        m_linkState = LinkState::Lost;
    m_problem = why;
    if (m_line && m_line->kind == Kind::Home)
        m_isPlaceInDoubt = true;
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
    const double since_s = now_s - std::max({m_opened_s, m_heard_s, m_reset_s.value_or(m_opened_s)});
    double allowed_s = m_linkState == LinkState::Live ? kSilence_s : kFirstReply_s;
    if (m_line && m_line->kind == Kind::Home)
        allowed_s = kHomingTime_s;
    else if (m_reset_s)
        allowed_s = kFirstReply_s;
    if (since_s > allowed_s) {
        const bool isOther = m_lastReply_s < m_opened_s && !m_lastGarbage.empty();
        lose(isOther ? Message{MessageCode::DeviceOther, {m_link.name(), m_lastGarbage}}
                     : Message{MessageCode::DeviceSilent, {m_link.name(), formatNumber(since_s, 2)}},
             now_s);
        return;
    }
    if (m_line && m_line->kind != Kind::Home && now_s - m_line->sent_s > kSlow_s && !m_isSlow) {
        m_isSlow = true;
        m_planner.forget();
        if (m_line->kind == Kind::Jog)
            stopJog();
    }
    if (m_reset_s && now_s - *m_reset_s > kResetTime_s) {
        m_reset_s.reset();
        m_next.reset();
        m_isSlow = true;
    }
    if (m_fence_s && now_s - *m_fence_s > kFenceTime_s)
        m_fence_s.reset();
}

void GrblRobot::ask(double now_s) {
    if (now_s - m_opened_s < kSettle_s || (m_asked_s && now_s - *m_asked_s < kReply_s))
        return;
    const double since_s = now_s - m_lastAsk_s;
    if (since_s < (isMoving() || m_isHalting ? kMotionPoll_s : kRestPoll_s))
        return;
    // Not shortly before a step ends, so that its end is seen at once.
    if (m_step && !m_isHalting && now_s < m_step->end_s && now_s > m_step->end_s - kMotionPoll_s)
        return;
    if (m_isHalting && (!m_fence_s || m_status.state == GrblState::Jog))
        m_link.write(std::string(1, grbl::kJogCancel));
    m_link.write(std::string(1, grbl::kStatus));
    m_asked_s = m_lastAsk_s = now_s;
}

// --- What it says ---

void GrblRobot::listen(double now_s) {
    m_splitter.add(m_link.read());
    while (const auto text = m_splitter.next()) {
        const GrblLine line = parseGrblLine(*text);
        if (now_s - m_opened_s >= kSettle_s || std::holds_alternative<GrblBanner>(line))
            take(line, now_s);
    }
}

void GrblRobot::take(const GrblLine& line, double now_s) {
    if (std::holds_alternative<GrblOk>(line)) {
        takeAnswer(0, now_s);
    } else if (const auto* error = std::get_if<GrblError>(&line)) {
        takeAnswer(error->number, now_s);
    } else if (const auto* alarm = std::get_if<GrblAlarm>(&line)) {
        m_alarm = alarm->number;
        m_isPlaceInDoubt = m_isPlaceInDoubt || !isPlaceKept(alarm->number);
        m_planner.forget();
        if (m_line && m_line->kind == Kind::Home)
            m_line.reset(); // it has failed
    } else if (const auto* status = std::get_if<GrblStatus>(&line)) {
        takeStatus(*status, now_s);
    } else if (const auto* banner = std::get_if<GrblBanner>(&line)) {
        takeBanner(*banner, now_s);
    } else if (const auto* report = std::get_if<GrblReport>(&line)) {
        takeReport(report->text, now_s);
    } else if (const auto* setting = std::get_if<GrblSetting>(&line)) {
        takeSetting(*setting);
    } else if (const auto* garbage = std::get_if<GrblGarbage>(&line)) {
        m_lastGarbage = garbage->text;
        discard(garbage->text, now_s);
    }
}

void GrblRobot::discard(const std::string& words, double now_s) {
    ++m_discarded;
    note({MessageCode::DeviceAnswersWrong, {m_link.name(), words}}, now_s);
}

void GrblRobot::takeAnswer(int error, double now_s) {
    const std::string words = error == 0 ? "ok" : "error:" + std::to_string(error);
    // An ok that is left from before would acknowledge lines whose own report has not come.
    const bool fits = m_line && (m_line->kind != Kind::Settings || m_line->hasReport || error != 0);
    if (fits) {
        const Pending line = *m_line;
        m_line.reset();
        m_isIdleSeen = false;
        m_heard_s = now_s;
        takeAnswerTo(line, error, now_s);
    } else if (now_s >= m_linesFrom_s) { // before, it is the fence's own
        discard(words, now_s);
    }
}

void GrblRobot::takeAnswerTo(const Pending& line, int error, double now_s) {
    switch (line.kind) {
    case Kind::Settings: // a controller that refuses them when at rest is not asked again
        m_isSetUp = !m_tellsInches && (error == 0 || isResting());
        if (m_isSetUp)
            m_setUpFrom_s = now_s;
        break;
    case Kind::Version:
        if (m_identity.empty())
            m_identity = "Grbl";
        break;
    case Kind::Jog:
        if (m_step && error == 0) {
            m_step->isTaken = true;
            m_step->end_s = now_s + m_step->plan.time_s + kStepMargin_s;
        } else {
            m_step.reset();
            m_planner.forget();
            m_refused = error;
        }
        break;
    case Kind::Home:
        if (error == 0)
            takeHome();
        [[fallthrough]];
    case Kind::Unlock:
        if (error != 0)
            note(refusal(error), now_s);
        break;
    }
}

void GrblRobot::takeHome() {
    m_isHomed = true;
    m_hasRestarted = m_isPlaceInDoubt = false;
    m_elsewhere.reset();
    m_refused.reset();
}

std::vector<double> GrblRobot::positionsIn(const GrblStatus& status) {
    if (!status.offset.empty())
        m_offset = status.offset;
    std::vector<double> all = status.machine;
    if (all.empty() && !status.work.empty() && m_offset.size() == status.work.size()) {
        all = status.work;
        for (std::size_t i = 0; i < all.size(); ++i)
            all[i] += m_offset[i];
    }
    if (all.empty())
        return {};
    std::vector<double> out;
    for (const AxisSpec& axis : m_planner.map().axes()) {
        const std::size_t index = grbl::kLetters.find(axis.letter);
        if (index >= all.size()) {
            m_problem = {MessageCode::DeviceAnswersWrong,
                         {m_link.name(), std::string("no axis ") + axis.letter}};
            return {};
        }
        out.push_back(all[index]);
    }
    return out;
}

void GrblRobot::takeStatus(const GrblStatus& status, double now_s) {
    m_status = status;
    const std::vector<double> at = positionsIn(status);
    if (now_s > m_lastReply_s && m_lastReply_s > m_opened_s)
        m_rate_Hz += 0.2 * (1.0 / (now_s - m_lastReply_s) - m_rate_Hz);
    m_lastReply_s = m_heard_s = now_s;
    if (m_asked_s)
        m_replyTime_s = now_s - *m_asked_s;
    // Measured after it was asked for; one that nobody asked for, after the one before.
    const double measured_s = m_asked_s ? *m_asked_s : std::max(m_at_s, m_opened_s);
    m_asked_s.reset();
    takeState(status);
    if (at.empty() || m_tellsInches) {
        m_linkState = m_wasLive ? LinkState::Lost : LinkState::Opening;
        return;
    }
    m_at = at;
    m_at_s = measured_s;
    checkPlace();
    if (status.state == GrblState::Idle && !m_line) {
        m_isHalting = false;
        m_isIdleSeen = true;
        m_step.reset();
        m_spanFrom = m_spanTo = at;
    }
    if (m_isSetUp || !isResting()) {
        m_linkState = LinkState::Live;
        m_wasLive = true;
        m_problem = {};
    }
}

void GrblRobot::takeState(const GrblStatus& status) {
    m_isIdleSeen = m_isIdleSeen && status.state == GrblState::Idle;
    if (status.isHomed)
        m_isHomed = *status.isHomed;
    if (status.state == GrblState::Alarm) {
        if (!m_alarm)
            m_alarm = status.part.value_or(kNotTold);
        m_isPlaceInDoubt = m_isPlaceInDoubt || !isPlaceKept(*m_alarm);
        m_planner.forget();
        m_step.reset();
        m_isHalting = false;
        return;
    }
    m_alarm.reset();
    const bool isHeld = status.state == GrblState::Hold || status.state == GrblState::Door ||
                        status.state == GrblState::Check || status.state == GrblState::Sleep ||
                        status.state == GrblState::Tool;
    if (!isHeld || m_reset_s)
        return;
    m_held = status.word;
    m_isPlaceInDoubt = m_isPlaceInDoubt || status.state == GrblState::Sleep; // its motors are off
    m_planner.forget();
    m_step.reset();
}

void GrblRobot::checkPlace() {
    const bool isFound = std::exchange(m_isPlaceToCheck, false) && !m_hasRestarted;
    const bool isEnded = m_step && m_step->isTaken && m_status.state == GrblState::Idle;
    if (m_spanFrom.empty() || (!isFound && !m_step))
        return;
    const bool isDue = isEnded && !m_step->isCancelled; // at the very end of the step
    const double error = outside(m_at, isDue ? m_spanTo : m_spanFrom, m_spanTo);
    if (error <= kElsewhere)
        return;
    m_elsewhere = error;
    m_planner.forget();
    stopJog();
}

void GrblRobot::takeBanner(const GrblBanner& banner, double now_s) {
    m_identity = banner.identity;
    if (m_reset_s) {
        m_isPlaceToCheck = true;
    } else {
        m_next.reset();
        m_isSetUp = m_isHomed = false;
        m_setUpFrom_s = now_s;
        m_hasRestarted = m_hasRestarted || m_wasLive;
        m_alarm.reset(); // the next report tells
    }
    m_heard_s = now_s;
    m_reset_s.reset();
    m_asked_s.reset();
    m_offset.clear();
    dropMotion();
}

void GrblRobot::takeReport(const std::string& text, double now_s) {
    if (text.starts_with("GC:") && m_fence_s) {
        m_fence_s.reset();
        if (m_line) { // it was done, or never will be
            m_isPlaceToCheck = m_step.has_value();
            m_step.reset();
            m_line.reset();
        }
        m_isIdleSeen = false;
        m_linesFrom_s = now_s + kQuiet_s;
    } else if (text.starts_with("VER:") && m_identity.empty()) {
        m_identity = "Grbl " + versionIn(text);
    }
}

void GrblRobot::takeSetting(const GrblSetting& setting) {
    if (!m_line || m_line->kind != Kind::Settings)
        return;
    m_line->hasReport = true;
    if (setting.number == 22)
        m_canHome = setting.value != "0";
    if (setting.number != 13)
        return;
    m_tellsInches = setting.value != "0";
    if (m_tellsInches)
        m_problem = {MessageCode::DeviceAnswersWrong,
                     {m_link.name(), "it tells its place in inches; set $13=0 in it"}};
}

// --- What it is told ---

bool GrblRobot::isResting() const {
    return m_status.state == GrblState::Idle || m_status.state == GrblState::Alarm;
}

bool GrblRobot::maySend(double now_s) const {
    return !m_line && !m_fence_s && !m_reset_s && !m_isHalting && now_s >= m_linesFrom_s;
}

void GrblRobot::send(Kind kind, const std::string& line, double now_s) {
    m_link.write(line);
    m_line = Pending{kind, now_s};
    m_isIdleSeen = false;
}

void GrblRobot::act(double now_s) {
    sendFence(now_s);
    if (!maySend(now_s))
        return;
    if (m_next) {
        const Kind next = *std::exchange(m_next, std::nullopt);
        send(next, next == Kind::Home ? "$H\n" : "$X\n", now_s);
        if (next == Kind::Home)
            m_spanFrom.clear();
    } else if (!m_isSetUp || m_identity.empty()) {
        setUp(now_s);
    } else if (m_isIdleSeen && m_linkState == LinkState::Live && alarm().code == MessageCode::None) {
        sendStep(now_s);
    }
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
    if (now_s < m_setUpFrom_s || m_lastReply_s < m_opened_s || !isResting())
        return;
    m_setUpFrom_s = now_s + kSetUpPause_s;
    if (!m_isSetUp)
        send(Kind::Settings, "$$\n", now_s);
    else
        send(Kind::Version, "$I\n", now_s);
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
    m_reset_s = now_s;
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
           m_status.state == GrblState::Home || (m_line && m_line->kind == Kind::Home);
}

bool GrblRobot::isPlaceSure() const {
    return !m_hasRestarted && !m_elsewhere && !m_isPlaceInDoubt && !isHomingDue();
}

Message GrblRobot::alarm() const {
    if (m_alarm == kNotTold)
        return {MessageCode::RobotAlarm, {"?", "the controller does not tell which"}};
    if (m_alarm)
        return {MessageCode::RobotAlarm,
                {std::to_string(*m_alarm), wordsOr(grblAlarmWords(*m_alarm), "not known to Bask")}};
    if (m_hasRestarted)
        return {MessageCode::RobotRestarted, {}};
    if (m_elsewhere)
        return {MessageCode::RobotElsewhere, {formatNumber(*m_elsewhere, 2)}};
    if (!m_held.empty())
        return {MessageCode::RobotHeld, {m_held}};
    if (m_isSlow)
        return {MessageCode::RobotSlow, {formatNumber(kSlow_s)}};
    if (m_refused)
        return refusal(*m_refused);
    if (!isPlaceSure())
        return {MessageCode::RobotPlaceUnsure, {}};
    return {};
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
    if (const Message what = alarm(); what.code != MessageCode::None) {
        Error error;
        error.message = what;
        return error;
    }
    if (twist.isZero(0.0))
        return halt();
    m_planner.setTwist(twist, validFor_s, m_clock.now_s());
    return {};
}

Result<void> GrblRobot::halt() {
    m_planner.forget();
    if (m_next == Kind::Home)
        m_next.reset();
    if (m_line && m_line->kind == Kind::Home)
        stopHoming();
    else if (m_step || m_status.state == GrblState::Jog)
        stopJog();
    if (m_linkState != LinkState::Live)
        return notLive();
    return {};
}

/// By a reset, since nothing else ends it; its place is lost.
void GrblRobot::stopHoming() {
    m_isPlaceInDoubt = true;
    m_line.reset();
    reset(std::nullopt, m_clock.now_s());
}

Result<void> GrblRobot::home() {
    if (m_linkState != LinkState::Live)
        return notLive();
    if (!m_canHome)
        return Error(MessageCode::RobotCannotHome, m_link.name());
    if (!isResting() || m_step || m_isHalting || m_reset_s || m_line || m_next)
        return Error(MessageCode::CommandNotNow, m_link.name(), {"home", m_status.word});
    m_planner.forget();
    if (m_status.state == GrblState::Alarm)
        reset(Kind::Home, m_clock.now_s());
    else
        m_next = Kind::Home;
    return {};
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
            return Error(MessageCode::RobotHeld, m_link.name(), {m_held});
        return {};
    case MessageCode::RobotSlow:
        if (m_line || m_fence_s)
            return Error(MessageCode::RobotSlow, m_link.name(), {formatNumber(kSlow_s)});
        m_isSlow = false;
        return {};
    case MessageCode::RobotRefused:
        m_refused.reset();
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
    m_held.clear();
    return true;
}

/// A person has confirmed its place.
Result<void> GrblRobot::clearDoubt() {
    m_hasRestarted = m_isPlaceInDoubt = false;
    m_elsewhere.reset();
    if (isHomingDue())
        return Error(MessageCode::RobotPlaceUnsure, m_link.name());
    return {};
}

} // namespace bask
