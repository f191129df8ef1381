#include "engine/recording/zeroing_record.h"

#include <nlohmann/json.hpp>

#include <algorithm>

namespace bask {

std::vector<double> zeroOffsets_K(const SessionRecord& facts) {
    const auto arm = std::ranges::find(facts.commands, "arm", &CommandRow::name);
    if (arm == facts.commands.end())
        return {};
    const auto value = nlohmann::json::parse(arm->value, nullptr, false);
    if (!value.is_object() || !value.contains("offsets_K") || !value["offsets_K"].is_array())
        return {};
    std::vector<double> offsets_K;
    for (const auto& offset : value["offsets_K"]) {
        if (!offset.is_number())
            return {};
        offsets_K.push_back(offset.get<double>());
    }
    return offsets_K;
}

} // namespace bask
