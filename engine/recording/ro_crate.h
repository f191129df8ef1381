#pragma once
// RO-Crate metadata of an export folder: which files these are, of what run, made by what, and their SHA-256
// (https://w3id.org/ro/crate/1.1), so that a folder explains itself in an archive.

#include "engine/recording/session_file.h"
#include "engine/recording/staged_files.h"

#include <string>

namespace bask {

inline constexpr const char* kCrateName = "ro-crate-metadata.json";

/// Adds the metadata of the staged files; what an earlier export said of other files in the folder stays, if
/// it is of the same session. Call it before commit(). Errors: FileUnwritable; ExportForeign for a file of
/// that name that is no crate.
Result<void> addCrate(StagedFiles& files, const SessionRecord& session);

} // namespace bask
