#pragma once
// Which alarm follows from which: one lost link is one alarm, with what it leads to under it.

#include "engine/runtime/safety_monitor.h"

#include <optional>
#include <string>
#include <vector>

namespace bask {

/// The same for the same thing that is wrong with the same object or device, whatever its message says now.
std::string alarmKey(const SafetyFinding& finding, const Experiment& experiment);

/// The one of `present` that a condition follows from in the end; null: it is a cause itself. The condition
/// may be among them.
const SafetyFinding* causeOf(const SafetyFinding& finding, const std::vector<SafetyFinding>& present,
                             const Experiment& experiment);

} // namespace bask
