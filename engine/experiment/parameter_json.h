#pragma once
// Tables of parameters as the fields of a JSON object.

#include "engine/base/json_fields.h"
#include "engine/base/parameter.h"
#include "engine/experiment/json_quantities.h"

#include <nlohmann/json_fwd.hpp>

namespace bask {

/// Reads a parameter; a missing one is empty, which is a failure if it is required.
std::optional<double> readParameter(Fields& fields, const ParameterFacts& facts, bool isWhole);
void putParameter(nlohmann::ordered_json& j, const ParameterFacts& facts, double si, bool isWhole);

/// Reads all parameters of a table; missing ones are unchanged, and required ones that are missing are
/// failures of `fields`.
template <class Spec> void readParameters(Fields& fields, ParameterTable<Spec> table, Spec& out) {
    for (const Parameter<Spec>& parameter : table)
        if (const auto si = readParameter(fields, parameter, parameter.isWhole()))
            parameter.set(out, *si);
}
template <class Spec>
void readParameters(const nlohmann::json& j, const std::string& path, Failure& failure,
                    ParameterTable<Spec> table, Spec& out) {
    Fields fields(j, path, failure);
    readParameters(fields, table, out);
    fields.close();
}

/// Writes all parameters of a table, except optional ones that are not set.
template <class Spec>
void putParameters(nlohmann::ordered_json& j, ParameterTable<Spec> table, const Spec& spec) {
    for (const Parameter<Spec>& parameter : table)
        if (const auto si = parameter.get(spec))
            putParameter(j, parameter, *si, parameter.isWhole());
}
/// Also leaves out parameters that have their default.
template <class Spec>
void putChangedParameters(nlohmann::ordered_json& j, ParameterTable<Spec> table, const Spec& spec) {
    for (const Parameter<Spec>& parameter : table)
        if (const auto si = parameter.get(spec); si && si != parameter.get(Spec()))
            putParameter(j, parameter, *si, parameter.isWhole());
}

} // namespace bask
