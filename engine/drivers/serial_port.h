#pragma once
// What the system tells of a serial port beside Qt.

#include "engine/base/message.h"
#include "engine/protocols/serial_settings.h"

#include <functional>
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

/// Keeps other programs out that ask, as the guard and Bask do; the system's own lock does not hold for root.
/// False: one has it.
bool lockPort(int descriptor);
inline constexpr const char* kPortIds = "/dev/serial/by-id";
/// The port's own name, as its adapter has it ("usb-FTDI_FT232R_USB_UART_A1-if00-port0"), whatever number the
/// system gave it; empty: it has none.
std::string portIdOf(const std::string& path, const std::string& folder = kPortIds);

/// Keeps a link to the port that it had first, or was told: the same path may be another one's later.
class PortCheck {
public:
    using IdOf = std::function<std::string(const std::string& path)>;

    /// `expected`: its own name; empty: it has none, or is not known.
    explicit PortCheck(
        std::string expected = {}, IdOf idOf = [](const std::string& path) { return portIdOf(path); });

    /// Before it is opened: why it is not to be, DeviceExchanged; None: it may.
    Message look(const std::string& path);
    const std::string& found() const { return m_found; }

private:
    std::string m_expected, m_found;
    IdOf m_idOf;
};

/// Why a port could not be opened, in words that say what to do; `otherwise` where the system does not tell.
std::string whyNotOpened(const std::string& path, bool isTaken, const std::string& otherwise);
/// The same of an errno, without a look at the system.
std::string whyNotOpened(int problem);

} // namespace bask
