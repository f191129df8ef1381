#pragma once
// Alarms as the window lists them: causes with their consequences, and the shelved ones.

#include "engine/model/alarm.h"

#include <vector>

namespace bask {

/// An alarm and its direct and indirect consequences, in the engine's order.
struct AlarmGroup {
    Alarm alarm;
    std::vector<Alarm> consequences;
    bool isActive() const;  ///< whether any of them is active
    bool isCalling() const; ///< it still is so, and nobody has seen it
    bool operator==(const AlarmGroup&) const = default;
};

struct AlarmGroups {
    /// active groups before those that are over, otherwise in the engine's order
    std::vector<AlarmGroup> present;
    std::vector<AlarmGroup> shelved;
    bool operator==(const AlarmGroups&) const = default;
};

/// Returns the present group that comes first for a reader: active, then by priority, then the first raised;
/// null if there is none.
const AlarmGroup* gravest(const AlarmGroups& groups);
/// Returns the same, or the first of its priority that nobody has seen: what calls is what is told.
const AlarmGroup* callingFirst(const AlarmGroups& groups);

/// An alarm whose cause is not in the list counts as a cause, and so does one that stands by itself beside it
/// (standsByItself()): the words of a cause that is over are not of now, and one that was seen calls nobody.
AlarmGroups groupAlarms(const std::vector<Alarm>& alarms);

/// Returns the priority of the alarm that a sentence is told by; 0 if it is told by none.
int reasonPriority(const Message& reason, const std::vector<Alarm>& alarms);
/// Returns the highest priority among the reasons; 0 if no alarm tells any of them.
int gravestPriority(const std::vector<Message>& reasons, const std::vector<Alarm>& alarms);

} // namespace bask
