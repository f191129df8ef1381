#pragma once
// Modbus RTU over a serial port with Qt's client, and what that lacks: a deadline, the treatment of replies
// that are too short or late, and of a port that is unplugged.

#include "engine/base/clock.h"
#include "engine/drivers/modbus_link.h"
#include "engine/drivers/serial_port.h"
#include "engine/protocols/serial_settings.h"

#include <memory>
#include <string>

namespace bask {

/// Needs a thread with Qt's event loop; make and use it only there.
///
/// A reply contains its unit and function but not the request, so a late reply also fits the next request.
/// Therefore the line stays silent after a request without a valid reply for the time that a reply may take,
/// and longer while bytes still arrive. The next reply of that unit is used only if the same request was
/// repeated; then the line is silent once more, because another reply may be late.
class QtModbusLink final : public ModbusLink {
public:
    static constexpr double kReply_s = 0.3;

    /// `path` as in a serial link; replyTime_s is the time until the slowest device starts its answer.
    QtModbusLink(std::string path, const SerialSettings& settings, const Clock& clock,
                 double replyTime_s = kReply_s, PortCheck check = PortCheck());
    ~QtModbusLink() override;

    /// No effect if the link is open.
    void open() override;
    void close() override;
    bool isOpen() const override;
    Message problem() const override;
    bool isFree() const override;
    /// Throws std::logic_error unless it is free.
    int send(const ModbusRequest& request) override;
    std::optional<ModbusReply> takeReply(int number) override;
    std::string name() const override;
    std::string portId() const override;
    /// Returns the number of replies that arrived and were not used.
    int discarded() const;

private:
    struct Line;
    std::unique_ptr<Line> m_line;
};

} // namespace bask
