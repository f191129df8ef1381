#include "engine/drivers/link_watch.h"

#include "engine/base/message_code.h"

#include <algorithm>

namespace bask {
namespace {

/// A line as it can be shown: short, and what cannot be printed as a point.
std::string shown(std::string_view line) {
    std::string text(line.substr(0, 40));
    std::ranges::replace_if(
        text, [](char c) { return c < ' ' || c > '~'; }, '.');
    return "\"" + text + "\"";
}

} // namespace

LinkWatch::LinkWatch(ByteLink& link, const Clock& clock, double silence_s)
    : m_keeper(link), m_clock(clock), m_silence_s(silence_s) {}

LinkWatch::Turn LinkWatch::work() {
    const double now_s = m_clock.now_s();
    m_isAsked = true;
    switch (m_keeper.work(now_s)) {
    case LinkKeeper::Found::Opened:
        m_rate.clear();
        return Turn::Opened;
    case LinkKeeper::Found::Open:
        break;
    case LinkKeeper::Found::Lost:
    case LinkKeeper::Found::Closed:
        if (const Message lost = m_keeper.link().problem(); lost.code != MessageCode::None)
            m_problem = lost;
        return Turn::Closed;
    }
    if (m_keeper.silence_s(m_lastReply_s, now_s) <= m_silence_s)
        return Turn::Open;
    m_problem = silent();
    m_keeper.close(now_s);
    return Turn::Closed;
}

void LinkWatch::answered(double replyTime_s) {
    m_lastReply_s = m_clock.now_s();
    m_replyTime_s = replyTime_s;
    m_problem = {};
    m_rate.answered(m_lastReply_s);
}

void LinkWatch::discarded(std::string_view line) {
    ++m_discards;
    complain(shown(line));
}

void LinkWatch::complain(const std::string& words) {
    m_complained_s = m_clock.now_s();
    m_complaint = {MessageCode::DeviceAnswersWrong, {m_keeper.link().name(), words}};
}

bool LinkWatch::isLive() const {
    return m_keeper.isOpen() && m_keeper.link().isOpen() && m_lastReply_s >= m_keeper.opened_s() &&
           m_clock.now_s() - m_lastReply_s <= m_silence_s;
}

Message LinkWatch::problem() const {
    const Message ofLink = m_keeper.link().problem();
    if (ofLink.code != MessageCode::None)
        return ofLink;
    if (m_clock.now_s() - m_complained_s <= kTold_s)
        return m_complaint;
    if (isLive())
        return {};
    const bool isSilent = m_problem.code == MessageCode::None && m_lastReply_s > -1e300;
    return isSilent ? silent() : m_problem; // work() says so a moment later
}

Message LinkWatch::silent() const {
    return {MessageCode::DeviceSilent, {m_keeper.link().name(), formatNumber(m_silence_s)}};
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
        status.rate_Hz = m_rate.rate_Hz();
    } else if (m_isAsked) {
        status.link = m_lastReply_s > -1e300 ? LinkState::Lost : LinkState::Opening;
    }
    return status;
}

Error LinkWatch::error() const {
    Message message = problem();
    if (message.code == MessageCode::None) {
        const double since_s = std::max(m_keeper.opened_s(), m_lastReply_s);
        const double silent_s = since_s > -1e300 ? m_clock.now_s() - since_s : 0.0;
        message = {MessageCode::DeviceSilent, {m_keeper.link().name(), formatNumber(silent_s, 2)}};
    }
    return {message.code, {}, message.args};
}

} // namespace bask
