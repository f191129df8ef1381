#pragma once
// Refuses a fault that a simulated device does not support.

#include "engine/base/message_code.h"
#include "engine/base/result.h"

#include <algorithm>

namespace bask {

inline Result<void> checkFault(const std::string& name, const std::vector<std::string>& known) {
    if (std::ranges::find(known, name) != known.end())
        return {};
    std::string all;
    for (const std::string& each : known)
        all += (all.empty() ? "" : ", ") + each;
    return Error{MessageCode::ValueUnknown, "fault", {name, all}};
}

} // namespace bask
