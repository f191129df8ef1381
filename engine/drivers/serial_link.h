#pragma once
// A serial port as a link of bytes; needs no processor time while it is unplugged.

#include "engine/drivers/byte_link.h"
#include "engine/drivers/serial_port.h"
#include "engine/protocols/serial_settings.h"

#include <memory>

namespace bask {

/// Needs a thread with Qt's event loop; make and use it only there.
class SerialLink final : public ByteLink {
public:
    /// `path`: "/dev/ttyUSB0", "/dev/serial/by-id/...", or any link to a terminal.
    SerialLink(std::string path, const SerialSettings& settings, PortCheck check = PortCheck());
    ~SerialLink() override;

    void open() override;
    void close() override;
    bool isOpen() const override;
    Message problem() const override;
    std::string read() override;
    void write(std::string_view bytes) override;
    std::string name() const override;
    std::string portId() const override;

private:
    struct Port;
    std::unique_ptr<Port> m_port;
};

} // namespace bask
