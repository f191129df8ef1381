#include "engine/drivers/heater_guard.h"

#include "engine/base/message_code.h"
#include "engine/base/program_part.h"
#include "engine/base/result.h"
#include "engine/base/thread_name.h"
#include "engine/drivers/spawn_process.h"

#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <filesystem>
#include <mutex>
#include <poll.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <system_error>
#include <thread>
#include <unistd.h>
#include <utility>
#include <vector>

namespace bask {
namespace {

using guard::Order;
using guard::Told;

constexpr double kDelayed_s = 0.3; // since the last work(): the engine was silent, not the guard
constexpr double kStarting_s = 3.0;
constexpr double kEnding_s = 0.5; // then its port is tried all the same
constexpr std::size_t kMaxUnread = 65536;

std::string_view bytesOf(const guard::OffProgram& program) {
    return {reinterpret_cast<const char*>(&program), sizeof program};
}

/// With nothing of this program but the socket: no environment, no blocked signals.
int startProcess(const std::string& program, int socket, const std::vector<std::string>& arguments,
                 pid_t& process) {
    char* const environment[] = {nullptr};
    return spawnProcess({program, arguments, {{socket, guard::kSocket}}, {}, environment}, process);
}

} // namespace

/// The process, and the thread that starts it and waits for its end, which may outlive the guard.
struct HeaterGuard::Process {
    /// There. `socket` is its own, and closed.
    void live(const std::string& program, int socket, const std::vector<std::string>& arguments) {
        nameThread("heater guard");
        pid_t started = -1;
        const int failed = startProcess(program, socket, arguments, started);
        set(failed == 0 ? started : -1, failed);
        ::close(socket); // what went wrong is known before this is heard
        siginfo_t how{};
        while (failed == 0 && ::waitid(P_PID, static_cast<id_t>(started), &how, WEXITED | WNOWAIT) != 0 &&
               errno == EINTR) {
        }
        const std::lock_guard lock(mutex);
        if (failed == 0)
            (void)::waitpid(started, nullptr, WNOHANG); // from here on its id may be another's
        id = -1;
        isOver = true;
    }
    void set(pid_t started, int failed) {
        const std::lock_guard lock(mutex);
        id = started;
        problem = failed;
    }
    template <class Value> Value get(Value Process::*value) {
        const std::lock_guard lock(mutex);
        return this->*value;
    }
    void kill() {
        const std::lock_guard lock(mutex);
        if (id > 0)
            ::kill(id, SIGKILL);
    }

    std::mutex mutex; ///< of all below
    pid_t id = -1;
    int problem = 0; ///< errno of its start
    bool isOver = false;
};

const std::string& guardProgram() {
    static const std::string found = programPart("bask-guard", BASK_GUARD_BUILT);
    return found;
}

HeaterGuard::HeaterGuard(std::string port, const SerialSettings& settings, std::string logFile,
                         const Clock& clock, std::string portId, std::string idFolder)
    : m_port(std::move(port)), m_settings(settings), m_logFile(std::move(logFile)),
      m_portId(std::move(portId)), m_idFolder(std::move(idFolder)), m_clock(clock) {}

/// By the end of the socket: an armed one takes over, another one ends. Nobody waits for that.
HeaterGuard::~HeaterGuard() {
    if (m_socket >= 0)
        ::close(m_socket);
}

std::optional<int> HeaterGuard::processId() const {
    const pid_t id = m_process ? m_process->get(&Process::id) : -1;
    return id > 0 ? std::optional<int>(id) : std::nullopt; // signals to -1 would go to every process
}

void HeaterGuard::start(const std::string& program) {
    if (m_state != State::None && m_state != State::Ended)
        return;
    m_state = State::None;
    m_isArmed = m_isPortOpen = m_isPortOpening = false;
    m_unread.clear();
    m_off.clear();
    m_portProblem = {};
    const auto fail = [this](const std::string& why) {
        m_problem = {MessageCode::HeaterGuardMissing, {why}};
    };
    if (program.empty())
        return fail("bask-guard is not there");
    std::array<int, 2> ends{};
    if (::socketpair(AF_UNIX, SOCK_SEQPACKET | SOCK_CLOEXEC | SOCK_NONBLOCK, 0, ends.data()) != 0)
        return fail(std::strerror(errno));
    m_process = std::make_shared<Process>();
    try {
        std::thread([process = m_process, program, socket = ends[1], port = m_port, settings = m_settings,
                     logFile = m_logFile, portId = m_portId, idFolder = m_idFolder] {
            std::error_code code;
            process->live(program, socket,
                          {"bask-guard", std::filesystem::absolute(port, code).string(),
                           std::to_string(settings.baud), std::to_string(settings.dataBits),
                           std::string(1, settings.parity), std::to_string(settings.stopBits), logFile,
                           portId, idFolder});
        }).detach();
    } catch (const std::system_error& problem) {
        ::close(ends[0]);
        ::close(ends[1]);
        m_process.reset();
        return fail(problem.what());
    }
    m_socket = ends[0];
    m_state = State::Starting;
    m_problem = {};
    m_answered_s = m_beat_s = m_worked_s = m_clock.now_s();
}

void HeaterGuard::work() {
    const double now_s = m_clock.now_s();
    receive();
    if (now_s - m_worked_s > kDelayed_s)
        m_answered_s = now_s;
    m_worked_s = now_s;
    if (m_process && m_socket < 0 && (m_process->get(&Process::isOver) || now_s - m_hungUp_s > kEnding_s))
        return end();
    if (m_socket < 0 || m_state == State::TookOver)
        return;
    const double max_s = m_state == State::Starting ? kStarting_s : kSilent_s;
    if (now_s - m_answered_s > max_s) {
        m_process->kill(); // stopped, or stuck: the port must become free
        return hangUp();
    }
    if (now_s - m_beat_s >= guard::kBeat_s) {
        m_beat_s = now_s;
        tell(Order::Beat);
    }
}

/// Nothing more is heard; work() sees when its port is free.
void HeaterGuard::hangUp() {
    ::close(std::exchange(m_socket, -1));
    m_hungUp_s = m_clock.now_s();
}

void HeaterGuard::receive() {
    std::array<char, 1 + guard::kMax> packet{};
    while (m_socket >= 0) {
        const ssize_t count = ::recv(m_socket, packet.data(), packet.size(), MSG_DONTWAIT);
        if (count > 0)
            take(static_cast<Told>(packet[0]), {packet.data() + 1, static_cast<std::size_t>(count) - 1});
        else if (count < 0 && (errno == EINTR || errno == ECONNRESET))
            continue; // the second is told once, before its last words
        else if (count < 0 && errno == EAGAIN)
            return;
        else
            hangUp();
    }
}

void HeaterGuard::take(Told kind, std::string_view bytes) {
    if (m_state != State::TookOver)
        m_answered_s = m_clock.now_s();
    switch (kind) {
    case Told::Hello:
        if (!bytes.empty() && bytes[0] == guard::kVersion)
            m_state = State::Guarding;
        return;
    case Told::Beat:
    case Told::Off: // its end follows
        return;
    case Told::Opened:
        m_isPortOpen = true;
        m_isPortOpening = false;
        m_portProblem = {};
        if (m_portId.empty())
            m_portId = bytes;
        return;
    case Told::Exchanged:
        return losePort(
            {MessageCode::DeviceExchanged, {m_port, m_portId, bytes.empty() ? "?" : std::string(bytes)}});
    case Told::Failed: {
        int problem = 0;
        std::memcpy(&problem, bytes.data(), std::min(bytes.size(), sizeof problem));
        return losePort({MessageCode::LinkNotOpened, {m_port, whyNotOpened(problem)}});
    }
    case Told::Lost:
        return losePort({MessageCode::LinkLost, {m_port, "it was unplugged"}});
    case Told::Stuck:
        return losePort({MessageCode::LinkStuck, {m_port}});
    case Told::Bytes:
        if (m_isPortOpen && m_unread.size() < kMaxUnread)
            m_unread += bytes;
        return;
    case Told::TookOver:
        m_state = State::TookOver;
        m_problem = {MessageCode::HeaterGuardTookOver, {std::string(bytes)}};
        return losePort(m_problem);
    }
}

bool HeaterGuard::tell(Order order, std::string_view bytes) {
    std::string packet(1, static_cast<char>(order));
    packet += bytes;
    return m_socket >= 0 && ::send(m_socket, packet.data(), packet.size(), MSG_DONTWAIT | MSG_NOSIGNAL) ==
                                static_cast<ssize_t>(packet.size());
}

void HeaterGuard::losePort(Message problem) {
    m_isPortOpen = m_isPortOpening = false;
    m_unread.clear();
    m_portProblem = std::move(problem);
}

void HeaterGuard::end() {
    if (m_state == State::Starting) {
        const int problem = m_process->get(&Process::problem);
        const bool isOver = m_process->get(&Process::isOver);
        m_problem = {MessageCode::HeaterGuardMissing,
                     {problem != 0 ? "bask-guard: " + std::string(std::strerror(problem))
                      : isOver     ? "bask-guard has ended at once"
                                   : "bask-guard does not start"}};
    } else if (m_state == State::Guarding) {
        m_problem = {MessageCode::HeaterGuardLost, {}};
    }
    m_state = m_state == State::Starting ? State::None : State::Ended;
    losePort(m_problem);
    m_isArmed = false;
    m_process.reset();
}

void HeaterGuard::arm(const guard::OffProgram& off) {
    if (m_state != State::Guarding)
        return;
    if (bytesOf(off) != m_off && tell(Order::Program, bytesOf(off)))
        m_off = bytesOf(off);
    if (!m_isArmed && !m_off.empty())
        m_isArmed = tell(Order::Arm);
}

void HeaterGuard::disarm() {
    if (m_isArmed)
        m_isArmed = !tell(Order::Disarm);
}

bool HeaterGuard::handOver(double within_s) {
    if (m_isArmed)
        tell(Order::TakeOver);
    const double until_s = SteadyClock().now_s() + within_s;
    while (m_isArmed && m_socket >= 0 && m_state == State::Guarding && SteadyClock().now_s() < until_s) {
        pollfd state{m_socket, POLLIN, 0};
        ::poll(&state, 1, 10);
        receive();
    }
    return m_state == State::TookOver;
}

void HeaterGuard::openPort() {
    if (m_isPortOpening || (m_state != State::Guarding && m_state != State::Starting))
        return;
    m_isPortOpen = false;
    m_isPortOpening = true;
    m_unread.clear();
    m_portProblem = {};
    tell(Order::Open);
}

void HeaterGuard::closePort() {
    m_isPortOpen = m_isPortOpening = false;
    m_unread.clear();
    tell(Order::Close);
}

std::string HeaterGuard::read() {
    receive(); // now, and not at the next work(): what has come is not to wait
    return std::exchange(m_unread, {});
}

void HeaterGuard::write(std::string_view bytes) {
    for (; isPortOpen() && !bytes.empty(); bytes.remove_prefix(std::min(bytes.size(), guard::kMax)))
        tell(Order::Write, bytes.substr(0, guard::kMax));
}

} // namespace bask
