#include "engine/drivers/logged_link.h"

#include "engine/base/message_code.h"

#include <utility>

namespace bask {

Result<void> LinkDesk::send(const std::string& link, std::string_view bytes) {
    if (bytes.empty() || bytes.size() > LoggedLink::kMaxByHand)
        return Error(MessageCode::ValueOutOfRange, "bytes",
                     {std::to_string(bytes.size()), "1", std::to_string(LoggedLink::kMaxByHand), ""});
    for (LoggedLink* each : m_links) {
        if (each->name() != link || !each->isThere())
            continue;
        each->m_isByHand = true;
        each->m_byHandUntil_s = each->m_clock.now_s() + LoggedLink::kByHand_s;
        each->add(TrafficKind::SentByHand, bytes);
        each->m_link->write(bytes);
        return {};
    }
    return Error(MessageCode::LinkNotOpened, {}, {link, "it is not open now"});
}

void LinkDesk::work() {
    for (LoggedLink* each : m_links) {
        if (!each->m_isByHand)
            continue;
        if (const std::string bytes = each->m_link->read(); !bytes.empty())
            each->add(TrafficKind::Received, bytes);
        each->m_isByHand = each->isThere();
    }
}

void LinkDesk::end() {
    for (LoggedLink* each : m_links)
        each->m_byHandUntil_s = 0.0;
}

LoggedLink::LoggedLink(std::unique_ptr<ByteLink> link, std::shared_ptr<TrafficLog> log, const Clock& clock,
                       LinkDesk* desk, After after)
    : m_link(std::move(link)), m_log(std::move(log)), m_clock(clock), m_desk(desk), m_after(after) {
    if (m_desk != nullptr)
        m_desk->m_links.push_back(this);
}

LoggedLink::~LoggedLink() {
    if (m_desk != nullptr)
        std::erase(m_desk->m_links, this);
    if (m_isTold)
        add(TrafficKind::Closed);
}

void LoggedLink::add(TrafficKind kind, std::string_view bytes) const {
    m_log->add(kind, m_link->name(), bytes, m_clock.now_s());
}

bool LoggedLink::isThere() const {
    const bool isThere = m_link->isOpen();
    if (std::exchange(m_isTold, isThere) != isThere)
        add(isThere ? TrafficKind::Opened : TrafficKind::Closed);
    return isThere;
}

void LoggedLink::open() {
    if (m_isByHand && isThere() && m_clock.now_s() < m_byHandUntil_s)
        return;
    if (m_isByHand && m_after == After::Restarted)
        m_link->close();
    m_isByHand = false;
    if (isThere())
        (void)m_link->read(); // of before
    else
        m_link->open();
    (void)isThere();
}

void LoggedLink::close() {
    if (m_isByHand)
        return; // it is not the driver's
    m_link->close();
    (void)isThere();
}

bool LoggedLink::isOpen() const {
    return isThere() && !m_isByHand;
}

Message LoggedLink::problem() const {
    return m_isByHand ? Message{MessageCode::LinkByHand, {name()}} : m_link->problem();
}

std::string LoggedLink::read() {
    if (m_isByHand)
        return {};
    std::string bytes = m_link->read();
    if (!bytes.empty())
        add(TrafficKind::Received, bytes);
    return bytes;
}

void LoggedLink::write(std::string_view bytes) {
    if (m_isByHand)
        return;
    if (isThere())
        add(TrafficKind::Sent, bytes);
    m_link->write(bytes);
}

} // namespace bask
