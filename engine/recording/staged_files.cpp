#include "engine/recording/staged_files.h"

#include "engine/base/message_code.h"
#include "engine/base/replaced_files.h"

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <utility>

#include <fcntl.h>
#include <unistd.h>

namespace bask {
namespace {

namespace fs = std::filesystem;

Error unwritable(const std::string& path, const std::string& reason) {
    return {MessageCode::FileUnwritable, path, {reason}};
}

/// What a disk without room says, which may come only now; empty when all is on the disk.
std::string synced(const std::string& path) {
    const int file = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
    if (file < 0)
        return std::strerror(errno);
    const std::string reason = ::fsync(file) == 0 ? "" : std::strerror(errno);
    ::close(file);
    return reason;
}

} // namespace

StagedFiles::StagedFiles(std::string folder, std::vector<Unfinished> made, HiddenFolder stage)
    : m_folder(std::move(folder)), m_made(std::move(made)), m_stage(std::move(stage)) {}

Result<StagedFiles> StagedFiles::into(const std::string& folder) {
    std::error_code failed;
    auto made = makeFolders(folder, failed);
    if (failed)
        return unwritable(folder, failed.message());
    auto stage = HiddenFolder::in(folder, HiddenFolder::Purpose::Export);
    if (!stage)
        return stage.error();
    return StagedFiles(folder, std::move(made), std::move(*stage));
}

Result<std::string> StagedFiles::place(const std::string& name) {
    const fs::path path = fs::path(m_stage.path()) / name;
    std::error_code failed;
    const Uninterrupted together; // not under a stage that is being deleted
    fs::create_directories(path.parent_path(), failed);
    if (failed)
        return unwritable(target(name), failed.message());
    m_names.push_back(name);
    return path.string();
}

Result<void> StagedFiles::write(const std::string& name, const std::string& contents) {
    const auto path = place(name);
    if (!path)
        return path.error();
    std::ofstream file(*path, std::ios::binary);
    file.write(contents.data(), static_cast<std::streamsize>(contents.size()));
    file.close();
    return file ? Result<void>() : unwritable(target(name), std::strerror(errno));
}

std::string StagedFiles::staged(const std::string& name) const {
    return (fs::path(m_stage.path()) / name).string();
}

std::string StagedFiles::target(const std::string& name) const {
    return (fs::path(m_folder) / name).string();
}

Result<std::vector<std::string>> StagedFiles::commit() {
    for (const std::string& name : m_names) // before the first is moved
        if (const std::string reason = synced((fs::path(m_stage.path()) / name).string()); !reason.empty())
            return unwritable(target(name), reason);
    std::error_code failed, ignored;
    const Uninterrupted together;
    for (const std::string& name : m_names) {
        const fs::path parent = fs::path(target(name)).parent_path();
        const bool isMade = fs::create_directories(parent, failed);
        if (!failed && !fs::is_directory(target(name), ignored))
            continue;
        if (isMade)
            fs::remove(parent, ignored);
        return unwritable(target(name), failed ? failed.message() : "it is a folder");
    }
    std::vector<std::string> files;
    ReplacedFiles old;
    for (const std::string& name : m_names) {
        if (auto kept = old.setAside(target(name)); !kept)
            return kept.error();
        fs::rename(fs::path(m_stage.path()) / name, target(name), failed);
        if (failed)
            return unwritable(target(name), failed.message());
        files.push_back(target(name));
    }
    old.keepNew();
    return files;
}

} // namespace bask
