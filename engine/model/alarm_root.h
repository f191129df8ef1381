#pragma once
// Under which alarm an alarm is listed: the one rule for the log of alarms, their list, the horn and the
// state bar.

#include "engine/model/alarm.h"

#include <cstddef>
#include <vector>

namespace bask {

/// Whether an alarm stands by itself although its cause is listed: it is shelved, it still is so while its
/// cause is over, or nobody has seen it while its cause is seen (acknowledged or shelved), so that the cause
/// calls nobody. One of priority 1 that nobody has seen does not stand under a lesser one either.
bool standsByItself(const Alarm& alarm, const Alarm& cause);

/// Returns the index of the alarm that `alarms[i]` is listed under, directly or through others; `i` if it
/// stands by itself. A circle of causes is followed for as many steps as there are alarms.
std::size_t rootOf(const std::vector<Alarm>& alarms, std::size_t i);

} // namespace bask
