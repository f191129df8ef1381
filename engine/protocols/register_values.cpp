#include "engine/protocols/register_values.h"

#include "engine/base/message_code.h"
#include "engine/base/units.h"
#include "engine/protocols/pt100.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>

namespace bask {
namespace {

const char* const kOpen = "open";
const char* const kShort = "short";
const char* const kOutOfRange = "out_of_range";
const char* const kOther = "other";

// NAMUR NE 43, mA.
constexpr double kNoCurrent = 1.0, kFaultBelow = 3.6, kValidFrom = 3.8, kValidTo = 20.5, kFaultAbove = 21.0;
constexpr double kWatchdogWithin = 0.1;                  // of its time; a register may count minutes
constexpr double kMin_degC = -200.0, kMax_degC = 1800.0; // no thermometer of a rig reads beyond

std::uint32_t longWord(const RegisterSpec& spec, std::span<const std::uint16_t> r) {
    const std::uint32_t high = spec.isLowWordFirst ? r[1] : r[0];
    const std::uint32_t low = spec.isLowWordFirst ? r[0] : r[1];
    return high << 16U | low;
}

double number(const RegisterSpec& spec, std::span<const std::uint16_t> r) {
    if (static_cast<int>(r.size()) != registerCount(spec.type))
        throw std::invalid_argument("register values: registers of one number");
    switch (spec.type) {
    case RegisterType::Int16:
        return static_cast<std::int16_t>(r[0]);
    case RegisterType::Uint16:
        return r[0];
    case RegisterType::Int32:
        return static_cast<std::int32_t>(longWord(spec, r));
    case RegisterType::Uint32:
        return longWord(spec, r);
    case RegisterType::Float32:
        break;
    }
    return static_cast<double>(std::bit_cast<float>(longWord(spec, r)));
}

template <class T> std::pair<double, double> limitsOf() {
    return {std::numeric_limits<T>::lowest(), std::numeric_limits<T>::max()};
}

std::pair<double, double> limits(RegisterType type) {
    switch (type) {
    case RegisterType::Int16:
        return limitsOf<std::int16_t>();
    case RegisterType::Uint16:
        return limitsOf<std::uint16_t>();
    case RegisterType::Int32:
        return limitsOf<std::int32_t>();
    case RegisterType::Uint32:
        return limitsOf<std::uint32_t>();
    case RegisterType::Float32:
        break;
    }
    return limitsOf<float>();
}

bool isEndOfType(RegisterType type, double n) {
    const auto [min, max] = limits(type);
    return type == RegisterType::Float32 ? !std::isfinite(n)
                                         : n == max || (min < 0.0 && (n == min || n == -max));
}

RegisterValue atFault(const char* fault) {
    return {0.0, fault};
}

RegisterValue fromCelsius(double t_degC) {
    if (!(t_degC >= kMin_degC && t_degC <= kMax_degC))
        return atFault(kOutOfRange);
    return {kelvinFromCelsius(t_degC), {}};
}

RegisterValue fromMilliamperes(const ModbusProfile& profile, double mA) {
    if (mA < kNoCurrent)
        return atFault(kOpen);
    if (mA < kFaultBelow || mA > kFaultAbove)
        return atFault(kOther);
    if (mA < kValidFrom || mA > kValidTo)
        return atFault(kOutOfRange);
    return fromCelsius(profile.at4mA_degC + (mA - 4.0) / 16.0 * (profile.at20mA_degC - profile.at4mA_degC));
}

RegisterValue fromOhm(double ohm) {
    if (const auto t_degC = pt100Celsius(ohm))
        return fromCelsius(*t_degC);
    return atFault(ohm < 100.0 ? kShort : kOpen);
}

} // namespace

int registerCount(RegisterType type) {
    return type == RegisterType::Int16 || type == RegisterType::Uint16 ? 1 : 2;
}

double quantityFromRegisters(const RegisterSpec& spec, std::span<const std::uint16_t> registers) {
    return spec.scale * number(spec, registers) + spec.offset;
}

Result<std::vector<std::uint16_t>> registersFromQuantity(const RegisterSpec& spec, double quantity) {
    const auto [min, max] = limits(spec.type);
    const bool isFloat = spec.type == RegisterType::Float32;
    const double exact = (quantity - spec.offset) / spec.scale;
    const double n = isFloat ? exact : std::round(exact);
    if (!(n >= min && n <= max)) {
        const double a = spec.scale * min + spec.offset, b = spec.scale * max + spec.offset;
        return Error(
            MessageCode::ValueOutOfRange, "",
            {formatNumber(quantity), formatNumber(std::min(a, b)), formatNumber(std::max(a, b)), ""});
    }
    if (registerCount(spec.type) == 1)
        return std::vector{static_cast<std::uint16_t>(static_cast<std::int32_t>(n))};
    const std::uint32_t bits = isFloat ? std::bit_cast<std::uint32_t>(static_cast<float>(n))
                                       : static_cast<std::uint32_t>(static_cast<std::int64_t>(n));
    const auto high = static_cast<std::uint16_t>(bits >> 16U), low = static_cast<std::uint16_t>(bits);
    return spec.isLowWordFirst ? std::vector{low, high} : std::vector{high, low};
}

RegisterValue temperatureFromRegisters(const ModbusProfile& profile, const RegisterSpec& spec,
                                       std::span<const std::uint16_t> registers) {
    const double n = number(spec, registers);
    if (const auto it = spec.faults.find(n); it != spec.faults.end())
        return {0.0, it->second};
    if (isEndOfType(spec.type, n))
        return atFault(kOutOfRange);
    const double quantity = spec.scale * n + spec.offset;
    switch (spec.unit) {
    case RegisterUnit::Celsius:
        return fromCelsius(quantity);
    case RegisterUnit::Fahrenheit:
        return fromCelsius((quantity - 32.0) / 1.8);
    case RegisterUnit::Kelvin:
        return fromCelsius(celsiusFromKelvin(quantity));
    case RegisterUnit::Ohm:
        return fromOhm(quantity);
    case RegisterUnit::Milliampere:
        return fromMilliamperes(profile, quantity);
    case RegisterUnit::None:
        break;
    }
    throw std::invalid_argument("register values: no temperature");
}

Result<std::vector<std::uint16_t>> registersFromTemperature(const ModbusProfile& profile,
                                                            const RegisterSpec& spec, double t_K) {
    const double t_degC = celsiusFromKelvin(t_K);
    switch (spec.unit) {
    case RegisterUnit::Celsius:
        return registersFromQuantity(spec, t_degC);
    case RegisterUnit::Fahrenheit:
        return registersFromQuantity(spec, t_degC * 1.8 + 32.0);
    case RegisterUnit::Kelvin:
        return registersFromQuantity(spec, t_K);
    case RegisterUnit::Ohm:
        return registersFromQuantity(spec, pt100Ohm(t_degC));
    case RegisterUnit::Milliampere:
        return registersFromQuantity(spec, 4.0 + 16.0 * (t_degC - profile.at4mA_degC) /
                                                     (profile.at20mA_degC - profile.at4mA_degC));
    case RegisterUnit::None:
        break;
    }
    throw std::invalid_argument("register values: no temperature");
}

Result<std::vector<std::uint16_t>> watchdogRegisters(const ModbusProfile& profile, double time_s) {
    const RegisterSpec& spec = profile.watchdog.value();
    auto registers = registersFromQuantity(spec, time_s / profile.watchdogUnit_s);
    if (registers && std::abs(quantityFromRegisters(spec, *registers) * profile.watchdogUnit_s - time_s) <=
                         kWatchdogWithin * time_s)
        return registers;
    const auto [a, b] = limits(spec.type);
    const double max_s =
        profile.watchdogUnit_s * std::max(spec.scale * a + spec.offset, spec.scale * b + spec.offset);
    const double step_s = profile.watchdogUnit_s * std::abs(spec.scale);
    return Error(MessageCode::ValueOutOfRange, "",
                 {formatNumber(time_s), formatNumber(step_s), formatNumber(max_s), "s"});
}

std::string signatureFromRegisters(std::span<const std::uint16_t> registers) {
    constexpr const char* kDigits = "0123456789abcdef";
    std::string out;
    for (const std::uint16_t word : registers) {
        if (!out.empty())
            out += ' ';
        for (int shift = 12; shift >= 0; shift -= 4)
            out += kDigits[word >> shift & 0xf];
    }
    return out;
}

double resolution_K(const RegisterSpec& spec) {
    const double step = spec.type == RegisterType::Float32 ? 0.001 : std::abs(spec.scale);
    return spec.unit == RegisterUnit::Fahrenheit ? step / 1.8 : step;
}

bool isAtFault(const StatusSpec& status, int channel, std::uint16_t value) {
    const int bit = status.firstBit + channel * status.bitStep;
    return ((value >> bit & 1) != 0) == status.isFaultWhenSet;
}

const std::vector<std::string>& sensorFaultWords() {
    static const std::vector<std::string> kWords{kOpen, kShort, kOutOfRange, kOther};
    return kWords;
}

} // namespace bask
