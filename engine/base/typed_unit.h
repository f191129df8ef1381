#pragma once
// Units as people type them beside a number, and what a value is in another unit of the same dimension.

#include "engine/base/units.h"

#include <optional>
#include <string_view>

namespace bask {

/// Returns a value of the unit `from` in the unit `to`: 1.5 for 15 "mm" in "cm". Units are products of those
/// that Bask shows, in UTF-8 or in ASCII: "mm/s\u00b2", "mm/s2", "W/(m\u00b2 K)", "\u00b0", "deg", "%"; after
/// a "/", what follows a space or a point may be below it: "W/m2 K" is in "W/(m\u00b2 K)". An
/// empty one is that of a plain number. "\u00b0C" and "\u00b0F" are those of differences. Empty if a unit is
/// not known or their dimensions differ.
std::optional<double> converted(double value, std::string_view from, std::string_view to);

/// Returns the unit of a temperature on a scale: "\u00b0C", "degC" or "C", and so on; empty if it is another
/// one.
std::optional<TemperatureUnit> typedTemperatureUnit(std::string_view text);

} // namespace bask
