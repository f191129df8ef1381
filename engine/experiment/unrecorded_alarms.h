#pragma once
// The file of the grave alarms that came while nothing was recorded: no recorded run tells of them.

#include "engine/base/result.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace bask {

constexpr std::uintmax_t kMaxUnrecordedBytes = 1 << 20;

enum class AlarmChange {
    Raised,
    Over, ///< or its rig was left
    Acknowledged
};

/// A change of an alarm of priority 1 or 2. Times are UTC seconds since 1970.
struct UnrecordedChange {
    AlarmChange change = AlarmChange::Raised;
    double utc_s = 0.0;
    double raised_s = 0.0; ///< when the alarm was raised: with its key it tells which alarm this is
    std::string key;
    Message message;
    int priority = 1;
    bool isLive = false;
    std::string operatorName; ///< who acknowledged it, otherwise who was at work; empty if not known
    bool operator==(const UnrecordedChange&) const = default;
};

struct UnrecordedAlarms {
    std::vector<UnrecordedChange> changes; ///< in the order of the file
    std::size_t damaged = 0;               ///< lines that were skipped
};

/// Returns the file beside that of the alarms; empty if that is.
std::string unrecordedAlarmFile(const std::string& alarmFile);

/// Reads the newest kMaxUnrecordedBytes; nothing if there is no file. Errors: FileUnreadable.
Result<UnrecordedAlarms> readUnrecordedAlarms(const std::string& path);
/// Appends lines of JSON, all or none. A file that would have more than kMaxUnrecordedBytes loses its older
/// half first. Waits for other programs that write into it. Errors: FileUnwritable.
Result<void> appendUnrecordedAlarms(const std::vector<UnrecordedChange>& changes, const std::string& path);

} // namespace bask
