#pragma once
// A ModbusLink for tests without a port: every request goes to the test, by hand's time.

#include "engine/base/clock.h"
#include "engine/base/message_code.h"
#include "engine/drivers/modbus_link.h"

#include <functional>
#include <map>
#include <stdexcept>

namespace bask::test {

/// An answer, or none: then the request is silent.
using ModbusAnswer = std::function<std::optional<ModbusReply>(const ModbusRequest&)>;

class ScriptedModbusLink final : public ModbusLink {
public:
    static constexpr double kSilent_s = 0.3;

    ScriptedModbusLink(const Clock& clock, ModbusAnswer answer)
        : m_clock(clock), m_answer(std::move(answer)) {}

    void open() override {
        ++opened;
        isUp = isPlugged;
        m_problem = isPlugged ? Message{} : Message{MessageCode::LinkNotOpened, {name(), "no port"}};
    }
    void close() override { isUp = false; }
    bool isOpen() const override { return isUp; }
    Message problem() const override { return m_problem; }
    bool isFree() const override { return isUp && m_clock.now_s() >= m_free_s; }
    int send(const ModbusRequest& request) override {
        if (!isFree())
            throw std::logic_error("sent while it was not free");
        sent.push_back(request);
        auto reply = m_answer(request);
        m_free_s = m_clock.now_s() + (reply ? reply_s : 2.0 * kSilent_s);
        const double at_s = m_clock.now_s() + (reply ? reply_s : kSilent_s);
        m_replies.emplace(++m_number, std::pair(at_s, reply.value_or(silent())));
        return m_number;
    }
    std::optional<ModbusReply> takeReply(int number) override {
        const auto it = m_replies.find(number);
        if (it == m_replies.end() || m_clock.now_s() < it->second.first)
            return std::nullopt;
        std::optional<ModbusReply> out(it->second.second);
        m_replies.erase(it);
        return out;
    }
    std::string name() const override { return "line"; }

    void unplug() {
        isPlugged = isUp = false;
        m_problem = {MessageCode::LinkLost, {name(), "unplugged"}};
        for (auto& [number, reply] : m_replies)
            reply = {m_clock.now_s(), silent()};
    }

    double reply_s = 0.02;
    bool isPlugged = true, isUp = false;
    int opened = 0;
    std::vector<ModbusRequest> sent;

private:
    ModbusReply silent() const { return Error(MessageCode::DeviceSilent, name(), {name(), "0.3"}); }

    const Clock& m_clock;
    ModbusAnswer m_answer;
    std::map<int, std::pair<double, ModbusReply>> m_replies;
    int m_number = 0;
    double m_free_s = 0.0;
    Message m_problem;
};

} // namespace bask::test
