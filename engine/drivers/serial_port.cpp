#include "engine/drivers/serial_port.h"

#include "engine/base/message_code.h"

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <poll.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <sys/sysmacros.h>
#include <unistd.h>

namespace bask {
namespace {

bool isPseudoTerminal(const std::string& path) {
    constexpr unsigned kFirstMajor = 136, kLastMajor = 143; // Linux' numbers for /dev/pts
    struct stat there {};
    if (::stat(path.c_str(), &there) != 0 || !S_ISCHR(there.st_mode))
        return false;
    const unsigned number = major(there.st_rdev);
    return number >= kFirstMajor && number <= kLastMajor;
}

} // namespace

SerialPortState serialPortState(int descriptor) {
    pollfd state{descriptor, POLLIN, 0};
    if (::poll(&state, 1, 0) <= 0)
        return SerialPortState::Nothing;
    return (state.revents & (POLLHUP | POLLERR | POLLNVAL)) != 0 ? SerialPortState::HungUp
                                                                 : SerialPortState::Bytes;
}

SerialSettings settableOf(const std::string& path, SerialSettings wanted) {
    if (isPseudoTerminal(path)) {
        wanted.dataBits = 8;
        wanted.parity = 'N';
    }
    return wanted;
}

bool lockPort(int descriptor) {
    return ::flock(descriptor, LOCK_EX | LOCK_NB) == 0;
}

std::string portIdOf(const std::string& path, const std::string& folder) {
    namespace fs = std::filesystem;
    std::error_code code;
    const fs::path port = fs::canonical(path, code);
    if (code)
        return {};
    for (fs::directory_iterator it(folder, code), end; !code && it != end; it.increment(code)) {
        std::error_code broken;
        if (fs::canonical(it->path(), broken) == port && !broken)
            return it->path().filename().string();
    }
    return {};
}

PortCheck::PortCheck(std::string expected, IdOf idOf)
    : m_expected(std::move(expected)), m_idOf(std::move(idOf)) {}

Message PortCheck::look(const std::string& path) {
    if (::access(path.c_str(), F_OK) != 0)
        return {}; // it cannot be opened, and that is told
    m_found = m_idOf(path);
    if (m_expected.empty())
        m_expected = m_found;
    if (m_found == m_expected)
        return {};
    return {MessageCode::DeviceExchanged, {path, m_expected, m_found.empty() ? "?" : m_found}};
}

std::string whyNotOpened(int problem) {
    switch (problem) {
    case ENOENT:
        return "there is no such port";
    case EACCES:
    case EPERM: // nearly everybody meets it once: the port belongs to a group that the user is not in
        return "you have no right to use it; have yourself added to its group, often \"dialout\", and log in "
               "again";
    case EBUSY:
        return "another program has it open";
    default:
        return std::strerror(problem);
    }
}

std::string whyNotOpened(const std::string& path, bool isTaken, const std::string& otherwise) {
    if (::access(path.c_str(), F_OK) != 0)
        return whyNotOpened(ENOENT);
    if (::access(path.c_str(), R_OK | W_OK) != 0)
        return whyNotOpened(EACCES);
    return isTaken ? whyNotOpened(EBUSY) : otherwise;
}

} // namespace bask
