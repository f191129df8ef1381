#pragma once
// Splits a stream of bytes, which arrives in pieces of any size, into lines.

#include <optional>
#include <string>
#include <string_view>
#include <utility>

namespace bask {

class LineSplitter {
public:
    static constexpr std::size_t kLongest = 512;

    /// Each character of `ends` ends a line.
    explicit LineSplitter(std::string ends = "\r\n", std::size_t longest = kLongest)
        : m_ends(std::move(ends)), m_longest(longest) {}

    void add(std::string_view bytes) { m_bytes += bytes; }
    /// Returns the next complete line without its end; blank lines are skipped. More bytes than the longest
    /// line without an end are returned as a line. Empty if there is no line yet.
    std::optional<std::string> next();
    void clear() { m_bytes.clear(); }

private:
    std::string m_ends, m_bytes;
    std::size_t m_longest;
};

} // namespace bask
