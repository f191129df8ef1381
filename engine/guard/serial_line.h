#pragma once
// The heater's serial line itself: alone, raw. Calls may wait for the system, which works through what came
// first; see GuardedPort.

#include <cstddef>

namespace bask::guard {

struct PortSettings {
    const char* path = "";
    int baud = 9600;
    int dataBits = 8;
    char parity = 'N';
    int stopBits = 1;
    const char* id = "";       ///< its own name; empty: it has none, or is not known
    const char* idFolder = ""; ///< where the system has links by that to the ports
};

/// Nothing is allocated.
class SerialLine {
public:
    static constexpr int kExchanged = -1;

    explicit SerialLine(const PortSettings& settings);

    /// 0; errno: EBUSY where another program has it; or kExchanged where it is not the one it was first, or
    /// is to be. What was unread before is forgotten.
    int open();
    /// The port's own name when it was opened, or was to be; empty: it has none.
    const char* id() const { return m_id; }
    /// Gives the last bytes a moment.
    void close();
    int descriptor() const { return m_descriptor; } ///< -1: not open
    /// -1: it is gone; 0: nothing there.
    long read(void* bytes, std::size_t most);

private:
    void findId(unsigned long long device);

    static constexpr std::size_t kLongestId = 256;

    PortSettings m_settings;
    char m_expected[kLongestId] = {}, m_id[kLongestId] = {};
    int m_descriptor = -1;
};

} // namespace bask::guard
