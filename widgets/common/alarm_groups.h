#pragma once
// Alarms as the window lists them: causes with what follows from each, and those that a person put aside.

#include "engine/model/alarm.h"

#include <vector>

namespace bask {

/// An alarm and those that follow from it, directly or through others, in the engine's order.
struct AlarmGroup {
    Alarm alarm;
    std::vector<Alarm> consequences;
    bool isActive() const; ///< of any of them
    bool operator==(const AlarmGroup&) const = default;
};

struct AlarmGroups {
    std::vector<AlarmGroup> present; ///< active ones before those that are over, else in the engine's order
    std::vector<AlarmGroup> shelved;
    bool operator==(const AlarmGroups&) const = default;
};

/// One whose cause is not in the list is a cause itself.
AlarmGroups groupAlarms(const std::vector<Alarm>& alarms);

} // namespace bask
