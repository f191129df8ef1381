#pragma once
// Keeps the alarms in a file across restarts. No call waits for the disk, except wait().

#include "engine/experiment/unrecorded_alarms.h"
#include "engine/model/alarm.h"
#include "engine/runtime/background_thread.h"

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace bask {

/// Each running Bask has its own file: the first one the given file, the next one "alarms-2.json" beside it.
/// The next Bask that starts takes over the files of those that have ended. What comes of grave alarms while
/// nothing is recorded is appended to unrecordedAlarmFile(), which all of them share.
class AlarmKeeper {
public:
    struct Before {
        std::vector<Alarm> alarms;
        std::optional<Error> problem; ///< a file that cannot be read; it will be overwritten
        std::string ownFile;          ///< the file in use if another Bask uses the given one; otherwise empty
    };

    /// With an empty name nothing is kept.
    explicit AlarmKeeper(std::string file);

    /// Returns the alarms kept before, once, as soon as they have been read.
    std::optional<Before> takeBefore();
    /// Whether a recording tells of the alarms, and who is at work.
    struct Now {
        bool isRecorded = true;
        std::string operatorName{};
    };
    /// Writes the alarms; if several calls wait for the disk, only the newest alarms are written, but all
    /// that has come of them. No effect before takeBefore() has returned them.
    void keep(const std::vector<Alarm>& alarms, const Now& now);
    /// Returns why a file cannot be written; once, until writing succeeds again.
    std::optional<Error> takeFailure();
    /// Returns false if not everything is written after `bound`.
    bool wait(std::chrono::milliseconds bound) const { return m_thread.wait(bound); }

private:
    struct Shared;
    std::shared_ptr<Shared> m_shared; ///< shared with the thread
    std::future<Before> m_before;
    std::vector<Alarm> m_last; ///< as keep() was called with last
    bool m_isRead = false;
    BackgroundThread m_thread;
};

/// Returns what has come of alarms of priority 1 and 2 from one call of keep() to the next. Those that are
/// from before are not raised.
std::vector<UnrecordedChange> alarmChanges(const std::vector<Alarm>& before, const std::vector<Alarm>& after,
                                           double utc_s, const std::string& operatorName);

} // namespace bask
