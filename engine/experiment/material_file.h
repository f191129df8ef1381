#pragma once
// A library of materials as a JSON file that labs share, see docs/experiment-format.md.

#include "engine/model/material_library.h"

#include <string>

namespace bask {

/// Reads "format": "bask-materials", "version": 1. A missing file is an error, FileNotFound. Refuses more
/// than 4 MiB, unknown keys and what validate() refuses.
Result<MaterialLibrary> readMaterialLibrary(const std::string& path);
/// Writes the whole library or leaves the old file. Refuses what could not be read again. Errors:
/// FileUnwritable, FileTooLarge, those of validate().
Result<void> writeMaterialLibrary(const MaterialLibrary& library, const std::string& path);

} // namespace bask
