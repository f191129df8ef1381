#include "engine/recording/staged_files.h"

#include "engine/base/message_code.h"
#include "engine/base/replaced_files.h"

#include <atomic>
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

StagedFiles::StagedFiles(std::string folder, std::string stage, bool isNew)
    : m_folder(std::move(folder)), m_stage(std::move(stage)), m_isNew(isNew) {}

StagedFiles::StagedFiles(StagedFiles&& other) noexcept
    : m_folder(std::move(other.m_folder)), m_stage(std::exchange(other.m_stage, {})), m_isNew(other.m_isNew),
      m_names(std::move(other.m_names)) {}

StagedFiles::~StagedFiles() {
    if (m_stage.empty())
        return;
    std::error_code failed;
    fs::remove_all(m_stage, failed);
    if (m_isNew)
        fs::remove(m_folder, failed); // only if it is empty
}

Result<StagedFiles> StagedFiles::into(const std::string& folder) {
    std::error_code failed;
    const bool isNew = !fs::exists(folder, failed);
    fs::create_directories(folder, failed);
    if (failed || !fs::is_directory(folder, failed))
        return unwritable(folder, failed ? failed.message() : "it is no folder");
    static std::atomic_int count = 0; // several may be on their way into one folder
    const std::string name = ".bask-export-" + std::to_string(::getpid()) + '-' + std::to_string(++count);
    const std::string stage = (fs::path(folder) / name).string();
    fs::remove_all(stage, failed); // of a killed process with this number
    if (!fs::create_directory(stage, failed))
        return unwritable(folder, failed ? failed.message() : "it is write-protected");
    return StagedFiles(folder, stage, isNew);
}

Result<std::string> StagedFiles::place(const std::string& name) {
    const fs::path path = fs::path(m_stage) / name;
    std::error_code failed;
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
    return (fs::path(m_stage) / name).string();
}

std::string StagedFiles::target(const std::string& name) const {
    return (fs::path(m_folder) / name).string();
}

Result<std::vector<std::string>> StagedFiles::commit() {
    for (const std::string& name : m_names) // before the first is moved
        if (const std::string reason = synced((fs::path(m_stage) / name).string()); !reason.empty())
            return unwritable(target(name), reason);
    std::error_code failed, ignored;
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
        fs::rename(fs::path(m_stage) / name, target(name), failed);
        if (failed)
            return unwritable(target(name), failed.message());
        files.push_back(target(name));
    }
    old.keepNew();
    return files;
}

std::string plainFileName(const std::string& name) {
    std::string out;
    for (const char c : name) {
        const bool isPlain =
            (c >= '0' && c <= '9') || (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z') || c == '-';
        out += isPlain ? c : '_';
    }
    return out;
}

} // namespace bask
