#pragma once
// Checks that the source, its parts and the objects have in common: shapes and coordinates of poses.

#include "engine/model/checker.h"
#include "engine/model/experiment.h"

#include <string>

namespace bask {

/// Checks a shape and the outline that it was made from. `max_m`: greatest radius about the shape's origin.
void checkShape(Checker& check, const std::string& path, const Shape& shape, const ContourOrigin& origin,
                double max_m);

/// Checks the coordinates of a pose by coordinateRange. `path` ends with a dot.
void checkCoordinates(Checker& check, const std::string& path, const Vector6d& q, double max_cm, bool unique);

} // namespace bask
