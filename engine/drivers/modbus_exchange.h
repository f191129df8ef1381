#pragma once
// A driver's part of the communication with one Modbus unit: opens the link repeatedly, sends one request at
// a time, and knows the state of the device.

#include "engine/base/clock.h"
#include "engine/devices/device.h"
#include "engine/drivers/modbus_link.h"
#include "engine/drivers/reply_rate.h"

#include <optional>

namespace bask {

class ModbusExchange {
public:
    /// A device is lost if no valid reply has arrived for silentAfter_s.
    ModbusExchange(ModbusLink& link, const Clock& clock, int unit, double silentAfter_s);

    void setSilentAfter(double silentAfter_s) { m_silentAfter_s = silentAfter_s; }
    /// Opens the link if it is due, and returns the reply to the last request when it has arrived. Call it
    /// first in each work() of a driver.
    std::optional<ModbusReply> work();
    /// False in the turn in which a reply arrived or the line became free after silence, so that other
    /// drivers of the line get their turn. A unit that was silent twice is asked once a second.
    bool canSend() const;
    /// Call it only if canSend(). Fills in the unit.
    void send(ModbusRequest request);
    /// Whether a request may be sent before all others on the line, including this unit's own; see
    /// ModbusLink.
    bool mayOvertake() const { return m_link.mayOvertake(); }
    void overtake(ModbusRequest request);

    DeviceStatus status() const;
    bool isLive() const;
    /// Returns why nothing can be read or set now.
    Error error() const;
    /// Returns when the request was sent that the newest reply answers, s: the reply may have waited.
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
    bool m_mustYield = false; ///< the line, when it becomes free
    int m_silent = 0;         ///< number of unanswered requests in a row
    double m_next_s = -1e300; ///< earliest time of the next request
    bool m_isBegun = false, m_wasLive = false;
    double m_opened_s = -1e300; ///< last attempt
    double m_begun_s = 0.0, m_sent_s = 0.0, m_answered_s = -1e300, m_replyTime_s = 0.0;
    ReplyRate m_rate;
    int m_discarded = 0;
    Message m_refusal; ///< refusal of the newest request; None: it was answered
};

} // namespace bask
