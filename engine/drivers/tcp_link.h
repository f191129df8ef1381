#pragma once
// A TCP connection as a link of bytes.

#include "engine/drivers/byte_link.h"

#include <memory>

namespace bask {

/// Needs a thread with Qt's event loop; make and use it only there. open() has no effect while it is being
/// opened, for up to kOpening_s.
class TcpLink final : public ByteLink {
public:
    static constexpr double kOpening_s = 2.0;

    TcpLink(std::string host, int port);
    ~TcpLink() override;

    void open() override;
    void close() override;
    bool isOpen() const override;
    Message problem() const override;
    std::string read() override;
    void write(std::string_view bytes) override;
    std::string name() const override;

private:
    struct Socket;
    std::unique_ptr<Socket> m_socket;
};

} // namespace bask
