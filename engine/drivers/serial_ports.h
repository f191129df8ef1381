#pragma once
// The serial ports of this computer, described for people.

#include <string>
#include <vector>

namespace bask {

struct SerialPort {
    std::string path;        ///< by-id if it exists, because that does not change after replugging
    std::string description; ///< "FTDI FT232R USB UART, ttyUSB0"
    bool operator==(const SerialPort&) const = default;
};

/// Returns the ports with a device behind them; pseudo-terminals are not listed.
std::vector<SerialPort> serialPorts();

} // namespace bask
