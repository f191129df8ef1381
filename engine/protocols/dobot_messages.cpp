#include "engine/protocols/dobot_messages.h"

#include "engine/base/message_code.h"

#include <algorithm>
#include <bit>
#include <cctype>
#include <charconv>
#include <cmath>
#include <utility>

namespace bask {
namespace {

constexpr double kFarthestTarget = 9999.999; // mm, degrees
constexpr std::size_t kModeAt = 24, kTimeAt = 32, kTestAt = 48, kPositionAt = 624, kUserAt = 1012,
                      kToolAt = 1013;
constexpr std::uint64_t kTest = 0x0123456789ABCDEF;

std::uint64_t wordAt(std::string_view packet, std::size_t at) {
    std::uint64_t word = 0;
    for (std::size_t i = 8; i-- > 0;)
        word = word << 8 | static_cast<unsigned char>(packet[at + i]);
    return word;
}

void putWord(std::string& packet, std::size_t at, std::uint64_t word) {
    for (std::size_t i = 0; i < 8; ++i, word >>= 8)
        packet[at + i] = static_cast<char>(word & 0xFF);
}

std::size_t sizeOf(std::string_view packet) {
    return static_cast<std::size_t>(wordAt(packet, 0) & 0xFFFF);
}

bool isPacket(std::string_view bytes) {
    return sizeOf(bytes) == DobotFeedbackReader::kPacketBytes && wordAt(bytes, kTestAt) == kTest;
}

std::string hex(std::uint64_t word) {
    std::array<char, 16> text{};
    const auto end = std::to_chars(text.data(), text.data() + text.size(), word, 16);
    return "0x" + std::string(text.data(), end.ptr);
}

bool readInt(std::string_view text, int& value) {
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    return !text.empty() && error == std::errc() && end == text.data() + text.size();
}

} // namespace

std::optional<DobotReply> parseDobotReply(std::string_view raw) {
    std::string plain(raw);
    std::erase_if(plain, [](char c) { return c >= 0 && c <= ' '; });
    const std::string_view text = plain;
    DobotReply reply;
    const std::size_t open = text.find(",{"), close = text.find("},");
    if (open == std::string_view::npos || close == std::string_view::npos || close < open ||
        !readInt(text.substr(0, open), reply.error))
        return std::nullopt;
    reply.values = text.substr(open + 2, close - open - 2);
    const std::string_view command = text.substr(close + 2);
    const std::size_t bracket = command.find('(');
    if (bracket == 0 || bracket == std::string_view::npos || command.back() != ')')
        return std::nullopt;
    for (const char c : command.substr(0, bracket)) {
        if (std::isalnum(static_cast<unsigned char>(c)) == 0)
            return std::nullopt;
        reply.command += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    }
    return reply;
}

std::string dobotErrorWords(int error) {
    if (error == -1)
        return "not carried out";
    if (error == -10000)
        return "unknown command";
    if (error == -20000)
        return "wrong number of parameters";
    if (error <= -30000 && error > -40000)
        return "wrong type of a parameter";
    if (error <= -40000 && error > -50000)
        return "parameter out of range";
    return {};
}

std::vector<int> dobotErrorIds(std::string_view values) {
    std::vector<int> out;
    for (const char *p = values.data(), *end = p + values.size(); p != end;) {
        int id = 0;
        const auto [after, error] = std::from_chars(p, end, id);
        if (error == std::errc())
            out.push_back(id);
        p = error == std::errc() ? after : p + 1;
    }
    return out;
}

Result<std::string> dobotMove(const DobotPosition& to, int speed_percent, int acceleration_percent) {
    std::string out = "MovL(";
    for (const double position : to) {
        if (!(std::abs(position) <= kFarthestTarget))
            return Error(MessageCode::ValueOutOfRange, "position",
                         {formatNumber(position), formatNumber(-kFarthestTarget, 7),
                          formatNumber(kFarthestTarget, 7), ""});
        std::array<char, 32> text{};
        const auto end =
            std::to_chars(text.data(), text.data() + text.size(),
                          std::round(position * 1000.0) / 1000.0 + 0.0, std::chars_format::fixed, 3);
        out.append(text.data(), end.ptr);
        out += ',';
    }
    return out + "SpeedL=" + std::to_string(speed_percent) + ",AccL=" + std::to_string(acceleration_percent) +
           ")";
}

void DobotFeedbackReader::clear() {
    m_bytes.clear();
    m_strange.clear();
}

/// The first of them begin like a packet where the sender has packets of another kind; later ones may be cut.
void DobotFeedbackReader::discard(std::size_t count) {
    if (count > 0 && (m_strange.empty() || std::exchange(m_isInStep, false)))
        m_strange =
            std::to_string(sizeOf(m_bytes)) + " bytes with test word " + hex(wordAt(m_bytes, kTestAt));
    m_discarded += count;
    m_bytes.erase(0, count);
}

std::optional<DobotFeedback> DobotFeedbackReader::next() {
    while (m_bytes.size() >= kPacketBytes) {
        std::size_t at = 0;
        while (at + kTestAt + 8 <= m_bytes.size() && !isPacket(std::string_view(m_bytes).substr(at)))
            ++at;
        discard(at);
        if (m_bytes.size() < kPacketBytes)
            break;
        DobotFeedback out;
        out.mode = static_cast<DobotMode>(wordAt(m_bytes, kModeAt));
        out.time_ms = wordAt(m_bytes, kTimeAt);
        out.user = static_cast<unsigned char>(m_bytes[kUserAt]);
        out.tool = static_cast<unsigned char>(m_bytes[kToolAt]);
        for (std::size_t i = 0; i < out.position.size(); ++i)
            out.position[i] = std::bit_cast<double>(wordAt(m_bytes, kPositionAt + 8 * i));
        const bool isFinite = std::ranges::all_of(out.position, [](double p) { return std::isfinite(p); });
        if (!isFinite) {
            discard(kPacketBytes);
            m_strange = "a position that is not a number";
            continue;
        }
        m_isInStep = true;
        m_bytes.erase(0, kPacketBytes);
        return out;
    }
    return std::nullopt;
}

std::string dobotPacket(const DobotFeedback& feedback) {
    std::string packet(DobotFeedbackReader::kPacketBytes, '\0');
    packet[0] = static_cast<char>(packet.size() & 0xFF);
    packet[1] = static_cast<char>(packet.size() >> 8);
    putWord(packet, kModeAt, static_cast<std::uint64_t>(feedback.mode));
    putWord(packet, kTimeAt, feedback.time_ms);
    putWord(packet, kTestAt, kTest);
    packet[kUserAt] = static_cast<char>(feedback.user);
    packet[kToolAt] = static_cast<char>(feedback.tool);
    for (std::size_t i = 0; i < feedback.position.size(); ++i)
        putWord(packet, kPositionAt + 8 * i, std::bit_cast<std::uint64_t>(feedback.position[i]));
    return packet;
}

} // namespace bask
