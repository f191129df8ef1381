#include "engine/runtime/alarm_keeper.h"

#include "engine/base/clock.h"
#include "engine/experiment/alarm_file.h"

#include <algorithm>
#include <cerrno>
#include <fcntl.h>
#include <filesystem>
#include <iterator>
#include <mutex>
#include <utility>

#include <sys/file.h>
#include <unistd.h>

namespace bask {
namespace {

constexpr int kMaxFiles = 16;
constexpr int kMaxGravePriority = 2; ///< priority of alarms whose changes are kept
constexpr std::size_t kMaxWaiting = 1000;

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

const Alarm* findAlarm(const std::vector<Alarm>& alarms, std::uint64_t id) {
    const auto found = std::ranges::find(alarms, id, &Alarm::id);
    return found == alarms.end() ? nullptr : &*found;
}

/// While the disk does not answer, the oldest are given up.
void addWaiting(std::vector<UnrecordedChange>& to, std::vector<UnrecordedChange> changes) {
    std::ranges::move(changes, std::back_inserter(to));
    if (to.size() > kMaxWaiting)
        to.erase(to.begin(), to.end() - kMaxWaiting);
}

} // namespace

std::vector<UnrecordedChange> alarmChanges(const std::vector<Alarm>& before, const std::vector<Alarm>& after,
                                           double utc_s, const std::string& operatorName) {
    using enum AlarmChange;
    std::vector<UnrecordedChange> out;
    const auto add = [&](const Alarm& alarm, AlarmChange change) {
        if (alarm.priority > kMaxGravePriority)
            return;
        const bool isBySeen = change == Acknowledged && !alarm.seenBy.empty();
        out.push_back({change, change == Raised ? alarm.raised_s : utc_s, alarm.raised_s, alarm.key,
                       alarm.message, alarm.priority, alarm.isLive, isBySeen ? alarm.seenBy : operatorName});
    };
    for (const Alarm& alarm : after) {
        const Alarm* const was = findAlarm(before, alarm.id);
        if (alarm.isActive && !alarm.isFromBefore && (was == nullptr || !was->isActive))
            add(alarm, Raised);
        if (alarm.isAcknowledged && (was == nullptr || !was->isAcknowledged))
            add(alarm, Acknowledged);
        if (!alarm.isActive && was != nullptr && was->isActive)
            add(alarm, Over);
    }
    for (const Alarm& was : before) // it is removed once it is both
        if (findAlarm(after, was.id) == nullptr) {
            if (!was.isAcknowledged)
                add(was, Acknowledged);
            if (was.isActive)
                add(was, Over);
        }
    return out;
}

struct AlarmKeeper::Shared {
    Before read();
    void write();

    std::string file, unrecordedFile;
    std::optional<FileLock> lock; ///< used by the thread only
    std::mutex mutex;             ///< protects all members below
    std::optional<std::vector<Alarm>> newest;
    std::vector<UnrecordedChange> unrecorded; ///< that are not written yet
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
    std::vector<UnrecordedChange> changes = std::exchange(unrecorded, {});
    held.unlock();
    if (!alarms)
        return;
    auto written = writeAlarms(*alarms, file);
    const auto appended = changes.empty() ? Result<void>() : appendUnrecordedAlarms(changes, unrecordedFile);
    held.lock();
    if (!appended) { // the next ones come after them
        addWaiting(changes, std::exchange(unrecorded, {}));
        unrecorded = std::move(changes);
    }
    if (written)
        written = appended;
    if (!written && !isFailing)
        failure = written.error();
    isFailing = !written;
}

AlarmKeeper::AlarmKeeper(std::string file) : m_shared(std::make_shared<Shared>()) {
    if (file.empty())
        return;
    m_shared->unrecordedFile = unrecordedAlarmFile(file);
    m_shared->file = std::move(file);
    m_before = m_thread.ask([shared = m_shared] { return shared->read(); });
}

std::optional<AlarmKeeper::Before> AlarmKeeper::takeBefore() {
    if (!isReady(m_before))
        return std::nullopt;
    m_isRead = true;
    return m_before.get();
}

void AlarmKeeper::keep(const std::vector<Alarm>& alarms, const Now& now) {
    if (!m_isRead)
        return;
    auto changes = alarmChanges(std::exchange(m_last, alarms), alarms, utcNow_s(), now.operatorName);
    const std::lock_guard held(m_shared->mutex);
    if (!now.isRecorded)
        addWaiting(m_shared->unrecorded, std::move(changes));
    if (!std::exchange(m_shared->newest, alarms))
        m_thread.post([shared = m_shared] { shared->write(); });
}

std::optional<Error> AlarmKeeper::takeFailure() {
    const std::lock_guard held(m_shared->mutex);
    return std::exchange(m_shared->failure, std::nullopt);
}

} // namespace bask
