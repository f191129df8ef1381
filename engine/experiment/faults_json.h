#pragma once
// Scripted faults of the simulated rig in an experiment's file.

#include "engine/base/json_fields.h"
#include "engine/model/safety_spec.h"

namespace bask {

/// Reads an array under `key`.
void readFaults(Fields& parent, const std::string& key, std::vector<ScriptedFault>& out);
nlohmann::ordered_json faultsJson(const std::vector<ScriptedFault>& faults);

} // namespace bask
