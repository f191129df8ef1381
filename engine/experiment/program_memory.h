#pragma once
// The programs that a person has confirmed on this computer, as a file.

#include "engine/base/result.h"

#include <map>
#include <string>

namespace bask {

/// Commands by their fingerprints, see programFiles().
using ProgramMemory = std::map<std::string, std::string>;

/// Reads "format": "bask-programs", "version": 1. A missing file is an empty memory.
Result<ProgramMemory> readProgramMemory(const std::string& path);
/// Writes the whole memory or leaves the old file.
Result<void> writeProgramMemory(const ProgramMemory& memory, const std::string& path);

} // namespace bask
