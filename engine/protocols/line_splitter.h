#pragma once
// Lines out of a stream of bytes that comes in any pieces.

#include <optional>
#include <string>
#include <string_view>
#include <utility>

namespace bask {

class LineSplitter {
public:
    static constexpr std::size_t kLongest = 512;

    /// Each of `ends` ends a line.
    explicit LineSplitter(std::string ends = "\r\n") : m_ends(std::move(ends)) {}

    void add(std::string_view bytes) { m_bytes += bytes; }
    /// The next whole line without its end; blank ones are left out. What grows longer than kLongest without
    /// an end is given as a line. Empty: none yet.
    std::optional<std::string> next();
    void clear() { m_bytes.clear(); }

private:
    std::string m_ends, m_bytes;
};

} // namespace bask
