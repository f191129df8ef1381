#pragma once
// The devices of a real rig in an experiment's file, and as a file of their own.

#include "engine/base/json_fields.h"
#include "engine/model/rig_spec.h"

namespace bask {

void readRig(const nlohmann::json& j, const std::string& path, Failure& failure, RigSpec& out);
nlohmann::ordered_json rigJson(const RigSpec& rig);

} // namespace bask
