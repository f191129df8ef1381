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
constexpr int kAgain_ms = 10;
constexpr int kMaxDropped = 64; // reads; a line that has no end is babbling

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

// Never ends: a guard that beats and has no port would be worse than none.
void GuardedPort::serve() {
    for (;;) {
        const bool isRead = m_line.descriptor() >= 0 && !m_isLost;
        pollfd ends[] = {{m_commands[1], POLLIN, 0}, {isRead ? m_line.descriptor() : -1, POLLIN, 0}};
        if (::poll(ends, 2, -1) < 0) {
            ::poll(nullptr, 0, kAgain_ms);
            continue;
        }
        Command command{};
        if (ends[0].revents != 0) {
            if (::recv(m_commands[1], &command, sizeof command, MSG_DONTWAIT) == sizeof command)
                obey(command);
        } else if (ends[1].revents != 0) {
            const long count = m_line.read(m_told.bytes, sizeof m_told.bytes);
            m_isLost = count < 0;
            if (m_isLost)
                tell(Event::Lost);
            else if (count > 0)
                tell(Event::Bytes, static_cast<std::size_t>(count));
        }
    }
}

void GuardedPort::obey(const Command& command) {
    m_told.number = command.number;
    switch (command.kind) {
    case Command::Kind::Close:
        return m_line.close();
    case Command::Kind::Open:
        m_line.close();
        m_told.problem = m_line.open();
        m_isLost = false;
        return tell(m_told.problem == 0 ? Event::Opened : Event::Failed);
    case Command::Kind::Drop:
        long count = m_isLost ? -1 : 1;
        for (int i = 0; i < kMaxDropped && count > 0; ++i)
            count = m_line.read(m_told.bytes, sizeof m_told.bytes);
        m_isLost = count < 0;
        return tell(m_isLost ? Event::Lost : Event::Dropped);
    }
}

void GuardedPort::tell(Event event, std::size_t count) {
    m_told.event = event;
    const std::size_t size = offsetof(Packet, bytes) + count;
    while (::send(m_events[1], &m_told, size, MSG_NOSIGNAL) < 0) // for want of memory
        ::poll(nullptr, 0, kAgain_ms);
}

/// False: it is not taken; what is told from here on is void all the same.
bool GuardedPort::order(Command::Kind kind) {
    const Command command{++m_number, kind};
    return ::send(m_commands[0], &command, sizeof command, MSG_DONTWAIT | MSG_NOSIGNAL) == sizeof command;
}

void GuardedPort::open() {
    m_isOpen = false;
    m_queued = 0;
    m_isOpening = order(Command::Kind::Open);
}

void GuardedPort::close() {
    if (!m_isOpen && !m_isOpening)
        return;
    for (int i = 0; m_isOpen && !isFlushed() && i < kLast_ms && flush(); ++i)
        ::poll(nullptr, 0, 1);
    m_isOpen = m_isOpening = false;
    m_queued = 0;
    (void)order(Command::Kind::Close);
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
    drop();
}

void GuardedPort::drop() {
    if (m_isOpen)
        (void)order(Command::Kind::Drop);
}

} // namespace bask::guard
