#include "engine/drivers/modbus_pdu.h"

#include <cstddef>

namespace bask {
namespace {

constexpr int kWriteOne = 6;
constexpr std::size_t kEcho = 4; ///< bytes of a write that are sent back

void append(std::string& out, int word) {
    out += static_cast<char>(word >> 8);
    out += static_cast<char>(word & 0xff);
}

} // namespace

std::string modbusData(const ModbusRequest& request) {
    std::string out;
    append(out, request.address);
    if (request.function != kWriteOne)
        append(out, request.reads() ? request.count : static_cast<int>(request.values.size()));
    if (request.function != kWriteOne && !request.reads())
        out += static_cast<char>(2 * request.values.size());
    for (const std::uint16_t value : request.values)
        append(out, value);
    return out;
}

std::optional<std::vector<std::uint16_t>> modbusRegisters(std::string_view data,
                                                          const ModbusRequest& request) {
    std::vector<std::uint16_t> out;
    if (!request.reads())
        return data == modbusData(request).substr(0, kEcho) ? std::optional(out) : std::nullopt;
    const auto bytes = 2 * static_cast<std::size_t>(request.count);
    if (data.size() != 1 + bytes || static_cast<unsigned char>(data[0]) != bytes)
        return std::nullopt;
    const auto byte = [&](std::size_t k) {
        return static_cast<unsigned>(static_cast<unsigned char>(data[k]));
    };
    for (std::size_t i = 1; i < data.size(); i += 2)
        out.push_back(static_cast<std::uint16_t>(byte(i) << 8U | byte(i + 1)));
    return out;
}

bool isSameOnTheLine(const ModbusRequest& a, const ModbusRequest& b) {
    return a.unit == b.unit && a.function == b.function && modbusData(a) == modbusData(b);
}

} // namespace bask
