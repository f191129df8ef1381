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
};

/// Nothing is allocated. Times are of the caller's poll.
class GuardedPort {
public:
    explicit GuardedPort(const PortSettings& settings) : m_settings(settings) {}

    /// 0, or errno: EBUSY where another program has it. What was unread before is forgotten.
    int open();
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

    PortSettings m_settings;
    int m_descriptor = -1;
    std::size_t m_queued = 0;
    char m_queue[4096] = {};
};

} // namespace bask::guard
