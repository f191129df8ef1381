#pragma once
// What the registers of a Modbus device mean: thermometers and temperature controllers as data, so that
// another one is a file.

#include "engine/base/result.h"

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace bask {

enum class RegisterType { Int16, Uint16, Int32, Uint32, Float32 };

/// What a register's number is a measure of.
enum class RegisterUnit { Celsius, Fahrenheit, Kelvin, Ohm, Milliampere, None };

/// One quantity in a device.
struct RegisterSpec {
    int function = 3; ///< 3 holding, 4 input
    int address = 0;  ///< counted from 0
    RegisterType type = RegisterType::Int16;
    bool isLowWordFirst = false;
    double scale = 1.0; ///< value = scale * number + offset
    double offset = 0.0;
    RegisterUnit unit = RegisterUnit::Celsius;
    /// Numbers (before scale) that are no value: open, short ...; what they stand for.
    std::map<double, std::string> faults = {};
    bool operator==(const RegisterSpec&) const = default;
};

/// Bits of one register that say which sensor is at fault.
struct StatusSpec {
    int function = 3;
    int address = 0;
    int firstBit = 0; ///< of channel 0; channel i has firstBit + i * bitStep
    int bitStep = 1;
    bool isFaultWhenSet = true;
    std::string fault = "open"; ///< open, short, out_of_range, other
    bool operator==(const StatusSpec&) const = default;
};

/// Registers that hold what no other device holds: a serial number, a name, a type.
struct IdentitySpec {
    int function = 3;
    int address = 0;
    int count = 1;
    bool operator==(const IdentitySpec&) const = default;
};

/// Highest set point that can stand for heat off.
inline constexpr double kHighestOff_degC = 40.0;

/// A thermometer module or a temperature controller.
struct ModbusProfile {
    std::string name;   ///< "eurotherm-2400"
    std::string title;  ///< maker and device, for people
    std::string source; ///< the manual it was read in
    std::optional<IdentitySpec> identity;
    // Thermometer
    std::optional<RegisterSpec> channel; ///< of channel 0
    int channels = 0;
    int channelStep = 1;            ///< registers from one channel to the next
    std::vector<StatusSpec> status; ///< of a controller too: channel 0 is its process value
    /// Milliamperes 4..20 stand for these, degC.
    double at4mA_degC = 0.0, at20mA_degC = 100.0;
    // Controller
    std::optional<RegisterSpec> processValue;
    std::optional<RegisterSpec> setPoint;        ///< towards which it heats
    std::optional<RegisterSpec> setPointWritten; ///< as written, and read back; empty: the same
    std::optional<RegisterSpec> run;             ///< heat on and off
    double runOn = 1.0, runOff = 0.0;
    /// Without `run`, the set point that stands for heat off.
    double setPointOff_degC = 0.0;
    std::optional<RegisterSpec> watchdog; ///< time without a poll after which it goes off
    double watchdogUnit_s = 0.001;
    std::optional<RegisterSpec> sensorFault; ///< not 0: its own sensor is broken
    /// Where it tells in which unit its registers count, and what it holds then.
    std::optional<RegisterSpec> temperatureUnit;
    double unitCelsius = 0.0, unitFahrenheit = 1.0;

    bool operator==(const ModbusProfile&) const = default;
};

/// A controller's, with its temperatures in degrees Celsius or Fahrenheit.
ModbusProfile inUnit(ModbusProfile profile, RegisterUnit unit);

/// `where` names it in errors. Refuses unknown keys, wrong types, what no device has, and what its registers
/// cannot hold.
Result<ModbusProfile> modbusProfileFromJson(const std::string& text, const std::string& where);
std::string modbusProfileToJson(const ModbusProfile& profile);

/// Those that come with Bask, by name.
const std::vector<ModbusProfile>& shippedProfiles();

} // namespace bask
