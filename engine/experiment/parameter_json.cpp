#include "engine/experiment/parameter_json.h"

#include <nlohmann/json.hpp>

namespace bask {

std::optional<double> readParameter(Fields& fields, const ParameterFacts& facts, bool isWhole) {
    const std::string key = keyOf(facts);
    const bool isInSi = facts.unit.edge && fields.find(siKey(facts.name, *facts.unit.edge)) != nullptr;
    if (fields.find(key, facts.isRequired && !isInSi) == nullptr && !isInSi)
        return std::nullopt;
    double si = 0.0;
    if (facts.unit.edge) {
        fields.read(facts.name, *facts.unit.edge, si);
    } else if (isWhole) {
        int whole = 0;
        fields.read(key, whole);
        si = whole;
    } else {
        fields.read(key, si);
    }
    return si;
}

void putParameter(nlohmann::ordered_json& j, const ParameterFacts& facts, double si, bool isWhole) {
    if (facts.unit.edge)
        putQuantity(j, facts.name, *facts.unit.edge, si);
    else if (isWhole)
        j[keyOf(facts)] = static_cast<int>(si);
    else
        j[keyOf(facts)] = si;
}

} // namespace bask
