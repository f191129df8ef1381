#pragma once
// A simulated device on a pseudo-terminal: any program opens it like a serial port.

#include "engine/device_simulators/byte_pump.h"
#include "engine/device_simulators/device_server.h"

namespace bask {

class PtyServer final : public DeviceServer {
public:
    /// Makes `linkPath` a symbolic link to the new terminal, which is removed at the end; an existing link is
    /// replaced in one step. `device` must outlive it. Errors: SimulatedPortTaken, FileUnwritable.
    static Result<std::unique_ptr<PtyServer>> create(ByteDevice& device, const std::string& linkPath);
    ~PtyServer() override;
    PtyServer(const PtyServer&) = delete;
    PtyServer& operator=(const PtyServer&) = delete;

    void work(double now_s) override;
    /// Returns the path of the terminal itself, "/dev/pts/5".
    std::string path() const { return m_terminal.path; }

private:
    struct Terminal {
        int master = -1;
        std::string path{};
    };
    PtyServer(ByteDevice& device, Terminal terminal, std::string linkPath);
    static Result<Terminal> linked(const std::string& linkPath);
    bool isLinked() const;
    bool hasClient() const;
    void forgetClient();

    BytePump m_pump;
    Terminal m_terminal;
    std::string m_linkPath;
    bool m_hadClient = false;
};

} // namespace bask
