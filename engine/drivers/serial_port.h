#pragma once
// What the system reports about a serial port in addition to Qt.

#include "engine/base/message.h"
#include "engine/protocols/serial_settings.h"

#include <functional>
#include <string>

namespace bask {

/// The state of the terminal; HungUp if the cable or its adapter is unplugged. It is checked here because Qt
/// reports it too often (up to 6.7) or not at all (later versions: the event loop then turns without a pause
/// until the port is closed, so a link must be checked every few milliseconds, as LinkThread does).
enum class SerialPortState { Nothing, Bytes, HungUp };
SerialPortState serialPortState(int descriptor);

/// Returns the settings that the port accepts: a pseudo-terminal has no line, and refuses bits and parity
/// that it does not support ("Invalid argument") if nothing else is changed with them, for example when it is
/// opened again.
SerialSettings settableOf(const std::string& path, SerialSettings wanted);

/// Locks the port against other programs that check this lock, as the guard and Bask do; the system's own
/// lock does not stop root. Returns false if another program has it.
bool lockPort(int descriptor);
inline constexpr const char* kPortIds = "/dev/serial/by-id";
/// Returns the port's own name given by its adapter ("usb-FTDI_FT232R_USB_UART_A1-if00-port0"), which does
/// not depend on the system's number; empty if it has none.
std::string portIdOf(const std::string& path, const std::string& folder = kPortIds);

/// Makes sure that a link uses the expected port, or else the first one found: the same path may belong to
/// another port later.
class PortCheck {
public:
    using IdOf = std::function<std::string(const std::string& path)>;

    /// `expected` is the port's own name; empty if it has none, or it is unknown.
    explicit PortCheck(
        std::string expected = {}, IdOf idOf = [](const std::string& path) { return portIdOf(path); });

    /// Call before it is opened. Returns why it must not be opened, DeviceExchanged; None if it may.
    Message look(const std::string& path);
    const std::string& found() const { return m_found; }

private:
    std::string m_expected, m_found;
    IdOf m_idOf;
};

/// Returns why a port could not be opened, with advice what to do; `otherwise` if the system gives no reason.
std::string whyNotOpened(const std::string& path, bool isTaken, const std::string& otherwise);
/// The same for an errno, without asking the system.
std::string whyNotOpened(int problem);

} // namespace bask
