#pragma once
// A controller and its gains as in an experiment's JSON.

#include "engine/control/controller_settings.h"

#include <string>

namespace bask {

std::string controllerToJson(const ControllerSettings& settings);

} // namespace bask
