#pragma once
// Which alarm is a consequence of which: a lost link is one alarm, and its consequences are listed under it.

#include "engine/runtime/safety_monitor.h"

#include <optional>
#include <string>
#include <vector>

namespace bask {

/// Returns the key of an alarm. It is the same for the same problem of the same object or device, whatever
/// the message says now.
std::string alarmKey(const SafetyFinding& finding, const Experiment& experiment);

/// Returns the root cause of a condition among `present`; null if the condition is a cause itself. `present`
/// may contain the condition.
const SafetyFinding* causeOf(const SafetyFinding& finding, const std::vector<SafetyFinding>& present,
                             const Experiment& experiment);

} // namespace bask
