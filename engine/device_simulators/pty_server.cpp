#include "engine/device_simulators/pty_server.h"

#include "engine/base/message_code.h"
#include "engine/device_simulators/terminal_server.h"

#include <array>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <fcntl.h>
#include <filesystem>
#include <poll.h>
#include <termios.h>
#include <unistd.h>

namespace bask {
namespace {

namespace fs = std::filesystem;

Error unwritable(const std::string& path, int reason) {
    return {MessageCode::FileUnwritable, path, {std::strerror(reason)}};
}

/// Opened and closed once, it tells from now on whether it has a client.
bool makeRaw(const std::string& path) {
    const int other = openRawTerminal(path);
    if (other >= 0)
        ::close(other);
    return other >= 0;
}

/// The new terminal's path; empty, and errno set, if it cannot be had.
std::string prepared(int master) {
    std::array<char, 128> path{};
    const bool ready = ::grantpt(master) == 0 && ::unlockpt(master) == 0 &&
                       ::ptsname_r(master, path.data(), path.size()) == 0 && makeRaw(path.data()) &&
                       ::fcntl(master, F_SETFL, O_NONBLOCK) == 0 && ::fcntl(master, F_SETFD, FD_CLOEXEC) == 0;
    return ready ? path.data() : "";
}

/// In one step, so that whoever opens `link` finds the old terminal or the new one.
Result<void> makeLink(const std::string& target, const std::string& link) {
    std::error_code failed;
    const fs::file_type there = fs::symlink_status(link, failed).type();
    if (there != fs::file_type::not_found && there != fs::file_type::symlink)
        return Error{MessageCode::SimulatedPortTaken, link, {link}};
    const std::string beside = link + ".new" + std::to_string(::getpid());
    ::unlink(beside.c_str());
    if (::symlink(target.c_str(), beside.c_str()) != 0)
        return unwritable(link, errno);
    if (::rename(beside.c_str(), link.c_str()) != 0) {
        const int reason = errno;
        ::unlink(beside.c_str());
        return unwritable(link, reason);
    }
    return {};
}

} // namespace

Result<PtyServer::Terminal> PtyServer::linked(const std::string& linkPath) {
    Terminal made;
    made.master = ::posix_openpt(O_RDWR | O_NOCTTY);
    if (made.master >= 0)
        made.path = prepared(made.master);
    if (made.path.empty()) {
        const int reason = errno;
        if (made.master >= 0)
            ::close(made.master);
        return unwritable(linkPath, reason);
    }
    if (const auto link = makeLink(made.path, linkPath); !link) {
        ::close(made.master);
        return link.error();
    }
    return made;
}

Result<std::unique_ptr<PtyServer>> PtyServer::create(ByteDevice& device, const std::string& linkPath) {
    auto terminal = linked(linkPath);
    if (!terminal)
        return terminal.error();
    return std::unique_ptr<PtyServer>(new PtyServer(device, std::move(*terminal), linkPath));
}

PtyServer::PtyServer(ByteDevice& device, Terminal terminal, std::string linkPath)
    : m_pump(device), m_terminal(std::move(terminal)), m_linkPath(std::move(linkPath)) {}

PtyServer::~PtyServer() {
    if (isLinked())
        ::unlink(m_linkPath.c_str());
    ::close(m_terminal.master);
}

/// Somebody else's link by now is left alone.
bool PtyServer::isLinked() const {
    std::error_code failed;
    return fs::read_symlink(m_linkPath, failed) == m_terminal.path;
}

bool PtyServer::hasClient() const {
    pollfd state{m_terminal.master, POLLIN, 0};
    return ::poll(&state, 1, 0) >= 0 && (state.revents & POLLHUP) == 0;
}

/// The next client gets nothing of what the last one left unread. A client that was killed may have kept the
/// terminal for itself alone, for as long as it lives: the next one then gets another, as of a real port,
/// which forgets.
void PtyServer::forgetClient() {
    m_hadClient = false;
    const int other = openRawTerminal(m_terminal.path); // the server's end has no means for this
    if (other >= 0) {
        ::tcflush(other, TCIFLUSH);
        ::close(other);
    } else if (isLinked()) {
        if (auto another = linked(m_linkPath)) {
            ::close(m_terminal.master);
            m_terminal = std::move(*another);
        }
    }
}

void PtyServer::work(double now_s) {
    // What a client sent just before it left is still read.
    const bool isThere = hasClient();
    if (isThere && !m_hadClient)
        m_pump.opened(now_s);
    if ((isThere || m_hadClient) && m_pump.work(m_terminal.master, now_s)) {
        m_hadClient = true;
        return;
    }
    if (m_hadClient)
        forgetClient();
    m_pump.discard(now_s);
}

} // namespace bask
