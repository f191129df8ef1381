#pragma once
// What the system tells of a serial port beside Qt.

#include <string>

namespace bask {

/// What the terminal has for us; hung up when the cable or its adapter is out. Asked here because Qt tells it
/// too often (up to 6.7) or not at all (since).
enum class SerialPortState { Nothing, Bytes, HungUp };
SerialPortState serialPortState(int descriptor);

/// Why a port could not be opened, in words that say what to do; `otherwise` where the system does not tell.
std::string whyNotOpened(const std::string& path, bool isTaken, const std::string& otherwise);

} // namespace bask
