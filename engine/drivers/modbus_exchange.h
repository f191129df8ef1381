#pragma once
// A driver's half of the talk with one Modbus unit: the link opened again and again, one request at a time,
// and how the device is.

#include "engine/base/clock.h"
#include "engine/devices/device.h"
#include "engine/drivers/modbus_link.h"
#include "engine/drivers/reply_rate.h"

#include <optional>

namespace bask {

class ModbusExchange {
public:
    /// A device is lost when nothing fitting has come for silentAfter_s.
    ModbusExchange(ModbusLink& link, const Clock& clock, int unit, double silentAfter_s);

    void setSilentAfter(double silentAfter_s) { m_silentAfter_s = silentAfter_s; }
    /// Opens the link if it is due, and answers the reply to the last request when it is there. First of all
    /// in each work() of a driver.
    std::optional<ModbusReply> work();
    /// Not in the turn in which a reply came or the line is free after silence: other drivers of the line are
    /// to have theirs. A unit that was silent twice is asked once a second.
    bool canSend() const;
    /// Only then. The unit is put in.
    void send(ModbusRequest request);
    /// Before all others of the line, this unit's own included; see ModbusLink.
    bool mayOvertake() const { return m_link.mayOvertake(); }
    void overtake(ModbusRequest request);

    DeviceStatus status() const;
    bool isLive() const;
    /// Why nothing can be read or set now.
    Error error() const;
    /// When was sent what the newest reply answers, s: it may have waited to be taken.
    double asked_s() const { return m_sent_s; }
    std::string name() const { return m_link.name(); }

private:
    void note(const ModbusReply& reply);
    Message problem() const;
    Message silence() const;

    ModbusLink& m_link;
    const Clock& m_clock;
    int m_unit;
    double m_silentAfter_s;
    std::optional<int> m_asked;
    bool m_mayContinue = true;
    bool m_mustYield = false; ///< the line, once it is free
    int m_silent = 0;         ///< requests in a row
    double m_next_s = -1e300; ///< not before
    bool m_isBegun = false, m_wasLive = false;
    double m_opened_s = -1e300; ///< tried last
    double m_begun_s = 0.0, m_sent_s = 0.0, m_answered_s = -1e300, m_replyTime_s = 0.0;
    ReplyRate m_rate;
    int m_discarded = 0;
    Message m_refusal; ///< of the newest request; None: it was answered
};

} // namespace bask
