#pragma once
// The serial ports of this computer, as a person tells them apart.

#include <string>
#include <vector>

namespace bask {

struct SerialPort {
    std::string path;        ///< by-id where there is one, which stays the same after replugging
    std::string description; ///< "FTDI FT232R USB UART, ttyUSB0"
    bool operator==(const SerialPort&) const = default;
};

/// Those with a device behind them; pseudo-terminals are not listed.
std::vector<SerialPort> serialPorts();

} // namespace bask
