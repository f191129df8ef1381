#pragma once
// Modbus RTU over a serial port, by Qt's client, with what that leaves open: a deadline of its own, replies
// that are too short or late, and a port that is unplugged.

#include "engine/base/clock.h"
#include "engine/drivers/modbus_link.h"
#include "engine/drivers/serial_port.h"
#include "engine/protocols/serial_settings.h"

#include <memory>
#include <string>

namespace bask {

/// Needs a thread with Qt's event loop, and is made and used there only.
///
/// A reply tells its unit and function but not what was asked, so one that comes late fits the next request.
/// After a request without a fitting reply the line is therefore kept silent for the time that a reply may
/// take, and longer while bytes still come. The next reply of that unit is used only if the same was asked
/// again; then the line is silent once more, for what else may be late.
class QtModbusLink final : public ModbusLink {
public:
    static constexpr double kReply_s = 0.3;

    /// `path` as of a serial link; replyTime_s is what the slowest device takes to begin its answer.
    QtModbusLink(std::string path, const SerialSettings& settings, const Clock& clock,
                 double replyTime_s = kReply_s, PortCheck check = PortCheck());
    ~QtModbusLink() override;

    /// A link that is open stays as it is.
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
    /// Replies that came and were not used.
    int discarded() const;

private:
    struct Line;
    std::unique_ptr<Line> m_line;
};

} // namespace bask
