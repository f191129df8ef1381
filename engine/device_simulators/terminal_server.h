#pragma once
// A simulated device on an existing terminal: of a null-modem cable, or socat's.

#include "engine/device_simulators/byte_pump.h"
#include "engine/device_simulators/device_server.h"

namespace bask {

/// Opens a terminal raw, as a device has it: no echo, no line editing, no waiting; its speed is not changed.
/// Returns -1 and sets errno if it cannot be opened.
int openRawTerminal(const std::string& path);

class TerminalServer final : public DeviceServer {
public:
    static constexpr double kReopen_s = 0.5; ///< how often a terminal that has disappeared is tried again

    /// `device` must outlive it. Errors: FileUnwritable if there is no terminal.
    static Result<std::unique_ptr<TerminalServer>> open(ByteDevice& device, const std::string& path);
    ~TerminalServer() override;
    TerminalServer(const TerminalServer&) = delete;
    TerminalServer& operator=(const TerminalServer&) = delete;

    void work(double now_s) override;

private:
    TerminalServer(ByteDevice& device, int terminal, std::string path);

    BytePump m_pump;
    int m_terminal; ///< -1: it has disappeared
    std::string m_path;
    double m_nextOpen_s = 0.0;
};

} // namespace bask
