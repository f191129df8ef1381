#pragma once
// A simulated device on a TCP port of this computer.

#include "engine/device_simulators/byte_pump.h"
#include "engine/device_simulators/device_server.h"

#include <memory>

namespace bask {

class TcpServer final : public DeviceServer {
public:
    /// Listens on 127.0.0.1; port 0: any free port. `device` must outlive it. Errors: LinkNotOpened.
    static Result<std::unique_ptr<TcpServer>> create(ByteDevice& device, int port = 0);
    ~TcpServer() override;
    TcpServer(const TcpServer&) = delete;
    TcpServer& operator=(const TcpServer&) = delete;

    /// Accepts one client at a time; another is rejected.
    void work(double now_s) override;
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
