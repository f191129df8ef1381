#pragma once
// An alarm as people see it: what is wrong, whether it still is, whether somebody has seen it.

#include "engine/base/result.h"

#include <cstdint>
#include <string>
#include <vector>

namespace bask {

/// Gone from the list once it is both over and acknowledged.
struct Alarm {
    std::uint64_t id = 0; ///< acknowledged by this
    std::string key;      ///< the same for the same condition of the same object
    Message message;      ///< as raised last, with the values
    int priority = 1;     ///< 1 the highest .. 3
    bool isActive = true;
    bool isAcknowledged = false;
    bool isFirst = false;      ///< the first of those that came together: likely their cause
    bool isLive = false;       ///< of a real rig, not of the simulated one
    bool isFromBefore = false; ///< active when Bask was last left
    int count = 1;             ///< raised so often since it was last acknowledged
    double raised_s = 0.0;     ///< last, UTC seconds since 1970
    double cleared_s = 0.0;    ///< last; 0: never
    /// Key of the alarm in the list that it follows from: it is listed under that one, does not count as an
    /// alarm of its own, and is acknowledged with it. Empty: it is a cause itself.
    std::string cause{};
    /// Put aside by a person until then, UTC seconds since 1970: counts as acknowledged, and comes back by
    /// itself where it still is so. 0: not shelved.
    double shelvedUntil_s = 0.0;
    std::string shelfReason{}; ///< as that person said it
    bool operator==(const Alarm&) const = default;
};

} // namespace bask
