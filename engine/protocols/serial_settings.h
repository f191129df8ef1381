#pragma once
// The settings of a serial line.

namespace bask {

struct SerialSettings {
    int baud = 115200;
    int dataBits = 8;  ///< 5 to 8
    char parity = 'N'; ///< N, E, O
    int stopBits = 1;  ///< 1, 2
    bool operator==(const SerialSettings&) const = default;
};

/// Returns the time that bytes take on the line, s.
inline double onTheLine_s(const SerialSettings& line, double bytes) {
    return bytes * (line.dataBits + 3) / line.baud;
}

} // namespace bask
