#pragma once
// All controllers: names, gains, and how each is made. Code that runs, reads, shows or exports controllers
// uses this list.

#include "engine/base/named_values.h"
#include "engine/base/parameter.h"
#include "engine/control/controller_settings.h"

#include <functional>
#include <memory>
#include <vector>

namespace bask {

class Controller;
struct ControlModel;

/// A gain of one controller, and where the settings store it.
struct ControllerGain {
    const ParameterFacts* facts;
    std::function<double(const ControllerSettings&)> get;
    std::function<void(ControllerSettings&, double)> set;
};

struct ControllerEntry {
    ControllerKind kind;
    const char* group;       ///< group of its gains in files: "level_servo"
    const char* name;        ///< English, translation context "Controller"
    const char* help;        ///< an English sentence in the same context
    const char* description; ///< description of its law in English, for exported files
    std::vector<ControllerGain> gains;
    std::unique_ptr<Controller> (*make)(const ControllerSettings& settings, ControlModel model);
};

/// Returns a controller's own gains from the settings.
template <class Gains>
Gains gainsFrom(const ControllerSettings& settings, ParameterTable<Gains> table, const char* group) {
    const auto own = settings.own.find(group);
    return own == settings.own.end() ? Gains() : settingsFrom(table, own->second);
}

/// Returns the gains of a controller of your own: lines of a table of its own struct, whose values are in
/// ControllerSettings::own[group]. `table` must be static.
template <class Gains> std::vector<ControllerGain> ownGains(ParameterTable<Gains> table, const char* group) {
    std::vector<ControllerGain> out;
    out.reserve(table.size());
    for (const Parameter<Gains>& gain : table)
        out.push_back({&gain,
                       [&gain, table, group](const ControllerSettings& settings) {
                           return gain.get(gainsFrom(settings, table, group)).value();
                       },
                       [&gain, group](ControllerSettings& settings, double si) {
                           NamedValues& values = settings.own[group];
                           values.erase(keyOf(gain)); // a default is left out: equal gains, equal settings
                           if (si != gain.get(Gains()).value())
                               values.emplace(keyOf(gain), si);
                           if (values.empty())
                               settings.own.erase(group);
                       }});
    return out;
}

/// Returns the controllers in the order in which they are offered.
const std::vector<ControllerEntry>& controllerCatalogue();
/// Returns the entry of a kind. Throws std::invalid_argument if it is not in the catalogue.
const ControllerEntry& controllerEntry(ControllerKind kind);

} // namespace bask
