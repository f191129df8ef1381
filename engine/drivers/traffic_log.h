#pragma once
// What goes over the links to the devices, in both directions, kept for ten minutes.

#include <cstddef>
#include <cstdint>
#include <deque>
#include <memory>
#include <mutex>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace bask {

enum class TrafficKind {
    Sent,
    SentByHand,
    Received,
    ErrorOutput, ///< what a program says to people
    Opened,
    Closed
};

/// Bytes that were written or read at once.
struct TrafficLine {
    std::uint64_t number = 0; ///< counts from 1
    double time_s = 0.0;      ///< SteadyClock
    std::int64_t utc_ms = 0;  ///< since 1970
    TrafficKind kind = TrafficKind::Received;
    std::string link; ///< name of the link: "/dev/ttyUSB0", "192.168.1.6:29999"
    std::string bytes;
};

/// "sent", "sent-by-hand", "received", "error-output", "opened", "closed"
const char* trafficKindWord(TrafficKind kind);

/// Returns bytes for people: text with "\r", "\n" and "\t" for the ends of lines and tabs, or hexadecimal
/// numbers if they are no text.
std::string shownBytes(std::string_view bytes);

/// Every function may be called by any thread and is short: lines are shared, not copied.
class TrafficLog {
public:
    static constexpr double kKept_s = 600.0;
    static constexpr std::size_t kMaxBytes = 128 << 20; ///< limit of its memory; the oldest lines go first

    using Line = std::shared_ptr<const TrafficLine>;

    void add(TrafficKind kind, const std::string& link, std::string_view bytes, double now_s);
    /// Returns up to `max` lines from this number on, oldest first.
    std::vector<Line> from(std::uint64_t number, std::size_t max = SIZE_MAX) const;

    /// Returns the names of the links that are open.
    std::vector<std::string> openLinks() const;

private:
    static constexpr int kFreedAtOnce = 64; ///< lines of one call of add()
    static std::size_t memoryOf(const TrafficLine& line);

    mutable std::mutex m_mutex;
    // Protected by the mutex
    std::deque<Line> m_lines;
    std::size_t m_bytes = 0;
    std::uint64_t m_last = 0;
    std::set<std::string> m_open;
};

} // namespace bask
