#pragma once
// A stream of bytes to a device and back: a serial port, a TCP connection, or a test's script.

#include "engine/base/message.h"

#include <limits>
#include <string>
#include <string_view>

namespace bask {

/// Nothing here waits. Used on the engine thread only.
class ByteLink {
public:
    static constexpr std::size_t kMaxQueued = 4096; ///< bytes that the other end has not taken

    virtual ~ByteLink() = default;
    /// Begins to open it; a port that is not there is told by problem(). What was unread before is forgotten.
    virtual void open() = 0;
    virtual void close() = 0;
    virtual bool isOpen() const = 0;
    /// Why it could not be opened, or was lost since; code None: neither. A lost link is closed.
    virtual Message problem() const = 0;
    /// All that has come since.
    virtual std::string read() = 0;
    /// When the line was last seen empty before any of what read() gave last had come, SteadyClock, s: it may
    /// have waited. Infinite: the link does not tell.
    virtual double emptyAt_s() const { return std::numeric_limits<double>::infinity(); }
    /// Queued. One that would queue more than kMaxQueued closes the link, with a problem.
    virtual void write(std::string_view bytes) = 0;
    /// The port's own name, when it was opened last; empty: it has none.
    virtual std::string portId() const { return {}; }
    /// As a person knows it: "/dev/ttyUSB0", "192.168.1.6:29999".
    virtual std::string name() const = 0;
};

} // namespace bask
