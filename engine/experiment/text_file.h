#pragma once
// Writes a text file completely or not at all.

#include "engine/base/result.h"

#include <string>

namespace bask {

/// The old file remains until the new one is complete. Errors: FileUnwritable.
Result<void> writeTextFile(const std::string& path, const std::string& text);

} // namespace bask
