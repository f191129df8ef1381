#include "engine/runtime/alarm_keeper.h"

#include "engine/experiment/alarm_file.h"

#include <cerrno>
#include <fcntl.h>
#include <filesystem>
#include <mutex>
#include <utility>

#include <sys/file.h>
#include <unistd.h>

namespace bask {
namespace {

constexpr int kMaxFiles = 16;

/// Locked by one process until it ends, in whatever way.
class FileLock {
public:
    explicit FileLock(const std::string& path)
        : m_file(::open(path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0600)) {
        m_isHeld = m_file >= 0 && ::flock(m_file, LOCK_EX | LOCK_NB) == 0;
        m_isTaken = m_file >= 0 && !m_isHeld && errno == EWOULDBLOCK;
    }
    ~FileLock() {
        if (m_file >= 0)
            ::close(m_file);
    }
    FileLock(FileLock&& other) noexcept
        : m_file(std::exchange(other.m_file, -1)), m_isHeld(other.m_isHeld), m_isTaken(other.m_isTaken) {}
    FileLock& operator=(FileLock&&) = delete;
    FileLock(const FileLock&) = delete;
    FileLock& operator=(const FileLock&) = delete;

    bool isHeld() const { return m_isHeld; }
    bool isTaken() const { return m_isTaken; } ///< by another process

private:
    int m_file;
    bool m_isHeld = false, m_isTaken = false;
};

std::string numbered(const std::string& file, int number) {
    if (number == 1)
        return file;
    const std::filesystem::path path(file);
    return (path.parent_path() / (path.stem().string() + '-' + std::to_string(number)))
        .concat(path.extension().string())
        .string();
}

} // namespace

struct AlarmKeeper::Shared {
    Before read();
    void write();

    std::string file;
    std::optional<FileLock> lock; ///< used by the thread only
    std::mutex mutex;             ///< protects all members below
    std::optional<std::vector<Alarm>> newest;
    std::optional<Error> failure;
    bool isFailing = false;
};

/// Claims a file and takes over the alarms that ended processes have left.
AlarmKeeper::Before AlarmKeeper::Shared::read() {
    Before out;
    std::vector<std::string> left;
    std::vector<FileLock> locks;
    const std::string named = file;
    for (int number = 1; number <= kMaxFiles; ++number) {
        const std::string each = numbered(named, number);
        std::error_code code;
        if (lock && !std::filesystem::exists(each, code))
            continue;
        FileLock held(each + ".lock");
        if (held.isTaken())
            continue;
        if (!lock) { // also if the system cannot lock files
            lock.emplace(std::move(held));
            file = each;
            out.ownFile = number == 1 ? std::string() : each;
        } else if (held.isHeld()) {
            left.push_back(each);
            locks.push_back(std::move(held));
        }
        if (auto alarms = readAlarms(each))
            std::ranges::move(*alarms, std::back_inserter(out.alarms));
        else
            out.problem = alarms.error();
    }
    if (!left.empty() && writeAlarms(out.alarms, file))
        for (const std::string& each : left)
            ::unlink(each.c_str());
    return out;
}

void AlarmKeeper::Shared::write() {
    std::unique_lock held(mutex);
    const auto alarms = std::exchange(newest, std::nullopt);
    held.unlock();
    if (!alarms)
        return;
    const auto written = writeAlarms(*alarms, file);
    held.lock();
    if (!written && !isFailing)
        failure = written.error();
    isFailing = !written;
}

AlarmKeeper::AlarmKeeper(std::string file) : m_shared(std::make_shared<Shared>()) {
    if (file.empty())
        return;
    m_shared->file = std::move(file);
    m_before = m_thread.ask([shared = m_shared] { return shared->read(); });
}

std::optional<AlarmKeeper::Before> AlarmKeeper::takeBefore() {
    if (!isReady(m_before))
        return std::nullopt;
    m_isRead = true;
    return m_before.get();
}

void AlarmKeeper::keep(const std::vector<Alarm>& alarms) {
    if (!m_isRead)
        return;
    const std::lock_guard held(m_shared->mutex);
    if (!std::exchange(m_shared->newest, alarms))
        m_thread.post([shared = m_shared] { shared->write(); });
}

std::optional<Error> AlarmKeeper::takeFailure() {
    const std::lock_guard held(m_shared->mutex);
    return std::exchange(m_shared->failure, std::nullopt);
}

} // namespace bask
