#pragma once
// A stream of bytes to and from a device: a serial port, a TCP connection, or a test's script.

#include "engine/base/message.h"

#include <limits>
#include <string>
#include <string_view>

namespace bask {

/// No function here waits. Use it only on the engine thread.
class ByteLink {
public:
    static constexpr std::size_t kMaxQueued = 4096; ///< limit of bytes that the other end has not accepted

    virtual ~ByteLink() = default;
    /// Starts to open it; problem() reports a port that does not exist. Unread bytes from before are
    /// discarded.
    virtual void open() = 0;
    virtual void close() = 0;
    virtual bool isOpen() const = 0;
    /// Returns why it could not be opened, or was lost later; code None if neither. A lost link is closed.
    virtual Message problem() const = 0;
    /// Returns all bytes received since the last call.
    virtual std::string read() = 0;
    /// Returns when the line was last seen empty before the bytes of the last read() arrived, SteadyClock, s:
    /// they may have waited since then. Infinite if the link does not report it.
    virtual double emptyAt_s() const { return std::numeric_limits<double>::infinity(); }
    /// Queues bytes. If more than kMaxQueued would be queued, the link is closed with a problem.
    virtual void write(std::string_view bytes) = 0;
    /// Returns the port's own name from the last time it was opened; empty if it has none.
    virtual std::string portId() const { return {}; }
    /// Returns the name for people: "/dev/ttyUSB0", "192.168.1.6:29999".
    virtual std::string name() const = 0;
};

} // namespace bask
