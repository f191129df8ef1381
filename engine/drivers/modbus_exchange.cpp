#include "engine/drivers/modbus_exchange.h"

#include "engine/base/message_code.h"

#include <algorithm>

namespace bask {
namespace {

constexpr double kOpenAgain_s = 0.5;
constexpr double kAskAgain_s = 1.0; // each silence costs the other units of the line twice a reply's time
constexpr int kSilentOnce = 1;      // may be noise

} // namespace

ModbusExchange::ModbusExchange(ModbusLink& link, const Clock& clock, int unit, double silentAfter_s)
    : m_link(link), m_clock(clock), m_unit(unit), m_silentAfter_s(silentAfter_s), m_begun_s(clock.now_s()) {}

std::optional<ModbusReply> ModbusExchange::work() {
    const double now_s = m_clock.now_s();
    if (!m_isBegun)
        m_begun_s = now_s;
    m_isBegun = true;
    m_mayContinue = true;
    const bool isByHand = m_link.problem().code == MessageCode::LinkByHand; // free at once when it is over
    if (!m_link.isOpen() && (isByHand || now_s >= m_opened_s + kOpenAgain_s)) {
        m_opened_s = now_s;
        m_link.open();
        m_silent = 0;
        m_next_s = now_s;
    }
    if (m_mustYield && m_link.isFree())
        m_mayContinue = m_mustYield = false;
    if (!m_asked)
        return std::nullopt;
    std::optional<ModbusReply> reply = m_link.takeReply(*m_asked);
    if (!reply)
        return std::nullopt;
    m_asked.reset();
    m_mayContinue = false;
    note(*reply);
    return reply;
}

void ModbusExchange::note(const ModbusReply& reply) {
    if (!reply) {
        m_refusal = reply.error().message;
        m_mustYield = m_refusal.code == MessageCode::DeviceSilent;
        m_silent = m_mustYield ? m_silent + 1 : 0;
        m_next_s = m_silent > kSilentOnce ? m_clock.now_s() + kAskAgain_s : m_clock.now_s();
        m_discarded += m_refusal.code == MessageCode::DeviceAnswersWrong ? 1 : 0;
        return;
    }
    m_refusal = {};
    m_silent = 0;
    m_wasLive = true;
    m_answered_s = m_clock.now_s();
    m_replyTime_s = m_answered_s - m_sent_s;
    m_rate.answered(m_answered_s);
}

bool ModbusExchange::canSend() const {
    return m_mayContinue && !m_asked && m_clock.now_s() >= m_next_s && m_link.isFree();
}

void ModbusExchange::send(ModbusRequest request) {
    request.unit = m_unit;
    m_sent_s = m_clock.now_s();
    m_asked = m_link.send(request);
}

void ModbusExchange::overtake(ModbusRequest request) {
    request.unit = m_unit;
    m_sent_s = m_clock.now_s();
    m_asked = m_link.overtake(request);
}

bool ModbusExchange::isLive() const {
    return m_link.isOpen() && m_clock.now_s() - m_answered_s <= m_silentAfter_s;
}

Message ModbusExchange::problem() const {
    if (!m_link.isOpen() && m_link.problem() != Message{})
        return m_link.problem();
    if (m_refusal != Message{} && m_refusal.code != MessageCode::DeviceSilent)
        return m_refusal;
    const bool isLate = m_clock.now_s() - std::max(m_answered_s, m_begun_s) > m_silentAfter_s;
    return isLate ? silence() : Message{};
}

Message ModbusExchange::silence() const {
    const double silence_s = m_clock.now_s() - std::max(m_answered_s, m_begun_s);
    return {MessageCode::DeviceSilent, {m_link.name(), formatNumber(silence_s, 2)}};
}

Error ModbusExchange::error() const {
    const Message known = problem();
    const Message message = known == Message{} ? silence() : known;
    return {message.code, "", message.args};
}

DeviceStatus ModbusExchange::status() const {
    DeviceStatus out;
    if (!m_isBegun)
        return out;
    out.lastReply_s = m_answered_s;
    out.replyTime_s = m_replyTime_s;
    out.discarded = m_discarded;
    if (isLive()) {
        out.link = LinkState::Live;
        out.rate_Hz = m_rate.rate_Hz();
    } else {
        out.link = m_wasLive ? LinkState::Lost : LinkState::Opening;
        out.problem = problem();
    }
    return out;
}

} // namespace bask
