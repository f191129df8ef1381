#pragma once
// Shapes and poses as they stand in JSON files of view-factor cases, each taken as given (not moved to its
// centroid).

#include "engine/base/pose.h"
#include "engine/base/result.h"
#include "engine/shape/shape.h"

#include <nlohmann/json_fwd.hpp>

#include <string>

namespace bask {

/// {"type":"disk","radius_m"} | {"type":"fourier","coefficients":[[j,re,im],...]} |
/// {"type":"polygon","points_m":[[x,y],...]}, each with "holes_m":[[[x,y],...],...] or not. Clockwise
/// outlines are reversed; outlines that cross themselves or have no area, holes that do not fit (checkHoles)
/// and lengths beyond 1e6 m are refused. Keys that are not known are passed over. `where` starts the place
/// named in errors.
Result<Shape> shapeFromJson(const nlohmann::json& json, const std::string& where);

/// {"translation_m":[x,y,z],"rotation_vector_rad":[x,y,z]}.
Result<Pose> poseFromJson(const nlohmann::json& json, const std::string& where);

/// The value of `key`, or JsonMissingKey / JsonWrongType when `json` has none or is no object.
Result<const nlohmann::json*> memberOf(const nlohmann::json& json, const std::string& key,
                                       const std::string& where);

/// Words for what a JSON value is: "a number", "text" ...
const char* jsonTypeWords(const nlohmann::json& json);

} // namespace bask
