#pragma once
// All controllers: names, gains, and how each is made. What runs, reads, shows or exports controllers walks
// this.

#include "engine/base/parameter.h"
#include "engine/control/controller_settings.h"

#include <functional>
#include <memory>
#include <vector>

namespace bask {

class Controller;
struct ControlModel;

/// A gain of one controller, wherever the settings keep it.
struct ControllerGain {
    const ParameterFacts* facts;
    std::function<double(const ControllerSettings&)> get;
    std::function<void(ControllerSettings&, double)> set;
};

struct ControllerEntry {
    ControllerKind kind;
    const char* key;         ///< in files: "level-servo"
    const char* group;       ///< of its gains in files: "level_servo"
    const char* name;        ///< English, context "Controller"
    const char* help;        ///< a sentence, likewise
    const char* description; ///< of its law, for exported files, English
    std::vector<ControllerGain> gains;
    std::unique_ptr<Controller> (*make)(const ControllerSettings& settings, ControlModel model);
};

/// In the order in which they are offered.
const std::vector<ControllerEntry>& controllerCatalogue();
/// Throws std::invalid_argument for a kind that is not in the catalogue.
const ControllerEntry& controllerEntry(ControllerKind kind);

} // namespace bask
