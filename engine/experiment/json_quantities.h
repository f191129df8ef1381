#pragma once
// Quantities and coordinates as an experiment file has them.

#include "engine/base/edge_units.h"
#include "engine/base/pose.h"

#include <nlohmann/json_fwd.hpp>

namespace bask {

/// Writes the readable unit if it gives back exactly the same number, else SI.
void putQuantity(nlohmann::ordered_json& j, std::string_view name, EdgeUnit unit, double si);
/// Returns all six coordinates.
nlohmann::ordered_json coordinatesJson(const Vector6d& q);

} // namespace bask
