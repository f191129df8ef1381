#pragma once
// Keeps the alarms in a file over a restart. No call waits for the disk.

#include "engine/model/alarm.h"
#include "engine/runtime/background_thread.h"

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace bask {

/// Each Bask that runs has a file of its own: the first the one that is named, the next "alarms-2.json"
/// beside it. What one that has ended has left is taken over by the next that starts.
class AlarmKeeper {
public:
    struct Before {
        std::vector<Alarm> alarms;
        std::optional<Error> problem; ///< of a file that cannot be read; it is written anew
        std::string ownFile;          ///< where another Bask has the named one; else empty
    };

    /// An empty name keeps nothing.
    explicit AlarmKeeper(std::string file);

    /// What was kept before, once, as soon as it is read.
    std::optional<Before> takeBefore();
    /// Of several that wait for the disk the newest is written. Nothing is before takeBefore() has answered.
    void keep(const std::vector<Alarm>& alarms);
    /// Why the file cannot be written; told once until it can be again.
    std::optional<Error> takeFailure();
    /// Returns false when not all is written after `bound`.
    bool wait(std::chrono::milliseconds bound) const { return m_thread.wait(bound); }

private:
    struct Shared;
    std::shared_ptr<Shared> m_shared; ///< with the thread
    std::future<Before> m_before;
    bool m_isRead = false;
    BackgroundThread m_thread;
};

} // namespace bask
