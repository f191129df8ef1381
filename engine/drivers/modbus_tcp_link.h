#pragma once
// Modbus TCP over any link of bytes.

#include "engine/base/clock.h"
#include "engine/drivers/byte_link.h"
#include "engine/drivers/modbus_link.h"

#include <memory>

namespace bask {

/// A reply contains the number of its request: one that is late is never used for another request, and the
/// line needs no silence. A reply with that number that has another unit or function is not used either.
/// Bytes that are no frame of Modbus TCP close the link, because where the next frame begins is then unknown.
class ModbusTcpLink final : public ModbusLink {
public:
    static constexpr double kReply_s = 0.5; ///< the device may be a gateway to a serial line

    /// replyTime_s is the time until the reply is complete. `clock` must outlive it.
    ModbusTcpLink(std::unique_ptr<ByteLink> line, const Clock& clock, double replyTime_s = kReply_s);
    ~ModbusTcpLink() override;

    /// No effect if the link is open.
    void open() override;
    void close() override;
    bool isOpen() const override;
    Message problem() const override;
    bool isFree() const override;
    /// Throws std::logic_error if a request is in progress.
    int send(const ModbusRequest& request) override;
    /// True once the request in progress has had kOvertake_s.
    bool mayOvertake() const override;
    /// Throws std::logic_error unless mayOvertake().
    int overtake(const ModbusRequest& request) override;
    std::optional<ModbusReply> takeReply(int number) override;
    std::string name() const override;
    std::string portId() const override;
    static constexpr double kOvertake_s = 0.1;
    /// Returns the number of replies that arrived and were not used.
    int discarded() const;

private:
    struct Line;
    std::unique_ptr<Line> m_line;
};

} // namespace bask
