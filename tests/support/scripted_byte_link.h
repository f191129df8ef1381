#pragma once
// Links without a port, for tests of drivers: one whose other end the test itself plays, and one to a
// simulated device.

#include "engine/base/clock.h"
#include "engine/base/message_code.h"
#include "engine/device_simulators/byte_device.h"
#include "engine/drivers/byte_link.h"

#include <utility>

namespace bask::test {

/// A cable that can be pulled.
class PluggedLink : public ByteLink {
public:
    void open() override {
        ++opens;
        m_isOpen = isPlugged;
        m_problem = isPlugged ? Message{} : Message{MessageCode::LinkNotOpened, {name(), "no such port"}};
    }
    void close() override { m_isOpen = false; }
    bool isOpen() const override { return m_isOpen; }
    Message problem() const override { return m_problem; }
    std::string name() const override { return "/dev/ttyTEST"; }

    void unplug() {
        isPlugged = m_isOpen = false;
        m_problem = {MessageCode::LinkLost, {name(), "unplugged"}};
    }

    bool isPlugged = true;
    int opens = 0;

private:
    bool m_isOpen = false;
    Message m_problem;
};

class ScriptedByteLink final : public PluggedLink {
public:
    std::string read() override { return std::exchange(toRead, {}); }
    void write(std::string_view bytes) override {
        if (isOpen())
            sent += bytes;
    }
    std::string takeSent() { return std::exchange(sent, {}); }

    std::string sent, toRead;
};

class DeviceLink final : public PluggedLink {
public:
    DeviceLink(ByteDevice& device, const Clock& clock) : m_device(device), m_clock(clock) {}

    std::string read() override {
        const std::string said = m_device.transmit(m_clock.now_s());
        return isOpen() ? said : std::string();
    }
    void write(std::string_view bytes) override {
        if (isOpen())
            m_device.receive(bytes, m_clock.now_s());
    }

private:
    ByteDevice& m_device;
    const Clock& m_clock;
};

} // namespace bask::test
