#include "engine/drivers/serial_port.h"

#include <poll.h>
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

/// Nearly everybody meets it once: the port belongs to a group that the user is not in.
std::string whyNotOpened(const std::string& path, bool isTaken, const std::string& otherwise) {
    if (::access(path.c_str(), F_OK) != 0)
        return "there is no such port";
    if (::access(path.c_str(), R_OK | W_OK) != 0)
        return "you have no right to use it; have yourself added to its group, often \"dialout\", and log in "
               "again";
    return isTaken ? "another program has it open" : otherwise;
}

} // namespace bask
