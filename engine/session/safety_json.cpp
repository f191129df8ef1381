#include "engine/session/safety_json.h"

#include "engine/session/json_quantities.h"

#include <nlohmann/json.hpp>

namespace bask {
namespace {

using nlohmann::json;
using Json = nlohmann::ordered_json;

/// A quantity that may be left out, in either spelling.
void readOptional(Fields& fields, const std::string& name, EdgeUnit unit, std::optional<double>& out) {
    if (fields.find(readableKey(name, unit)) != nullptr || fields.find(siKey(name, unit)) != nullptr)
        fields.read(name, unit, out.emplace());
}

ScriptedFault readFault(const json& j, const std::string& path, Failure& failure) {
    std::map<std::string, SimulatedFault> words;
    for (int i = 1; i < kSimulatedFaults; ++i) {
        const auto fault = static_cast<SimulatedFault>(i);
        words[simulatedFaultName(fault)] = fault;
    }
    Fields fields(j, path, failure);
    ScriptedFault fault;
    int object = 0;
    fields.read("time_s", fault.time_s, true);
    fields.readWord("fault", words, fault.fault, true);
    fields.read("object", object);
    if (fields.find("until_s") != nullptr)
        fields.read("until_s", fault.until_s.emplace());
    fields.close();
    fault.object = static_cast<std::size_t>(object); // a negative one is out of range, whatever the objects
    return fault;
}

} // namespace

void readLimits(Fields& fields, std::optional<double>& warning_K, std::optional<double>& trip_K) {
    readOptional(fields, "warning", EdgeUnit::Temperature, warning_K);
    readOptional(fields, "trip", EdgeUnit::Temperature, trip_K);
}

void putLimits(Json& j, const std::optional<double>& warning_K, const std::optional<double>& trip_K) {
    if (warning_K)
        putQuantity(j, "warning", EdgeUnit::Temperature, *warning_K);
    if (trip_K)
        putQuantity(j, "trip", EdgeUnit::Temperature, *trip_K);
}

void readSafety(const json& j, const std::string& path, Failure& failure, SafetySpec& out) {
    Fields fields(j, path, failure);
    fields.read("warning", EdgeUnit::Temperature, out.warning_K);
    fields.read("trip", EdgeUnit::Temperature, out.trip_K);
    readOptional(fields, "source_trip", EdgeUnit::Temperature, out.sourceTrip_K);
    fields.read("stale_periods", out.stalePeriods);
    fields.read("held_limit_s", out.heldLimit_s);
    if (fields.find("largest_rate_K_s") != nullptr)
        fields.read("largest_rate_K_s", out.largestRate_K_s.emplace());
    fields.read("jumps", out.jumps);
    fields.read("frozen_s", out.frozen_s);
    fields.read("warming_K", out.warming_K);
    fields.read("cross_check_K", out.crossCheck_K);
    fields.read("source_heating_s", out.sourceHeating_s);
    fields.read("source_band_K", out.sourceBand_K);
    fields.read("source_unasked_K", out.sourceUnasked_K);
    fields.read("least_disk_MB", out.leastDisk_MB);
    fields.close();
}

void readFaults(Fields& parent, const std::string& key, std::vector<ScriptedFault>& out) {
    const json* j = parent.find(key);
    if (j == nullptr)
        return;
    const std::string path = parent.pathOf(key);
    if (!j->is_array())
        return parent.fail(MessageCode::JsonWrongType, path, {"an array", typeName(*j)});
    for (std::size_t i = 0; i < j->size() && !parent.failure(); ++i)
        out.push_back(readFault((*j)[i], path + '[' + std::to_string(i) + ']', parent.failure()));
}

Json safetyJson(const SafetySpec& s) {
    const SafetySpec usual;
    Json j = Json::object();
    const auto put = [&](const char* key, double value, double usualValue) {
        if (value != usualValue)
            j[key] = value;
    };
    if (s.warning_K != usual.warning_K)
        putQuantity(j, "warning", EdgeUnit::Temperature, s.warning_K);
    if (s.trip_K != usual.trip_K)
        putQuantity(j, "trip", EdgeUnit::Temperature, s.trip_K);
    if (s.sourceTrip_K)
        putQuantity(j, "source_trip", EdgeUnit::Temperature, *s.sourceTrip_K);
    put("stale_periods", s.stalePeriods, usual.stalePeriods);
    put("held_limit_s", s.heldLimit_s, usual.heldLimit_s);
    if (s.largestRate_K_s)
        j["largest_rate_K_s"] = *s.largestRate_K_s;
    if (s.jumps != usual.jumps)
        j["jumps"] = s.jumps;
    put("frozen_s", s.frozen_s, usual.frozen_s);
    put("warming_K", s.warming_K, usual.warming_K);
    put("cross_check_K", s.crossCheck_K, usual.crossCheck_K);
    put("source_heating_s", s.sourceHeating_s, usual.sourceHeating_s);
    put("source_band_K", s.sourceBand_K, usual.sourceBand_K);
    put("source_unasked_K", s.sourceUnasked_K, usual.sourceUnasked_K);
    put("least_disk_MB", s.leastDisk_MB, usual.leastDisk_MB);
    return j;
}

Json faultsJson(const std::vector<ScriptedFault>& faults) {
    Json list = Json::array();
    for (const ScriptedFault& fault : faults) {
        Json j;
        j["time_s"] = fault.time_s;
        j["fault"] = simulatedFaultName(fault.fault);
        if (isOfObject(fault.fault))
            j["object"] = fault.object;
        if (fault.until_s)
            j["until_s"] = *fault.until_s;
        list.push_back(std::move(j));
    }
    return list;
}

} // namespace bask
