#include "engine/recording/staged_files.h"

#include "engine/base/message_code.h"
#include "engine/base/program_part.h"
#include "engine/base/replaced_files.h"

#include <atomic>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <mutex>
#include <utility>

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

namespace bask {
namespace {

namespace fs = std::filesystem;

Error unwritable(const std::string& path, const std::string& reason) {
    return {MessageCode::FileUnwritable, path, {reason}};
}

/// With the computer's name: of a shared folder only its own are looked at, since not every lock is seen from
/// elsewhere.
std::string stagePrefix() {
    return ".bask-export-" + plainFileName(hostName()) + '-';
}

int openStage(const std::string& stage) {
    return ::open(stage.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
}

bool isLocked(int stage) {
    return ::flock(stage, LOCK_EX | LOCK_NB) == 0;
}

/// A stage that can be locked was left by a process that was killed.
void removeLeft(const std::string& folder) {
    std::error_code failed;
    const std::string prefix = stagePrefix();
    for (const fs::directory_entry& entry : fs::directory_iterator(folder, failed)) {
        if (!entry.path().filename().string().starts_with(prefix))
            continue;
        const int stage = openStage(entry.path().string());
        if (stage >= 0 && isLocked(stage))
            fs::remove_all(entry.path(), failed);
        if (stage >= 0)
            ::close(stage);
    }
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

StagedFiles::StagedFiles(std::string folder, std::vector<Unfinished> made, std::string stage, int lock)
    : m_folder(std::move(folder)), m_made(std::move(made)), m_stage(std::move(stage)), m_lock(lock) {}

StagedFiles::StagedFiles(StagedFiles&& other) noexcept
    : m_folder(std::move(other.m_folder)), m_made(std::move(other.m_made)), m_stage(std::move(other.m_stage)),
      m_lock(std::exchange(other.m_lock, -1)), m_names(std::move(other.m_names)) {}

StagedFiles::~StagedFiles() {
    if (m_lock >= 0)
        ::close(m_lock);
}

Result<StagedFiles> StagedFiles::into(const std::string& folder) {
    std::error_code failed;
    auto made = makeFolders(folder, failed);
    if (failed)
        return unwritable(folder, failed.message());
    static std::atomic_int count = 0; // several may be on their way into one folder
    static std::mutex making;         // of two threads neither takes the other's for left before it is locked
    const std::string name = stagePrefix() + std::to_string(::getpid()) + '-' + std::to_string(++count);
    const std::string stage = (fs::path(folder) / name).string();
    const std::lock_guard lock(making);
    removeLeft(folder);
    if (!fs::create_directory(stage, failed))
        return unwritable(folder, failed ? failed.message() : "it is write-protected");
    const int opened = openStage(stage);
    (void)isLocked(opened); // where there are no locks nobody takes it for left
    return StagedFiles(folder, std::move(made), stage, opened);
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
