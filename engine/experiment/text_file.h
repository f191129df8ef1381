#pragma once
// Writes a text file completely or not at all.

#include "engine/base/whole_file.h"

#include <string>

namespace bask {

/// As writeWholeFile(). Errors: FileUnwritable.
inline Result<void> writeTextFile(const std::string& path, const std::string& text) {
    return writeWholeFile(path, text);
}

} // namespace bask
