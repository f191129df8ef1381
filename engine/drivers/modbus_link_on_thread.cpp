#include "engine/drivers/modbus_link_on_thread.h"

#include "engine/base/message_code.h"

#include <stdexcept>
#include <utility>

namespace bask {
namespace {} // namespace

ModbusLinkOnThread::ModbusLinkOnThread(std::string name, std::function<std::unique_ptr<ModbusLink>()> make)
    : m_name(std::move(name)), m_thread([this] { turn(); }) {
    m_thread.post([this, make = std::move(make)] { m_link = make(); });
}

ModbusLinkOnThread::~ModbusLinkOnThread() {
    m_thread.finish([this] {
        m_thread.stop();
        m_link.reset();
    });
}

void ModbusLinkOnThread::open() {
    const std::lock_guard lock(m_mutex);
    if (m_isOpening || m_isOpen)
        return;
    drop();
    m_problem = {};
    m_isOpening = true;
    m_thread.post([this, wanted = m_wanted] {
        m_done = wanted;
        m_toSend.reset();
        m_sent.reset();
        m_link->open();
        m_thread.start();
        turn();
    });
}

void ModbusLinkOnThread::close() {
    const std::lock_guard lock(m_mutex);
    drop();
    m_thread.post([this, wanted = m_wanted] {
        m_done = wanted;
        m_toSend.reset();
        m_sent.reset();
        m_thread.stop();
        m_link->close();
    });
}

/// What was before is no more, and the request under way is told that there was no answer; under the mutex.
void ModbusLinkOnThread::drop() {
    ++m_wanted;
    m_isOpen = m_isOpening = m_isFree = false;
    if (m_asked)
        m_replies.deliver(*std::exchange(m_asked, std::nullopt),
                          Error(MessageCode::DeviceSilent, "", {m_name, "0"}));
}

/// There: sends what waits, takes over what the line has and how it is.
void ModbusLinkOnThread::turn() {
    if (m_toSend && m_link->isFree())
        m_sent = m_link->send(*std::exchange(m_toSend, std::nullopt));
    auto reply = m_sent ? m_link->takeReply(*m_sent) : std::nullopt;
    if (reply)
        m_sent.reset();
    const bool isOpen = m_link->isOpen();
    const bool isFree = m_link->isFree();
    const Message problem = m_link->problem();
    const std::string portId = m_link->portId();
    const bool isFailed = !isOpen && problem.code != MessageCode::None;
    if (isFailed)
        m_thread.stop();
    const std::lock_guard lock(m_mutex);
    if (m_done != m_wanted)
        return;
    if (reply && m_asked)
        m_replies.deliver(*std::exchange(m_asked, std::nullopt), std::move(*reply));
    if (isFailed)
        drop();
    m_done = m_wanted;
    m_isOpen = isOpen;
    m_isFree = isFree && !m_asked;
    m_isOpening = m_isOpening && !isOpen && !isFailed;
    m_problem = problem;
    m_portId = portId;
}

bool ModbusLinkOnThread::isOpen() const {
    const std::lock_guard lock(m_mutex);
    return m_isOpen;
}

std::string ModbusLinkOnThread::portId() const {
    const std::lock_guard lock(m_mutex);
    return m_portId;
}

Message ModbusLinkOnThread::problem() const {
    const std::lock_guard lock(m_mutex);
    return m_problem;
}

bool ModbusLinkOnThread::isFree() const {
    const std::lock_guard lock(m_mutex);
    return m_isFree;
}

int ModbusLinkOnThread::send(const ModbusRequest& request) {
    const std::lock_guard lock(m_mutex);
    if (!m_isFree)
        throw std::logic_error("ModbusLinkOnThread: sends only when it is free");
    m_isFree = false;
    m_asked = ++m_lastNumber;
    m_thread.post([this, request, wanted = m_wanted] {
        if (m_done != wanted)
            return;
        m_toSend = request;
        turn();
    });
    return m_lastNumber;
}

std::optional<ModbusReply> ModbusLinkOnThread::takeReply(int number) {
    const std::lock_guard lock(m_mutex);
    return m_replies.take(number);
}

} // namespace bask
