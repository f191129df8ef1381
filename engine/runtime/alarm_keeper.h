#pragma once
// Keeps the alarms in a file across restarts. No call waits for the disk, except wait().

#include "engine/model/alarm.h"
#include "engine/runtime/background_thread.h"

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace bask {

/// Each running Bask has its own file: the first one the given file, the next one "alarms-2.json" beside it.
/// The next Bask that starts takes over the files of those that have ended.
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
    /// Writes the alarms; if several calls wait for the disk, only the newest alarms are written. No effect
    /// before takeBefore() has returned them.
    void keep(const std::vector<Alarm>& alarms);
    /// Returns why the file cannot be written; once, until writing succeeds again.
    std::optional<Error> takeFailure();
    /// Returns false if not everything is written after `bound`.
    bool wait(std::chrono::milliseconds bound) const { return m_thread.wait(bound); }

private:
    struct Shared;
    std::shared_ptr<Shared> m_shared; ///< shared with the thread
    std::future<Before> m_before;
    bool m_isRead = false;
    BackgroundThread m_thread;
};

} // namespace bask
