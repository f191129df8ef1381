#pragma once
// Modbus RTU over any link of bytes: requests, replies, deadlines, and replies that are late.

#include "engine/base/clock.h"
#include "engine/drivers/byte_link.h"
#include "engine/drivers/modbus_link.h"
#include "engine/protocols/serial_settings.h"

#include <memory>

namespace bask {

/// A reply contains its unit and function but not the request, so a late reply also fits the next request.
/// Therefore the line stays silent after a request without a valid reply for the time that a reply may take,
/// and longer while bytes still arrive. The next reply of that unit is used only if the same request was
/// repeated; then the line is silent once more, because another reply may be late.
class RtuLink final : public ModbusLink {
public:
    /// `settings` are those of the line, for the time that bytes take; replyTime_s is the time until the
    /// slowest device starts its answer. `clock` must outlive it.
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
