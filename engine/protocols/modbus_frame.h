#pragma once
// Modbus RTU as a device at the line sees it: requests out of bytes, and replies.

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace bask {

/// As asked of a device: reading by function 3 or 4, writing by 6 or 16.
struct ModbusQuery {
    int unit = 0;
    int function = 0;
    int address = 0;
    int count = 0;                     ///< of registers
    std::vector<std::uint16_t> values; ///< to be written
    bool isKnown = true;               ///< false: another function, or counts that contradict each other
};

/// Of silence between two frames, in the time of bytes.
inline constexpr double kModbusGapBytes = 3.5;

/// CRC-16 of the Modbus serial line specification; sent low byte first.
std::uint16_t modbusCrc(std::string_view bytes);

/// Unit, function and data with their CRC.
std::string modbusFrame(int unit, std::string_view functionAndData);

/// A request for `count` registers, or with `values` to write them; with its CRC.
std::string modbusRequest(const ModbusQuery& query);

/// Takes the first whole request out of the bytes, skipping what is none. Empty: none is complete yet.
std::optional<ModbusQuery> takeModbusQuery(std::string& bytes);

/// Frames that answer.
std::string modbusReadReply(int unit, int function, const std::vector<std::uint16_t>& values);
std::string modbusWriteReply(const ModbusQuery& query);
std::string modbusException(int unit, int function, int exception);

} // namespace bask
