#pragma once
// Modbus RTU on the device's side: finds requests in bytes, and makes replies.

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace bask {

/// A request to a device: reading by function 3 or 4, writing by 6 or 16.
struct ModbusQuery {
    int unit = 0;
    int function = 0;
    int address = 0;
    int count = 0;                     ///< number of registers
    std::vector<std::uint16_t> values; ///< values to write
    bool isKnown = true;               ///< false: another function, or counts that contradict each other
};

/// Silence between two frames, as a number of bytes.
inline constexpr double kModbusGapBytes = 3.5;

/// CRC-16 of the Modbus serial line specification; sent low byte first.
std::uint16_t modbusCrc(std::string_view bytes);

/// Returns unit, function and data with their CRC.
std::string modbusFrame(int unit, std::string_view functionAndData);

/// Returns a request for `count` registers, or one that writes `values`; with its CRC.
std::string modbusRequest(const ModbusQuery& query);

/// Removes the first complete request from the bytes and skips what is not one. Empty if none is complete
/// yet.
std::optional<ModbusQuery> takeModbusQuery(std::string& bytes);

/// Return reply frames.
std::string modbusReadReply(int unit, int function, const std::vector<std::uint16_t>& values);
std::string modbusWriteReply(const ModbusQuery& query);
std::string modbusException(int unit, int function, int exception);

} // namespace bask
