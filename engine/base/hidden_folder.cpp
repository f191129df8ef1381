#include "engine/base/hidden_folder.h"

#include "engine/base/message_code.h"
#include "engine/base/plain_text.h"
#include "engine/base/program_part.h"

#include <array>
#include <atomic>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <mutex>
#include <set>
#include <system_error>
#include <utility>

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

namespace bask {
namespace {

namespace fs = std::filesystem;

constexpr mode_t kOwnOnly = 0700; // what is finished is moved out of it
constexpr std::array kPurposes{"part", "export", "old"};

/// With the computer's name: of a shared folder only its own are looked at, since not every lock is seen from
/// elsewhere.
std::string prefixOf(HiddenFolder::Purpose purpose) {
    static const std::string kHost = plainFileName(hostName());
    return std::string(".bask-") + kPurposes[static_cast<std::size_t>(purpose)] + '-' + kHost + '-';
}

/// -1 if it cannot be; no link is followed.
int openFolder(const std::string& path) {
    return ::open(path.c_str(), O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC);
}

enum class Lock { Had, Taken, None };

/// `None` where there are no locks.
Lock lockOf(int folder) {
    if (::flock(folder, LOCK_EX | LOCK_NB) == 0)
        return Lock::Had;
    return errno == EWOULDBLOCK ? Lock::Taken : Lock::None;
}

bool isOwn(int folder) {
    struct stat info {};
    return ::fstat(folder, &info) == 0 && info.st_uid == ::geteuid();
}

/// Whether the path still is the folder that is open: it may have been taken for left before it was locked.
bool isThere(const std::string& path, int folder) {
    struct stat opened {
    }, named{};
    return ::fstat(folder, &opened) == 0 && ::lstat(path.c_str(), &named) == 0 &&
           opened.st_ino == named.st_ino && opened.st_dev == named.st_dev;
}

void putBack(const fs::path& left, const fs::path& folder) {
    std::error_code failed;
    for (const fs::directory_entry& old : fs::directory_iterator(left, failed)) {
        const fs::path place = folder / old.path().filename();
        if (!fs::exists(fs::symlink_status(place, failed)))
            fs::rename(old.path(), place, failed);
    }
}

void clearOnce(const std::string& folder) {
    static std::mutex mutex;
    static std::set<std::string> cleared;
    std::error_code failed;
    const std::string path = fs::canonical(folder, failed).string();
    {
        const std::lock_guard lock(mutex);
        if (!cleared.insert(path).second)
            return;
    }
    clearLeft(folder);
}

} // namespace

void clearLeft(const std::string& folder) {
    std::error_code failed;
    for (fs::directory_iterator entry(folder, failed), end; !failed && entry != end;
         entry.increment(failed)) {
        const std::string name = entry->path().filename().string();
        const bool isOld = name.starts_with(prefixOf(HiddenFolder::Purpose::Old));
        if (!isOld && !name.starts_with(prefixOf(HiddenFolder::Purpose::Part)) &&
            !name.starts_with(prefixOf(HiddenFolder::Purpose::Export)))
            continue;
        const int left = openFolder(entry->path().string());
        if (left >= 0 && isOwn(left) && lockOf(left) == Lock::Had) {
            std::error_code ignored;
            if (isOld)
                putBack(entry->path(), folder);
            fs::remove_all(entry->path(), ignored);
        }
        if (left >= 0)
            ::close(left);
    }
}

HiddenFolder::HiddenFolder(std::string path, Purpose purpose, int lock)
    : m_path(std::move(path)), m_lock(lock) {
    if (purpose != Purpose::Old)
        m_unfinished.emplace(m_path);
}

HiddenFolder::HiddenFolder(HiddenFolder&& other) noexcept
    : m_path(std::exchange(other.m_path, {})), m_lock(std::exchange(other.m_lock, -1)),
      m_unfinished(std::move(other.m_unfinished)) {}

HiddenFolder::~HiddenFolder() {
    if (m_path.empty())
        return;
    std::error_code ignored;
    if (!m_unfinished)
        fs::remove_all(m_path, ignored);
    m_unfinished.reset();
    if (m_lock >= 0)
        ::close(m_lock);
}

Result<HiddenFolder> HiddenFolder::in(const std::string& folder, Purpose purpose) {
    constexpr int kTries = 100;
    static std::atomic_int count = 0;
    clearOnce(folder);
    for (int k = 0; k < kTries; ++k) {
        const std::string path = (fs::path(folder) / (prefixOf(purpose) + std::to_string(::getpid()) + '-' +
                                                      std::to_string(++count)))
                                     .string();
        if (::mkdir(path.c_str(), kOwnOnly) != 0) {
            if (errno == EEXIST) // of another computer of this name, or of a process of this number
                continue;
            return Error(MessageCode::FileUnwritable, folder, {std::strerror(errno)});
        }
        const int opened = openFolder(path);
        // Who looks for what is left may have been quicker; where there are no locks nobody is.
        if (opened >= 0 && lockOf(opened) != Lock::Taken && isThere(path, opened))
            return HiddenFolder(path, purpose, opened);
        if (opened >= 0)
            ::close(opened);
    }
    return Error(MessageCode::FileUnwritable, folder, {std::strerror(EEXIST)});
}

Result<HiddenFolder> HiddenFolder::temporary() {
    std::error_code failed;
    const fs::path folder = fs::temp_directory_path(failed);
    if (failed)
        return Error(MessageCode::FileUnwritable, folder.string(), {failed.message()});
    return in(folder.string());
}

std::string behindLinks(const std::string& path) {
    constexpr int kMaxLinks = 40; // as the system has it
    fs::path place(path);
    std::error_code failed;
    for (int k = 0; k < kMaxLinks && fs::is_symlink(fs::symlink_status(place, failed)); ++k) {
        const fs::path to = fs::read_symlink(place, failed);
        if (failed)
            break;
        place = place.parent_path() / to;
    }
    return place.string();
}

std::string folderOfFile(const std::string& file) {
    const std::string folder = fs::path(file).parent_path().string();
    return folder.empty() ? "." : folder;
}

} // namespace bask
