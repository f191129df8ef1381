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
    explicit LineSplitter(std::string ends = "\r\n") : m_ends(std::move(ends)) {}

    void add(std::string_view bytes) { m_bytes += bytes; }
    /// Returns the next complete line without its end; blank lines are skipped. Bytes longer than kLongest
    /// without an end are returned as a line. Empty if there is no line yet.
    std::optional<std::string> next();
    void clear() { m_bytes.clear(); }

private:
    std::string m_ends, m_bytes;
};

} // namespace bask
