#pragma once
// Replaces several files together: either all are replaced or none.

#include "engine/base/result.h"

#include <string>
#include <vector>

namespace bask {

/// Restores the old files and removes the new ones when it is destroyed, unless keepNew() was called.
/// Symbolic links are not followed.
class ReplacedFiles {
public:
    ReplacedFiles() = default;
    ~ReplacedFiles();
    ReplacedFiles(const ReplacedFiles&) = delete;
    ReplacedFiles& operator=(const ReplacedFiles&) = delete;

    /// Call before a new file is written to `path`: keeps a copy of the old file beside it. Error:
    /// FileUnwritable.
    Result<void> setAside(const std::string& path);
    /// Call when all new files are written: keeps them.
    void keepNew();

private:
    struct Place {
        std::string path;
        std::string old; ///< empty if there was no file before
    };
    std::vector<Place> m_places;
};

} // namespace bask
