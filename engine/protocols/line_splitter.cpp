#include "engine/protocols/line_splitter.h"

#include <algorithm>

namespace bask {

std::optional<std::string> LineSplitter::next() {
    m_bytes.erase(0, std::min(m_bytes.find_first_not_of(m_ends), m_bytes.size()));
    std::size_t end = m_bytes.find_first_of(m_ends);
    if (end == std::string::npos && m_bytes.size() < m_longest)
        return std::nullopt;
    end = std::min(end, m_longest);
    std::string line = m_bytes.substr(0, end);
    m_bytes.erase(0, end);
    return line;
}

} // namespace bask
