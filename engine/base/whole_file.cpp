#include "engine/base/whole_file.h"

#include "engine/base/hidden_folder.h"
#include "engine/base/message_code.h"
#include "engine/base/replaced_files.h"

#include <cerrno>
#include <cstring>
#include <map>
#include <utility>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

namespace bask {
namespace {

/// Writes all bytes and waits for the disk; false with errno.
bool writeAll(int file, std::string_view bytes) {
    while (!bytes.empty()) {
        const ssize_t written = ::write(file, bytes.data(), bytes.size());
        if (written < 0 && errno == EINTR)
            continue;
        if (written < 0)
            return false;
        bytes.remove_prefix(static_cast<std::size_t>(written));
    }
    return ::fsync(file) == 0 || errno == EINVAL; // what cannot wait
}

/// A file that is written, but not in its place yet.
struct Staged {
    std::string part, target;
};

Result<Staged> stage(const std::string& path, std::string_view bytes, const HiddenFolder& hidden,
                     const std::string& name) {
    const Staged staged{hidden.place(name), behindLinks(path)};
    const auto unwritable = [&](int reason) {
        return Error(MessageCode::FileUnwritable, path, {std::strerror(reason)});
    };
    struct stat old {};
    const bool isThere = ::stat(staged.target.c_str(), &old) == 0;
    if (isThere && S_ISDIR(old.st_mode))
        return unwritable(EISDIR);
    if (isThere && ::access(staged.target.c_str(), W_OK) != 0)
        return unwritable(errno);
    const int file = ::open(staged.part.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    if (file < 0)
        return unwritable(errno);
    int failed = 0;
    if (!writeAll(file, bytes) || (isThere && ::fchmod(file, old.st_mode & 07777U) != 0))
        failed = errno;
    if (::close(file) != 0 && failed == 0)
        failed = errno;
    return failed == 0 ? Result<Staged>(staged) : unwritable(failed);
}

Result<void> putInPlace(const Staged& staged, const std::string& path) {
    return ::rename(staged.part.c_str(), staged.target.c_str()) == 0
               ? Result<void>()
               : Error(MessageCode::FileUnwritable, path, {std::strerror(errno)});
}

Result<HiddenFolder> hiddenBeside(const std::string& path) {
    auto hidden = HiddenFolder::in(folderOfFile(behindLinks(path)));
    return hidden
               ? std::move(hidden)
               : Result<HiddenFolder>(Error(MessageCode::FileUnwritable, path, hidden.error().message.args));
}

} // namespace

Result<void> writeWholeFile(const std::string& path, std::string_view bytes) {
    auto hidden = hiddenBeside(path);
    if (!hidden)
        return hidden.error();
    const auto staged = stage(path, bytes, *hidden, "0");
    return staged ? putInPlace(*staged, path) : staged.error();
}

Result<void> writeWholeFiles(const std::vector<WholeFile>& files) {
    std::map<std::string, HiddenFolder> folders; // by the folder that they are in
    std::vector<Staged> staged;
    for (const WholeFile& file : files) {
        const std::string folder = folderOfFile(behindLinks(file.path));
        auto hidden = folders.find(folder);
        if (hidden == folders.end()) {
            auto made = hiddenBeside(file.path);
            if (!made)
                return made.error();
            hidden = folders.emplace(folder, std::move(*made)).first;
        }
        auto part = stage(file.path, file.bytes, hidden->second, std::to_string(staged.size()));
        if (!part)
            return part.error();
        staged.push_back(std::move(*part));
    }
    ReplacedFiles replaced;
    for (std::size_t k = 0; k < files.size(); ++k) {
        auto done = replaced.setAside(staged[k].target);
        if (done)
            done = putInPlace(staged[k], files[k].path);
        if (!done)
            return done;
    }
    replaced.keepNew();
    return {};
}

} // namespace bask
