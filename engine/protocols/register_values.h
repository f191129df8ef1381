#pragma once
// Converts registers of a Modbus device to temperatures and numbers, or to the fault of a sensor, and back.

#include "engine/protocols/modbus_profile.h"

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace bask {

/// A temperature, or the reason why there is none.
struct RegisterValue {
    double value_K = 0.0;
    std::string fault; ///< open, short, out_of_range, other; empty if there is a value
    bool operator==(const RegisterValue&) const = default;
};

/// Returns the number of 16-bit registers of one number.
int registerCount(RegisterType type);

/// Returns the number in the registers times scale plus offset, in the spec's own unit.
double quantityFromRegisters(const RegisterSpec& spec, std::span<const std::uint16_t> registers);

/// The reverse, rounded to the precision of the type. Refuses values outside its range (ValueOutOfRange).
Result<std::vector<std::uint16_t>> registersFromQuantity(const RegisterSpec& spec, double quantity);

/// Converts registers to a temperature. The following are faults: the profile's fault numbers, the ends of an
/// integer type (in most modules a sensor that is open, shorted or beyond the range), currents invalid in
/// NAMUR NE 43 (valid 3.8..20.5 mA), resistances outside IEC 60751, and temperatures that no thermometer
/// reads.
RegisterValue temperatureFromRegisters(const ModbusProfile& profile, const RegisterSpec& spec,
                                       std::span<const std::uint16_t> registers);

/// Returns the registers that a device with that profile would have.
Result<std::vector<std::uint16_t>> registersFromTemperature(const ModbusProfile& profile,
                                                            const RegisterSpec& spec, double t_K);

/// Returns the registers that set the profile's watchdog to time_s, within a tenth. Errors: ValueOutOfRange.
Result<std::vector<std::uint16_t>> watchdogRegisters(const ModbusProfile& profile, double time_s);

/// Returns the signature of a device from its identity registers: "0012 34ab".
std::string signatureFromRegisters(std::span<const std::uint16_t> registers);

/// Returns the temperature difference of one step of the register, for comparing a set point that is read
/// back.
double resolution_K(const RegisterSpec& spec);

/// Returns whether the status register reports a fault of a channel's sensor.
bool isAtFault(const StatusSpec& status, int channel, std::uint16_t value);

/// Returns the fault words that profiles may use.
const std::vector<std::string>& sensorFaultWords();

} // namespace bask
