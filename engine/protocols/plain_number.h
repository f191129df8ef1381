#pragma once
// Numbers in the lines of devices.

#include <optional>
#include <string_view>

namespace bask {

/// The text between its first and last that is no blank.
std::string_view withoutBlanks(std::string_view text);
/// The whole text as a number with a decimal point, "-12.5", "+3e2"; no "nan", no "inf", nothing besides.
std::optional<double> plainNumber(std::string_view text);

} // namespace bask
