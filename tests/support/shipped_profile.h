#pragma once
// The profiles of Modbus devices that come with Bask, by name.

#include "engine/protocols/modbus_profile.h"

#include <algorithm>
#include <stdexcept>
#include <string>
#include <string_view>

namespace bask::test {

/// Throws std::out_of_range for a name that none has.
inline const ModbusProfile& shipped(std::string_view name) {
    const auto& all = shippedProfiles();
    const auto found = std::ranges::find(all, name, &ModbusProfile::name);
    if (found == all.end())
        throw std::out_of_range(std::string(name));
    return *found;
}

} // namespace bask::test
