#pragma once
// Modbus over TCP with Qt's client.

#include "engine/base/clock.h"
#include "engine/drivers/modbus_link.h"

#include <memory>
#include <optional>
#include <string>

namespace bask {

/// A host and a port.
struct NetworkAddress {
    std::string host;
    int port = 0;
};

/// Reads "192.168.1.20", "logger:1502" or "[fe80::1]:502"; `usual` is the port that is not given. Empty if it
/// is no address.
std::optional<NetworkAddress> networkAddress(const std::string& text, int usual);

/// Needs a thread with Qt's event loop; make and use it only there. A reply names its request, so a late one
/// is never taken for the next one's. Only one process of this computer uses an address.
class ModbusTcpLink final : public ModbusLink {
public:
    static constexpr int kPort = 502;
    static constexpr double kReply_s = 0.5;   ///< a device on a network may be a gateway to a serial line
    static constexpr double kOpening_s = 3.0; ///< until a host that does not answer is given up

    /// `address` as in networkAddress(). `clock` must outlive it.
    ModbusTcpLink(std::string address, const Clock& clock, double replyTime_s = kReply_s);
    ~ModbusTcpLink() override;

    /// No effect if the link is open, or is being opened.
    void open() override;
    void close() override;
    bool isOpen() const override;
    Message problem() const override;
    bool isFree() const override;
    /// Throws std::logic_error unless it is free.
    int send(const ModbusRequest& request) override;
    std::optional<ModbusReply> takeReply(int number) override;
    std::string name() const override;

private:
    struct Line;
    std::unique_ptr<Line> m_line;
};

} // namespace bask
