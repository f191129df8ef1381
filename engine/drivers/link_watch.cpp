#include "engine/drivers/link_watch.h"

#include "engine/base/message_code.h"

#include <algorithm>

namespace bask {
namespace {

constexpr std::size_t kRepliesForRate = 20;

/// A line as it can be shown: short, and what cannot be printed as a point.
std::string shown(std::string_view line) {
    std::string text(line.substr(0, 40));
    std::ranges::replace_if(
        text, [](char c) { return c < ' ' || c > '~'; }, '.');
    return "\"" + text + "\"";
}

} // namespace

LinkWatch::LinkWatch(ByteLink& link, const Clock& clock, double silence_s)
    : m_link(link), m_clock(clock), m_silence_s(silence_s) {}

LinkWatch::Turn LinkWatch::opened() {
    m_isOpen = true;
    m_opened_s = m_waiting_s = m_clock.now_s();
    m_replies_s.clear();
    return Turn::Opened;
}

LinkWatch::Turn LinkWatch::work() {
    const double now_s = m_clock.now_s();
    m_isAsked = true;
    if (now_s - m_worked_s > kHeldUp_s)
        m_waiting_s = now_s; // what came meanwhile is still to be read
    m_worked_s = now_s;
    if (!m_link.isOpen()) {
        m_isOpen = false;
        if (now_s >= m_nextOpen_s) {
            if (const Message lost = m_link.problem(); lost.code != MessageCode::None)
                m_problem = lost;
            m_link.open();
            m_nextOpen_s = now_s + kReopen_s;
        }
        return m_link.isOpen() ? opened() : Turn::Closed;
    }
    if (!m_isOpen)
        return opened();
    if (now_s - std::max(m_waiting_s, m_lastReply_s) <= m_silence_s)
        return Turn::Open;
    m_problem = {MessageCode::DeviceSilent, {m_link.name(), formatNumber(m_silence_s)}};
    m_link.close();
    m_isOpen = false;
    m_nextOpen_s = now_s + kReopen_s;
    return Turn::Closed;
}

void LinkWatch::answered(double replyTime_s) {
    m_lastReply_s = m_clock.now_s();
    m_replyTime_s = replyTime_s;
    m_problem = {};
    m_replies_s.push_back(m_lastReply_s);
    if (m_replies_s.size() > kRepliesForRate)
        m_replies_s.pop_front();
}

void LinkWatch::discarded(std::string_view line) {
    ++m_discards;
    complain(shown(line));
}

void LinkWatch::complain(const std::string& words) {
    m_complained_s = m_clock.now_s();
    m_complaint = {MessageCode::DeviceAnswersWrong, {m_link.name(), words}};
}

bool LinkWatch::isLive() const {
    return m_isOpen && m_link.isOpen() && m_lastReply_s >= m_opened_s &&
           m_clock.now_s() - m_lastReply_s <= m_silence_s;
}

Message LinkWatch::problem() const {
    const Message ofLink = m_link.problem();
    if (ofLink.code != MessageCode::None)
        return ofLink;
    if (m_clock.now_s() - m_complained_s <= kTold_s)
        return m_complaint;
    return isLive() ? Message{} : m_problem;
}

DeviceStatus LinkWatch::status() const {
    DeviceStatus status;
    status.problem = problem();
    status.signature = "";
    status.lastReply_s = m_lastReply_s;
    status.replyTime_s = m_replyTime_s;
    status.discarded = m_discards;
    if (isLive()) {
        status.link = LinkState::Live;
        const double over_s = m_replies_s.back() - m_replies_s.front();
        if (over_s > 0.0)
            status.rate_Hz = static_cast<double>(m_replies_s.size() - 1) / over_s;
    } else if (m_isAsked) {
        status.link = m_lastReply_s > -1e300 ? LinkState::Lost : LinkState::Opening;
    }
    return status;
}

Error LinkWatch::error() const {
    Message message = problem();
    if (message.code == MessageCode::None) {
        const double since_s = std::max(m_opened_s, m_lastReply_s);
        const double silent_s = since_s > -1e300 ? m_clock.now_s() - since_s : 0.0;
        message = {MessageCode::DeviceSilent, {m_link.name(), formatNumber(silent_s, 2)}};
    }
    return {message.code, {}, message.args};
}

} // namespace bask
