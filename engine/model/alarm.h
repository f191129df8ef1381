#pragma once
// An alarm as people see it: what is wrong, whether it is still active, and whether somebody acknowledged it.

#include "engine/base/result.h"

#include <algorithm>
#include <cstdint>
#include <string>
#include <vector>

namespace bask {

/// An alarm is removed from the list when it is both over and acknowledged.
struct Alarm {
    std::uint64_t id = 0; ///< identifies it when it is acknowledged
    std::string key;      ///< equal for the same condition of the same object
    Message message;      ///< with the newest values of the last time it was active
    int priority = 1;     ///< 1 the highest .. 3
    bool isActive = true;
    bool isAcknowledged = false;
    /// Whether it was the first of several that came together: probably their cause.
    bool isFirst = false;
    bool isLive = false;       ///< true on a real rig, false on the simulated one
    bool isFromBefore = false; ///< whether it was active when Bask was last closed
    int count = 1;             ///< how often it was raised since the last acknowledgement
    double raised_s = 0.0;     ///< last time, UTC seconds since 1970
    double cleared_s = 0.0;    ///< last time; 0: never
    /// Key of the alarm in the list that caused this one. It is then listed under its cause, does not count
    /// as an alarm of its own, and is acknowledged with it. Empty if it is itself a cause.
    std::string cause{};
    /// Time until which a person shelved it, UTC seconds since 1970. It counts as acknowledged until then,
    /// and returns by itself if it is still active. 0 if it is not shelved.
    double shelvedUntil_s = 0.0;
    std::string shelfReason{}; ///< reason given by that person
    /// Operator who acknowledged or shelved it; empty if not known.
    std::string seenBy{};
    bool operator==(const Alarm&) const = default;
};

/// Whether an alarm with this message is active, acknowledged or not.
inline bool isActive(const std::vector<Alarm>& alarms, MessageCode code) {
    return std::ranges::any_of(
        alarms, [code](const Alarm& alarm) { return alarm.isActive && alarm.message.code == code; });
}

} // namespace bask
