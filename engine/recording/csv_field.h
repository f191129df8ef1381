#pragma once
// A text as a field of a CSV file.

#include <string>

namespace bask {

/// Returns the text by RFC 4180: quoted if it holds a comma, a quote or a line break. What a spreadsheet
/// would take for a formula gets a ' before it.
std::string csvField(const std::string& text);

} // namespace bask
