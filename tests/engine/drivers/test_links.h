#pragma once
// Links for tests of drivers: one that a test answers by hand, one that ends at a simulated device.

#include "engine/base/clock.h"
#include "engine/base/message_code.h"
#include "engine/device_simulators/byte_device.h"
#include "engine/drivers/byte_link.h"

#include <deque>
#include <string>
#include <utility>

namespace bask::test {

/// What both have in common: a plug, and a record of what was written.
class PluggedLink : public ByteLink {
public:
    explicit PluggedLink(std::string name = "port") : m_name(std::move(name)) {}
    void open() override {
        ++m_opened;
        m_isOpen = m_isPlugged;
        m_problem = m_isPlugged ? Message{} : Message{MessageCode::LinkNotOpened, {name(), "no such port"}};
    }
    void close() override { m_isOpen = false; }
    bool isOpen() const override { return m_isOpen; }
    Message problem() const override { return m_problem; }
    std::string name() const override { return m_name; }

    void unplug() {
        m_isPlugged = false;
        if (std::exchange(m_isOpen, false))
            m_problem = {MessageCode::LinkLost, {name(), "unplugged"}};
    }
    void plug() { m_isPlugged = true; }
    int opened() const { return m_opened; }
    std::string takeSent() { return std::exchange(m_sent, {}); }

protected:
    bool m_isPlugged = true, m_isOpen = false;
    Message m_problem;
    int m_opened = 0;
    std::string m_sent;

private:
    std::string m_name;
};

class ScriptedLink final : public PluggedLink {
public:
    using PluggedLink::PluggedLink;
    void open() override {
        PluggedLink::open();
        m_unread.clear();
    }
    std::string read() override { return std::exchange(m_unread, {}); }
    void write(std::string_view bytes) override { m_sent += bytes; }
    void say(std::string_view bytes) { m_unread += bytes; }
    double emptyAt_s() const override { return m_emptyAt_s; }
    void setEmptyAt(double time_s) { m_emptyAt_s = time_s; }

private:
    std::string m_unread;
    double m_emptyAt_s = std::numeric_limits<double>::infinity();
};

/// Bytes take `delay_s` each way.
class DeviceLink final : public PluggedLink {
public:
    DeviceLink(ByteDevice& device, const Clock& clock) : m_device(device), m_clock(clock) {}
    void open() override {
        PluggedLink::open();
        work();
        m_back.clear();
    }
    std::string read() override {
        work();
        std::string out;
        for (; !m_back.empty() && m_back.front().first <= m_clock.now_s(); m_back.pop_front())
            out += m_back.front().second;
        return isOpen() ? out : std::string();
    }
    void write(std::string_view bytes) override {
        if (!isOpen())
            return;
        m_sent += bytes;
        m_there.emplace_back(m_clock.now_s() + m_delay_s, bytes);
        work();
    }
    /// Lets the device live while nobody reads.
    void work() {
        for (; !m_there.empty() && m_there.front().first <= m_clock.now_s(); m_there.pop_front()) {
            keep(m_device.transmit(m_there.front().first));
            m_device.receive(m_there.front().second, m_there.front().first);
        }
        keep(m_device.transmit(m_clock.now_s()));
    }
    /// Bytes that are not the device's.
    void inject(std::string bytes) { keep(std::move(bytes)); }
    void setDelay(double delay_s) { m_delay_s = delay_s; }

private:
    void keep(std::string bytes) {
        if (!bytes.empty() && isOpen())
            m_back.emplace_back(m_clock.now_s() + m_delay_s, std::move(bytes));
    }

    ByteDevice& m_device;
    const Clock& m_clock;
    double m_delay_s = 0.0;
    std::deque<std::pair<double, std::string>> m_there, m_back;
};

} // namespace bask::test
