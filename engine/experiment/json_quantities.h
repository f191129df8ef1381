#pragma once
// Quantities and coordinates as an experiment file has them.

#include "engine/base/edge_units.h"
#include "engine/base/pose.h"

#include <nlohmann/json_fwd.hpp>

namespace bask {

/// In the readable unit where that gives back the very same number, else in SI.
void putQuantity(nlohmann::ordered_json& j, std::string_view name, EdgeUnit unit, double si);
/// All six.
nlohmann::ordered_json coordinatesJson(const Vector6d& q);

} // namespace bask
