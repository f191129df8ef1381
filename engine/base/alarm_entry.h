#pragma once
// The rows of the alarm table (alarm_table.inc, which explains the columns), for all who need to know more of
// an alarm than its sentence and its priority.

#include "engine/base/message.h"

#include <span>

namespace bask {

/// The reaction to a condition, the most serious last. Retreats and halts end in a fault that is latched
/// until reset.
enum class SafetyReaction {
    Note,    ///< reported only
    Hold,    ///< zero velocity; the heat of a run stays on
    Stop,    ///< heat off; a run retreats first, otherwise the robot is halted where it is
    Retreat, ///< heat off; the robot moves the objects away, even if no run is on
    Halt     ///< heat off, zero velocity: the robot cannot be trusted
};

/// The conditions that are detected: the lines of the alarm table.
enum class SafetyCondition {
#include "engine/base/condition_names.inc" // made by the build: "RobotLost," ...
};

/// A row of the alarm table.
struct AlarmEntry {
    SafetyCondition condition;
    MessageCode code; ///< of its sentence; None if the device has its own
    const char* key;  ///< conditions with the same key share one alarm
    int priority;     ///< priority of the alarm, 1 is the highest
    SafetyReaction reaction;
    bool isOfObject;
    bool isLoss;     ///< a measured value is lost
    bool isSeenOver; ///< its end can be observed
    double on_s;     ///< it must be present for this time
    double off_s;    ///< and absent for this time
};
const AlarmEntry& alarmEntry(SafetyCondition condition);
/// Returns all rows, in the order of the conditions.
std::span<const AlarmEntry> alarmEntries();

} // namespace bask
