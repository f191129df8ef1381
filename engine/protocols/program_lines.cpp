#include "engine/protocols/program_lines.h"

#include "engine/base/json_fields.h"
#include "engine/base/pose.h"
#include "engine/protocols/register_values.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace bask {
namespace {

using nlohmann::json;
using Line = nlohmann::ordered_json;

constexpr std::size_t kMaxWords = 80, kMaxAlarm = 1000;
constexpr int kMaxChannels = 64;
constexpr std::int64_t kMaxNumber = std::int64_t{1} << 53;
constexpr double kMaxMetres = 100.0, kMaxRadians = 100.0, kMaxKelvin = 5000.0, kMaxAge_s = 3600.0;

const std::map<std::string, int>& coordinatesByName() {
    static const std::map<std::string, int> kNames = [] {
        std::map<std::string, int> out;
        for (std::size_t k = 0; k < kCoordinateNames.size(); ++k)
            out[kCoordinateNames[k]] = static_cast<int>(k);
        return out;
    }();
    return kNames;
}

/// Reads the fields of one object of a line, and refuses what no device can mean.
class LineFields : public Fields {
public:
    using Fields::Fields;

    void words(const char* key, std::size_t max, std::string& out, bool required) {
        read(key, out, required);
        if (!failure() && out.size() > max)
            fail(MessageCode::ValueOutOfRange, pathOf(key),
                 {std::to_string(out.size()), "0", std::to_string(max), "bytes"});
        out = printable(out);
        std::ranges::replace_if(
            out, [](char c) { return c == '\n' || c == '\t'; }, ' ');
    }
    void within(const char* key, double min, double max, double& out, bool required) {
        read(key, out, required);
        check(pathOf(key), out, min, max);
    }
    void check(const std::string& path, double value, double min, double max) const {
        if (!failure() && !(value >= min && value <= max))
            fail(MessageCode::ValueOutOfRange, path,
                 {formatNumber(value), formatNumber(min), formatNumber(max), ""});
    }
    /// A number, or null for one that is not known.
    void orNull(const json& j, const std::string& path, double max, std::optional<double>& out) const {
        if (failure() || j.is_null())
            return;
        if (!j.is_number())
            return fail(MessageCode::JsonWrongType, path, {"a number or null", typeName(j)});
        out = j.get<double>();
        check(path, *out, 0.0, max);
    }
    void orNull(const char* key, double max, std::optional<double>& out, bool required) {
        if (const json* j = find(key, required))
            orNull(*j, pathOf(key), max, out);
    }
    /// One of the words for a sensor's fault, or none.
    void fault(const json& j, const std::string& path, std::string& out) const {
        std::string known;
        for (const std::string& word : sensorFaultWords()) {
            known += ", " + word;
            if (j == word)
                out = word;
        }
        if (out.empty() && j != "")
            fail(MessageCode::ValueUnknown, path, {plainWords(j.dump()), known});
    }
    /// The list of a key; null if it is missing or none.
    const json* list(const char* key, std::size_t max, bool required) {
        const json* j = find(key, required);
        if (j == nullptr || failure())
            return nullptr;
        if (!j->is_array()) {
            fail(MessageCode::JsonWrongType, pathOf(key), {"a list", typeName(*j)});
            return nullptr;
        }
        check(pathOf(key), static_cast<double>(j->size()), 1.0, static_cast<double>(max));
        return failure() ? nullptr : j;
    }
};

std::string placeOf(const LineFields& fields, const char* key, std::size_t i) {
    return fields.pathOf(key) + '[' + std::to_string(i) + ']';
}

double greatest(int coordinate) {
    return coordinate < kThetaX ? kMaxMetres : kMaxRadians;
}

void readAxes(LineFields& fields, ProgramHello& out) {
    const json* axes = fields.list("axes", kCoordinateNames.size(), true);
    for (std::size_t i = 0; axes != nullptr && i < axes->size(); ++i) {
        const json& axis = (*axes)[i];
        const auto known =
            axis.is_string() ? coordinatesByName().find(axis.get<std::string>()) : coordinatesByName().end();
        if (known == coordinatesByName().end())
            return fields.fail(MessageCode::ValueUnknown, placeOf(fields, "axes", i),
                               {plainWords(axis.dump()), Fields::joined(coordinatesByName())});
        if (std::ranges::find(out.axes, known->second) != out.axes.end())
            return fields.fail(MessageCode::AxisTwice, placeOf(fields, "axes", i), {known->first});
        out.axes.push_back(known->second);
    }
}

void readLimits(LineFields& fields, ProgramHello& out) {
    for (int k = 0; k < 6; ++k)
        out.limits[static_cast<std::size_t>(k)] = {-greatest(k), greatest(k)};
    const json* limits = fields.find("limits");
    if (limits == nullptr || fields.failure())
        return;
    LineFields each(*limits, fields.pathOf("limits"), fields.failure());
    for (const auto& [name, k] : coordinatesByName()) {
        std::vector<double> pair;
        each.read(name, pair);
        if (each.failure() || each.find(name) == nullptr)
            continue;
        if (pair.size() != 2 || !(pair[0] < pair[1]))
            return each.fail(MessageCode::JsonWrongType, each.pathOf(name),
                             {"the least and the greatest position", "another list"});
        out.limits[static_cast<std::size_t>(k)] = {pair[0], pair[1]};
    }
    each.close();
}

void readHello(LineFields& fields, ProgramRole role, ProgramHello& out) {
    int protocol = 0;
    std::string roleWord;
    fields.read("protocol", protocol, true);
    fields.read("role", roleWord, true);
    if (!fields.failure() && protocol != program::kProtocol)
        fields.fail(MessageCode::ValueUnknown, fields.pathOf("protocol"),
                    {std::to_string(protocol), std::to_string(program::kProtocol)});
    if (!fields.failure() && roleWord != programRoleWord(role))
        fields.fail(MessageCode::ValueUnknown, fields.pathOf("role"),
                    {plainWords(roleWord), programRoleWord(role)});
    fields.words("name", kMaxWords, out.name, true);
    if (!fields.failure() && out.name.empty())
        fields.fail(MessageCode::JsonMissingKey, fields.pathOf("name"), {"name"});
    fields.words("serial", kMaxWords, out.serial, false);
    switch (role) {
    case ProgramRole::Robot: {
        static const std::map<std::string, bool> kMoves{{"steps", false}, {"velocity", true}};
        readAxes(fields, out);
        fields.readWord("moves", kMoves, out.takesVelocities, true);
        fields.read("can_home", out.canHome);
        readLimits(fields, out);
        break;
    }
    case ProgramRole::Thermometer:
        fields.read("channels", out.channels, true);
        fields.check(fields.pathOf("channels"), out.channels, 1.0, kMaxChannels);
        break;
    case ProgramRole::HeatSource:
        fields.within("max_temperature", 0.0, kMaxKelvin, out.maxTemperature_K, true);
        fields.read("watchdog", out.hasWatchdog);
        break;
    }
    fields.close(Fields::Unknown::Ignored);
}

ProgramRobotState readRobotState(LineFields& fields) {
    ProgramRobotState out;
    if (fields.find("position", true) != nullptr)
        fields.read("position", out.position);
    else
        out.position.resize(1);
    fields.check(fields.pathOf("position"), static_cast<double>(out.position.size()), 1.0, 6.0);
    for (std::size_t i = 0; i < out.position.size(); ++i)
        fields.check(placeOf(fields, "position", i), out.position[i], -kMaxMetres, kMaxMetres);
    if (fields.find("moving", true) != nullptr)
        fields.read("moving", out.isMoving);
    if (fields.find("sure", true) != nullptr)
        fields.read("sure", out.isSure);
    fields.words("alarm", kMaxAlarm, out.alarm, false);
    return out;
}

std::vector<ProgramChannel> readChannels(LineFields& fields) {
    std::vector<ProgramChannel> out;
    const json* temperatures = fields.list("temperatures", kMaxChannels, true);
    if (temperatures == nullptr)
        return out;
    out.resize(temperatures->size());
    const auto isAsLong = [&](const char* key, std::size_t size) {
        fields.check(fields.pathOf(key), static_cast<double>(size), static_cast<double>(out.size()),
                     static_cast<double>(out.size()));
        return !fields.failure();
    };
    for (std::size_t i = 0; i < out.size(); ++i)
        fields.orNull((*temperatures)[i], placeOf(fields, "temperatures", i), kMaxKelvin,
                      out[i].temperature_K);
    if (const json* faults = fields.list("faults", kMaxChannels, false);
        faults && isAsLong("faults", faults->size()))
        for (std::size_t i = 0; i < out.size(); ++i)
            fields.fault((*faults)[i], placeOf(fields, "faults", i), out[i].fault);
    std::vector<double> uncertainties;
    fields.read("uncertainties", uncertainties);
    if (!uncertainties.empty() && isAsLong("uncertainties", uncertainties.size()))
        for (std::size_t i = 0; i < out.size(); ++i) {
            out[i].standardUncertainty_K = uncertainties[i];
            fields.check(placeOf(fields, "uncertainties", i), uncertainties[i], 0.0, kMaxKelvin);
        }
    for (ProgramChannel& channel : out) // one with a fault and a number is not believed
        if (!channel.fault.empty())
            channel.temperature_K.reset();
        else if (!channel.temperature_K)
            channel.fault = "other";
    return out;
}

ProgramHeaterState readHeaterState(LineFields& fields) {
    ProgramHeaterState out;
    fields.orNull("temperature", kMaxKelvin, out.temperature_K, true);
    if (fields.find("heating", true) != nullptr)
        fields.read("heating", out.isHeating);
    fields.orNull("set_point", kMaxKelvin, out.setPoint_K, false);
    return out;
}

void readState(LineFields& fields, ProgramRole role, ProgramLine& out) {
    fields.within("age", 0.0, kMaxAge_s, out.age_s, false);
    switch (role) {
    case ProgramRole::Robot:
        out.what = readRobotState(fields);
        break;
    case ProgramRole::Thermometer:
        out.what = readChannels(fields);
        break;
    case ProgramRole::HeatSource:
        out.what = readHeaterState(fields);
        break;
    }
    fields.close(Fields::Unknown::Ignored);
}

void readWhole(LineFields& fields, const char* key, std::int64_t& out) {
    const json* j = fields.find(key, true);
    if (j == nullptr || fields.failure())
        return;
    if (!j->is_number_integer() || *j < 1 || *j > kMaxNumber)
        return fields.fail(MessageCode::JsonWrongType, fields.pathOf(key),
                           {"a whole number from 1", typeName(*j)});
    out = j->get<std::int64_t>();
}

void readLine(const json& j, Failure& failure, ProgramRole role, ProgramLine& out) {
    LineFields fields(j, {}, failure);
    readWhole(fields, "seq", out.seq);
    fields.within("time", -1e12, 1e12, out.time_s, true);
    if (const json* id = fields.find("id"); id != nullptr && !id->is_null())
        readWhole(fields, "id", out.id.emplace());
    const char* const kKinds[] = {"state", "ok", "error", "hello"};
    const auto kinds = std::ranges::count_if(kKinds, [&](const char* key) { return fields.find(key); });
    if (kinds != 1 && !failure)
        fields.fail(MessageCode::JsonMissingKey, {}, {"state, ok, error or hello, one of them"});
    if (failure)
        return;
    if (const json* state = fields.find("state")) {
        LineFields part(*state, "state", failure);
        readState(part, role, out);
    } else if (fields.find("error") != nullptr) {
        fields.words("error", kMaxAlarm, out.what.emplace<ProgramRefusal>().words, true);
    } else if (!out.id) {
        fields.fail(MessageCode::JsonMissingKey, {}, {"id"});
    } else if (const json* hello = fields.find("hello")) {
        LineFields part(*hello, "hello", failure);
        readHello(part, role, out.what.emplace<ProgramHello>());
    } else if (const json* ok = fields.find("ok"); !ok->is_boolean() || !ok->get<bool>()) {
        fields.fail(MessageCode::JsonWrongType, "ok", {"true", plainWords(ok->dump())});
    }
    fields.close(Fields::Unknown::Ignored);
}

std::string written(const Line& line) {
    return line.dump() + '\n';
}

} // namespace

std::string coordinateNames(const std::vector<int>& coordinates) {
    std::string out;
    for (const int coordinate : coordinates)
        out +=
            (out.empty() ? "" : ", ") + std::string(kCoordinateNames[static_cast<std::size_t>(coordinate)]);
    return out;
}

const char* programRoleWord(ProgramRole role) {
    switch (role) {
    case ProgramRole::Robot:
        return "robot";
    case ProgramRole::Thermometer:
        return "thermometer";
    case ProgramRole::HeatSource:
        break;
    }
    return "heater";
}

Result<ProgramLine> parseProgramLine(std::string_view line, ProgramRole role) {
    return readJsonText<ProgramLine>(
        std::string(line), {},
        [role](const json& j, Failure& failure, ProgramLine& out) { readLine(j, failure, role, out); });
}

ProgramNumbers programNumbers(std::string_view line) {
    const json j = json::parse(line, nullptr, false);
    ProgramNumbers out;
    if (!j.is_object())
        return out;
    for (const auto& [key, number] : {std::pair("id", &out.id), std::pair("seq", &out.seq)})
        if (const auto it = j.find(key);
            it != j.end() && it->is_number_integer() && *it >= 1 && *it <= kMaxNumber)
            *number = it->get<std::int64_t>();
    return out;
}

std::string programHello(std::int64_t id, ProgramRole role) {
    return written({{"id", id},
                    {"do", "hello"},
                    {"protocol", program::kProtocol},
                    {"role", programRoleWord(role)},
                    {"dead_man", program::kDeadMan_s}});
}

std::string programRequest(std::int64_t id, const char* what) {
    return written({{"id", id}, {"do", what}});
}

std::string programVelocity(std::int64_t id, const std::vector<double>& rates, double validFor_s) {
    return written({{"id", id}, {"do", "velocity"}, {"rates", rates}, {"valid_for", validFor_s}});
}

std::string programStep(std::int64_t id, const std::vector<double>& to, double duration_s) {
    return written({{"id", id}, {"do", "step"}, {"to", to}, {"duration", duration_s}});
}

std::string programHeat(std::int64_t id, double setPoint_K, double validFor_s) {
    return written({{"id", id}, {"do", "heat"}, {"set_point", setPoint_K}, {"valid_for", validFor_s}});
}

} // namespace bask
