#pragma once
// A simulated device on a TCP port of this computer.

#include "engine/device_simulators/byte_pump.h"

#include <memory>

namespace bask {

class TcpServer {
public:
    /// Listens on 127.0.0.1; port 0: any free port. `device` must outlive it. Errors: LinkNotOpened.
    static Result<std::unique_ptr<TcpServer>> create(ByteDevice& device, int port = 0);
    ~TcpServer();
    TcpServer(const TcpServer&) = delete;
    TcpServer& operator=(const TcpServer&) = delete;

    /// Moves bytes in both directions and never waits. Accepts one client at a time; another is rejected.
    void work(double now_s);
    int port() const { return m_port; }

private:
    TcpServer(ByteDevice& device, int listener, int port);
    void admit();

    BytePump m_pump;
    int m_listener;
    int m_client = -1;
    int m_port;
};

} // namespace bask
