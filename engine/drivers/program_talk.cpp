#include "engine/drivers/program_talk.h"

#include "engine/base/message_code.h"
#include "engine/base/plain_text.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace bask {
namespace {

using Kind = ProgramRequest::Kind;

constexpr double kTold_s = 2.0; ///< how long a complaint is told
constexpr double kClockDrift = 1e-3;
constexpr std::size_t kMaxAsked = 8; ///< or commands would wait for long where a program is slow
constexpr double kLongestPeriod_s = 0.1;

} // namespace

ProgramTalk::ProgramTalk(ByteLink& link, const Clock& clock, ProgramRole role)
    : m_keeper(link), m_clock(clock), m_role(role), m_name(link.name()) {}

ProgramTalk::Turn ProgramTalk::work(const Take& take) {
    const double now_s = m_clock.now_s();
    switch (m_keeper.work(now_s)) {
    case LinkKeeper::Found::Opened:
        begin();
        return Turn::Opened;
    case LinkKeeper::Found::Open:
        break;
    case LinkKeeper::Found::Lost:
    case LinkKeeper::Found::Closed:
        if (const Message why = m_keeper.link().problem(); why.code != MessageCode::None)
            m_ended = why;
        return Turn::Closed;
    }
    m_lines.add(m_keeper.link().read());
    while (const auto line = m_keeper.isOpen() ? m_lines.next() : std::nullopt)
        takeLine(*line, take);
    if (m_keeper.isOpen())
        watch();
    if (!m_keeper.isOpen())
        return Turn::Closed;
    if (now_s >= m_nextRead_s && mayWrite() && !isWaitingFor(Kind::Read)) {
        m_nextRead_s = now_s + m_period_s;
        send(Kind::Read);
    }
    return Turn::Open;
}

void ProgramTalk::setPeriod(double period_s) {
    m_period_s = std::clamp(0.5 * period_s, 0.02, kLongestPeriod_s);
}

void ProgramTalk::begin() {
    m_lines.clear();
    m_hello.reset();
    m_misfit.clear();
    m_asked.clear();
    m_bad_s.clear();
    m_programClock = {};
    m_rate.clear();
    m_id = m_seq = 0;
    m_nextRead_s = m_clock.now_s();
    m_keeper.link().write(programHello(++m_id, m_role));
    m_asked.push_back({Kind::Hello, m_id, m_clock.now_s()});
}

void ProgramTalk::end(const std::string& words) {
    end(Message{MessageCode::ProgramStopped, {m_name, words}});
}

void ProgramTalk::end(const Message& why) {
    m_ended = why;
    m_keeper.close(m_clock.now_s());
}

void ProgramTalk::takeLine(const std::string& text, const Take& take) {
    if (text.size() >= program::kLongestLine)
        return end("a line of it is longer than " + std::to_string(program::kLongestLine) + " bytes");
    const auto line = parseProgramLine(text, m_role);
    if (!line) { // its request is answered nevertheless, and the next is asked
        const ProgramNumbers numbers = programNumbers(text);
        m_seq = numbers.seq.value_or(m_seq + 1);
        if (const auto known = find(numbers.id); known != m_asked.end())
            m_asked.erase(m_asked.begin(), std::next(known));
        return complain(plainWords(text.substr(0, 60)) + ": " + describe(line.error()));
    }
    std::optional<ProgramRequest> asked;
    if (!answers(*line, asked))
        return;
    const ProgramRequest* request = asked ? &*asked : nullptr;
    if (request == nullptr && std::holds_alternative<ProgramRefusal>(line->what))
        return complain("it could not read a line: " + std::get<ProgramRefusal>(line->what).words);
    if (!checkClock(*line, request))
        return;
    if (const auto* hello = std::get_if<ProgramHello>(&line->what)) {
        takeHello(*hello);
    } else if (!m_hello) {
        return request == nullptr ? complain("a state before its hello") : end("it refuses to say hello");
    } else if (std::holds_alternative<ProgramRefusal>(line->what) && request->kind == Kind::Read) {
        return note("it refuses to tell its state: " + std::get<ProgramRefusal>(line->what).words);
    }
    const double now_s = m_clock.now_s();
    if (request != nullptr)
        m_replyTime_s = now_s - request->sent_s;
    if (line->isState() && mayWrite()) {
        m_state_s = now_s;
        m_rate.answered(now_s);
        m_wasLive = true;
        m_ended = {};
    }
    if (mayWrite())
        take(*line, request);
}

std::deque<ProgramRequest>::iterator ProgramTalk::find(const std::optional<std::int64_t>& id) {
    return id ? std::ranges::find(m_asked, *id, &ProgramRequest::id) : m_asked.end();
}

/// Requests are answered in their order, and each with what it asks for.
bool ProgramTalk::answers(const ProgramLine& line, std::optional<ProgramRequest>& asked) {
    const std::int64_t due = m_seq + 1;
    m_seq = line.seq;
    const auto known = find(line.id);
    const bool isFirst = known == m_asked.begin(), isKnown = known != m_asked.end();
    if (isKnown) { // those before it are not answered any more
        asked = *known;
        m_asked.erase(m_asked.begin(), std::next(known));
    }
    if (line.seq != due) {
        complain("line " + std::to_string(line.seq) + " (seq) instead of line " + std::to_string(due));
        return false;
    }
    if (!line.id)
        return true;
    if (!isKnown) {
        complain("an answer to request " + std::to_string(*line.id) + " (id), which is not open");
        return false;
    }
    if (!isFirst) {
        complain("an answer to request " + std::to_string(*line.id) + " (id) before those of earlier ones");
        return false;
    }
    const bool isRefusal = std::holds_alternative<ProgramRefusal>(line.what);
    const bool isHello = std::holds_alternative<ProgramHello>(line.what);
    if (isRefusal ||
        (isHello == (asked->kind == Kind::Hello) && line.isState() == (asked->kind == Kind::Read)))
        return true;
    complain("request " + std::to_string(*line.id) + " is answered with something else");
    return false;
}

/// The answer was written between its request and now. The first answer to a read is the measure: the program
/// may have started slowly before.
bool ProgramTalk::checkClock(const ProgramLine& line, const ProgramRequest* asked) {
    if (asked == nullptr || asked->kind == Kind::Hello)
        return true;
    const double now_s = m_clock.now_s();
    const double off_s = m_programClock.off_s(line.time_s, asked->sent_s, now_s);
    const double room_s = kClockOff_s + kClockDrift * m_programClock.since_s(now_s);
    if (off_s <= room_s)
        return true;
    end("its clock is off by " + formatNumber(off_s, 2) + " s");
    return false;
}

void ProgramTalk::takeHello(const ProgramHello& hello) {
    m_hello = hello;
    m_hello_s = m_clock.now_s();
    if (!m_expected)
        m_expected = signature();
}

std::string ProgramTalk::signature() const {
    return m_hello->serial.empty() ? m_hello->name : m_hello->name + ", " + m_hello->serial;
}

bool ProgramTalk::isOther() const {
    return m_hello && m_expected && signature() != *m_expected;
}

void ProgramTalk::refuse(const std::string& words) {
    m_misfit = words;
}

void ProgramTalk::note(const std::string& words) {
    m_complained_s = m_clock.now_s();
    m_complaint = {MessageCode::DeviceAnswersWrong, {m_name, words}};
}

void ProgramTalk::complain(const std::string& words) {
    const double now_s = m_clock.now_s();
    ++m_discards;
    note(words);
    m_bad_s.push_back(now_s);
    while (now_s - m_bad_s.front() > kBadWindow_s)
        m_bad_s.pop_front();
    if (m_bad_s.size() >= kMaxBad)
        end(std::to_string(m_bad_s.size()) + " lines of it could not be used, the last one: " + words);
}

void ProgramTalk::watch() {
    const double now_s = m_clock.now_s();
    if (mayWrite() && m_keeper.silence_s(std::max(m_state_s, m_hello_s), now_s) > kNoState_s)
        return end("it has told no state for " + formatNumber(kNoState_s) + " s");
    if (m_asked.empty())
        return;
    const ProgramRequest& oldest = m_asked.front();
    const double silent_s = m_keeper.silence_s(oldest.sent_s, now_s);
    if (oldest.kind == Kind::Hello ? silent_s > kHello_s : silent_s > kSilence_s)
        end(Message{MessageCode::ProgramSilent, {m_name, formatNumber(silent_s, 2)}});
}

template <class Write> void ProgramTalk::write(Kind kind, Write text) {
    const bool isUrgent = kind == Kind::Stop || kind == Kind::Off;
    if (!m_keeper.isOpen() || !mayWrite() || (m_asked.size() >= kMaxAsked && !isUrgent))
        return;
    m_keeper.link().write(text(++m_id));
    m_asked.push_back({kind, m_id, m_clock.now_s()});
}

void ProgramTalk::send(Kind kind) {
    const char* const what = kind == Kind::Read    ? "read"
                             : kind == Kind::Stop  ? "stop"
                             : kind == Kind::Home  ? "home"
                             : kind == Kind::Clear ? "clear"
                                                   : "off";
    write(kind, [&](std::int64_t id) { return programRequest(id, what); });
}

void ProgramTalk::sendVelocity(const std::vector<double>& rates, double validFor_s) {
    write(Kind::Velocity, [&](std::int64_t id) { return programVelocity(id, rates, validFor_s); });
}

void ProgramTalk::sendStep(const std::vector<double>& to, double duration_s) {
    write(Kind::Step, [&](std::int64_t id) { return programStep(id, to, duration_s); });
}

void ProgramTalk::sendHeat(double setPoint_K, double validFor_s) {
    write(Kind::Heat, [&](std::int64_t id) { return programHeat(id, setPoint_K, validFor_s); });
}

double ProgramTalk::measuredAt_s(const ProgramLine& line, const ProgramRequest* asked) const {
    const double came_s = std::min(m_clock.now_s(), m_keeper.link().emptyAt_s());
    return (asked != nullptr ? asked->sent_s : came_s) - line.age_s;
}

bool ProgramTalk::isWaitingFor(Kind kind) const {
    return std::ranges::find(m_asked, kind, &ProgramRequest::kind) != m_asked.end();
}

bool ProgramTalk::isLive() const {
    return m_keeper.isOpen() && m_keeper.link().isOpen() && mayWrite() && m_state_s >= m_keeper.opened_s() &&
           m_keeper.silence_s(m_state_s, m_clock.now_s()) <= kSilence_s;
}

bool ProgramTalk::isSlow() const {
    return !m_asked.empty() && m_keeper.silence_s(m_asked.front().sent_s, m_clock.now_s()) > kSlow_s;
}

Message ProgramTalk::problem() const {
    if (Message ofLink = m_keeper.link().problem(); ofLink.code != MessageCode::None)
        return ofLink;
    if (isOther())
        return {MessageCode::DeviceExchanged, {m_name, *m_expected, signature()}};
    if (!m_misfit.empty())
        return {MessageCode::ProgramOther, {m_name, m_misfit}};
    if (!m_keeper.isOpen() && m_ended.code != MessageCode::None)
        return m_ended;
    if (m_clock.now_s() - m_complained_s <= kTold_s)
        return m_complaint;
    if (isLive() && isSlow())
        return {MessageCode::ProgramSilent, {m_name, formatNumber(kSlow_s)}};
    return isLive() ? Message{} : m_ended;
}

DeviceStatus ProgramTalk::status() const {
    DeviceStatus out;
    out.problem = problem();
    out.link = isLive() ? LinkState::Live : m_wasLive ? LinkState::Lost : LinkState::Opening;
    out.lastReply_s = m_state_s;
    out.replyTime_s = m_replyTime_s;
    out.rate_Hz = isLive() ? m_rate.rate_Hz() : 0.0;
    out.discarded = m_discards;
    if (m_hello) {
        out.identity = signature();
        out.signature = signature();
    }
    return out;
}

Error ProgramTalk::error() const {
    Message message = problem();
    if (message.code == MessageCode::None)
        message = {
            MessageCode::ProgramSilent,
            {m_name,
             formatNumber(m_keeper.isOpen() ? m_keeper.silence_s(m_state_s, m_clock.now_s()) : 0.0, 2)}};
    Error error;
    error.message = std::move(message);
    return error;
}

} // namespace bask
