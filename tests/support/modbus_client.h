#pragma once
// A Modbus client for tests, written apart from the engine's: requests as bytes, and what replies say.

#include "engine/drivers/modbus_link.h"
#include "engine/protocols/modbus_frame.h"

#include <string>

namespace bask::test {

inline std::string wordBytes(int word) {
    return {static_cast<char>(word >> 8), static_cast<char>(word & 0xff)};
}

inline std::string requestBytes(const ModbusRequest& r) {
    std::string pdu = static_cast<char>(r.function) + wordBytes(r.address);
    if (r.function == 6)
        pdu += wordBytes(r.values.at(0));
    else
        pdu += wordBytes(r.count);
    if (r.function == 16) {
        pdu += static_cast<char>(2 * r.values.size());
        for (const std::uint16_t value : r.values)
            pdu += wordBytes(value);
    }
    return modbusFrame(r.unit, pdu);
}

/// Registers of a reply that reads; an exception's code as {0xE000 + code}; {0xFFFF, 0xFFFF} for what is
/// none.
inline std::vector<std::uint16_t> replyRegisters(const std::string& bytes, int unit, int function) {
    const auto at = [&](std::size_t i) { return static_cast<unsigned char>(bytes[i]); };
    if (bytes.size() < 5 || at(0) != unit || modbusFrame(unit, bytes.substr(1, bytes.size() - 3)) != bytes)
        return {0xFFFF, 0xFFFF};
    if (at(1) == (function | 0x80))
        return {static_cast<std::uint16_t>(0xE000 + at(2))};
    std::vector<std::uint16_t> out;
    if (at(1) == function && function <= 4) {
        for (std::size_t i = 3; i + 3 < bytes.size(); i += 2)
            out.push_back(static_cast<std::uint16_t>(at(i) << 8 | at(i + 1)));
    }
    return out;
}

} // namespace bask::test
