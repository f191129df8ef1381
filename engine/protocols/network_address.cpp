#include "engine/protocols/network_address.h"

#include <algorithm>
#include <charconv>

namespace bask {
namespace {

constexpr int kMaxPort = 65535;

bool isHostCharacter(char c) {
    return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '-' ||
           c == '.' || c == '_' || static_cast<unsigned char>(c) >= 0x80;
}

bool isNumericCharacter(char c) {
    return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'f') || (c >= 'A' && c <= 'F') || c == ':' || c == '.';
}

/// A name, or a numeric address; one with colons may end with its network: "fe80::1%eth0".
bool isHostText(const std::string& text) {
    if (text.find(':') == std::string::npos)
        return !text.empty() && std::ranges::all_of(text, isHostCharacter);
    const std::size_t zone = text.find('%');
    return std::ranges::all_of(text.substr(0, zone), isNumericCharacter) &&
           (zone == std::string::npos || std::ranges::all_of(text.substr(zone + 1), isHostCharacter));
}

} // namespace

std::optional<NetworkAddress> networkAddress(const std::string& text, int usualPort) {
    NetworkAddress out{text, usualPort};
    std::size_t colon = std::string::npos;
    if (text.starts_with('[')) { // the address itself has colons
        const std::size_t end = text.find(']');
        if (end == std::string::npos || (end + 1 != text.size() && text[end + 1] != ':'))
            return std::nullopt;
        out.host = text.substr(1, end - 1);
        colon = end + 1 < text.size() ? end + 1 : std::string::npos;
    } else if (std::ranges::count(text, ':') == 1) {
        colon = text.find(':');
        out.host = text.substr(0, colon);
    }
    if (colon != std::string::npos) {
        const char* const end = text.data() + text.size();
        const auto read = std::from_chars(text.data() + colon + 1, end, out.port);
        if (read.ec != std::errc() || read.ptr != end)
            return std::nullopt;
    }
    return isHostText(out.host) && out.port >= 1 && out.port <= kMaxPort ? std::optional(out) : std::nullopt;
}

} // namespace bask
