#pragma once
// The heater's serial port as the guard has it: alone, raw, and never waited for.

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

/// Nothing is allocated. Times are of the caller's poll.
class GuardedPort {
public:
    static constexpr int kExchanged = -1;

    explicit GuardedPort(const PortSettings& settings);

    /// 0; errno: EBUSY where another program has it; or kExchanged where it is not the one it was first, or
    /// is to be. What was unread before is forgotten.
    int open();
    /// The port's own name when it was opened, or was to be; empty: it has none.
    const char* id() const { return m_id; }
    /// Gives the last bytes a moment.
    void close();
    bool isOpen() const { return m_descriptor >= 0; }
    int descriptor() const { return m_descriptor; }
    /// What the caller's poll is to wait for.
    short events() const;

    /// -1: it is gone; 0: nothing there.
    long read(void* bytes, std::size_t most);
    /// Queues; false: so much is queued that the device does not read.
    bool write(const void* bytes, std::size_t count);
    /// Gives what is queued as far as the port takes it; false: it is gone.
    bool flush();
    bool isFlushed() const { return m_queued == 0; }
    /// Forgets what is queued, and what the system holds of it and of what came.
    void forget();

private:
    void drain();
    void findId(unsigned long long device);

    static constexpr std::size_t kLongestId = 256;

    PortSettings m_settings;
    char m_expected[kLongestId] = {}, m_id[kLongestId] = {};
    int m_descriptor = -1;
    std::size_t m_queued = 0;
    char m_queue[4096] = {};
};

} // namespace bask::guard
