#pragma once
// What the system tells of a serial port beside Qt.

#include "engine/protocols/serial_settings.h"

#include <string>

namespace bask {

/// What the terminal has for us; hung up when the cable or its adapter is out. Asked here because Qt tells it
/// too often (up to 6.7) or not at all (since: its event loop then turns without a pause until the port is
/// closed, so a link is to be asked every few milliseconds, as LinkThread does).
enum class SerialPortState { Nothing, Bytes, HungUp };
SerialPortState serialPortState(int descriptor);

/// What the port is to be set to: a pseudo-terminal has no line, and refuses bits and parity that it cannot
/// have ("Invalid argument") where nothing else is changed with them, as when it is opened again.
SerialSettings settableOf(const std::string& path, SerialSettings wanted);

/// Why a port could not be opened, in words that say what to do; `otherwise` where the system does not tell.
std::string whyNotOpened(const std::string& path, bool isTaken, const std::string& otherwise);

} // namespace bask
