#include "engine/drivers/port_claim.h"

#include <algorithm>
#include <cerrno>
#include <cstddef>

#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

namespace bask {

bool PortClaim::take(const std::string& name) {
    release();
    m_socket = ::socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0);
    if (m_socket < 0)
        return true;
    sockaddr_un address{};
    address.sun_family = AF_UNIX;
    const std::string whole = '\0' + ("bask port " + name); // in no folder: gone with the process
    const std::size_t length = std::min(whole.size(), sizeof address.sun_path);
    whole.copy(address.sun_path, length);
    const auto size = static_cast<socklen_t>(offsetof(sockaddr_un, sun_path) + length);
    if (::bind(m_socket, reinterpret_cast<const sockaddr*>(&address), size) == 0 || errno != EADDRINUSE)
        return true;
    release();
    return false;
}

void PortClaim::release() {
    if (m_socket >= 0)
        ::close(m_socket);
    m_socket = -1;
}

} // namespace bask
