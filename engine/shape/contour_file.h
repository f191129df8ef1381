#pragma once
// What the readers of outlines share: a whole file in memory with its refusals, and lines without blanks.

#include "engine/base/result.h"

#include <cstdint>
#include <string>
#include <string_view>

namespace bask {

/// Bytes of an ordinary file. Errors: FileNotFound, FileUnreadable (folder, device, permission), FileEmpty,
/// FileTooLarge (above `limit_bytes`).
Result<std::string> readFileBytes(const std::string& path, std::uintmax_t limit_bytes);

/// Without spaces, tabs and carriage returns at both ends.
std::string_view trimmed(std::string_view text);

} // namespace bask
