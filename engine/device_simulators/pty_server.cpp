#include "engine/device_simulators/pty_server.h"

#include "engine/base/message_code.h"

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

int openTerminal(const std::string& path) {
    return ::open(path.c_str(), O_RDWR | O_NOCTTY | O_NONBLOCK | O_CLOEXEC);
}

/// Raw, as a device has it: no echo, no line editing. Opened and closed once, it tells from now on whether it
/// has a client.
bool makeRaw(const std::string& path) {
    const int other = openTerminal(path);
    if (other < 0)
        return false;
    termios settings{};
    const bool read = ::tcgetattr(other, &settings) == 0;
    ::cfmakeraw(&settings);
    const bool written = read && ::tcsetattr(other, TCSANOW, &settings) == 0;
    ::close(other);
    return written;
}

/// The new terminal's path; empty, and errno set, if it cannot be had.
std::string prepared(int master) {
    std::array<char, 128> path{};
    const bool ready = ::grantpt(master) == 0 && ::unlockpt(master) == 0 &&
                       ::ptsname_r(master, path.data(), path.size()) == 0 && makeRaw(path.data()) &&
                       ::fcntl(master, F_SETFL, O_NONBLOCK) == 0 && ::fcntl(master, F_SETFD, FD_CLOEXEC) == 0;
    return ready ? path.data() : "";
}

/// The next client gets nothing of what the last one left unread.
void forgetUnread(const std::string& path) {
    const int other = openTerminal(path); // the server's end has no means for this
    ::tcflush(other, TCIFLUSH);
    ::close(other);
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

Result<std::unique_ptr<PtyServer>> PtyServer::create(ByteDevice& device, const std::string& linkPath) {
    const int master = ::posix_openpt(O_RDWR | O_NOCTTY);
    const std::string path = master < 0 ? std::string() : prepared(master);
    if (path.empty()) {
        const int reason = errno;
        if (master >= 0)
            ::close(master);
        return unwritable(linkPath, reason);
    }
    if (const auto made = makeLink(path, linkPath); !made) {
        ::close(master);
        return made.error();
    }
    return std::unique_ptr<PtyServer>(new PtyServer(device, master, path, linkPath));
}

PtyServer::PtyServer(ByteDevice& device, int master, std::string path, std::string linkPath)
    : m_pump(device), m_master(master), m_path(std::move(path)), m_linkPath(std::move(linkPath)) {}

PtyServer::~PtyServer() {
    std::error_code failed; // somebody else's link by now is left alone
    if (fs::read_symlink(m_linkPath, failed) == m_path)
        ::unlink(m_linkPath.c_str());
    ::close(m_master);
}

bool PtyServer::hasClient() const {
    pollfd state{m_master, POLLIN, 0};
    return ::poll(&state, 1, 0) >= 0 && (state.revents & POLLHUP) == 0;
}

void PtyServer::work(double now_s) {
    // What a client sent just before it left is still read.
    const bool isThere = hasClient();
    if ((isThere || m_hadClient) && m_pump.work(m_master, now_s)) {
        m_hadClient = true;
        return;
    }
    if (m_hadClient)
        forgetUnread(m_path);
    m_hadClient = false;
    m_pump.discard(now_s);
}

} // namespace bask
