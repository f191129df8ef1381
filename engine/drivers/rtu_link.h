#pragma once
// Modbus RTU over any link of bytes: requests, replies, deadlines, and replies that are late.

#include "engine/base/clock.h"
#include "engine/drivers/byte_link.h"
#include "engine/drivers/modbus_link.h"
#include "engine/protocols/serial_settings.h"

#include <memory>

namespace bask {

/// Keeps to the rules of QtModbusLink: a reply that may answer an earlier question is not used, and the line
/// is kept silent after a request without a fitting reply.
class RtuLink final : public ModbusLink {
public:
    /// `settings`: of the line, for the time that bytes take; replyTime_s as of QtModbusLink. `clock`
    /// outlives it.
    RtuLink(std::unique_ptr<ByteLink> line, const SerialSettings& settings, const Clock& clock,
            double replyTime_s = 0.3);
    ~RtuLink() override;

    /// A link that is open stays as it is.
    void open() override;
    void close() override;
    bool isOpen() const override;
    Message problem() const override;
    bool isFree() const override;
    /// Throws std::logic_error unless it is free.
    int send(const ModbusRequest& request) override;
    /// Once what is under way has had kOvertake_s beyond its bytes' time on the line.
    bool mayOvertake() const override;
    /// Throws std::logic_error unless it may.
    int overtake(const ModbusRequest& request) override;
    std::optional<ModbusReply> takeReply(int number) override;
    std::string name() const override;
    std::string portId() const override;
    static constexpr double kOvertake_s = 0.1; ///< most devices have begun to answer by then
    /// Replies that came and were not used.
    int discarded() const;

private:
    struct Line;
    std::unique_ptr<Line> m_line;
};

} // namespace bask
