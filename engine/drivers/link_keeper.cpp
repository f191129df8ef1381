#include "engine/drivers/link_keeper.h"

#include "engine/base/message_code.h"

#include <algorithm>
#include <utility>

namespace bask {
namespace {

constexpr double kReopen_s = 0.5;
constexpr double kOpening_s = 3.0; // a link that neither opens nor fails is opened anew
constexpr double kPause_s = 0.5;   // since the last call: the engine was silent, not the device

} // namespace

LinkKeeper::Found LinkKeeper::work(double now_s) {
    if (now_s - m_worked_s > kPause_s)
        m_listening_s = now_s;
    m_worked_s = now_s;
    if (m_link.isOpen()) {
        if (std::exchange(m_isOpen, true))
            return Found::Open;
        m_opened_s = now_s;
        return Found::Opened;
    }
    if (m_isOpen) {
        m_isOpen = m_isOpening = false;
        m_tried_s = now_s;
        return Found::Lost;
    }
    const MessageCode problem = m_link.problem().code;
    const bool hasFailed = problem != MessageCode::None;
    if (problem == MessageCode::LinkByHand) // the port is open: it is free as soon as the person has done
        m_tried_s = -1e300;
    if (now_s - m_tried_s >= (hasFailed || !m_isOpening ? kReopen_s : kOpening_s)) {
        m_tried_s = now_s;
        m_isOpening = true;
        m_link.open();
    }
    return Found::Closed;
}

double LinkKeeper::silence_s(double last_s, double now_s) const {
    return now_s - std::max({last_s, m_opened_s, m_listening_s});
}

void LinkKeeper::close(double now_s) {
    m_link.close();
    m_isOpen = m_isOpening = false;
    m_tried_s = now_s;
}

Message LinkKeeper::problem() const {
    const Message problem = m_link.problem();
    return problem.code == MessageCode::None ? Message{MessageCode::LinkLost, {m_link.name(), "closed"}}
                                             : problem;
}

} // namespace bask
