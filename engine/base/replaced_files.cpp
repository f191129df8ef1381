#include "engine/base/replaced_files.h"

#include "engine/base/message_code.h"

#include <atomic>
#include <filesystem>

#include <unistd.h>

namespace bask {

namespace fs = std::filesystem;

Result<void> ReplacedFiles::setAside(const std::string& path) {
    static std::atomic_int count = 0;
    std::error_code failed;
    Place place{path, {}};
    if (fs::exists(fs::symlink_status(path, failed))) {
        const std::string name = ".bask-old-" + std::to_string(::getpid()) + '-' + std::to_string(++count);
        place.old = (fs::path(path).parent_path() / name).string();
        fs::remove(place.old, failed); // of a killed process with this number
        fs::create_hard_link(path, place.old, failed);
        if (failed) // a file system without links
            fs::copy(path, place.old, fs::copy_options::copy_symlinks, failed);
        if (failed)
            return Error(MessageCode::FileUnwritable, path, {failed.message()});
    }
    m_places.push_back(std::move(place));
    return {};
}

void ReplacedFiles::keepNew() {
    std::error_code ignored;
    for (const Place& place : m_places)
        if (!place.old.empty())
            fs::remove(place.old, ignored);
    m_places.clear();
}

ReplacedFiles::~ReplacedFiles() {
    std::error_code ignored;
    // Not a range view: clang 14, which builds the fuzzers, cannot compile libstdc++'s.
    for (auto place = m_places.rbegin(); place != m_places.rend(); ++place) {
        if (!place->old.empty())
            fs::rename(place->old, place->path, ignored); // nothing is done where both are the same file
        fs::remove(place->old.empty() ? place->path : place->old, ignored);
    }
}

} // namespace bask
