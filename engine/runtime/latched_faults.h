#pragma once
// Faults that stay until a person resets them, in addition to the current findings of the safety monitor.

#include "engine/runtime/alarm_log.h"
#include "engine/runtime/safety_monitor.h"

#include <optional>
#include <string>
#include <vector>

namespace bask {

/// A fault that is latched until reset: a message, with the condition that caused it.
struct LatchedFault {
    Message message;
    std::string key; ///< key of its alarm
    std::optional<SafetyFinding> finding;
    bool wasOver = false; ///< its end was recorded since its last event
};

LatchedFault latchedFault(Message reason);
LatchedFault latchedFault(const SafetyFinding& finding, const Experiment& experiment);

/// Borrows its arguments for its lifetime. One thread.
class LatchedFaults {
public:
    LatchedFaults(const Experiment& experiment, const SafetyMonitor& safety);

    /// Adds a fault. Returns false, and changes nothing, if its alarm is already latched; true also for one
    /// that was over and is back.
    bool add(LatchedFault fault);
    /// Call when the end of a finding was recorded: its fault stays latched.
    void noteOver(const SafetyFinding& finding);
    void clear() { m_faults.clear(); }
    bool isEmpty() const { return m_faults.empty(); }
    const std::vector<LatchedFault>& all() const { return m_faults; }
    /// Takes the faults of the previous loop. The finding of an object that no longer exists is removed from
    /// its fault.
    void use(std::vector<LatchedFault> faults);

    /// Returns the messages of what is latched and of what keeps a run from continuing, each cause once; also
    /// a consequence of priority 1 that asks for more than its cause, as a retreat.
    std::vector<Message> reasons() const;
    /// Returns the conditions of what is latched, then of what is found now.
    std::vector<AlarmCondition> alarmConditions() const;

private:
    std::string keyOf(const SafetyFinding& finding) const;
    const SafetyFinding* activeOne(const std::string& key) const;
    Message newest(const LatchedFault& fault) const;
    bool isSeenOver(const LatchedFault& fault) const;
    std::vector<SafetyFinding> foundOrLatched() const;

    const Experiment& m_experiment;
    const SafetyMonitor& m_safety;
    std::vector<LatchedFault> m_faults;
};

} // namespace bask
