#pragma once
// A simulated device on a pseudo-terminal: any program opens it as it opens a serial port.

#include "engine/device_simulators/byte_pump.h"

#include <memory>

namespace bask {

class PtyServer {
public:
    /// `linkPath` becomes a symbolic link to the new terminal and is removed at the end; a link that is there
    /// already is replaced in one step. `device` must outlive it. Errors: SimulatedPortTaken,
    /// FileUnwritable.
    static Result<std::unique_ptr<PtyServer>> create(ByteDevice& device, const std::string& linkPath);
    ~PtyServer();
    PtyServer(const PtyServer&) = delete;
    PtyServer& operator=(const PtyServer&) = delete;

    /// Moves bytes both ways and never waits. Clients may come and go.
    void work(double now_s);
    /// Of the terminal itself, "/dev/pts/5".
    std::string path() const { return m_path; }

private:
    PtyServer(ByteDevice& device, int master, std::string path, std::string linkPath);
    bool hasClient() const;

    BytePump m_pump;
    int m_master;
    std::string m_path, m_linkPath;
    bool m_hadClient = false;
};

} // namespace bask
