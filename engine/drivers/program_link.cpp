#include "engine/drivers/program_link.h"

#include "engine/base/clock.h"
#include "engine/base/message_code.h"
#include "engine/base/thread_name.h"
#include "engine/drivers/confirmed_programs.h"
#include "engine/drivers/port_claim.h"
#include "engine/drivers/program_files.h"
#include "engine/drivers/spawn_process.h"
#include "engine/drivers/traffic_log.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <condition_variable>
#include <csignal>
#include <cstring>
#include <mutex>
#include <thread>
#include <utility>

#include <fcntl.h>
#include <poll.h>
#include <sys/eventfd.h>
#include <sys/wait.h>
#include <unistd.h>

namespace bask {
namespace {

constexpr std::size_t kMaxUnread = 128 * 1024;    ///< more waits in the pipe
constexpr std::size_t kMaxNotesPerSecond = 16384; ///< bytes that are kept of its standard error
constexpr std::size_t kMaxNote = 300;
constexpr int kMaxLooks = 16;
constexpr double kFirstPause_s = 0.5, kLongestPause_s = 8.0;
constexpr double kLongLife_s = 10.0; ///< of one that has not failed at its start
constexpr double kTerm_s = 1.0, kKill_s = 2.0;
constexpr int kLook_ms = 100, kLookAtEnd_ms = 10;

/// All threads that run a program.
struct Running {
    std::mutex mutex;
    std::condition_variable changed;
    int count = 0;
};

Running& running() {
    static Running* const kRunning = new Running; // a thread may outlive the statics
    return *kRunning;
}

class Descriptor {
public:
    Descriptor() = default;
    explicit Descriptor(int value) : m_value(value) {}
    ~Descriptor() { reset(); }
    Descriptor(Descriptor&& other) noexcept : m_value(std::exchange(other.m_value, -1)) {}
    Descriptor& operator=(Descriptor&& other) noexcept {
        reset();
        m_value = std::exchange(other.m_value, -1);
        return *this;
    }
    int get() const { return m_value; }
    void reset() {
        if (m_value >= 0)
            ::close(m_value);
        m_value = -1;
    }

private:
    int m_value = -1;
};

struct Pipe {
    Descriptor in, out; ///< to read, to write
};

Pipe makePipe() {
    std::array<int, 2> ends{-1, -1};
    if (::pipe2(ends.data(), O_CLOEXEC) != 0)
        return {};
    return {Descriptor(ends[0]), Descriptor(ends[1])};
}

void setNonBlocking(const Descriptor& end) {
    ::fcntl(end.get(), F_SETFL, ::fcntl(end.get(), F_GETFL) | O_NONBLOCK);
}

std::string endWords(const siginfo_t& end, const std::string& note) {
    std::string words = end.si_code == CLD_EXITED ? "exit code " + std::to_string(end.si_status)
                                                  : std::string("signal ") + std::to_string(end.si_status) +
                                                        " (" + ::strsignal(end.si_status) + ")";
    return note.empty() ? words : words + ", \"" + note + "\"";
}

} // namespace

class ProgramLink::Runner : public std::enable_shared_from_this<Runner> {
public:
    Runner(std::string command, std::string device, std::shared_ptr<const ConfirmedPrograms> confirmed,
           std::shared_ptr<TrafficLog> traffic)
        : m_command(std::move(command)), m_device(std::move(device)),
          m_name(programName(m_command) + " (" + m_device + ')'), m_confirmed(std::move(confirmed)),
          m_traffic(std::move(traffic)), m_wake(::eventfd(0, EFD_CLOEXEC | EFD_NONBLOCK)) {}

    void start() {
        {
            const std::lock_guard lock(running().mutex);
            ++running().count;
        }
        std::thread([self = shared_from_this()]() mutable {
            nameThread("device program");
            self->run();
            self.reset();
            const std::lock_guard lock(running().mutex);
            --running().count;
            running().changed.notify_all();
        }).detach();
    }
    void finish() {
        close();
        {
            const std::lock_guard lock(m_mutex);
            m_isFinished = true;
        }
        wake();
    }
    void open() {
        const std::lock_guard lock(m_mutex);
        if (m_isWanted || m_clock.now_s() < m_notBefore_s)
            return;
        m_isWanted = true;
        m_problem = {};
        wake();
    }
    void close() {
        const std::lock_guard lock(m_mutex);
        drop();
        wake();
    }
    bool isOpen() const {
        const std::lock_guard lock(m_mutex);
        return m_isOpen;
    }
    Message problem() const {
        const std::lock_guard lock(m_mutex);
        return m_problem;
    }
    std::string read() {
        const std::lock_guard lock(m_mutex);
        m_readEmptyAt_s = m_unreadEmptyAt_s;
        if (m_unread.size() >= kMaxUnread)
            wake();
        return std::exchange(m_unread, {});
    }
    double emptyAt_s() const {
        const std::lock_guard lock(m_mutex);
        return m_readEmptyAt_s;
    }
    void write(std::string_view bytes) {
        const std::lock_guard lock(m_mutex);
        if (!m_isOpen)
            return;
        if (m_unwritten.size() + bytes.size() > kMaxQueued) {
            fail({MessageCode::ProgramStopped, {m_name, "it does not read its standard input"}});
            return;
        }
        m_unwritten += bytes;
        wake();
    }
    const std::string& name() const { return m_name; }

private:
    // Under the mutex

    void drop() {
        m_mustEnd = m_mustEnd || m_isWanted; // also if it is opened again before the thread has looked
        m_isWanted = m_isOpen = false;
        m_unread.clear();
        m_unwritten.clear();
    }
    void fail(Message why) {
        m_problem = std::move(why);
        drop();
        wake();
    }
    void wake() const {
        const std::uint64_t one = 1;
        [[maybe_unused]] const auto written = ::write(m_wake.get(), &one, sizeof one);
    }

    // On the thread

    void run() {
        sigset_t pipe;
        sigemptyset(&pipe);
        sigaddset(&pipe, SIGPIPE);
        ::pthread_sigmask(SIG_BLOCK, &pipe, nullptr);
        while (true) {
            bool isWanted = false, isFinished = false, isDue = false, mustEnd = false;
            {
                const std::lock_guard lock(m_mutex);
                mustEnd = std::exchange(m_mustEnd, false);
                isWanted = m_isWanted;
                isFinished = m_isFinished;
                isDue = m_clock.now_s() >= m_notBefore_s;
            }
            if (m_pid > 0 && (mustEnd || !isWanted) && !m_isEnding)
                beginEnd();
            if (m_pid == 0 && isWanted && isDue)
                begin();
            if (m_pid == 0 && isFinished)
                return;
            waitForMore(isWanted);
            if (m_pid == 0)
                continue;
            writeInput();
            readOutput();
            readNotes();
            workEnd();
        }
    }
    void begin() {
        if (const Message why = startProgram(); why.code != MessageCode::None) {
            m_claim.release();
            pause(why.code == MessageCode::ProgramNotConfirmed); // which is no failed start
            const std::lock_guard lock(m_mutex);
            fail(why);
            return;
        }
        m_isEnding = false;
        m_begun_s = m_second_s = m_lookedAt_s = m_clock.now_s();
        m_inSecond = 0;
        m_note.clear();
        const std::lock_guard lock(m_mutex);
        m_isOpen = m_isWanted;
    }
    Message startProgram() {
        const auto files = programFiles(m_command);
        if (!files)
            return {MessageCode::ProgramNotStarted, {m_name, files.error().message.args.at(1)}};
        if (!m_confirmed || !m_confirmed->has(files->hash))
            return {MessageCode::ProgramNotConfirmed, {m_name}};
        if (!m_claim.take(m_device + ": " + files->hash)) // a command may be longer than such a name
            return {MessageCode::ProgramNotStarted, {m_name, "it runs already for this device"}};
        Pipe in = makePipe(), out = makePipe(), err = makePipe();
        if (in.in.get() < 0 || out.in.get() < 0 || err.in.get() < 0)
            return {MessageCode::ProgramNotStarted, {m_name, std::strerror(errno)}};
        pid_t pid = 0;
        const int failed = spawnProcess(
            {files->program,
             files->words,
             {{in.in.get(), STDIN_FILENO}, {out.out.get(), STDOUT_FILENO}, {err.out.get(), STDERR_FILENO}},
             STDERR_FILENO + 1,
             environ},
            pid);
        if (failed != 0)
            return {MessageCode::ProgramNotStarted, {m_name, std::strerror(failed)}};
        m_pid = pid;
        m_in = std::move(in.out);
        m_out = std::move(out.in);
        m_err = std::move(err.in);
        for (const Descriptor* end : {&m_in, &m_out, &m_err})
            setNonBlocking(*end);
        return {};
    }
    /// Until the next start; one that has lived long has not failed at its start.
    void pause(bool hasLived) {
        const std::lock_guard lock(m_mutex);
        m_pause_s = hasLived || m_pause_s == 0.0 ? kFirstPause_s : std::min(2.0 * m_pause_s, kLongestPause_s);
        m_notBefore_s = m_clock.now_s() + m_pause_s;
    }
    void beginEnd() {
        m_in.reset();
        m_isEnding = true;
        m_ended_s = m_clock.now_s();
        m_signal = 0;
    }
    void waitForMore(bool isWanted) {
        bool hasRoom = false, hasInput = false;
        {
            const std::lock_guard lock(m_mutex);
            hasRoom = m_unread.size() < kMaxUnread;
            hasInput = !m_unwritten.empty();
        }
        std::array<pollfd, 4> ends{{{m_wake.get(), POLLIN, 0},
                                    {m_out.get(), POLLIN, 0},
                                    {m_err.get(), POLLIN, 0},
                                    {hasInput ? m_in.get() : -1, POLLOUT, 0}}};
        if (!hasRoom && !m_isEnding)
            ends[1].fd = -1;
        const bool isIdle = m_pid == 0 && !isWanted;
        ::poll(ends.data(), ends.size(), isIdle ? -1 : m_isEnding ? kLookAtEnd_ms : kLook_ms);
        std::uint64_t count = 0;
        [[maybe_unused]] const auto woken = ::read(m_wake.get(), &count, sizeof count);
    }
    void writeInput() {
        const std::lock_guard lock(m_mutex);
        if (m_unwritten.empty() || m_in.get() < 0)
            return;
        const auto written = ::write(m_in.get(), m_unwritten.data(), m_unwritten.size());
        if (written > 0)
            m_unwritten.erase(0, static_cast<std::size_t>(written));
        else if (errno != EAGAIN && errno != EINTR)
            m_unwritten.clear(); // it has closed its input; its end is seen at its output
    }
    void readOutput() {
        std::array<char, 16384> bytes;
        for (int i = 0; i < kMaxLooks && m_out.get() >= 0; ++i) { // it may write faster than it is read
            const auto got = ::read(m_out.get(), bytes.data(), bytes.size());
            const double now_s = m_clock.now_s();
            if (got < 0) {
                m_lookedAt_s = now_s;
                return;
            }
            if (got == 0) {
                m_out.reset();
                return;
            }
            if (now_s - m_second_s > 1.0) {
                m_second_s = now_s;
                m_inSecond = 0;
            }
            m_inSecond += static_cast<std::size_t>(got);
            const std::lock_guard lock(m_mutex);
            if (!m_isOpen)
                continue;
            if (m_inSecond > kMaxPerSecond)
                return fail({MessageCode::ProgramStopped,
                             {m_name, "it writes more than " + std::to_string(kMaxPerSecond / 1024) +
                                          " KiB within a second"}});
            if (m_unread.empty())
                m_unreadEmptyAt_s = m_lookedAt_s;
            m_unread.append(bytes.data(), static_cast<std::size_t>(got));
            if (m_unread.size() >= kMaxUnread)
                return;
        }
    }
    void keep(std::string_view note) {
        const double now_s = m_clock.now_s();
        if (!m_traffic || (now_s - m_noteSecond_s < 1.0 && m_notesInSecond > kMaxNotesPerSecond))
            return;
        if (now_s - m_noteSecond_s >= 1.0) {
            m_noteSecond_s = now_s;
            m_notesInSecond = 0;
        }
        m_notesInSecond += note.size();
        m_traffic->add(TrafficKind::ErrorOutput, m_name, note, now_s);
    }
    /// The last line of what it tells people.
    void readNotes() {
        std::array<char, 4096> bytes;
        for (int i = 0; i < kMaxLooks && m_err.get() >= 0; ++i) {
            const auto got = ::read(m_err.get(), bytes.data(), bytes.size());
            if (got < 0)
                return;
            if (got == 0)
                return m_err.reset();
            const std::string_view note(bytes.data(), static_cast<std::size_t>(got));
            keep(note);
            for (const char c : note) {
                if (c == '\n') {
                    m_isNoteDone = true;
                    continue;
                }
                if (std::exchange(m_isNoteDone, false))
                    m_note.clear();
                if (m_note.size() < kMaxNote)
                    m_note += static_cast<unsigned char>(c) < ' ' ? ' ' : c;
            }
        }
    }
    /// Sees one that has ended, and helps one that is to end and does not.
    void workEnd() {
        const double now_s = m_clock.now_s();
        siginfo_t end{};
        const int waited = ::waitid(P_PID, static_cast<id_t>(m_pid), &end, WEXITED | WNOHANG | WNOWAIT);
        if (waited != 0 && errno == ECHILD) // the system was told to keep no exit codes
            return ended("it is gone");
        if (waited == 0 && end.si_pid == m_pid) {
            readNotes();
            ::kill(-m_pid, SIGKILL); // what it has started; its number is its own until it is waited for
            ::waitpid(m_pid, nullptr, 0);
            return ended(endWords(end, m_note));
        }
        if (!m_isEnding && m_out.get() < 0) {
            const std::lock_guard lock(m_mutex);
            if (m_isOpen && now_s - m_lookedAt_s > 1e-3 * kLook_ms) // its end is told with its exit code
                fail({MessageCode::ProgramEnded, {m_name, "it has closed its standard output"}});
        }
        if (!m_isEnding)
            return;
        const int due = now_s - m_ended_s > kKill_s ? SIGKILL : now_s - m_ended_s > kTerm_s ? SIGTERM : 0;
        if (due != m_signal)
            ::kill(-m_pid, due);
        m_signal = due;
    }
    void ended(const std::string& words) {
        m_pid = 0;
        m_in.reset();
        m_out.reset();
        m_err.reset();
        m_claim.release();
        pause(m_clock.now_s() - m_begun_s > kLongLife_s);
        const std::lock_guard lock(m_mutex);
        if (m_isOpen && !m_isEnding)
            fail({MessageCode::ProgramEnded, {m_name, words}});
    }

    const std::string m_command, m_device, m_name;
    const std::shared_ptr<const ConfirmedPrograms> m_confirmed;
    const std::shared_ptr<TrafficLog> m_traffic;
    const Descriptor m_wake;
    const SteadyClock m_clock;

    mutable std::mutex m_mutex;
    // Protected by the mutex
    bool m_isWanted = false, m_isOpen = false, m_isFinished = false, m_mustEnd = false;
    Message m_problem;
    std::string m_unread, m_unwritten;
    double m_unreadEmptyAt_s = 0.0, m_readEmptyAt_s = 0.0;
    double m_notBefore_s = -1e300, m_pause_s = 0.0;
    // Used only on the thread
    PortClaim m_claim;
    pid_t m_pid = 0; ///< 0: none runs
    Descriptor m_in, m_out, m_err;
    bool m_isEnding = false;
    int m_signal = 0; ///< the gravest that was sent
    double m_begun_s = 0.0, m_ended_s = 0.0, m_second_s = 0.0, m_lookedAt_s = 0.0;
    std::size_t m_inSecond = 0;
    std::string m_note;
    double m_noteSecond_s = -1e300;
    std::size_t m_notesInSecond = 0;
    bool m_isNoteDone = false;
};

ProgramLink::ProgramLink(std::string command, std::string device,
                         std::shared_ptr<const ConfirmedPrograms> confirmed,
                         std::shared_ptr<TrafficLog> traffic) {
    m_runner = std::make_shared<Runner>(std::move(command), std::move(device), std::move(confirmed),
                                        std::move(traffic));
    m_runner->start();
}

ProgramLink::~ProgramLink() {
    m_runner->finish();
}

void ProgramLink::open() {
    m_runner->open();
}

void ProgramLink::close() {
    m_runner->close();
}

bool ProgramLink::isOpen() const {
    return m_runner->isOpen();
}

Message ProgramLink::problem() const {
    return m_runner->problem();
}

std::string ProgramLink::read() {
    return m_runner->read();
}

double ProgramLink::emptyAt_s() const {
    return m_runner->emptyAt_s();
}

void ProgramLink::write(std::string_view bytes) {
    m_runner->write(bytes);
}

std::string ProgramLink::name() const {
    return m_runner->name();
}

void ProgramLink::waitForAll() {
    std::unique_lock lock(running().mutex);
    running().changed.wait_for(lock, std::chrono::duration<double>(kKill_s + 1.0),
                               [] { return running().count == 0; });
}

} // namespace bask
