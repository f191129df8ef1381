#include "engine/base/replaced_files.h"

#include "engine/base/message_code.h"

#include <algorithm>
#include <filesystem>

namespace bask {

namespace fs = std::filesystem;

Result<void> ReplacedFiles::setAside(const std::string& path) {
    std::error_code failed;
    if (std::ranges::any_of(m_places, [&](const Place& known) { return known.path == path; }))
        return {}; // what is there now is new
    Place place{path, {}};
    if (fs::exists(fs::symlink_status(path, failed))) {
        const std::string folder = folderOfFile(path);
        auto hidden = m_hidden.find(folder);
        if (hidden == m_hidden.end()) {
            auto made = HiddenFolder::in(folder, HiddenFolder::Purpose::Old);
            if (!made)
                return Error(MessageCode::FileUnwritable, path, made.error().message.args);
            hidden = m_hidden.emplace(folder, std::move(*made)).first;
        }
        place.old = hidden->second.place(fs::path(path).filename().string());
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
    m_places.clear();
    m_hidden.clear();
}

ReplacedFiles::~ReplacedFiles() {
    std::error_code ignored;
    // Not a range view: clang 14, which builds the fuzzers, cannot compile libstdc++'s.
    for (auto place = m_places.rbegin(); place != m_places.rend(); ++place) {
        if (!place->old.empty())
            fs::rename(place->old, place->path, ignored); // nothing is done where both are the same file
        else
            fs::remove(place->path, ignored);
    }
}

} // namespace bask
