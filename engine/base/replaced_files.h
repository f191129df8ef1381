#pragma once
// Replaces several files together: either all are replaced or none.

#include "engine/base/hidden_folder.h"
#include "engine/base/result.h"
#include "engine/base/unfinished.h"

#include <map>
#include <string>
#include <vector>

namespace bask {

/// Restores the old files and removes the new ones when it is destroyed, unless keepNew() was called. A
/// signal that ends the program waits meanwhile; after a kill the old files that are missing go back to their
/// places when something is next written there. Symbolic links are not followed.
class ReplacedFiles {
public:
    ReplacedFiles() = default;
    ~ReplacedFiles();
    ReplacedFiles(const ReplacedFiles&) = delete;
    ReplacedFiles& operator=(const ReplacedFiles&) = delete;

    /// Call before a new file is written to `path`: keeps a copy of the old file in a hidden folder beside
    /// it. Error: FileUnwritable.
    Result<void> setAside(const std::string& path);
    /// Call when all new files are written: keeps them.
    void keepNew();

private:
    struct Place {
        std::string path;
        std::string old; ///< empty if there was no file before
    };
    Uninterrupted m_together;
    std::map<std::string, HiddenFolder> m_hidden; ///< by the folder that they are in
    std::vector<Place> m_places;
};

} // namespace bask
