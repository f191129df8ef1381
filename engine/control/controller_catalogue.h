#pragma once
// All controllers: names, gains, and how each is made. Code that runs, reads, shows or exports controllers
// uses this list.

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
    const char* key;         ///< in files: "level-servo"
    const char* group;       ///< group of its gains in files: "level_servo"
    const char* name;        ///< English, translation context "Controller"
    const char* help;        ///< an English sentence in the same context
    const char* description; ///< description of its law in English, for exported files
    std::vector<ControllerGain> gains;
    std::unique_ptr<Controller> (*make)(const ControllerSettings& settings, ControlModel model);
};

/// Returns the controllers in the order in which they are offered.
const std::vector<ControllerEntry>& controllerCatalogue();
/// Returns the entry of a kind. Throws std::invalid_argument if it is not in the catalogue.
const ControllerEntry& controllerEntry(ControllerKind kind);

} // namespace bask
