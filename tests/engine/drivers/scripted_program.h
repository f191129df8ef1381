#pragma once
// A program for tests without a process: it answers at once, by hand's time, and can be made to misbehave.

#include "engine/base/clock.h"
#include "engine/base/message_code.h"
#include "engine/drivers/byte_link.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <functional>
#include <stdexcept>
#include <string>
#include <vector>

namespace bask::test {

class ScriptedProgram final : public ByteLink {
public:
    using Json = nlohmann::json;

    explicit ScriptedProgram(const Clock& clock) : m_clock(&clock) {}

    double now_s() const { return m_clock->now_s(); }

    void open() override {
        ++opened;
        isUp = true;
        m_seq = 0;
        m_unread.clear();
    }
    void close() override {
        closed += isUp ? 1 : 0;
        isUp = false;
    }
    bool isOpen() const override { return isUp; }
    Message problem() const override {
        return hasDied ? Message{MessageCode::ProgramEnded, {name(), "exit code 1"}} : Message{};
    }
    std::string read() override { return std::exchange(m_unread, {}); }
    std::string name() const override { return "python3 device.py"; }
    void write(std::string_view bytes) override {
        const Json request = Json::parse(bytes);
        const std::string what = request["do"];
        asked.push_back(what);
        requests.push_back(request);
        if (isSilent)
            return;
        Json answer{{"id", request["id"]}};
        if (what == "hello")
            answer["hello"] = hello;
        else if (refusals.contains(what))
            answer["error"] = refusals[what];
        else if (what == "read")
            answer["state"] = state();
        else
            answer["ok"] = true;
        if (what != "hello" && what != "read" && !refusals.contains(what) && obey)
            obey(request);
        say(answer);
    }
    void say(Json line) {
        line["seq"] = ++m_seq + seqOff;
        line["time"] = now_s() * clockRate + clockOff_s;
        sayText(line.dump() + '\n');
    }
    void sayText(const std::string& text) { m_unread += text; }
    int count(const std::string& what) const {
        return static_cast<int>(std::count(asked.begin(), asked.end(), what));
    }
    const Json& last(const std::string& what) const {
        for (auto it = requests.rbegin(); it != requests.rend(); ++it)
            if ((*it)["do"] == what)
                return *it;
        throw std::out_of_range(what);
    }

    Json hello;
    std::function<Json()> state;
    std::function<void(const Json&)> obey;
    Json refusals = Json::object();
    std::vector<std::string> asked;
    std::vector<Json> requests;
    bool isUp = false, isSilent = false, hasDied = false;
    int opened = 0, closed = 0;
    std::int64_t seqOff = 0;
    double clockOff_s = 0.0, clockRate = 1.0;

private:
    const Clock* m_clock;
    std::int64_t m_seq = 0;
    std::string m_unread;
};

} // namespace bask::test
