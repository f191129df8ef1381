#pragma once
// Modbus RTU over any link of bytes: requests, replies, deadlines, and replies that are late.

#include "engine/base/clock.h"
#include "engine/drivers/byte_link.h"
#include "engine/drivers/modbus_link.h"
#include "engine/protocols/serial_settings.h"

#include <memory>

namespace bask {

/// Follows the rules of QtModbusLink: a reply that may answer an earlier request is not used, and the line
/// stays silent after a request without a valid reply.
class RtuLink final : public ModbusLink {
public:
    /// `settings` are those of the line, for the time that bytes take; replyTime_s as in QtModbusLink.
    /// `clock` must outlive it.
    RtuLink(std::unique_ptr<ByteLink> line, const SerialSettings& settings, const Clock& clock,
            double replyTime_s = 0.3);
    ~RtuLink() override;

    /// No effect if the link is open.
    void open() override;
    void close() override;
    bool isOpen() const override;
    Message problem() const override;
    bool isFree() const override;
    /// Throws std::logic_error unless it is free.
    int send(const ModbusRequest& request) override;
    /// True once the request in progress has had kOvertake_s in addition to its bytes' time on the line.
    bool mayOvertake() const override;
    /// Throws std::logic_error unless mayOvertake().
    int overtake(const ModbusRequest& request) override;
    std::optional<ModbusReply> takeReply(int number) override;
    std::string name() const override;
    std::string portId() const override;
    static constexpr double kOvertake_s = 0.1; ///< most devices have started their answer by then
    /// Returns the number of replies that arrived and were not used.
    int discarded() const;

private:
    struct Line;
    std::unique_ptr<Line> m_line;
};

} // namespace bask
