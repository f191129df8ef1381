#include "engine/protocols/modbus_profile.h"

#include "engine/base/message_code.h"
#include "engine/base/units.h"
#include "engine/protocols/register_ranges.h"
#include "engine/protocols/register_values.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <set>
#include <stdexcept>

namespace bask {

/// The files in profiles/, put into the program by CMake: names and texts.
std::vector<std::pair<std::string, std::string>> shippedProfileTexts();

namespace {

using nlohmann::json;
using nlohmann::ordered_json;

constexpr int kMaxAddress = 65535;
constexpr std::size_t kMaxDepth = 8;
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

/// Printable, on one line, not too long: it may be shown.
std::string plain(std::string words) {
    std::replace_if(
        words.begin(), words.end(), [](char c) { return c < ' ' || c > '~'; }, '?');
    return words.substr(0, 300);
}

/// What stops the reading; caught where it began.
[[noreturn]] void refuse(MessageCode code, const std::string& where, std::vector<MessageArg> args = {}) {
    throw Error(code, where, std::move(args));
}

/// One JSON object: typed access by key. close() refuses the keys that nobody asked for.
class Object {
public:
    Object(const json& j, std::string path) : m_json(j), m_path(std::move(path)) {
        if (!j.is_object())
            wrongType("", "an object", j);
    }

    const json* find(const std::string& key) {
        m_asked.insert(key);
        const auto it = m_json.find(key);
        return it == m_json.end() ? nullptr : &*it;
    }
    std::string pathOf(const std::string& key) const {
        return m_path.empty() || key.empty() ? m_path + key : m_path + '.' + key;
    }
    void require(const std::string& key) {
        if (find(key) == nullptr && m_missing.empty())
            m_missing = key;
    }

    void read(const std::string& key, double& out) {
        if (const json* j = find(key)) {
            if (!j->is_number())
                wrongType(key, "a number", *j);
            out = j->get<double>();
        }
    }
    void read(const std::string& key, bool& out) {
        if (const json* j = find(key)) {
            if (!j->is_boolean())
                wrongType(key, "true or false", *j);
            out = j->get<bool>();
        }
    }
    void read(const std::string& key, std::string& out) {
        if (const json* j = find(key)) {
            if (!j->is_string())
                wrongType(key, "text", *j);
            out = j->get<std::string>();
        }
    }
    void read(const std::string& key, int& out, int least, int most) {
        if (const json* j = find(key)) {
            if (!j->is_number_integer())
                wrongType(key, "a whole number", *j);
            const auto value = j->get<double>();
            if (value < least || value > most)
                refuse(MessageCode::ValueOutOfRange, pathOf(key),
                       {j->dump(), std::to_string(least), std::to_string(most), ""});
            out = static_cast<int>(value);
        }
    }
    template <class T> void readWord(const std::string& key, const std::map<std::string, T>& table, T& out) {
        std::string word;
        read(key, word);
        if (find(key) == nullptr)
            return;
        const auto it = table.find(word);
        if (it == table.end()) {
            std::vector<std::string> known;
            for (const auto& [name, unused] : table)
                known.push_back(name);
            refuse(MessageCode::ValueUnknown, pathOf(key), {plain(word), joined(known)});
        }
        out = it->second;
    }
    /// Calls with the value and its place, if there is one.
    template <class Use> void with(const std::string& key, Use use) {
        if (const json* j = find(key))
            use(*j, pathOf(key));
    }

    void close() {
        for (const auto& item : m_json.items()) {
            if (!m_asked.contains(item.key()))
                refuse(MessageCode::JsonUnknownKey, m_path, {plain(item.key()), joined(m_asked)});
        }
        if (!m_missing.empty())
            refuse(MessageCode::JsonMissingKey, m_path, {m_missing});
    }

private:
    [[noreturn]] void wrongType(const std::string& key, const char* expected, const json& found) const {
        refuse(MessageCode::JsonWrongType, pathOf(key), {expected, found.type_name()});
    }

    const json& m_json;
    std::string m_path, m_missing;
    std::set<std::string> m_asked;
};

void checkFaultWord(const std::string& word, const std::string& where) {
    const auto& known = sensorFaultWords();
    if (std::find(known.begin(), known.end(), word) == known.end())
        refuse(MessageCode::ValueUnknown, where, {plain(word), joined(known)});
}

void readFaults(const json& j, const std::string& path, std::map<double, std::string>& out) {
    if (!j.is_object())
        refuse(MessageCode::JsonWrongType, path, {"an object", j.type_name()});
    for (const auto& [key, word] : j.items()) {
        double number = 0.0;
        const char* end = key.data() + key.size();
        const auto [stop, error] = std::from_chars(key.data(), end, number);
        if (error != std::errc() || stop != end)
            refuse(MessageCode::JsonWrongType, path + '.' + plain(key), {"a number", "text"});
        if (!word.is_string())
            refuse(MessageCode::JsonWrongType, path + '.' + key, {"text", word.type_name()});
        checkFaultWord(word.get<std::string>(), path + '.' + key);
        out[number] = word.get<std::string>();
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

RegisterSpec readRegister(const json& j, const std::string& path, Use use) {
    RegisterSpec out;
    const bool isWritten = use == Use::WrittenTemperature || use == Use::WrittenNumber;
    if (use == Use::Number || use == Use::WrittenNumber)
        out.unit = RegisterUnit::None;
    Object object(j, path);
    object.require("address");
    object.read("function", out.function, 3, isWritten ? 3 : 4);
    object.read("address", out.address, 0, kMaxAddress);
    object.readWord("type", kTypes, out.type);
    object.read("low_word_first", out.isLowWordFirst);
    object.read("scale", out.scale);
    object.read("offset", out.offset);
    object.readWord("unit", kUnits, out.unit);
    object.with("faults",
                [&](const json& faults, const std::string& where) { readFaults(faults, where, out.faults); });
    object.close();
    if (out.scale == 0.0)
        refuse(MessageCode::ValueUnknown, path + ".scale", {"0", "any other number"});
    if (out.address + registerCount(out.type) - 1 > kMaxAddress)
        refuse(MessageCode::ValueOutOfRange, path + ".address",
               {std::to_string(out.address), "0", std::to_string(kMaxAddress - 1), ""});
    if (!isUnitFor(use, out.unit))
        refuse(MessageCode::ValueUnknown, path + ".unit", {wordOf(kUnits, out.unit), unitsFor(use)});
    return out;
}

void readRegister(Object& parent, const std::string& key, Use use, std::optional<RegisterSpec>& out) {
    parent.with(key, [&](const json& j, const std::string& path) { out = readRegister(j, path, use); });
}

StatusSpec readStatus(const json& j, const std::string& path, int channels) {
    StatusSpec out;
    Object object(j, path);
    object.require("address");
    object.read("function", out.function, 3, 4);
    object.read("address", out.address, 0, kMaxAddress);
    object.read("first_bit", out.firstBit, 0, 15);
    object.read("bit_step", out.bitStep, -15, 15);
    object.read("fault_when_set", out.isFaultWhenSet);
    object.read("fault", out.fault);
    object.close();
    checkFaultWord(out.fault, path + ".fault");
    const int last = out.firstBit + (channels - 1) * out.bitStep;
    if (last < 0 || last > 15)
        refuse(MessageCode::ValueOutOfRange, path + ".first_bit", {std::to_string(last), "0", "15", ""});
    return out;
}

void readStatuses(Object& object, ModbusProfile& profile) {
    object.with("status", [&](const json& j, const std::string& path) {
        if (!j.is_array())
            refuse(MessageCode::JsonWrongType, path, {"an array", j.type_name()});
        for (std::size_t i = 0; i < j.size(); ++i)
            profile.status.push_back(
                readStatus(j[i], path + '[' + std::to_string(i) + ']', std::max(1, profile.channels)));
    });
}

void readThermometer(Object& object, ModbusProfile& profile) {
    object.require("channels");
    readRegister(object, "channel", Use::Sensor, profile.channel);
    object.read("channels", profile.channels, 1, kMaxRegisters);
    const int size = registerCount(profile.channel->type);
    object.read("channel_step", profile.channelStep, size, kMaxRegisters);
    object.read("at_4mA_degC", profile.at4mA_degC);
    object.read("at_20mA_degC", profile.at20mA_degC);
    const int span = (profile.channels - 1) * profile.channelStep + size;
    if (profile.channelStep < size || span > kMaxRegisters ||
        profile.channel->address + span - 1 > kMaxAddress)
        refuse(
            MessageCode::ValueOutOfRange, "channel_step",
            {std::to_string(profile.channelStep), std::to_string(size), std::to_string(kMaxRegisters), ""});
    if (profile.at4mA_degC == profile.at20mA_degC)
        refuse(MessageCode::ValueUnknown, "at_20mA_degC",
               {formatNumber(profile.at20mA_degC), "any other temperature than at 4 mA"});
}

/// Read back it is to be what it was.
void checkHeld(const RegisterSpec& spec, const char* key, double number) {
    const auto registers = registersFromQuantity(spec, number);
    if (!registers)
        refuse(MessageCode::ValueOutOfRange, key, registers.error().message.args);
    if (std::abs(quantityFromRegisters(spec, *registers) - number) > 1e-6 * std::max(1.0, std::abs(number)))
        refuse(MessageCode::ValueUnknown, key, {formatNumber(number, 10), "what the register can hold"});
}

/// Where off is a set point, it must read back as one.
void checkOff(const ModbusProfile& profile) {
    const double off_degC = profile.setPointOff_degC;
    if (!(off_degC >= kLowestOff_degC && off_degC <= kHighestOff_degC))
        refuse(
            MessageCode::ValueOutOfRange, "set_point_off_degC",
            {formatNumber(off_degC), formatNumber(kLowestOff_degC), formatNumber(kHighestOff_degC), "degC"});
    if (profile.run || !profile.setPoint)
        return;
    const RegisterSpec& spec = profile.setPointWritten ? *profile.setPointWritten : *profile.setPoint;
    const auto registers = registersFromTemperature(profile, spec, kelvinFromCelsius(off_degC));
    if (!registers)
        refuse(MessageCode::ValueOutOfRange, "set_point_off_degC", registers.error().message.args);
    const RegisterValue back = temperatureFromRegisters(profile, spec, *registers);
    if (!back.fault.empty() || celsiusFromKelvin(back.value_K) > kHighestOff_degC)
        refuse(MessageCode::ValueUnknown, "set_point_off_degC",
               {formatNumber(off_degC), "what the register can hold"});
}

void readUnitRegister(Object& object, ModbusProfile& profile) {
    readRegister(object, "temperature_unit", Use::Number, profile.temperatureUnit);
    if (profile.temperatureUnit) {
        object.require("temperature_unit_degC");
        object.require("temperature_unit_degF");
    }
    object.read("temperature_unit_degC", profile.unitCelsius);
    object.read("temperature_unit_degF", profile.unitFahrenheit);
    if (profile.unitCelsius == profile.unitFahrenheit)
        refuse(MessageCode::ValueUnknown, "temperature_unit_degF",
               {formatNumber(profile.unitFahrenheit), "any other than temperature_unit_degC"});
    if (!profile.temperatureUnit)
        return;
    checkHeld(*profile.temperatureUnit, "temperature_unit_degC", profile.unitCelsius);
    checkHeld(*profile.temperatureUnit, "temperature_unit_degF", profile.unitFahrenheit);
}

void readController(Object& object, ModbusProfile& profile) {
    object.require("set_point");
    readRegister(object, "process_value", Use::Temperature, profile.processValue);
    readRegister(object, "set_point_written", Use::WrittenTemperature, profile.setPointWritten);
    readRegister(object, "set_point", profile.setPointWritten ? Use::Temperature : Use::WrittenTemperature,
                 profile.setPoint);
    readRegister(object, "run", Use::WrittenNumber, profile.run);
    object.read("run_on", profile.runOn);
    object.read("run_off", profile.runOff);
    object.read("set_point_off_degC", profile.setPointOff_degC);
    readRegister(object, "watchdog", Use::WrittenNumber, profile.watchdog);
    object.read("watchdog_unit_s", profile.watchdogUnit_s);
    readRegister(object, "sensor_fault", Use::Number, profile.sensorFault);
    readUnitRegister(object, profile);
    if (profile.runOn == profile.runOff)
        refuse(MessageCode::ValueUnknown, "run_off", {formatNumber(profile.runOff), "any other than run_on"});
    if (profile.run) {
        checkHeld(*profile.run, "run_on", profile.runOn);
        checkHeld(*profile.run, "run_off", profile.runOff);
    }
    checkOff(profile);
    if (!(profile.watchdogUnit_s > 0.0))
        refuse(MessageCode::ValueNotPositive, "watchdog_unit_s", {formatNumber(profile.watchdogUnit_s)});
}

void readIdentity(Object& parent, std::optional<IdentitySpec>& out) {
    constexpr int kMaxWords = 16;
    parent.with("identity", [&](const json& j, const std::string& path) {
        out.emplace();
        Object object(j, path);
        object.require("address");
        object.read("function", out->function, 3, 4);
        object.read("address", out->address, 0, kMaxAddress - kMaxWords);
        object.read("count", out->count, 1, kMaxWords);
        object.close();
    });
}

ModbusProfile readProfile(const json& j) {
    ModbusProfile out;
    Object object(j, "");
    object.require("name");
    object.read("name", out.name);
    object.read("title", out.title);
    object.read("source", out.source);
    readIdentity(object, out.identity);
    if (object.find("process_value") != nullptr)
        readController(object, out);
    else if (object.find("channel") != nullptr)
        readThermometer(object, out);
    else
        object.require("channel");
    readStatuses(object, out);
    object.close();
    if (out.name.empty())
        refuse(MessageCode::NameEmpty, "name");
    return out;
}

/// Refuses keys given twice and nesting too deep, which the parser would take.
class TextCheck {
public:
    bool operator()(int depth, json::parse_event_t event, const json& parsed) {
        if (static_cast<std::size_t>(depth) > kMaxDepth)
            refuse(MessageCode::JsonTooDeep, "", {std::to_string(kMaxDepth)});
        const auto level = static_cast<std::size_t>(depth);
        if (event == json::parse_event_t::object_start)
            m_keys[level + 1].clear();
        if (event == json::parse_event_t::key && !m_keys[level].insert(parsed.get<std::string>()).second)
            refuse(MessageCode::JsonDuplicateKey, "", {plain(parsed.get<std::string>())});
        return true;
    }

private:
    std::map<std::size_t, std::set<std::string>> m_keys;
};

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
    const auto place = [&where](const std::string& path) {
        return path.empty() || where.empty() ? where + path : where + ": " + path;
    };
    try {
        return readProfile(json::parse(text, TextCheck()));
    } catch (const Error& error) {
        return Error(error.code(), place(error.where), error.message.args);
    } catch (const json::exception& error) {
        return Error(MessageCode::JsonSyntax, where, {plain(error.what())});
    }
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
