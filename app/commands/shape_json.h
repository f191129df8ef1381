#pragma once
// Shapes and poses as they stand in JSON files of view-factor cases, each taken as given (not moved to its
// centroid). Keys that are not known are ignored.

#include "engine/base/json_text.h"
#include "engine/base/pose.h"
#include "engine/shape/shape.h"

#include <string>

namespace bask {

/// {"type":"disk","radius_m"} | {"type":"fourier","coefficients":[[j,re,im],...]} |
/// {"type":"polygon","points_m":[[x,y],...]}, each with "holes_m":[[[x,y],...],...] or not. Clockwise
/// outlines are reversed; outlines that cross themselves or have no area, holes that do not fit (checkHoles)
/// and lengths beyond 1e6 m are refused.
Shape readCaseShape(const nlohmann::json& json, const std::string& path, Failure& failure);

/// {"translation_m":[x,y,z],"rotation_vector_rad":[x,y,z]}.
Pose readCasePose(const nlohmann::json& json, const std::string& path, Failure& failure);

} // namespace bask
