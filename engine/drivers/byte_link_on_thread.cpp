#include "engine/drivers/byte_link_on_thread.h"

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
    const std::string bytes = unread < kMostUnread ? m_link->read() : std::string();
    const bool isOpen = m_link->isOpen();
    const Message problem = m_link->problem();
    const bool isFailed = !isOpen && problem.code != MessageCode::None;
    if (isFailed)
        m_thread.stop();
    const std::lock_guard lock(m_mutex);
    if (m_done != m_wanted)
        return;
    m_unread += bytes;
    m_isOpen = isOpen;
    m_isOpening = m_isOpening && !isOpen && !isFailed;
    m_problem = problem;
}

bool ByteLinkOnThread::isOpen() const {
    const std::lock_guard lock(m_mutex);
    return m_isOpen;
}

Message ByteLinkOnThread::problem() const {
    const std::lock_guard lock(m_mutex);
    return m_problem;
}

std::string ByteLinkOnThread::read() {
    const std::lock_guard lock(m_mutex);
    return std::exchange(m_unread, {});
}

void ByteLinkOnThread::write(std::string_view bytes) {
    const std::lock_guard lock(m_mutex);
    if (!m_isOpen)
        return;
    if (m_unwritten + bytes.size() > kMostQueued) {
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
