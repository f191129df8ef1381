#include "engine/drivers/dobot_robot.h"

#include "engine/base/message_code.h"
#include "engine/base/translated.h"
#include "engine/base/units.h"
#include "engine/drivers/driver_catalogue.h"
#include "engine/drivers/driver_make.h"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <stdexcept>
#include <utility>

namespace bask {
namespace {

constexpr double kFirstPacket_s = 3.0;
constexpr double kPacketSilence_s = 1.0;
constexpr double kDrift = 1e-3; // of two clocks
constexpr double kPacketPeriod_s = 0.008;
constexpr double kSlowArm_s = 2.0;
constexpr double kThere = 0.05;       // mm, degrees: the servos' own noise
constexpr double kNotBegun_s = 0.5;   // idle for so long after a move was taken: it does not carry it out
constexpr double kHaste = 2.0;        // a move takes half its step's time; the rest is for what is on its way
constexpr double kLate_s = 0.5;       // beyond twice a step's time
constexpr double kFrames_s = 0.5;     // they go through its queue
constexpr double kResetAgain_s = 0.1; // a move may come to the arm after the reset that is for it
constexpr double kResetting_s = 1.0, kEnabling_s = 5.0;
constexpr double kNoReply_s = 5.0;
constexpr double kNoteAgain_s = 5.0;
constexpr double kErrorsPause_s = 1.0;
constexpr double kPaceOver_s = 0.024, kPaceGap_s = 0.1; // some packets
constexpr double kTooFast = 1.5, kPaceNoise_mm_s = 6.0;

/// Words of a mode in which somebody else has the arm; empty: nobody has.
const char* pausedWords(DobotMode mode) {
    switch (mode) {
    case DobotMode::Starting:
        return "starting";
    case DobotMode::BrakeOpen:
        return "brake open";
    case DobotMode::Dragged:
        return "dragged by hand";
    case DobotMode::Recording:
        return "recording";
    case DobotMode::Paused:
        return "paused";
    default:
        return "";
    }
}

} // namespace

DobotRobot::DobotRobot(ByteLink& dashboard, ByteLink& motion, ByteLink& feedback, const Clock& clock,
                       AxisMap map, MotionGuard guard, double fullSpeed_mm_s)
    : m_dashboard(dashboard), m_motion(motion), m_feedback(feedback), m_clock(clock),
      m_planner(std::move(map), std::move(guard)), m_fullSpeed_mm_s(fullSpeed_mm_s) {}

void DobotRobot::limitSpeed(double max_m_s, double max_rad_s) {
    const double max_mm_s = 1000.0 * max_m_s, max_deg_s = degFromRad(max_rad_s);
    if (max_mm_s == m_largest_mm_s && max_deg_s == m_largest_deg_s)
        return;
    m_largest_mm_s = max_mm_s;
    m_largest_deg_s = max_deg_s;
    m_isSetUp = false; // the factor is set anew, before the next move
}

void DobotRobot::work() {
    const double now_s = m_clock.now_s();
    if (!areLinksOpen(now_s))
        return;
    listen(now_s);
    watch(now_s);
    if (m_isOpen)
        act(now_s);
}

// --- The links ---

bool DobotRobot::areLinksOpen(double now_s) {
    bool areOpen = true;
    for (LinkKeeper* keeper : {&m_dashboard, &m_motion, &m_feedback}) {
        const LinkKeeper::Found found = keeper->work(now_s);
        areOpen = areOpen && keeper->isOpen();
        if (found == LinkKeeper::Found::Lost && m_isOpen)
            lose(keeper->problem(), now_s);
        else if (found == LinkKeeper::Found::Closed && keeper->link().problem().code != MessageCode::None)
            m_problem = keeper->link().problem();
    }
    if (m_linkState == LinkState::Closed)
        m_linkState = LinkState::Opening;
    if (areOpen && !m_isOpen)
        begin(now_s);
    return areOpen;
}

void DobotRobot::begin(double now_s) {
    m_isOpen = true;
    m_opened_s = m_lastRead_s = now_s;
    m_dashboardReplies.clear();
    m_motionReplies.clear();
    m_packets.clear();
    m_isSetUp = false;
    m_time_ms = 0;
    m_otherFrame_s.reset();
    m_isPlaceToCheck = m_wasLive;
}

void DobotRobot::lose(const Message& why, double now_s) {
    if (m_linkState == LinkState::Live)
        m_linkState = LinkState::Lost;
    m_problem = why;
    m_isOpen = false;
    for (LinkKeeper* keeper : {&m_dashboard, &m_motion, &m_feedback})
        keeper->close(now_s);
    m_planner.forget();
    m_toAsk.clear();
    m_asked.reset();
    m_move_s.reset();
    m_step.reset();
    m_isHalting = m_isIdleSeen = false;
}

void DobotRobot::watch(double now_s) {
    const bool isLive = m_linkState == LinkState::Live;
    const double silent_s = m_feedback.silence_s(std::max(m_lastPacket_s, m_opened_s), now_s);
    const double unanswered_s = m_asked ? m_dashboard.silence_s(m_asked->sent_s, now_s) : 0.0;
    if (silent_s > (isLive ? kPacketSilence_s : kFirstPacket_s))
        return lose(silent(silent_s), now_s);
    if (unanswered_s > kNoReply_s)
        return lose({MessageCode::DeviceSilent, {m_dashboard.link().name(), formatNumber(unanswered_s, 2)}},
                    now_s);
    const double move_s = m_move_s ? m_motion.silence_s(*m_move_s, now_s) : 0.0;
    if (move_s > kNoReply_s)
        return lose({MessageCode::DeviceSilent, {m_motion.link().name(), formatNumber(move_s, 2)}}, now_s);
    if (move_s > kSlowArm_s && !m_isSlow) {
        m_isSlow = true;
        m_planner.forget();
        stopMove();
    }
}

// --- What it says ---

void DobotRobot::listen(double now_s) {
    m_dashboardReplies.add(m_dashboard.link().read());
    while (const auto text = m_dashboardReplies.next()) {
        if (const auto reply = parseDobotReply(*text))
            takeReply(*reply, now_s);
        else
            discard(*text, now_s);
    }
    m_motionReplies.add(m_motion.link().read());
    while (const auto text = m_motionReplies.next())
        takeMoveReply(*text, now_s);
    m_packets.add(m_feedback.link().read());
    while (const auto packet = m_packets.next())
        takeFeedback(*packet, now_s);
    takeStrange(now_s);
    m_lastRead_s = now_s;
}

/// Packets of another firmware, or damaged ones.
void DobotRobot::takeStrange(double now_s) {
    const std::size_t bytes = m_packets.discarded() - std::exchange(m_strangeBytes, m_packets.discarded());
    if (bytes == 0)
        return;
    m_discarded +=
        static_cast<int>((bytes + DobotFeedbackReader::kPacketBytes - 1) / DobotFeedbackReader::kPacketBytes);
    m_strange_s = now_s;
    note({MessageCode::DeviceAnswersWrong, {m_feedback.link().name(), m_packets.strange()}}, now_s);
}

/// One that sends something else is not silent.
Message DobotRobot::silent(double silent_s) const {
    if (m_strange_s > std::max(m_lastPacket_s, m_opened_s))
        return {MessageCode::DeviceOther,
                {m_feedback.link().name(), m_packets.strange() + "; its firmware may be of another version"}};
    return {MessageCode::DeviceSilent, {m_feedback.link().name(), formatNumber(silent_s, 2)}};
}

void DobotRobot::discard(const std::string& words, double now_s) {
    ++m_discarded;
    note({MessageCode::DeviceAnswersWrong, {m_dashboard.link().name(), words}}, now_s);
}

void DobotRobot::takeReply(const DobotReply& reply, double now_s) {
    if (reply.command == "geterrorid") { // nothing waits for it
        const std::vector<int> ids = dobotErrorIds(reply.values);
        if (m_alarm && !ids.empty())
            m_alarm = ids.front();
        return;
    }
    if (!m_asked || m_asked->command != reply.command)
        return discard(reply.command, now_s);
    m_replyTime_s = now_s - m_asked->sent_s;
    m_asked.reset();
    takeSetUp(reply, now_s);
}

void DobotRobot::takeSetUp(const DobotReply& reply, double now_s) {
    const bool isSetting =
        reply.command == "speedfactor" || reply.command == "user" || reply.command == "tool";
    if (reply.error != 0 && reply.command != "continue") { // one that is not paused may refuse that
        note({MessageCode::RobotRefused, {std::to_string(reply.error), dobotErrorWords(reply.error)}}, now_s);
        if (isSetting || (reply.command == "resetrobot" && m_mode == DobotMode::Idle && !m_isHalting)) {
            m_refused = reply.error;
            m_toAsk.clear();
        }
        return;
    }
    if (reply.command == "resetrobot" || reply.command == "enablerobot") {
        m_mustReset = m_mustReset && reply.command != "resetrobot";
        m_isSetUp = false; // what was in its queue is gone
        std::erase_if(m_toAsk, [](const std::string& text) {
            return text != "ClearError()" && text != "ResetRobot()" && text != "EnableRobot()";
        });
    }
    m_mustContinue = m_mustContinue && reply.command != "continue";
    if ((reply.command == "tool" || reply.command == "continue") && m_toAsk.empty()) {
        m_isSetUp = true;
        m_setUp_s = now_s;
    }
}

void DobotRobot::takeMoveReply(const std::string& text, double now_s) {
    const auto reply = parseDobotReply(text);
    if (!reply || reply->command != "movl" || !m_move_s)
        return discard(text, now_s);
    m_move_s.reset();
    m_answered_s = now_s;
    m_isIdleSeen = false;
    if (reply->error != 0) {
        m_refused = reply->error;
        m_step.reset();
        m_planner.forget();
    } else if (m_step) {
        m_step->isTaken = true;
        m_step->taken_s = now_s;
    }
}

std::vector<double> DobotRobot::axesOf(const DobotPosition& position) {
    std::vector<double> out;
    for (const AxisSpec& axis : m_planner.map().axes()) {
        const std::size_t index = kDobotLetters.find(axis.letter);
        if (index == std::string_view::npos) {
            m_problem = {MessageCode::DeviceAnswersWrong,
                         {m_feedback.link().name(), std::string("no axis ") + axis.letter}};
            return {};
        }
        out.push_back(position[index]);
    }
    return out;
}

void DobotRobot::takeFeedback(const DobotFeedback& feedback, double now_s) {
    if (now_s > m_lastPacket_s && m_lastPacket_s > m_opened_s)
        m_rate_Hz += 0.05 * (1.0 / (now_s - m_lastPacket_s) - m_rate_Hz);
    m_lastPacket_s = now_s;
    m_mode = feedback.mode;
    m_position = feedback.position;
    const std::vector<double> at = axesOf(feedback.position);
    if (at.empty())
        return;
    m_at = at;
    takeTime(feedback, now_s);
    checkPace();
    takeFrames(feedback);
    takeMode();
    followStep();
    checkPlace();
    if (m_isSetUp || m_refused || m_mode != DobotMode::Idle) {
        m_linkState = LinkState::Live;
        m_wasLive = true;
        m_problem = {};
    }
}

/// No packet is newer than it was read, and one of many that waited is as much older as its own clock says.
void DobotRobot::takeTime(const DobotFeedback& feedback, double now_s) {
    const double told_s = 0.001 * static_cast<double>(feedback.time_ms);
    if (feedback.time_ms <= m_time_ms || m_time_ms == 0) // it was set, or has none
        m_offset_s = m_lastRead_s - told_s;
    else
        m_offset_s = std::min(m_offset_s + kDrift * 0.001 * static_cast<double>(feedback.time_ms - m_time_ms),
                              now_s - told_s);
    m_time_ms = feedback.time_ms;
    m_at_s = m_offset_s + told_s - kPacketPeriod_s;
}

/// Its full speed may not be what it is taken for.
void DobotRobot::checkPace() {
    const bool goesOn = m_time_ms >= m_paced_ms; // its clock may be set
    const double over_s = goesOn ? 0.001 * static_cast<double>(m_time_ms - m_paced_ms) : kPaceGap_s;
    if (over_s < kPaceOver_s)
        return;
    double squares = 0.0;
    for (std::size_t i = 0; i < 3; ++i)
        squares += std::pow(m_position[i] - m_pacedAt[i], 2);
    if (over_s < kPaceGap_s && m_step && m_step->isTaken && m_failure.empty() &&
        std::sqrt(squares) > (kTooFast * m_largest_mm_s + kPaceNoise_mm_s) * over_s)
        failStep("it moves faster than it may; compare its full speed with its settings");
    m_pacedAt = m_position;
    m_paced_ms = m_time_ms;
}

/// What is told in another frame is another place, and so is where a move leads.
/// By the packet's own time, like what follows: one may have waited for an engine that was held up.
void DobotRobot::takeFrames(const DobotFeedback& feedback) {
    if (feedback.user == 0 && feedback.tool == 0)
        return m_otherFrame_s.reset();
    m_otherFrame_s = m_otherFrame_s.value_or(m_at_s);
    if (m_isSetUp && m_at_s - std::max(m_setUp_s, *m_otherFrame_s) > kFrames_s && m_failure.empty())
        failStep("it moves in another frame than user 0 and tool 0");
}

void DobotRobot::takeMode() {
    const bool isQuiet = m_isHalting || m_at_s < m_quietUntil_s;
    if (m_mode == DobotMode::Error) {
        m_alarm = m_alarm.value_or(0);
        m_mustReset = m_mustContinue = true; // what it was told last still waits
        m_isSetUp = false;
        m_planner.forget();
        m_isHalting = false;
        m_step.reset();
    } else {
        m_alarm.reset();
    }
    m_isDisabled = m_isDisabled || (m_mode == DobotMode::Disabled && !isQuiet);
    if (const std::string words = pausedWords(m_mode); !words.empty() && !isQuiet)
        m_pausedBy = words;
    if (m_isDisabled || !m_pausedBy.empty())
        m_planner.forget();
    if (m_isDisabled)
        m_step.reset();
}

/// A move is over when the arm is idle and has been running since it was taken, or is there.
void DobotRobot::followStep() {
    m_isIdleSeen = m_isIdleSeen && m_mode == DobotMode::Idle;
    if (m_step && m_step->isTaken && m_mode == DobotMode::Running)
        m_step->wasRunning = true;
    const bool isOnItsWay = m_step && m_step->isTaken && !m_step->isCancelled;
    if (isOnItsWay && m_mode == DobotMode::Running &&
        m_at_s - m_step->taken_s > 2.0 * m_step->plan.time_s + kLate_s)
        return failStep("a step took over twice its time; compare its full speed with its settings");
    if (m_mode != DobotMode::Idle || m_move_s)
        return;
    if (m_step) {
        const bool isThere = outside(m_at, m_step->plan.to, m_step->plan.to) < kThere;
        if (!m_step->wasRunning && !isThere) {
            if (m_at_s - m_step->taken_s < kNotBegun_s)
                return;
            if (isOnItsWay) {
                m_mustContinue = true;
                return failStep("a step was taken and not carried out");
            }
        }
        m_isPlaceToCheck = true;
        if (!m_step->isCancelled)
            m_spanFrom = m_spanTo; // at the very end of the step
        m_step.reset();
    }
    if (m_isHalting && (m_asked || !m_toAsk.empty() || isResetDue()))
        return; // the reset itself is on its way
    m_isHalting = false;
    m_isIdleSeen = true;
}

void DobotRobot::checkPlace() {
    const bool isDue = std::exchange(m_isPlaceToCheck, false) || m_step;
    if (isDue && !m_spanFrom.empty()) {
        const double error = outside(m_at, m_spanFrom, m_spanTo);
        if (error > kElsewhere) {
            m_elsewhere = error;
            m_planner.forget();
            stopMove();
        }
    }
    if (m_isIdleSeen)
        m_spanFrom = m_spanTo = m_at;
}

// --- What it is told ---

void DobotRobot::act(double now_s) {
    if (m_alarm == 0 && !m_asked && m_toAsk.empty() && now_s - m_askErrors_s > kErrorsPause_s) {
        m_askErrors_s = now_s;
        m_dashboard.link().write("GetErrorID()");
    }
    setUp();
    const bool mayMove = m_mode == DobotMode::Running || m_move_s || isResetDue();
    if (m_isHalting && !m_asked && mayMove && now_s - m_reset_s > kResetAgain_s) {
        m_toAsk.emplace_front("ResetRobot()");
        m_reset_s = now_s;
        m_quietUntil_s = std::max(m_quietUntil_s, now_s + kResetting_s);
    }
    if (!m_asked && !m_toAsk.empty()) {
        std::string name = m_toAsk.front().substr(0, m_toAsk.front().find('('));
        std::ranges::transform(name, name.begin(),
                               [](char c) { return c < 'a' ? static_cast<char>(c + 32) : c; });
        m_dashboard.link().write(m_toAsk.front());
        m_toAsk.pop_front();
        m_asked = Asked{name, now_s};
    }
    const bool isFree = m_isIdleSeen && !m_move_s && !m_isHalting && !m_asked && m_toAsk.empty();
    if (isFree && m_isSetUp && !m_otherFrame_s && m_linkState == LinkState::Live &&
        keepsFromTwist().code == MessageCode::None)
        sendStep(now_s);
}

/// Whenever its queue was emptied: its frames go through it.
void DobotRobot::setUp() {
    if (m_isSetUp || m_asked || !m_toAsk.empty() || m_mode != DobotMode::Idle || m_isHalting || m_refused)
        return;
    if (m_mustReset) {
        m_toAsk = {"ResetRobot()"};
        return;
    }
    m_toAsk = {"SpeedFactor(" + std::to_string(speedFactor()) + ")", "User(0)",
               "Tool(0)"}; // its base's, its flange
    if (m_mustContinue)
        m_toAsk.emplace_back("Continue()");
}

/// Of all its moves, in whole percent: one at 100 % is then no quicker than the quickest that it may make.
int DobotRobot::speedFactor() const {
    const double share = std::max(m_largest_mm_s, m_largest_deg_s) / m_fullSpeed_mm_s;
    return static_cast<int>(std::clamp(std::floor(100.0 * share + 1e-6), 1.0, 100.0));
}

/// In whole percent of that. Degrees count as millimetres. 0: one percent is too quick.
int DobotRobot::speedOf(const PlannedStep& plan) const {
    double moved = 0.0, turned = 0.0;
    for (std::size_t i = 0; i < plan.to.size(); ++i)
        (m_planner.map().axes()[i].coordinate < 3 ? moved : turned) += std::pow(plan.to[i] - plan.from[i], 2);
    const double way = std::sqrt(moved + turned);
    const double min_s = std::max(std::sqrt(moved) / m_largest_mm_s, std::sqrt(turned) / m_largest_deg_s);
    const double percent = 1e-4 * speedFactor() * m_fullSpeed_mm_s;
    const double wanted = std::ceil(kHaste * way / (plan.time_s * percent) - 1e-6);
    const double max = std::floor(way / (min_s * percent) + 1e-6);
    return static_cast<int>(std::min(std::clamp(wanted, 1.0, 100.0), max));
}

/// Stopped, and told until a person has seen to it.
void DobotRobot::failStep(const char* words) {
    m_failure = words;
    m_planner.forget();
    stopMove();
}

void DobotRobot::sendStep(double now_s) {
    const auto plan = m_planner.next(m_at, now_s);
    if (m_planner.isRefused())
        note({MessageCode::RobotStepOutside, {}}, now_s);
    if (!plan)
        return;
    for (std::size_t i = 0; i < m_still.size(); ++i) // its own noise is not followed, what a person did is
        if (std::abs(m_still[i] - m_position[i]) > kElsewhere)
            m_still[i] = m_position[i];
    DobotPosition to = m_still;
    const auto& axes = m_planner.map().axes();
    for (std::size_t i = 0; i < axes.size(); ++i)
        to[kDobotLetters.find(axes[i].letter)] = plan->to[i];
    const int speed = speedOf(*plan);
    if (speed < 1)
        return failStep("it cannot move as slowly as it has to");
    const auto move = dobotMove(to, speed, kAcceleration_percent);
    if (!move)
        return note(move.error().message, now_s);
    m_spanFrom = plan->from;
    m_spanTo = plan->to;
    m_step = Step{*plan};
    m_move_s = now_s;
    m_isIdleSeen = false;
    m_motion.link().write(*move);
}

void DobotRobot::stopMove() {
    if (m_step)
        m_step->isCancelled = true;
    if (m_isHalting || !m_isOpen)
        return;
    m_isHalting = true; // the reset is sent, and again until it is idle and owes no reply
    m_isIdleSeen = false;
    m_halted_s = m_clock.now_s();
    m_reset_s = -1e300;
    act(m_halted_s);
}

// --- For the engine ---

Error DobotRobot::notLive() const {
    if (m_problem.code == MessageCode::None)
        return Error(MessageCode::RobotOpening, m_feedback.link().name());
    Error error;
    error.message = m_problem;
    return error;
}

bool DobotRobot::isMoving() const {
    return m_step || m_mode == DobotMode::Running || m_mode == DobotMode::Jogging ||
           m_mode == DobotMode::Dragged;
}

Message DobotRobot::alarm() const {
    if (m_alarm)
        return {MessageCode::RobotAlarm,
                {*m_alarm == 0 ? "?" : std::to_string(*m_alarm), "as listed in the robot's manual"}};
    if (m_isDisabled)
        return {MessageCode::RobotDisabled, {}};
    if (!m_failure.empty())
        return {MessageCode::RobotAlarm, {"?", m_failure}};
    if (!m_pausedBy.empty())
        return {MessageCode::RobotHeld, {m_pausedBy}};
    if (m_isSlow)
        return {MessageCode::RobotSlow, {formatNumber(kSlowArm_s)}};
    if (m_refused)
        return {MessageCode::RobotRefused, {std::to_string(*m_refused), dobotErrorWords(*m_refused)}};
    if (m_elsewhere)
        return {MessageCode::RobotElsewhere, {formatNumber(*m_elsewhere, 2), formatNumber(kElsewhere)}};
    return {};
}

Message DobotRobot::keepsFromTwist() const {
    const Message what = alarm();
    return m_isRetreating && what.code == MessageCode::RobotElsewhere ? Message{} : what;
}

void DobotRobot::note(const Message& message, double now_s) {
    m_note = message;
    m_noteUntil_s = now_s + kNoteAgain_s;
}

DeviceStatus DobotRobot::status() const {
    DeviceStatus out;
    out.link = m_linkState;
    if (m_linkState != LinkState::Live)
        out.problem = m_problem;
    else if (m_clock.now_s() < m_noteUntil_s)
        out.problem = m_note;
    out.lastReply_s = m_lastPacket_s;
    out.replyTime_s = m_replyTime_s;
    out.rate_Hz = m_rate_Hz;
    out.identity = m_wasLive ? "Dobot" : "";
    out.signature = "";
    out.discarded = m_discarded;
    return out;
}

Result<RobotState> DobotRobot::state() {
    if (m_linkState != LinkState::Live)
        return notLive();
    return RobotState{m_at_s, m_planner.map().coordinates(m_at), isMoving(), !m_elsewhere && !m_otherFrame_s,
                      alarm()};
}

Result<void> DobotRobot::setTwist(const Vector6d& twist, double validFor_s) {
    if (!twist.allFinite() || !std::isfinite(validFor_s))
        throw std::invalid_argument("DobotRobot: a twist is not finite");
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

Result<void> DobotRobot::halt() {
    m_planner.forget();
    if (m_step || m_move_s || m_mode == DobotMode::Running)
        stopMove();
    if (m_linkState != LinkState::Live)
        return notLive();
    return {};
}

Result<void> DobotRobot::home() {
    return Error(MessageCode::RobotCannotHome, m_feedback.link().name());
}

// What it refused, or was late with, keeps no object before the heat.
void DobotRobot::setRetreating(bool isRetreating) {
    m_isRetreating = isRetreating;
    if (!isRetreating)
        return;
    m_refused.reset();
    m_isSlow = m_isSlow && m_move_s;
}

Result<void> DobotRobot::clearAlarm() {
    if (m_linkState != LinkState::Live)
        return notLive();
    const double now_s = m_clock.now_s();
    switch (alarm().code) {
    case MessageCode::RobotAlarm:
        if (!m_alarm) {
            m_failure.clear();
            m_isSetUp = false;
            break;
        }
        m_refused.reset(); // of a move that came to it behind the alarm
        m_toAsk = {"ClearError()", "ResetRobot()", "EnableRobot()"};
        m_quietUntil_s = now_s + kEnabling_s;
        break;
    case MessageCode::RobotDisabled:
        m_isDisabled = false;
        m_toAsk = {"EnableRobot()"};
        m_quietUntil_s = now_s + kEnabling_s;
        break;
    case MessageCode::RobotHeld:
        if (m_mode == DobotMode::Paused)
            stopMove(); // what was paused is dropped
        else if (*pausedWords(m_mode) != '\0')
            return Error(MessageCode::RobotHeld, m_feedback.link().name(), {m_pausedBy});
        m_pausedBy.clear();
        break;
    case MessageCode::RobotSlow:
        if (m_move_s)
            return Error(MessageCode::RobotSlow, m_feedback.link().name(), {formatNumber(kSlowArm_s)});
        m_isSlow = false;
        break;
    default:
        m_elsewhere.reset();
        m_refused.reset();
        break;
    }
    return {};
}

RobotDriver dobotDriver() {
    static constexpr int kDashboard = 29999, kMotion = 30003, kFeedback = 30004;
    RobotDriver driver;
    driver.key = "dobot";
    driver.name = QT_TRANSLATE_NOOP("bask::Device", "Dobot MG400 or M1 Pro (network)");
    driver.link = DriverLink::Network;
    driver.serial = {115200, 8, 'N', 1}; // not used, but files have it
    driver.usualAxes = {
        {'X', kX, false, 0.0}, {'Y', kY, false, 0.0}, {'Z', kZ, false, 0.0}, {'R', kThetaZ, false, 0.0}};
    driver.make = [](DriverLinks& links, const RobotDeviceSpec&, const AxisMap& axes,
                     MotionGuard mayGo) -> MadeDevice<Robot> {
        ByteLink& dashboard = links.tcp(kDashboard);
        ByteLink& motion = links.tcp(kMotion);
        ByteLink& feedback = links.tcp(kFeedback);
        return std::make_unique<DobotRobot>(dashboard, motion, feedback, links.clock(), axes,
                                            std::move(mayGo));
    };
    return driver;
}

} // namespace bask
