#pragma once
// Helpers that the outline readers share: reading a whole file with size checks, and trimming lines.

#include "engine/base/result.h"

#include <cstdint>
#include <string>
#include <string_view>

namespace bask {

/// Reads all bytes of an ordinary file. Errors: FileNotFound, FileUnreadable (folder, device, permission),
/// FileEmpty, FileTooLarge (larger than `limit_bytes`).
Result<std::string> readFileBytes(const std::string& path, std::uintmax_t limit_bytes);

/// Returns the text without spaces, tabs and carriage returns at both ends.
std::string_view trimmed(std::string_view text);

} // namespace bask
