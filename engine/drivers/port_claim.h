#pragma once
// Makes sure that only one program of this computer uses a device.

#include <string>

namespace bask {

/// Claims a name that no other process of this computer can claim at the same time, even if this process is
/// killed. Uses no file.
class PortClaim {
public:
    PortClaim() = default;
    ~PortClaim() { release(); }
    PortClaim(const PortClaim&) = delete;
    PortClaim& operator=(const PortClaim&) = delete;

    /// Claims a name and releases the previous one. Returns false if another process has it; true also if the
    /// system does not support such names.
    bool take(const std::string& name);
    void release();

private:
    int m_socket = -1;
};

} // namespace bask
