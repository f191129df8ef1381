#pragma once
// Reads a whole file into memory with the refusals that every contour reader shares.

#include "engine/base/result.h"

#include <cstdint>
#include <string>

namespace bask {

/// Bytes of an ordinary file. Errors: FileNotFound, FileUnreadable (folder, device, permission), FileEmpty,
/// FileTooLarge (above `limit_bytes`).
Result<std::string> readFileBytes(const std::string& path, std::uintmax_t limit_bytes);

} // namespace bask
