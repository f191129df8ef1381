#pragma once
// Values of a table of parameters kept by their names, where only the table's owner knows their struct.

#include "engine/base/parameter.h"

#include <map>
#include <string>

namespace bask {

/// In SI, by the key in files: "emittance". One that is not there is as by default.
using NamedValues = std::map<std::string, double>;

/// The struct of these values.
template <class Settings> Settings settingsFrom(ParameterTable<Settings> table, const NamedValues& values) {
    Settings out;
    for (const Parameter<Settings>& parameter : table)
        if (const auto it = values.find(keyOf(parameter)); it != values.end())
            parameter.set(out, it->second);
    return out;
}

} // namespace bask
