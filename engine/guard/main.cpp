// bask-guard: has a heater's port in Bask's place, and switches the heater off when Bask no longer beats.
// Nothing is allocated after the start, and nothing waited for but the port.

#include "engine/guard/off_run.h"

#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <fcntl.h>
#include <poll.h>
#include <sched.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <unistd.h>

namespace bask::guard {
namespace {

constexpr int kLook_ms = 50; // between looks at the time

volatile std::sig_atomic_t g_mustEnd = 0;

/// The one that goes on while the computer sleeps: an engine that slept has not beaten either.
double now_s() {
    timespec now{};
    ::clock_gettime(CLOCK_BOOTTIME, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

/// Ended last: out of Bask's session, deaf to what ends it, and kept in memory where that is allowed.
void outlive() {
    ::setsid();
    struct sigaction action {};
    action.sa_handler = SIG_IGN;
    constexpr int kIgnored[] = {SIGINT,  SIGHUP,  SIGPIPE, SIGQUIT, SIGTSTP,
                                SIGTTIN, SIGTTOU, SIGUSR1, SIGUSR2};
    for (const int each : kIgnored)
        ::sigaction(each, &action, nullptr);
    action.sa_handler = [](int) { g_mustEnd = 1; };
    ::sigaction(SIGTERM, &action, nullptr); // a shutdown: off first
    ::prctl(PR_SET_NAME, "bask-guard");
    ::close_range(kSocket + 1, ~0U, 0);
    if (const int nothing = ::open("/dev/null", O_RDWR);
        nothing >= 0) { // whoever reads Bask's words waits for no more
        for (int each = STDIN_FILENO; each <= STDERR_FILENO; ++each)
            ::dup2(nothing, each);
        ::close(nothing);
    }
    if (::chdir("/") != 0) {
        // it then holds the folder, which is no harm
    }
    if (const int file = ::open("/proc/self/oom_score_adj", O_WRONLY | O_CLOEXEC); file >= 0) {
        [[maybe_unused]] const ssize_t written = ::write(file, "-1000", 5);
        ::close(file);
    }
    ::setpriority(PRIO_PROCESS, 0, -15);
    const sched_param first{1};
    ::sched_setscheduler(0, SCHED_RR | SCHED_RESET_ON_FORK, &first);
}

class Guard {
public:
    Guard(const PortSettings& settings, GuardLog& log) : m_port(settings), m_log(log) {}

    int run() {
        if (!m_port.isWorking())
            return 1;
        const char version = kVersion;
        tell(Told::Hello, &version, 1);
        m_beat_s = now_s();
        for (;;) {
            pollfd ends[] = {{kSocket, POLLIN, 0}, {m_port.descriptor(), POLLIN, 0}};
            ::poll(ends, 2, m_port.isFlushed() ? kLook_ms : GuardedPort::kFlush_ms);
            const bool isThere = hear(); // all of it, before its silence is judged
            if (m_isArmed) {
                if (!isThere)
                    return takeOver("Bask has ended");
                if (now_s() - m_beat_s > kSilence_s)
                    return takeOver("Bask does not answer");
                if (g_mustEnd != 0)
                    return takeOver("the guard is told to end");
                if (m_mustTakeOver)
                    return takeOver("Bask has not seen the heat go off");
            } else if (!isThere) {
                return 0;
            }
            pump();
        }
    }

private:
    void tell(Told kind, const void* bytes = nullptr, std::size_t count = 0) {
        m_packet[0] = static_cast<char>(kind);
        if (count > 0)
            std::memcpy(m_packet + 1, bytes, count);
        // What a full queue does not take is lost: an engine that does not read has no use for it later.
        ::send(kSocket, m_packet, 1 + count, MSG_DONTWAIT | MSG_NOSIGNAL);
    }

    /// Everything that the engine has said; false: it is gone.
    bool hear() {
        for (;;) {
            const ssize_t count = ::recv(kSocket, m_packet, sizeof m_packet, MSG_DONTWAIT);
            if (count > 0)
                obey(static_cast<Order>(m_packet[0]), m_packet + 1, static_cast<std::size_t>(count) - 1);
            else if (count < 0 && (errno == EINTR || errno == ECONNRESET))
                continue; // the second is told once, before what still waits: its end is a 0
            else
                return count < 0 && errno == EAGAIN;
        }
    }

    void obey(Order order, const char* bytes, std::size_t count) {
        switch (order) {
        case Order::Beat:
            m_beat_s = now_s();
            return tell(Told::Beat);
        case Order::Open:
            return m_port.open();
        case Order::Close:
            return m_port.close();
        case Order::Write:
            if (m_port.isOpen() && !m_port.write(bytes, count))
                lose(Told::Stuck);
            return;
        case Order::Program:
            if (count == sizeof m_program)
                std::memcpy(&m_program, bytes, count);
            return;
        case Order::Arm:
            m_isArmed = true;
            return;
        case Order::Disarm:
            m_isArmed = false;
            return;
        case Order::TakeOver:
            m_mustTakeOver = true;
            return;
        }
    }

    void lose(Told how) {
        m_port.close();
        tell(how);
    }

    void pump() {
        if (m_port.isOpen() && !m_port.flush())
            return lose(Told::Lost);
        char bytes[GuardedPort::kMaxBytes];
        std::size_t count = 0;
        for (;;) {
            switch (m_port.take(bytes, count)) {
            case GuardedPort::Event::None:
                return;
            case GuardedPort::Event::Dropped:
                break;
            case GuardedPort::Event::Opened:
                tell(Told::Opened, m_port.id(), std::strlen(m_port.id()));
                break;
            case GuardedPort::Event::Failed:
                tellFailed();
                break;
            case GuardedPort::Event::Bytes:
                tell(Told::Bytes, bytes, count);
                break;
            case GuardedPort::Event::Lost:
                return lose(Told::Lost);
            }
        }
    }

    void tellFailed() {
        const int problem = m_port.problem();
        if (problem == SerialLine::kExchanged)
            tell(Told::Exchanged, m_port.id(), std::strlen(m_port.id()));
        else
            tell(Told::Failed, &problem, sizeof problem);
    }

    int takeOver(const char* why) {
        tell(Told::TookOver, why, std::strlen(why));
        m_log.say("takes over: %s", why);
        OffRun(m_port, m_program, m_log).untilConfirmed();
        m_port.close();
        tell(Told::Off);
        m_log.finish();
        return 0;
    }

    GuardedPort m_port;
    GuardLog& m_log;
    OffProgram m_program;
    bool m_isArmed = false, m_mustTakeOver = false;
    double m_beat_s = 0.0;
    char m_packet[1 + kMax] = {};
};

int run(char** words) {
    const PortSettings settings{words[1],    std::atoi(words[2]), std::atoi(words[3]),
                                words[4][0], std::atoi(words[5]), words[7],
                                words[8]};
    outlive();
    static GuardLog log(words[6], settings.path);
    ::mlockall(MCL_CURRENT | MCL_FUTURE);
    static Guard guard(settings, log);
    return guard.run();
}

} // namespace
} // namespace bask::guard

int main(int argc, char** argv) {
    int kind = 0;
    socklen_t size = sizeof kind;
    const bool isSocket =
        ::getsockopt(bask::guard::kSocket, SOL_SOCKET, SO_TYPE, &kind, &size) == 0 && kind == SOCK_SEQPACKET;
    if (argc == 9 && isSocket)
        return bask::guard::run(argv);
    std::fprintf(stderr, "bask-guard is started by Bask: it switches a heater off when Bask cannot.\n");
    return 2;
}
