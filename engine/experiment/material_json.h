#pragma once
// A material as the fields of a JSON object: those of an experiment's object, which a library has too.

#include "engine/base/json_fields.h"
#include "engine/thermal/heat_balance.h"

#include <nlohmann/json_fwd.hpp>

namespace bask {

/// Reads name, values, their uncertainties, source and date; what is missing stays, and values that are
/// required are failures.
void readMaterialFields(Fields& fields, Material& out);
/// Leaves out name, uncertainties, source and date where they are empty.
nlohmann::ordered_json materialJson(const Material& material);

} // namespace bask
