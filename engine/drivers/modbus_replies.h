#pragma once
// Replies to Modbus requests until they are taken.

#include "engine/drivers/modbus_link.h"

#include <cstddef>
#include <map>
#include <optional>
#include <utility>

namespace bask {

class ModbusReplies {
public:
    static constexpr std::size_t kMax = 16; ///< limit of replies that nobody has taken; the oldest go first

    void deliver(int number, ModbusReply reply) {
        m_replies.emplace(number, std::move(reply));
        if (m_replies.size() > kMax)
            m_replies.erase(m_replies.begin());
    }
    /// Returns the reply to that request, once; empty until it arrives.
    std::optional<ModbusReply> take(int number) {
        auto taken = m_replies.extract(number);
        return taken ? std::optional(std::move(taken.mapped())) : std::nullopt;
    }

private:
    std::map<int, ModbusReply> m_replies; ///< by the request's number
};

} // namespace bask
