#include "engine/drivers/traffic_log.h"

#include <algorithm>
#include <chrono>
#include <utility>

namespace bask {

const char* trafficKindWord(TrafficKind kind) {
    switch (kind) {
    case TrafficKind::Sent:
        return "sent";
    case TrafficKind::SentByHand:
        return "sent-by-hand";
    case TrafficKind::Received:
        return "received";
    case TrafficKind::ErrorOutput:
        return "error-output";
    case TrafficKind::Opened:
        return "opened";
    case TrafficKind::Closed:
        return "closed";
    }
    return "";
}

std::string shownBytes(std::string_view bytes) {
    const auto isText = [](char c) { return (c >= ' ' && c <= '~') || c == '\r' || c == '\n' || c == '\t'; };
    std::string out;
    if (std::ranges::all_of(bytes, isText)) {
        for (const char c : bytes)
            out += c == '\r' ? "\\r" : c == '\n' ? "\\n" : c == '\t' ? "\\t" : std::string(1, c);
        return out;
    }
    constexpr std::string_view kDigits = "0123456789abcdef";
    for (const char c : bytes) {
        const auto byte = static_cast<unsigned char>(c);
        out += out.empty() ? "" : " ";
        out += kDigits[byte >> 4U];
        out += kDigits[byte & 15U];
    }
    return out;
}

std::size_t TrafficLog::memoryOf(const TrafficLine& line) {
    return sizeof line + line.link.capacity() + line.bytes.capacity();
}

void TrafficLog::add(TrafficKind kind, const std::string& link, std::string_view bytes, double now_s) {
    const auto utc = std::chrono::system_clock::now().time_since_epoch();
    auto line = std::make_shared<TrafficLine>(
        TrafficLine{0, now_s, std::chrono::duration_cast<std::chrono::milliseconds>(utc).count(), kind, link,
                    std::string(bytes)});
    const std::lock_guard lock(m_mutex);
    line->number = ++m_last;
    if (kind == TrafficKind::Opened)
        m_open.insert(link);
    else if (kind == TrafficKind::Closed)
        m_open.erase(link);
    m_bytes += memoryOf(*line);
    m_lines.push_back(std::move(line));
    for (int i = 0; i < kFreedAtOnce && m_lines.size() > 1 &&
                    (m_bytes > kMaxBytes || m_lines.front()->time_s < now_s - kKept_s);
         ++i) {
        m_bytes -= memoryOf(*m_lines.front());
        m_lines.pop_front();
    }
}

std::vector<TrafficLog::Line> TrafficLog::from(std::uint64_t number, std::size_t max) const {
    const std::lock_guard lock(m_mutex);
    const auto first = std::ranges::lower_bound(m_lines, number, {}, &TrafficLine::number);
    const auto count = std::min(max, static_cast<std::size_t>(m_lines.end() - first));
    return {first, first + static_cast<std::ptrdiff_t>(count)};
}

std::vector<std::string> TrafficLog::openLinks() const {
    const std::lock_guard lock(m_mutex);
    return {m_open.begin(), m_open.end()};
}

} // namespace bask
