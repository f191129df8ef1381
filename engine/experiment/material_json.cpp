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
    readPart(fields, "uncertainty", false, [&](const nlohmann::json& part, const std::string& where) {
        Fields uncertainty(part, where, fields.failure());
        for (const Parameter<Material>& value : materialParameters()) {
            ParameterFacts facts = value;
            facts.isRequired = false;
            if (const auto si = readParameter(uncertainty, facts, false))
                out.uncertainties[value.name] = *si;
        }
        uncertainty.close();
    });
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
    for (const Parameter<Material>& value : materialParameters())
        if (const auto found = material.uncertainties.find(value.name); found != material.uncertainties.end())
            putParameter(j["uncertainty"], value, found->second, false);
    return j;
}

} // namespace bask
