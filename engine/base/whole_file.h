#pragma once
// Writes files completely or not at all.

#include "engine/base/result.h"

#include <string>
#include <string_view>
#include <vector>

namespace bask {

/// The old file remains until the new one is complete and on the disk. What is left of it when a signal ends
/// the program is deleted; after a kill the next one that writes there clears it. Through a link the file
/// behind it is replaced. Errors: FileUnwritable.
Result<void> writeWholeFile(const std::string& path, std::string_view bytes);

struct WholeFile {
    std::string path;
    std::string bytes;
};
/// The same for several files together: all are replaced, or none if one cannot be written or a signal comes.
/// Each path is another file.
Result<void> writeWholeFiles(const std::vector<WholeFile>& files);

} // namespace bask
