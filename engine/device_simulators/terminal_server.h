#pragma once
// A simulated device on a terminal that is there already: a null-modem cable's, or socat's.

#include "engine/device_simulators/byte_pump.h"
#include "engine/device_simulators/device_server.h"

namespace bask {

/// Opens it raw, as a device has it: no echo, no line editing, no waiting; its speed is left as it is. -1,
/// and errno set, where it cannot be opened.
int openRawTerminal(const std::string& path);

class TerminalServer final : public DeviceServer {
public:
    static constexpr double kReopen_s = 0.5; ///< a terminal that has gone is looked for so often

    /// `device` must outlive it. Errors: FileUnwritable where there is no terminal.
    static Result<std::unique_ptr<TerminalServer>> open(ByteDevice& device, const std::string& path);
    ~TerminalServer() override;
    TerminalServer(const TerminalServer&) = delete;
    TerminalServer& operator=(const TerminalServer&) = delete;

    void work(double now_s) override;

private:
    TerminalServer(ByteDevice& device, int terminal, std::string path);

    BytePump m_pump;
    int m_terminal; ///< -1: it has gone
    std::string m_path;
    double m_nextOpen_s = 0.0;
};

} // namespace bask
