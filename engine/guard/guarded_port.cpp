#include "engine/guard/guarded_port.h"

#include <asm/termbits.h>
#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <poll.h>
#include <pthread.h>
#include <sched.h>
#include <sys/ioctl.h>
#include <sys/socket.h>
#include <unistd.h>

namespace bask::guard {
namespace {

constexpr std::size_t kStack = 128 * 1024; // all of it is locked in memory
constexpr int kLast_ms = 100;              // for the last bytes before it is closed, which may be a stop

} // namespace

GuardedPort::GuardedPort(const PortSettings& settings) : m_line(settings) {
    if (::socketpair(AF_UNIX, SOCK_SEQPACKET | SOCK_CLOEXEC, 0, m_commands) != 0 ||
        ::socketpair(AF_UNIX, SOCK_SEQPACKET | SOCK_CLOEXEC, 0, m_events) != 0)
        return;
    pthread_attr_t attributes;
    ::pthread_attr_init(&attributes);
    ::pthread_attr_setstacksize(&attributes, kStack);
    m_isWorking = ::pthread_create(&m_thread, &attributes, run, this) == 0;
    ::pthread_attr_destroy(&attributes);
}

void* GuardedPort::run(void* port) {
    const sched_param first{1};
    ::sched_setscheduler(0, SCHED_RR, &first); // where that is allowed
    static_cast<GuardedPort*>(port)->serve();
    return nullptr;
}

void GuardedPort::serve() {
    Command command{};
    bool isLost = true;
    for (;;) {
        pollfd ends[] = {{m_commands[1], POLLIN, 0}, {isLost ? -1 : m_line.descriptor(), POLLIN, 0}};
        if (::poll(ends, 2, -1) < 0)
            continue;
        m_told.number = command.number;
        if (ends[0].revents != 0) {
            if (::recv(m_commands[1], &command, sizeof command, 0) != sizeof command)
                return;
            m_line.close();
            isLost = true;
            if (!command.isOpen)
                continue;
            m_told.number = command.number;
            m_told.problem = m_line.open();
            isLost = m_told.problem != 0;
            if (!tell(isLost ? Event::Failed : Event::Opened))
                return;
        } else if (ends[1].revents != 0) {
            const long count = m_line.read(m_told.bytes, sizeof m_told.bytes);
            isLost = count < 0;
            if (count != 0 &&
                !tell(isLost ? Event::Lost : Event::Bytes, isLost ? 0 : static_cast<std::size_t>(count)))
                return;
        }
    }
}

bool GuardedPort::tell(Event event, std::size_t count) {
    m_told.event = event;
    const std::size_t size = offsetof(Packet, bytes) + count;
    while (::send(m_events[1], &m_told, size, MSG_NOSIGNAL) < 0)
        if (errno != EINTR)
            return false;
    return true;
}

void GuardedPort::order(bool isOpen) {
    const Command command{++m_number, isOpen};
    m_isOpening = ::send(m_commands[0], &command, sizeof command, MSG_NOSIGNAL) == sizeof command && isOpen;
    m_isOpen = false;
    m_queued = 0;
}

void GuardedPort::open() {
    order(true);
}

void GuardedPort::close() {
    if (!m_isOpen && !m_isOpening)
        return;
    for (int i = 0; m_isOpen && !isFlushed() && i < kLast_ms && flush(); ++i)
        ::poll(nullptr, 0, 1);
    order(false);
}

GuardedPort::Event GuardedPort::take(void* bytes, std::size_t& count) {
    for (;;) {
        const ssize_t size = ::recv(m_events[0], &m_taken, sizeof m_taken, MSG_DONTWAIT);
        if (size < 0 && errno == EINTR)
            continue;
        if (size < static_cast<ssize_t>(offsetof(Packet, bytes)))
            return Event::None;
        if (m_taken.number != m_number) // of one that was closed since
            continue;
        if (m_taken.event == Event::Opened || m_taken.event == Event::Failed) {
            m_isOpening = false;
            m_isOpen = m_taken.event == Event::Opened;
            m_problem = m_taken.problem;
        }
        count = static_cast<std::size_t>(size) - offsetof(Packet, bytes);
        std::memcpy(bytes, m_taken.bytes, count);
        return m_taken.event;
    }
}

bool GuardedPort::write(const void* bytes, std::size_t count) {
    if (m_queued + count > sizeof m_queue)
        return false;
    std::memcpy(m_queue + m_queued, bytes, count);
    m_queued += count;
    return true;
}

bool GuardedPort::flush() {
    while (m_queued > 0) {
        const ssize_t count = ::write(m_line.descriptor(), m_queue, m_queued);
        if (count < 0)
            return errno == EAGAIN || errno == EINTR;
        if (count == 0)
            return true;
        m_queued -= static_cast<std::size_t>(count);
        std::memmove(m_queue, m_queue + count, m_queued);
    }
    return true;
}

void GuardedPort::forget() {
    m_queued = 0;
    if (m_isOpen)
        ::ioctl(m_line.descriptor(), TCFLSH, TCIOFLUSH);
}

} // namespace bask::guard
