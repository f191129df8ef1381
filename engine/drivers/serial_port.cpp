#include "engine/drivers/serial_port.h"

#include <poll.h>
#include <unistd.h>

namespace bask {

SerialPortState serialPortState(int descriptor) {
    pollfd state{descriptor, POLLIN, 0};
    if (::poll(&state, 1, 0) <= 0)
        return SerialPortState::Nothing;
    return (state.revents & (POLLHUP | POLLERR | POLLNVAL)) != 0 ? SerialPortState::HungUp
                                                                 : SerialPortState::Bytes;
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
