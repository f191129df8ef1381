#pragma once
// Values of a parameter table stored by name, for code that does not know the struct they belong to.

#include "engine/base/parameter.h"

#include <map>
#include <string>

namespace bask {

/// Values in SI by their key in files ("emittance"). A value that is missing has its default.
using NamedValues = std::map<std::string, double>;

/// Returns the struct with these values.
template <class Settings> Settings settingsFrom(ParameterTable<Settings> table, const NamedValues& values) {
    Settings out;
    for (const Parameter<Settings>& parameter : table)
        if (const auto it = values.find(keyOf(parameter)); it != values.end())
            parameter.set(out, it->second);
    return out;
}

} // namespace bask
