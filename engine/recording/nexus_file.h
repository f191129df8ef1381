#pragma once
// A recorded run as an HDF5 file in NeXus layout (base classes, no application definition): docs/exports.md.

#include "engine/base/share_done.h"
#include "engine/recording/session_file.h"

#include <string>

namespace bask {

/// Returns the session's name with the ending ".nxs".
std::string nexusName(const std::string& session);

/// Refuses a file that is there, not empty and not of exportNexus. Error: OutputForeign.
Result<void> checkNexus(const std::string& path);

/// Writes the whole record or nothing to `folder`, under `name`, else under nexusName(); returns the path.
/// Unknown values are NaN. Recorded pictures of the thermal camera are read from the session's file one by
/// one and written with it. Errors: FileUnwritable; OutputForeign if a file of another program has that name;
/// those of the session's file and of its pictures.
Result<std::string> exportNexus(const SessionRecord& session, const std::string& folder,
                                const ShareDone& done = {}, const std::string& name = {});

} // namespace bask
