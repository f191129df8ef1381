#include "engine/protocols/modbus_profile.h"

#include "engine/base/json_fields.h"
#include "engine/base/message_code.h"
#include "engine/base/plain_text.h"
#include "engine/base/units.h"
#include "engine/protocols/register_ranges.h"
#include "engine/protocols/register_values.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <stdexcept>

namespace bask {

/// The files in profiles/, put into the program by CMake: names and texts.
std::vector<std::pair<std::string, std::string>> shippedProfileTexts();

namespace {

using nlohmann::json;
using nlohmann::ordered_json;

constexpr int kMaxAddress = 65535;
constexpr double kLowestOff_degC = -200.0;

const std::map<std::string, RegisterType> kTypes{{"int16", RegisterType::Int16},
                                                 {"uint16", RegisterType::Uint16},
                                                 {"int32", RegisterType::Int32},
                                                 {"uint32", RegisterType::Uint32},
                                                 {"float32", RegisterType::Float32}};
const std::map<std::string, RegisterUnit> kUnits{
    {"degC", RegisterUnit::Celsius}, {"degF", RegisterUnit::Fahrenheit}, {"K", RegisterUnit::Kelvin},
    {"ohm", RegisterUnit::Ohm},      {"mA", RegisterUnit::Milliampere},  {"none", RegisterUnit::None}};

template <class T> std::string wordOf(const std::map<std::string, T>& table, T value) {
    for (const auto& [word, meant] : table) {
        if (meant == value)
            return word;
    }
    throw std::invalid_argument("modbus profile: a value without a word");
}

std::string joined(const auto& words) {
    std::string out;
    for (const std::string& word : words)
        out += (out.empty() ? "" : ", ") + word;
    return out;
}

/// What is out of range is not taken: sums over it could overflow.
void readWhole(Fields& fields, const std::string& key, int& out, int min, int max) {
    int value = out;
    fields.read(key, value);
    if (value >= min && value <= max)
        out = value;
    else if (fields.find(key) != nullptr)
        fields.fail(MessageCode::ValueOutOfRange, fields.pathOf(key),
                    {std::to_string(value), std::to_string(min), std::to_string(max), ""});
}

void checkFaultWord(const Fields& fields, const std::string& word, const std::string& where) {
    const auto& known = sensorFaultWords();
    if (std::find(known.begin(), known.end(), word) == known.end())
        fields.fail(MessageCode::ValueUnknown, where, {plainWords(word), joined(known)});
}

void readFaults(const json& j, const std::string& path, Failure& failure,
                std::map<double, std::string>& out) {
    Fields fields(j, path, failure);
    for (const auto& item : j.items()) {
        if (failure)
            return;
        const std::string& key = item.key();
        double number = 0.0;
        const char* end = key.data() + key.size();
        const auto [stop, error] = std::from_chars(key.data(), end, number);
        if (error != std::errc() || stop != end)
            fields.fail(MessageCode::JsonWrongType, fields.pathOf(plainWords(key)), {"a number", "text"});
        fields.read(key, out[number]);
        checkFaultWord(fields, out[number], fields.pathOf(key));
    }
}

enum class Use { Sensor, Temperature, WrittenTemperature, Number, WrittenNumber };

const char* unitsFor(Use use) {
    return use == Use::Sensor                                          ? "K, degC, degF, mA, ohm"
           : use == Use::Temperature || use == Use::WrittenTemperature ? "K, degC, degF"
                                                                       : "none";
}

bool isUnitFor(Use use, RegisterUnit unit) {
    const bool isElectrical = unit == RegisterUnit::Milliampere || unit == RegisterUnit::Ohm;
    if (use == Use::Number || use == Use::WrittenNumber)
        return unit == RegisterUnit::None;
    return unit != RegisterUnit::None && (use == Use::Sensor || !isElectrical);
}

RegisterSpec readRegister(const json& j, const std::string& path, Failure& failure, Use use) {
    RegisterSpec out;
    const bool isWritten = use == Use::WrittenTemperature || use == Use::WrittenNumber;
    if (use == Use::Number || use == Use::WrittenNumber)
        out.unit = RegisterUnit::None;
    Fields fields(j, path, failure);
    fields.find("address", true);
    readWhole(fields, "function", out.function, 3, isWritten ? 3 : 4);
    readWhole(fields, "address", out.address, 0, kMaxAddress);
    fields.readWord("type", kTypes, out.type);
    fields.read("low_word_first", out.isLowWordFirst);
    fields.read("scale", out.scale);
    fields.read("offset", out.offset);
    fields.readWord("unit", kUnits, out.unit);
    readPart(fields, "faults", false, [&](const json& faults, const std::string& where) {
        readFaults(faults, where, failure, out.faults);
    });
    fields.close();
    if (out.scale == 0.0)
        fields.fail(MessageCode::ValueUnknown, path + ".scale", {"0", "any other number"});
    if (out.address + registerCount(out.type) - 1 > kMaxAddress)
        fields.fail(MessageCode::ValueOutOfRange, path + ".address",
                    {std::to_string(out.address), "0", std::to_string(kMaxAddress - 1), ""});
    if (!isUnitFor(use, out.unit))
        fields.fail(MessageCode::ValueUnknown, path + ".unit", {wordOf(kUnits, out.unit), unitsFor(use)});
    return out;
}

void readRegister(Fields& parent, const std::string& key, Use use, std::optional<RegisterSpec>& out) {
    readPart(parent, key, false, [&](const json& j, const std::string& path) {
        out = readRegister(j, path, parent.failure(), use);
    });
}

StatusSpec readStatus(const json& j, const std::string& path, Failure& failure, int channels) {
    StatusSpec out;
    Fields fields(j, path, failure);
    fields.find("address", true);
    readWhole(fields, "function", out.function, 3, 4);
    readWhole(fields, "address", out.address, 0, kMaxAddress);
    readWhole(fields, "first_bit", out.firstBit, 0, 15);
    readWhole(fields, "bit_step", out.bitStep, -15, 15);
    fields.read("fault_when_set", out.isFaultWhenSet);
    fields.read("fault", out.fault);
    fields.close();
    checkFaultWord(fields, out.fault, path + ".fault");
    const int last = out.firstBit + (channels - 1) * out.bitStep;
    if (last < 0 || last > 15)
        fields.fail(MessageCode::ValueOutOfRange, path + ".first_bit", {std::to_string(last), "0", "15", ""});
    return out;
}

void readThermometer(Fields& fields, ModbusProfile& profile) {
    fields.find("channels", true);
    readRegister(fields, "channel", Use::Sensor, profile.channel);
    readWhole(fields, "channels", profile.channels, 1, kMaxRegisters);
    if (fields.failure())
        return;
    const int size = registerCount(profile.channel->type);
    readWhole(fields, "channel_step", profile.channelStep, size, kMaxRegisters);
    fields.read("one_by_one", profile.isOneByOne);
    fields.read("at_4mA_degC", profile.at4mA_degC);
    fields.read("at_20mA_degC", profile.at20mA_degC);
    const int span = (profile.channels - 1) * profile.channelStep + size;
    if (profile.channelStep < size || (span > kMaxRegisters && !profile.isOneByOne) ||
        profile.channel->address + span - 1 > kMaxAddress)
        fields.fail(
            MessageCode::ValueOutOfRange, "channel_step",
            {std::to_string(profile.channelStep), std::to_string(size), std::to_string(kMaxRegisters), ""});
    if (profile.at4mA_degC == profile.at20mA_degC)
        fields.fail(MessageCode::ValueUnknown, "at_20mA_degC",
                    {formatNumber(profile.at20mA_degC), "any other temperature than at 4 mA"});
}

/// Read back it is to be what it was.
void checkFits(const Fields& fields, const RegisterSpec& spec, const char* key, double number) {
    const auto registers = registersFromQuantity(spec, number);
    if (!registers)
        return fields.fail(MessageCode::ValueOutOfRange, key, registers.error().message.args);
    if (std::abs(quantityFromRegisters(spec, *registers) - number) > 1e-6 * std::max(1.0, std::abs(number)))
        fields.fail(MessageCode::ValueUnknown, key, {formatNumber(number, 10), "what the register can hold"});
}

/// Where off is a set point, it must read back as one.
void checkOff(const Fields& fields, const ModbusProfile& profile) {
    const double off_degC = profile.setPointOff_degC;
    if (!(off_degC >= kLowestOff_degC && off_degC <= kHighestOff_degC))
        fields.fail(
            MessageCode::ValueOutOfRange, "set_point_off_degC",
            {formatNumber(off_degC), formatNumber(kLowestOff_degC), formatNumber(kHighestOff_degC), "degC"});
    if (profile.run || !profile.setPoint)
        return;
    const RegisterSpec& spec = profile.setPointWritten ? *profile.setPointWritten : *profile.setPoint;
    const auto registers = registersFromTemperature(profile, spec, kelvinFromCelsius(off_degC));
    if (!registers)
        return fields.fail(MessageCode::ValueOutOfRange, "set_point_off_degC",
                           registers.error().message.args);
    const RegisterValue back = temperatureFromRegisters(profile, spec, *registers);
    if (!back.fault.empty() || celsiusFromKelvin(back.value_K) > kHighestOff_degC)
        fields.fail(MessageCode::ValueUnknown, "set_point_off_degC",
                    {formatNumber(off_degC), "what the register can hold"});
}

void readUnitRegister(Fields& fields, ModbusProfile& profile) {
    readRegister(fields, "temperature_unit", Use::Number, profile.temperatureUnit);
    if (profile.temperatureUnit) {
        fields.find("temperature_unit_degC", true);
        fields.find("temperature_unit_degF", true);
    }
    fields.read("temperature_unit_degC", profile.unitCelsius);
    fields.read("temperature_unit_degF", profile.unitFahrenheit);
    if (profile.unitCelsius == profile.unitFahrenheit)
        fields.fail(MessageCode::ValueUnknown, "temperature_unit_degF",
                    {formatNumber(profile.unitFahrenheit), "any other than temperature_unit_degC"});
    if (!profile.temperatureUnit || fields.failure())
        return;
    checkFits(fields, *profile.temperatureUnit, "temperature_unit_degC", profile.unitCelsius);
    checkFits(fields, *profile.temperatureUnit, "temperature_unit_degF", profile.unitFahrenheit);
}

void readDeviceType(Fields& fields, ModbusProfile& profile) {
    constexpr std::size_t kMaxTypes = 16;
    readRegister(fields, "device_type", Use::Number, profile.deviceType);
    const bool isThere = fields.find("device_types", profile.deviceType.has_value()) != nullptr;
    fields.read("device_types", profile.deviceTypes);
    if (fields.failure() || !isThere)
        return;
    const std::size_t min = profile.deviceType ? 1 : 0, max = profile.deviceType ? kMaxTypes : 0;
    if (profile.deviceTypes.size() < min || profile.deviceTypes.size() > max)
        return fields.fail(MessageCode::ValueOutOfRange, "device_types",
                           {std::to_string(profile.deviceTypes.size()), std::to_string(min),
                            std::to_string(max), "numbers"});
    for (const double type : profile.deviceTypes)
        checkFits(fields, *profile.deviceType, "device_types", type);
}

void readController(Fields& fields, ModbusProfile& profile) {
    fields.find("set_point", true);
    readRegister(fields, "process_value", Use::Temperature, profile.processValue);
    readRegister(fields, "set_point_written", Use::WrittenTemperature, profile.setPointWritten);
    readRegister(fields, "set_point", profile.setPointWritten ? Use::Temperature : Use::WrittenTemperature,
                 profile.setPoint);
    readRegister(fields, "run", Use::WrittenNumber, profile.run);
    fields.read("run_on", profile.runOn);
    fields.read("run_off", profile.runOff);
    fields.read("set_point_off_degC", profile.setPointOff_degC);
    readRegister(fields, "watchdog", Use::WrittenNumber, profile.watchdog);
    fields.read("watchdog_unit_s", profile.watchdogUnit_s);
    readRegister(fields, "sensor_fault", Use::Number, profile.sensorFault);
    readUnitRegister(fields, profile);
    if (fields.failure())
        return;
    if (profile.runOn == profile.runOff)
        fields.fail(MessageCode::ValueUnknown, "run_off",
                    {formatNumber(profile.runOff), "any other than run_on"});
    if (profile.run) {
        checkFits(fields, *profile.run, "run_on", profile.runOn);
        checkFits(fields, *profile.run, "run_off", profile.runOff);
    }
    checkOff(fields, profile);
    if (!(profile.watchdogUnit_s > 0.0))
        fields.fail(MessageCode::ValueNotPositive, "watchdog_unit_s", {formatNumber(profile.watchdogUnit_s)});
}

IdentitySpec readIdentity(const json& j, const std::string& path, Failure& failure) {
    constexpr int kMaxWords = 16;
    IdentitySpec out;
    Fields fields(j, path, failure);
    fields.find("address", true);
    readWhole(fields, "function", out.function, 3, 4);
    readWhole(fields, "address", out.address, 0, kMaxAddress - kMaxWords);
    readWhole(fields, "count", out.count, 1, kMaxWords);
    fields.close();
    return out;
}

void readProfile(const json& j, Failure& failure, ModbusProfile& out) {
    Fields fields(j, {}, failure);
    fields.readName("name", out.name, true);
    fields.readTitle("title", out.title);
    fields.read("source", out.source);
    readPart(fields, "identity", false, [&](const json& part, const std::string& path) {
        out.identity = readIdentity(part, path, failure);
    });
    readDeviceType(fields, out);
    if (fields.find("process_value") != nullptr)
        readController(fields, out);
    else if (fields.find("channel", true) != nullptr)
        readThermometer(fields, out);
    readEach(fields, "status", false, [&](const json& part, const std::string& path) {
        out.status.push_back(readStatus(part, path, failure, std::max(1, out.channels)));
    });
    fields.close();
    if (out.name.empty())
        fields.fail(MessageCode::NameEmpty, "name");
}

ordered_json written(const RegisterSpec& spec) {
    ordered_json faults = ordered_json::object();
    for (const auto& [number, word] : spec.faults)
        faults[json(number).dump()] = word;
    return {{"function", spec.function},
            {"address", spec.address},
            {"type", wordOf(kTypes, spec.type)},
            {"low_word_first", spec.isLowWordFirst},
            {"scale", spec.scale},
            {"offset", spec.offset},
            {"unit", wordOf(kUnits, spec.unit)},
            {"faults", faults}};
}

ordered_json written(const StatusSpec& status) {
    return {{"function", status.function},  {"address", status.address},
            {"first_bit", status.firstBit}, {"bit_step", status.bitStep},
            {"fault", status.fault},        {"fault_when_set", status.isFaultWhenSet}};
}

void writeRegister(ordered_json& j, const char* key, const std::optional<RegisterSpec>& spec) {
    if (spec)
        j[key] = written(*spec);
}

void writeThermometer(ordered_json& j, const ModbusProfile& profile) {
    j["channel"] = written(*profile.channel);
    j["channels"] = profile.channels;
    j["channel_step"] = profile.channelStep;
    j["one_by_one"] = profile.isOneByOne;
    j["at_4mA_degC"] = profile.at4mA_degC;
    j["at_20mA_degC"] = profile.at20mA_degC;
}

void writeController(ordered_json& j, const ModbusProfile& profile) {
    writeRegister(j, "process_value", profile.processValue);
    writeRegister(j, "set_point", profile.setPoint);
    writeRegister(j, "set_point_written", profile.setPointWritten);
    writeRegister(j, "run", profile.run);
    j["run_on"] = profile.runOn;
    j["run_off"] = profile.runOff;
    j["set_point_off_degC"] = profile.setPointOff_degC;
    writeRegister(j, "watchdog", profile.watchdog);
    j["watchdog_unit_s"] = profile.watchdogUnit_s;
    writeRegister(j, "sensor_fault", profile.sensorFault);
    writeRegister(j, "temperature_unit", profile.temperatureUnit);
    if (profile.temperatureUnit) {
        j["temperature_unit_degC"] = profile.unitCelsius;
        j["temperature_unit_degF"] = profile.unitFahrenheit;
    }
}

} // namespace

ModbusProfile inUnit(ModbusProfile profile, RegisterUnit unit) {
    for (auto* spec : {&profile.processValue, &profile.setPoint, &profile.setPointWritten})
        if (*spec)
            (*spec)->unit = unit;
    return profile;
}

Result<ModbusProfile> modbusProfileFromJson(const std::string& text, const std::string& where) {
    return readJsonText<ModbusProfile>(text, where, readProfile);
}

std::string modbusProfileToJson(const ModbusProfile& profile) {
    ordered_json j{{"name", profile.name}, {"title", profile.title}, {"source", profile.source}};
    if (profile.processValue)
        writeController(j, profile);
    else if (profile.channel)
        writeThermometer(j, profile);
    if (const auto& identity = profile.identity)
        j["identity"] = {
            {"function", identity->function}, {"address", identity->address}, {"count", identity->count}};
    if (profile.deviceType) {
        writeRegister(j, "device_type", profile.deviceType);
        j["device_types"] = profile.deviceTypes;
    }
    j["status"] = ordered_json::array();
    for (const StatusSpec& status : profile.status)
        j["status"].push_back(written(status));
    return j.dump(2, ' ', false, ordered_json::error_handler_t::replace);
}

const std::vector<ModbusProfile>& shippedProfiles() {
    static const std::vector<ModbusProfile> kProfiles = [] {
        std::vector<ModbusProfile> out;
        for (const auto& [name, text] : shippedProfileTexts())
            out.push_back(modbusProfileFromJson(text, name).value());
        return out;
    }();
    return kProfiles;
}

} // namespace bask
