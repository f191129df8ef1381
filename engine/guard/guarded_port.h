#pragma once
// The heater's serial port as the guard has it: never waited for. A look whether a terminal has bytes waits
// for the system's own work on them, half a second on a busy computer, and so may its opening: both are done
// by a thread, whose events are read. Bytes are written at once.

#include "engine/guard/serial_line.h"

#include <cstdint>

namespace bask::guard {

/// Nothing is allocated after the start.
class GuardedPort {
public:
    enum class Event { None, Opened, Failed, Bytes, Dropped, Lost };

    explicit GuardedPort(const PortSettings& settings);

    /// Its thread could be started; else nothing works.
    bool isWorking() const { return m_isWorking; }
    /// Opened or Failed is told later.
    void open();
    bool isOpening() const { return m_isOpening; }
    /// After Opened, until close().
    bool isOpen() const { return m_isOpen; }
    void close();

    /// To be polled for reading; always the same.
    int descriptor() const { return m_events[0]; }
    /// The next event, if there is one; of Bytes up to kMaxBytes.
    Event take(void* bytes, std::size_t& count);
    static constexpr std::size_t kMaxBytes = 1024;
    int problem() const { return m_problem; }      ///< of Failed: errno, or SerialLine::kExchanged
    const char* id() const { return m_line.id(); } ///< after Opened or Failed

    /// Queues; false: so much is queued that the device does not read.
    bool write(const void* bytes, std::size_t count);
    /// Gives what is queued as far as the port takes it; false: it is gone.
    bool flush();
    bool isFlushed() const { return m_queued == 0; }
    static constexpr int kFlush_ms = 2; ///< until the next flush() where one was not enough
    /// Forgets what is queued, and what the system holds of it; and drop().
    void forget();
    /// Forgets what has come, wherever it is on its way. What comes after Dropped is new.
    void drop();

private:
    struct Command {
        enum class Kind { Open, Close, Drop };
        std::uint32_t number; ///< of what is told from here on
        Kind kind;
    };
    struct Packet {
        std::uint32_t number;
        Event event;
        int problem;
        char bytes[kMaxBytes];
    };
    static void* run(void* port);
    void serve();
    void obey(const Command& command);
    bool order(Command::Kind kind);
    void tell(Event event, std::size_t count = 0);

    SerialLine m_line;     ///< the thread's, but for its descriptor between Opened and close()
    Packet m_told{};       ///< the thread's
    bool m_isLost = false; ///< the thread's
    Packet m_taken{};
    int m_commands[2] = {-1, -1}, m_events[2] = {-1, -1};
    unsigned long m_thread = 0;
    bool m_isWorking = false, m_isOpening = false, m_isOpen = false;
    std::uint32_t m_number = 0;
    int m_problem = 0;
    std::size_t m_queued = 0;
    char m_queue[4096] = {};
};

} // namespace bask::guard
