#pragma once
// A recorded run as an HDF5 file in NeXus layout (base classes, no application definition): docs/exports.md.

#include "engine/recording/session_file.h"

#include <string>

namespace bask {

/// Writes the record whole or not at all: to `folder` under the session's name with the ending ".nxs";
/// returns the file. Values that are not known are NaN. Errors: FileUnwritable; OutputForeign where another's
/// file of that name is in the way.
Result<std::string> exportNexus(const SessionRecord& session, const std::string& folder);

} // namespace bask
