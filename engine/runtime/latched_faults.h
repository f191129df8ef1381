#pragma once
// Faults that stay until a person resets them, beside what the safety monitor finds now.

#include "engine/runtime/alarm_log.h"
#include "engine/runtime/safety_monitor.h"

#include <optional>
#include <string>
#include <vector>

namespace bask {

/// Latched until reset: a message, with the condition that it is for.
struct LatchedFault {
    Message message;
    std::string key; ///< of its alarm
    std::optional<SafetyFinding> finding;
};

LatchedFault latchedFault(Message reason);
LatchedFault latchedFault(const SafetyFinding& finding, const Experiment& experiment);

/// Borrows its arguments for its life. One thread.
class LatchedFaults {
public:
    LatchedFaults(const Experiment& experiment, const SafetyMonitor& safety);

    /// Returns false, and changes nothing, if its alarm is latched already.
    bool add(LatchedFault fault);
    void clear() { m_faults.clear(); }
    bool isEmpty() const { return m_faults.empty(); }
    const std::vector<LatchedFault>& all() const { return m_faults; }
    /// Those of the loop before; a finding of an object that is no more is forgotten.
    void use(std::vector<LatchedFault> faults);

    /// What is latched and what is found that keeps a run from going on, each cause once.
    std::vector<Message> reasons() const;
    /// What is latched and found, the gravest first.
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
