#pragma once
// Writes a text file whole or not at all.

#include "engine/base/result.h"

#include <string>

namespace bask {

/// Until the new file is whole, the one of before stays. Errors: FileUnwritable.
Result<void> writeTextFile(const std::string& path, const std::string& text);

} // namespace bask
