#pragma once
// The heater's serial port in the guard, which never waits for it. Checking a terminal for bytes waits for
// the system's own work on them, half a second on a busy computer, and opening may wait, too. Therefore a
// thread does both and its events are read here. Bytes are written directly.

#include "engine/guard/serial_line.h"

#include <cstdint>

namespace bask::guard {

/// Allocates no memory after the start.
class GuardedPort {
public:
    enum class Event { None, Opened, Failed, Bytes, Dropped, Lost };

    explicit GuardedPort(const PortSettings& settings);

    /// Returns whether its thread could be started; otherwise nothing works.
    bool isWorking() const { return m_isWorking; }
    /// Starts to open the port; Opened or Failed is reported later.
    void open();
    bool isOpening() const { return m_isOpening; }
    /// True after Opened, until close().
    bool isOpen() const { return m_isOpen; }
    void close();

    /// Returns the descriptor to poll for reading; it never changes.
    int descriptor() const { return m_events[0]; }
    /// Returns the next event, if there is one; Bytes has up to kMaxBytes.
    Event take(void* bytes, std::size_t& count);
    static constexpr std::size_t kMaxBytes = 1024;
    int problem() const { return m_problem; }      ///< of Failed: errno, or SerialLine::kExchanged
    const char* id() const { return m_line.id(); } ///< after Opened or Failed

    /// Queues bytes. Returns false if so many are queued that the device does not seem to read.
    bool write(const void* bytes, std::size_t count);
    /// Writes as many queued bytes as the port accepts. Returns false if the port has disappeared.
    bool flush();
    bool isFlushed() const { return m_queued == 0; }
    static constexpr int kFlush_ms = 2; ///< time until the next flush() if one was not enough
    /// Discards queued bytes, also those in the system, and calls drop().
    void forget();
    /// Discards received bytes, wherever they are. Bytes after the event Dropped are new.
    void drop();

private:
    struct Command {
        enum class Kind { Open, Close, Drop };
        std::uint32_t number; ///< number of the following messages
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

    SerialLine m_line;     ///< used by the thread, except its descriptor between Opened and close()
    Packet m_told{};       ///< used by the thread
    bool m_isLost = false; ///< used by the thread
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
