#include "engine/experiment/material_json.h"

#include "engine/experiment/parameter_json.h"
#include "engine/model/experiment_parameters.h"

#include <nlohmann/json.hpp>

namespace bask {

void readMaterialFields(Fields& fields, Material& out) {
    fields.read("name", out.name);
    readParameters(fields, materialParameters(), out);
    fields.read("source", out.source);
    fields.read("date", out.date);
}

nlohmann::ordered_json materialJson(const Material& material) {
    nlohmann::ordered_json j;
    if (!material.name.empty())
        j["name"] = material.name;
    putParameters(j, materialParameters(), material);
    if (!material.source.empty())
        j["source"] = material.source;
    if (!material.date.empty())
        j["date"] = material.date;
    return j;
}

} // namespace bask
