#pragma once
// Numbers in the lines of devices.

#include <optional>
#include <string_view>

namespace bask {

/// Returns the text without blanks at both ends.
std::string_view withoutBlanks(std::string_view text);
/// Parses the whole text as a number with a decimal point, "-12.5", "+3e2"; refuses "nan", "inf" and anything
/// else.
std::optional<double> plainNumber(std::string_view text);

} // namespace bask
