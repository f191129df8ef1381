// What a Grbl robot says, line by line.

#include "engine/base/message_code.h"
#include "engine/drivers/grbl_robot.h"

#include <algorithm>
#include <utility>

namespace bask {
namespace {

constexpr double kQuiet_s = 0.5;
constexpr double kLateStep_s = 0.5; // beyond twice a step's time
constexpr double kMark = 7.0;       // mm/min, as its line sets it

/// "1.1h" of "VER:1.1h.20190825:".
std::string versionIn(const std::string& report) {
    constexpr std::size_t kDate = 9;
    const std::string version = report.substr(4, report.find(':', 4) - 4);
    return version.size() > kDate && version[version.size() - kDate] == '.'
               ? version.substr(0, version.size() - kDate)
               : version;
}

} // namespace

void GrblRobot::listen(double now_s) {
    m_splitter.add(m_link.read());
    while (const auto text = m_splitter.next()) {
        const GrblLine line = parseGrblLine(*text);
        if (now_s - m_keeper.opened_s() >= kSettle_s || std::holds_alternative<GrblBanner>(line))
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
        m_heard_s = m_alarmed_s = now_s; // after a homing that failed it is the first word for minutes
        if (!isPlaceKept(alarm->number))
            doubtPlace();
        m_planner.forget();
        m_homeStop_s.reset();
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
        const bool isOwn = garbage->text.starts_with('<') || (m_line && m_line->kind == Kind::Settings);
        if (!isOwn) // it may have been a setting's
            takeForeign();
    }
}

void GrblRobot::discard(const std::string& words, double now_s) {
    ++m_discarded;
    note({MessageCode::DeviceAnswersWrong, {m_link.name(), words}}, now_s);
}

void GrblRobot::takeAnswer(int error, double now_s) {
    const std::string words = error == 0 ? "ok" : "error:" + std::to_string(error);
    // An ok that is left from before would acknowledge lines whose own report has not come.
    const bool awaitsReport = m_line && (m_line->kind == Kind::Settings || m_line->kind == Kind::Modes);
    const bool fits = m_line && (!awaitsReport || m_line->hasReport || error != 0);
    if (fits) {
        const Pending line = *m_line;
        m_line.reset();
        m_isIdleSeen = false;
        m_heard_s = now_s;
        takeAnswerTo(line, error, now_s);
    } else if (now_s >= m_linesFrom_s) { // before, it is the fence's own
        discard(words, now_s);
        takeForeign();
    }
}

/// Somebody else gives it lines: its settings are asked for again before the next step.
void GrblRobot::takeForeign() {
    m_areUnitsDue = true;
    m_isMarked = m_isMarked && m_isMarkToCheck; // it is marked anew: another's feed is no restart
}

void GrblRobot::takeAnswerTo(const Pending& line, int error, double now_s) {
    switch (line.kind) {
    case Kind::Settings: // asked again where the line that matters was not read
        m_isSetUp = (m_isSetUp || line.hasUnits) && !m_tellsInches;
        m_areUnitsDue = !line.hasUnits || m_tellsInches;
        if (!m_areUnitsDue)
            m_setUpFrom_s = now_s;
        else if (!line.hasUnits)
            m_problem = {MessageCode::DeviceAnswersWrong, {m_link.name(), "it does not tell its $13"}};
        break;
    case Kind::Version:
        if (m_identity.empty())
            m_identity = "Grbl";
        if (error != 0)
            break;
        m_signature = line.version.empty() ? "Grbl" : line.version;
        if (!m_expected)
            m_expected = m_signature;
        m_setUpFrom_s = now_s;
        break;
    case Kind::Modes: // its report has told
        break;
    case Kind::Mark:
        m_isMarked = m_takesMark = error == 0;
        break;
    case Kind::Jog:
        if (m_step && error == 0) {
            m_step->isTaken = true;
            m_step->end_s = now_s + m_step->plan.time_s + kStepMargin_s;
        } else if (error == 0) {
            stopJog(); // nobody waits for its end any more
        } else {
            m_step.reset();
            m_planner.forget();
            m_refused = error;
        }
        break;
    case Kind::Home:
        endHomeState();
        if (error == 0)
            takeHome();
        [[fallthrough]];
    case Kind::Unlock:
        if (error != 0)
            note(refusal(error), now_s);
        break;
    }
}

/// What was told before is not true any more, and what comes next is not known.
void GrblRobot::endHomeState() {
    if (m_status.state == GrblState::Home)
        m_status.state = GrblState::Idle;
}

/// What was found by homing is lost: one that must be homed is to be homed anew.
void GrblRobot::doubtPlace() {
    m_isPlaceInDoubt = true;
    m_isHomed = false;
}

void GrblRobot::takeHome() {
    m_isHomed = true;
    m_hasRestarted = m_isPlaceInDoubt = false;
    m_elsewhere.reset();
    m_refused.reset();
}

std::vector<double> GrblRobot::positionsIn(const GrblStatus& status) {
    const std::vector<double>& all = status.machine;
    if (all.empty()) { // work positions are shifted by anybody's G92, and the offset is not in every report
        m_problem = {MessageCode::DeviceAnswersWrong,
                     {m_link.name(), "its reports have no machine position (MPos); set $10=" +
                                         std::to_string(m_reports | 1) + " in it"}};
        return {};
    }
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
    const bool wasIdle = m_status.state == GrblState::Idle;
    m_status = status;
    const std::vector<double> at = positionsIn(status);
    if (now_s > m_lastReply_s && m_lastReply_s > m_keeper.opened_s())
        m_rate_Hz += 0.2 * (1.0 / (now_s - m_lastReply_s) - m_rate_Hz);
    m_lastReply_s = m_heard_s = now_s;
    if (m_asked_s)
        m_replyTime_s = now_s - *m_asked_s;
    // Measured after it was asked for; one that nobody asked for, after the one before.
    const double measured_s = m_asked_s ? *m_asked_s : std::max(m_at_s, m_keeper.opened_s());
    m_asked_s.reset();
    takeState(status);
    const bool isPlaceTold = !at.empty() && !m_tellsInches;
    if (isPlaceTold) {
        m_at = at;
        m_at_s = measured_s;
        checkPlace(wasIdle);
        checkStepTime();
    }
    if (status.state == GrblState::Idle && !m_line) {
        m_isHalting = false;
        m_isIdleSeen = true;
        m_step.reset();
        if (isPlaceTold)
            m_spanFrom = m_spanTo = at;
    }
    if (!isPlaceTold) {
        m_isPlaceToCheck = m_wasLive; // when it is told again
        m_linkState = m_wasLive ? LinkState::Lost : LinkState::Opening;
        return;
    }
    if (isOther()) {
        m_linkState = m_wasLive ? LinkState::Lost : LinkState::Opening;
        m_problem = {MessageCode::DeviceExchanged, {m_link.name(), *m_expected, m_signature}};
        return;
    }
    // In some alarms it refuses its settings, and is to be cleared first.
    const bool isKnown = m_isSetUp && !m_isMarkToCheck && (!m_expected || !m_signature.empty());
    if (isKnown || !isResting() || m_alarm) {
        m_linkState = LinkState::Live;
        m_wasLive = true;
        m_problem = {};
    }
}

void GrblRobot::takeState(const GrblStatus& status) {
    m_isIdleSeen = m_isIdleSeen && status.state == GrblState::Idle;
    if (status.isHomed && !m_isPlaceInDoubt)
        m_isHomed = *status.isHomed;
    if (status.state == GrblState::Alarm) {
        m_homeStop_s.reset();
        if (!m_alarm)
            m_alarm = status.part.value_or(kNotTold);
        if (!isPlaceKept(*m_alarm))
            doubtPlace();
        m_planner.forget();
        m_step.reset();
        m_isHalting = false;
        return;
    }
    m_alarm.reset();
    const bool isOfLine = m_line && (m_line->kind == Kind::Jog || m_line->kind == Kind::Home);
    const bool isOwn = m_step || m_isHalting || isOfLine || m_homeStop_s;
    if (status.state == GrblState::Run ||
        (!isOwn && (status.state == GrblState::Jog || status.state == GrblState::Home)))
        takeForeign();
    const bool isPaused = status.state == GrblState::Hold || status.state == GrblState::Door ||
                          status.state == GrblState::Check || status.state == GrblState::Sleep ||
                          status.state == GrblState::Tool;
    if (!isPaused || m_reset_s || m_runStop_s)
        return;
    m_pausedBy = status.word;
    if (status.state == GrblState::Sleep) // its motors are off
        doubtPlace();
    m_planner.forget();
    m_step.reset();
}

void GrblRobot::checkPlace(bool wasIdle) {
    const bool isFound = std::exchange(m_isPlaceToCheck, false) && !m_hasRestarted;
    const bool isIdle = m_status.state == GrblState::Idle;
    const bool isEnded = m_step && m_step->isTaken && isIdle;
    const bool isAtRest = wasIdle && isIdle && !(m_line && m_line->kind == Kind::Jog);
    if (m_spanFrom.empty() || (!isFound && !m_step && !isAtRest))
        return;
    const bool isDue = isEnded && !m_step->isCancelled; // at the very end of the step
    const double error = outside(m_at, isDue ? m_spanTo : m_spanFrom, m_spanTo);
    if (error <= kElsewhere)
        return;
    m_elsewhere = error;
    takeForeign(); // in other units it is another place
    m_planner.forget();
    if (m_step || m_status.state == GrblState::Jog)
        stopJog();
}

/// By the time of the report: an engine that was held up is not the robot's delay. A retreat goes on
/// nevertheless.
void GrblRobot::checkStepTime() {
    const bool isUnderWay = m_step && m_step->isTaken && !m_step->isCancelled && !m_isRetreating;
    if (!isUnderWay || m_status.state != GrblState::Jog ||
        m_at_s - m_step->end_s <= m_step->plan.time_s + kLateStep_s)
        return;
    m_isStepLate = true;
    m_planner.forget();
    stopJog();
}

void GrblRobot::takeBanner(const GrblBanner& banner, double now_s) {
    m_identity = banner.identity;
    const bool isOfStop = m_isPlaceInDoubt && now_s - m_stopAgain_s < kQuiet_s; // one that was sent twice
    const bool isOfAlarm = m_alarm && now_s - m_alarmed_s < kQuiet_s;           // some of them end in a start
    if (m_reset_s || isOfStop) {
        m_isPlaceToCheck = true;
        m_setUpFrom_s = now_s; // asked again at once where an alarm had kept the answer
    } else {
        m_next.reset();
        m_isSetUp = m_isHomed = m_isConfirmed = false;
        m_signature.clear();
        m_setUpFrom_s = now_s;
        m_hasRestarted = m_hasRestarted || (m_wasLive && !isOfAlarm);
        m_spanFrom.clear(); // it may tell zero now
        if (!isOfAlarm)
            m_alarm.reset(); // the next report tells
    }
    endHomeState();
    m_isMarked = m_isMarkToCheck = false;
    takeForeign();
    m_heard_s = now_s;
    m_homeStop_s.reset();
    m_runStop_s.reset();
    m_reset_s.reset();
    m_asked_s.reset();
    dropMotion();
}

/// Its feed is zero after a start that nobody has heard, and another one where somebody else gave it lines.
void GrblRobot::takeModes(const std::string& text) {
    const auto feed = grblFeedIn(text);
    if (m_line && m_line->kind == Kind::Modes)
        m_line->hasReport = feed.has_value();
    if (!feed || !m_isMarkToCheck)
        return;
    m_isMarkToCheck = false;
    m_isMarked = *feed == kMark;
    if (m_isMarked)
        return;
    m_isHomed = m_isConfirmed = false;
    m_hasRestarted = m_hasRestarted || *feed == 0.0;
}

void GrblRobot::takeReport(const std::string& text, double now_s) {
    if (text.starts_with("GC:"))
        takeModes(text);
    if (!m_line && !m_fence_s && now_s >= m_linesFrom_s)
        takeForeign();
    if (text.starts_with("GC:") && m_fence_s) {
        m_fence_s.reset();
        if (m_line) { // it was done, or never will be
            m_isPlaceToCheck = m_step.has_value();
            m_step.reset();
            m_line.reset();
        }
        m_isIdleSeen = false;
        m_linesFrom_s = now_s + kQuiet_s;
    } else if (text.starts_with("VER:")) {
        if (m_identity.empty())
            m_identity = "Grbl " + versionIn(text);
        if (m_line && m_line->kind == Kind::Version)
            m_line->version = text;
    }
}

void GrblRobot::takeSetting(const GrblSetting& setting) {
    const bool isAsked = m_line && m_line->kind == Kind::Settings;
    if (isAsked)
        m_line->hasReport = true;
    else
        takeForeign();
    const auto axis = static_cast<std::size_t>(setting.number % 10);
    const int table = setting.number - setting.number % 10;
    if ((table == 110 || table == 120) && axis < m_maxRate.size())
        (table == 110 ? m_maxRate : m_acceleration)[axis] = grblNumber(setting.value).value_or(0.0);
    if (setting.number == 10)
        m_reports = static_cast<int>(grblNumber(setting.value).value_or(0.0));
    if (setting.number == 22 && !setting.value.empty())
        m_canHome = (setting.value.back() - '0') % 2 != 0; // grblHAL's other bits are how
    if (setting.number != 13)
        return;
    if (isAsked)
        m_line->hasUnits = true;
    m_tellsInches = setting.value != "0";
    if (m_tellsInches)
        m_problem = {MessageCode::DeviceAnswersWrong,
                     {m_link.name(), "it tells its place in inches; set $13=0 in it"}};
}

} // namespace bask
