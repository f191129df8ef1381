#pragma once
// Files that take the places of older ones, all or none of them.

#include "engine/base/result.h"

#include <string>
#include <vector>

namespace bask {

/// Unless it is told that all went well, what was in the places comes back when this ends, and what is new
/// there goes. Links are not followed.
class ReplacedFiles {
public:
    ReplacedFiles() = default;
    ~ReplacedFiles();
    ReplacedFiles(const ReplacedFiles&) = delete;
    ReplacedFiles& operator=(const ReplacedFiles&) = delete;

    /// Before a file takes this place: what is there also stays beside it. Error: FileUnwritable.
    Result<void> setAside(const std::string& path);
    /// All are in their places.
    void keepNew();

private:
    struct Place {
        std::string path;
        std::string old; ///< empty: nothing was there
    };
    std::vector<Place> m_places;
};

} // namespace bask
