#pragma once
// The address of a device on a network, as people write it.

#include <optional>
#include <string>

namespace bask {

struct NetworkAddress {
    std::string host; ///< a name, or a numeric address without brackets
    int port = 0;
    bool operator==(const NetworkAddress&) const = default;
};

/// Parses "192.168.1.20", "logger:1502", "fe80::1" or "[fe80::1]:502"; `usualPort` is the port if the text
/// has none. Returns nothing if it is not an address: a path, a text with blanks, a port outside 1 to 65535.
std::optional<NetworkAddress> networkAddress(const std::string& text, int usualPort);

} // namespace bask
