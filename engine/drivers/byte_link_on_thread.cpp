#include "engine/drivers/byte_link_on_thread.h"

#include "engine/base/clock.h"
#include "engine/base/message_code.h"

#include <utility>

namespace bask {

ByteLinkOnThread::ByteLinkOnThread(std::string name, std::function<std::unique_ptr<ByteLink>()> make)
    : m_name(std::move(name)), m_thread([this] { turn(); }) {
    m_thread.post([this, make = std::move(make)] { m_link = make(); });
}

ByteLinkOnThread::~ByteLinkOnThread() {
    m_thread.finish([this] {
        m_thread.stop();
        m_link.reset();
    });
}

void ByteLinkOnThread::open() {
    const std::lock_guard lock(m_mutex);
    if (m_isOpening)
        return;
    drop();
    m_problem = {};
    m_isOpening = true;
    m_thread.post([this, wanted = m_wanted] {
        m_done = wanted;
        m_looked_s = SteadyClock().now_s();
        m_link->open();
        m_thread.start();
        turn();
    });
}

void ByteLinkOnThread::close() {
    const std::lock_guard lock(m_mutex);
    shut();
}

/// Under the mutex.
void ByteLinkOnThread::shut() {
    drop();
    m_thread.post([this, wanted = m_wanted] {
        m_done = wanted;
        m_thread.stop();
        m_link->close();
    });
}

/// What was before is no more; under the mutex.
void ByteLinkOnThread::drop() {
    ++m_wanted;
    m_isOpen = m_isOpening = false;
    m_unread.clear();
}

/// There: takes over what the link has and how it is.
void ByteLinkOnThread::turn() {
    const std::size_t unread = [this] {
        const std::lock_guard lock(m_mutex);
        return m_unread.size();
    }();
    const bool looks = unread < kMaxUnread;
    const double begun_s = SteadyClock().now_s();
    const std::string bytes = looks ? m_link->read() : std::string();
    const double emptyAt_s = m_looked_s;
    if (looks)
        m_looked_s = begun_s;
    const bool isOpen = m_link->isOpen();
    const Message problem = m_link->problem();
    const std::string portId = m_link->portId();
    const bool isFailed = !isOpen && problem.code != MessageCode::None;
    if (isFailed)
        m_thread.stop();
    const std::lock_guard lock(m_mutex);
    if (m_done != m_wanted)
        return;
    if (m_unread.empty())
        m_unreadEmptyAt_s = bytes.empty() ? begun_s : emptyAt_s;
    m_unread += bytes;
    m_isOpen = isOpen;
    m_isOpening = m_isOpening && !isOpen && !isFailed;
    m_problem = problem;
    m_portId = portId;
}

bool ByteLinkOnThread::isOpen() const {
    const std::lock_guard lock(m_mutex);
    return m_isOpen;
}

std::string ByteLinkOnThread::portId() const {
    const std::lock_guard lock(m_mutex);
    return m_portId;
}

Message ByteLinkOnThread::problem() const {
    const std::lock_guard lock(m_mutex);
    return m_problem;
}

std::string ByteLinkOnThread::read() {
    const std::lock_guard lock(m_mutex);
    m_readEmptyAt_s = m_unreadEmptyAt_s;
    return std::exchange(m_unread, {});
}

double ByteLinkOnThread::emptyAt_s() const {
    const std::lock_guard lock(m_mutex);
    return m_readEmptyAt_s;
}

void ByteLinkOnThread::write(std::string_view bytes) {
    const std::lock_guard lock(m_mutex);
    if (!m_isOpen)
        return;
    if (m_unwritten + bytes.size() > kMaxQueued) {
        shut();
        m_problem = {MessageCode::LinkStuck, {m_name}};
        return;
    }
    m_unwritten += bytes.size();
    m_thread.post([this, text = std::string(bytes)] {
        m_link->write(text);
        const std::lock_guard inner(m_mutex);
        m_unwritten -= text.size();
    });
}

} // namespace bask
