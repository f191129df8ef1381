#include "engine/device_simulators/tcp_server.h"

#include "engine/base/message_code.h"

#include <cerrno>
#include <cstring>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <sys/socket.h>
#include <unistd.h>

namespace bask {
namespace {

sockaddr_in here(int port) {
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_port = htons(static_cast<std::uint16_t>(port));
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    return address;
}

/// The port that it listens on; -1, and errno set, if it cannot.
int listening(int listener, int port) {
    const int yes = 1;
    ::setsockopt(listener, SOL_SOCKET, SO_REUSEADDR, &yes, sizeof yes);
    sockaddr_in address = here(port);
    socklen_t size = sizeof address;
    auto* plain = reinterpret_cast<sockaddr*>(&address);
    const bool listens = ::bind(listener, plain, size) == 0 && ::listen(listener, 4) == 0 &&
                         ::getsockname(listener, plain, &size) == 0;
    return listens ? ntohs(address.sin_port) : -1;
}

} // namespace

Result<std::unique_ptr<TcpServer>> TcpServer::create(ByteDevice& device, int port) {
    const int listener = ::socket(AF_INET, SOCK_STREAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0);
    const int given = listener < 0 ? -1 : listening(listener, port);
    if (given < 0) {
        const std::string name = "127.0.0.1:" + std::to_string(port), reason = std::strerror(errno);
        if (listener >= 0)
            ::close(listener);
        return Error{MessageCode::LinkNotOpened, name, {name, reason}};
    }
    return std::unique_ptr<TcpServer>(new TcpServer(device, listener, given));
}

TcpServer::TcpServer(ByteDevice& device, int listener, int port)
    : m_pump(device), m_listener(listener), m_port(port) {}

TcpServer::~TcpServer() {
    if (m_client >= 0)
        ::close(m_client);
    ::close(m_listener);
}

void TcpServer::admit() {
    const int comer = ::accept4(m_listener, nullptr, nullptr, SOCK_NONBLOCK | SOCK_CLOEXEC);
    if (comer < 0)
        return;
    if (m_client >= 0) {
        ::close(comer);
        return;
    }
    const int yes = 1;
    ::setsockopt(comer, IPPROTO_TCP, TCP_NODELAY, &yes, sizeof yes);
    m_client = comer;
}

void TcpServer::work(double now_s) {
    if (m_client >= 0 && !m_pump.work(m_client, now_s)) {
        ::close(m_client);
        m_client = -1;
    }
    admit();
    if (m_client < 0)
        m_pump.discard(now_s);
}

} // namespace bask
