#pragma once
// Frames of Modbus: requests and replies on a serial line (RTU) as a device needs them, and those of Modbus
// TCP.

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

/// Port of Modbus TCP if an address has none.
inline constexpr int kModbusTcpPort = 502;

/// A frame of Modbus TCP: the number of the request that it is or answers, and unit, function and data.
struct ModbusTcpFrame {
    int transaction = 0;
    std::string unitAndPdu;
};

/// Returns unit, function and data, which have no CRC, with the header of Modbus TCP.
std::string modbusTcpFrame(int transaction, std::string_view unitAndPdu);

/// Removes the first complete frame of Modbus TCP from the view. Empty if none is complete yet, or
/// isModbusTcpBroken().
std::optional<ModbusTcpFrame> takeModbusTcpFrame(std::string_view& bytes);

/// Returns whether the bytes do not begin with a frame of Modbus TCP. Where the next one begins is then
/// unknown.
bool isModbusTcpBroken(std::string_view bytes);

} // namespace bask
