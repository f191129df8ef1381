#pragma once
// Checks a JSON text before it is parsed.

#include "engine/base/result.h"

#include <optional>
#include <string>

namespace bask {

/// Returns the first error of a JSON text: syntax, numbers out of range, repeated keys, nesting deeper
/// than 32. Empty if it has none.
std::optional<Message> checkJsonText(const std::string& text);

} // namespace bask
