#pragma once
// The meaning of a Modbus device's registers: thermometers and temperature controllers as data, so that a new
// device needs only a file.

#include "engine/base/result.h"

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace bask {

enum class RegisterType { Int16, Uint16, Int32, Uint32, Float32 };

/// The quantity or unit of a register's number.
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
    /// Numbers (before scale) that are not a value, and the fault that they mean: open, short ...
    std::map<double, std::string> faults = {};
    bool operator==(const RegisterSpec&) const = default;
};

/// Bits of one register that report which sensor has a fault.
struct StatusSpec {
    int function = 3;
    int address = 0;
    int firstBit = 0; ///< bit of channel 0; channel i has firstBit + i * bitStep
    int bitStep = 1;
    bool isFaultWhenSet = true;
    std::string fault = "open"; ///< open, short, out_of_range, other
    bool operator==(const StatusSpec&) const = default;
};

/// Registers that distinguish a device from all others: a serial number, a name, a type.
struct IdentitySpec {
    int function = 3;
    int address = 0;
    int count = 1;
    bool operator==(const IdentitySpec&) const = default;
};

/// Highest set point that may be used to mean heat off.
inline constexpr double kHighestOff_degC = 40.0;

/// A thermometer module or a temperature controller.
struct ModbusProfile {
    std::string name;   ///< "eurotherm-2400"
    std::string title;  ///< maker and device, for people
    std::string source; ///< the manual that it is based on
    std::optional<IdentitySpec> identity;
    /// The register that reports the kind of device, and its values for the devices of this profile.
    std::optional<RegisterSpec> deviceType;
    std::vector<double> deviceTypes;
    // Thermometer
    std::optional<RegisterSpec> channel; ///< register of channel 0
    int channels = 0;
    int channelStep = 1; ///< registers from one channel to the next
    /// Whether each channel needs a request of its own, because the device refuses those that contain a
    /// channel that is not set up.
    bool isOneByOne = false;
    std::vector<StatusSpec> status; ///< for a controller too: channel 0 is its process value
    /// Temperatures at 4 mA and 20 mA, degC.
    double at4mA_degC = 0.0, at20mA_degC = 100.0;
    // Controller
    std::optional<RegisterSpec> processValue;
    std::optional<RegisterSpec> setPoint; ///< the set point towards which it heats
    /// Register in which it is written and read back; empty: the same.
    std::optional<RegisterSpec> setPointWritten;
    std::optional<RegisterSpec> run; ///< heat on and off
    double runOn = 1.0, runOff = 0.0;
    /// Set point that means heat off, if there is no `run`.
    double setPointOff_degC = 0.0;
    std::optional<RegisterSpec> watchdog; ///< time without a poll after which the heat goes off
    double watchdogUnit_s = 0.001;
    std::optional<RegisterSpec> sensorFault; ///< not 0 if its own sensor is broken
    /// The register that reports the unit of its temperatures, and its values.
    std::optional<RegisterSpec> temperatureUnit;
    double unitCelsius = 0.0, unitFahrenheit = 1.0;

    bool operator==(const ModbusProfile&) const = default;
};

/// Returns a controller's profile with its temperatures in degrees Celsius or Fahrenheit.
ModbusProfile inUnit(ModbusProfile profile, RegisterUnit unit);

/// Parses a profile; `where` names it in errors. Refuses unknown keys, wrong types, impossible values, and
/// values that its registers cannot store.
Result<ModbusProfile> modbusProfileFromJson(const std::string& text, const std::string& where);
std::string modbusProfileToJson(const ModbusProfile& profile);

/// Returns the profiles that are part of Bask, by name.
const std::vector<ModbusProfile>& shippedProfiles();

} // namespace bask
