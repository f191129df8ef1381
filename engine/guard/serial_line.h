#pragma once
// The heater's serial line itself, exclusive and raw. Calls may wait for the system, which processes earlier
// work first; see GuardedPort.

#include <cstddef>

namespace bask::guard {

struct PortSettings {
    const char* path = "";
    int baud = 9600;
    int dataBits = 8;
    char parity = 'N';
    int stopBits = 1;
    const char* id = "";       ///< its own name; empty: it has none, or it is unknown
    const char* idFolder = ""; ///< folder in which the system has links to the ports by that name
};

/// Allocates no memory.
class SerialLine {
public:
    static constexpr int kExchanged = -1;

    explicit SerialLine(const PortSettings& settings);

    /// Opens the port. Returns 0; an errno, EBUSY if another program has it; or kExchanged if it is not the
    /// expected port, or the first one. Discards unread bytes from before.
    int open();
    /// Returns the port's own name from when it was opened, or the expected one; empty: it has none.
    const char* id() const { return m_id; }
    /// Closes the port, after a short time for the last bytes.
    void close();
    int descriptor() const { return m_descriptor; } ///< -1: not open
    /// Returns -1 if the port has disappeared, 0 if there is nothing to read.
    long read(void* bytes, std::size_t max);

private:
    void findId(unsigned long long device);

    static constexpr std::size_t kLongestId = 256;

    PortSettings m_settings;
    char m_expected[kLongestId] = {}, m_id[kLongestId] = {};
    int m_descriptor = -1;
};

} // namespace bask::guard
