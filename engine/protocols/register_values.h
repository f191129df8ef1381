#pragma once
// Registers of a Modbus device as temperatures and numbers, or as the fault of a sensor, and back.

#include "engine/protocols/modbus_profile.h"

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace bask {

/// A temperature, or why there is none.
struct RegisterValue {
    double value_K = 0.0;
    std::string fault; ///< open, short, out_of_range, other; empty: there is a value
    bool operator==(const RegisterValue&) const = default;
};

/// Of 16 bits that one number takes.
int registerCount(RegisterType type);

/// The number in the registers times scale plus offset, in the spec's own unit.
double quantityFromRegisters(const RegisterSpec& spec, std::span<const std::uint16_t> registers);

/// Back; rounded to what the type holds. Refuses what it cannot hold (ValueOutOfRange).
Result<std::vector<std::uint16_t>> registersFromQuantity(const RegisterSpec& spec, double quantity);

/// The profile's fault numbers, the ends of an integer type (a sensor that is open, shorted or beyond the
/// range in most modules), NAMUR NE 43 for currents (valid 3.8..20.5 mA), IEC 60751 for ohms, and what no
/// thermometer reads are faults.
RegisterValue temperatureFromRegisters(const ModbusProfile& profile, const RegisterSpec& spec,
                                       std::span<const std::uint16_t> registers);

/// What a device with that profile would hold.
Result<std::vector<std::uint16_t>> registersFromTemperature(const ModbusProfile& profile,
                                                            const RegisterSpec& spec, double t_K);

/// The profile's watchdog set to time_s, within a tenth. Errors: ValueOutOfRange.
Result<std::vector<std::uint16_t>> watchdogRegisters(const ModbusProfile& profile, double time_s);

/// What tells a device from others, as its identity's registers hold it: "0012 34ab".
std::string signatureFromRegisters(std::span<const std::uint16_t> registers);

/// Difference of temperature that one step of the register makes; for a set point read back.
double resolution_K(const RegisterSpec& spec);

/// Whether the status register says that a channel's sensor is at fault.
bool isAtFault(const StatusSpec& status, int channel, std::uint16_t value);

/// Fault words that profiles know.
const std::vector<std::string>& sensorFaultWords();

} // namespace bask
