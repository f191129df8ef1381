#pragma once
// What follows the function in a Modbus request and in its reply.

#include "engine/drivers/modbus_link.h"

#include <string>
#include <string_view>

namespace bask {

/// Returns what follows the function in a request.
std::string modbusData(const ModbusRequest& request);
/// Returns the registers in what follows a reply's function: none for a write; empty if it does not answer
/// the request.
std::optional<std::vector<std::uint16_t>> modbusRegisters(std::string_view data,
                                                          const ModbusRequest& request);
bool isSameOnTheLine(const ModbusRequest& a, const ModbusRequest& b);

} // namespace bask
