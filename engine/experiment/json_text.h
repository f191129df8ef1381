#pragma once
// A look at a JSON text before a tree is built of it.

#include "engine/base/result.h"

#include <optional>
#include <string>

namespace bask {

/// What is wrong with a text as JSON: syntax, numbers out of reach, repeated keys, nesting deeper than 32.
/// Empty: nothing.
std::optional<Message> checkJsonText(const std::string& text);

} // namespace bask
