#pragma once
// Safety limits and scripted faults in an experiment's file.

#include "engine/session/json_fields.h"
#include "engine/session/safety_spec.h"

namespace bask {

void readSafety(const nlohmann::json& j, const std::string& path, Failure& failure, SafetySpec& out);
/// An object's own limits, which may be left out.
void readLimits(Fields& fields, std::optional<double>& warning_K, std::optional<double>& trip_K);
void putLimits(nlohmann::ordered_json& j, const std::optional<double>& warning_K,
               const std::optional<double>& trip_K);
/// An array under `key`.
void readFaults(Fields& parent, const std::string& key, std::vector<ScriptedFault>& out);

/// What differs from the defaults.
nlohmann::ordered_json safetyJson(const SafetySpec& safety);
nlohmann::ordered_json faultsJson(const std::vector<ScriptedFault>& faults);

} // namespace bask
