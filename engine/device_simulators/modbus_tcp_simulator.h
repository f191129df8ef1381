#pragma once
// Simulated Modbus units behind a TCP port: the frames of Modbus TCP around those of a serial line.

#include "engine/device_simulators/modbus_simulator.h"

#include <cstddef>
#include <deque>

namespace bask {

class ModbusTcpSimulator final : public ByteDevice {
public:
    /// `units` must outlive it. Their faults, and "wrong-id": replies to another request.
    explicit ModbusTcpSimulator(ModbusSimulator& units) : m_units(units) {}

    void opened(double now_s) override;
    void receive(std::string_view bytes, double now_s) override;
    std::string transmit(double now_s) override;
    std::vector<std::string> faults() const override;
    Result<void> setFault(const std::string& name) override;
    /// Returns the functions of all requests so far.
    const std::vector<int>& functions() const { return m_functions; }

private:
    std::string wrapped(const std::string& frame);

    ModbusSimulator& m_units;
    std::string m_partial;
    /// A request that is not answered yet, and the length of its reply on the line.
    struct Open {
        int id, unit;
        std::size_t length;
    };
    std::deque<Open> m_open;
    std::vector<int> m_functions;
    bool m_isIdWrong = false, m_isSilent = false;
};

} // namespace bask
