#pragma once
// A device that several programs of this computer could talk to at once is talked to by one.

#include <string>

namespace bask {

/// Holds a name that no other process of this computer can hold meanwhile, however this one ends. It touches
/// no file.
class PortClaim {
public:
    PortClaim() = default;
    ~PortClaim() { release(); }
    PortClaim(const PortClaim&) = delete;
    PortClaim& operator=(const PortClaim&) = delete;

    /// Lets go of the one before. Returns false when somebody holds it; true also where the system has no
    /// such names.
    bool take(const std::string& name);
    void release();

private:
    int m_socket = -1;
};

} // namespace bask
