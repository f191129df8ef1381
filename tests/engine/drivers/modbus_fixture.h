#pragma once
// Modbus drivers on the simulated line, by hand's time.

#include "engine/device_simulators/modbus_simulator.h"
#include "tests/support/modbus_client.h"
#include "tests/support/scripted_modbus_link.h"
#include "tests/support/shipped_profile.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace bask::test {

class ModbusDriverTest : public testing::Test {
protected:
    /// Every 5 ms for so long, as the engine does.
    template <class Driver> void run(Driver& driver, double s) {
        const double end_s = clock.now_s() + s;
        while (clock.now_s() < end_s - 1e-9) {
            clock.advance(0.005);
            sim.transmit(clock.now_s());
            driver.work();
        }
    }
    int sentBy(int function) const {
        return static_cast<int>(
            std::count_if(link.sent.begin(), link.sent.end(),
                          [&](const ModbusRequest& r) { return r.function == function; }));
    }

    ManualClock clock;
    ModbusSimulator sim;
    /// In the test's way of the simulator, if set.
    ModbusAnswer before;
    ScriptedModbusLink link{clock, [this](const ModbusRequest& request) -> std::optional<ModbusReply> {
                                if (before) {
                                    if (auto reply = before(request))
                                        return reply;
                                }
                                return fromSimulator(request);
                            }};

private:
    std::optional<ModbusReply> fromSimulator(const ModbusRequest& request) {
        const double now_s = clock.now_s();
        sim.receive(requestBytes(request), now_s);
        const std::string bytes = sim.transmit(now_s + ModbusSimulator::kReplyTime_s);
        if (bytes.empty())
            return std::nullopt;
        const auto registers = replyRegisters(bytes, request.unit, request.function);
        if (!registers.empty() && registers[0] >= 0xE001 && registers[0] <= 0xE010)
            return Error(MessageCode::DeviceException, "line",
                         {"line", std::to_string(request.unit), std::to_string(registers[0] - 0xE000)});
        return ModbusReply(registers);
    }
};

} // namespace bask::test
