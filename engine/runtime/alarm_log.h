#pragma once
// Alarms out of conditions: raised, over, acknowledged, repeated; the first of those that came together.

#include "engine/session/alarm.h"

#include <string>
#include <vector>

namespace bask {

/// What holds now and is worth an alarm.
struct AlarmCondition {
    std::string key;
    Message message;
    int priority = 1;
};

/// Pure: conditions in, alarms out. An alarm stays until it is over and a person has acknowledged it.
class AlarmLog {
public:
    /// Alarms kept from before: those that were active are over now, and say so.
    explicit AlarmLog(std::vector<Alarm> before = {});

    /// All conditions that hold at this moment, the gravest first; each key once. True: the alarms have
    /// changed.
    bool update(double utc_s, const std::vector<AlarmCondition>& conditions);
    /// False: there is none such that is not acknowledged.
    bool acknowledge(std::uint64_t id);
    bool acknowledgeAll();

    /// Those not acknowledged first, then by priority, then the newest first.
    const std::vector<Alarm>& alarms() const { return m_alarms; }

private:
    void sort();

    std::vector<Alarm> m_alarms;
    std::uint64_t m_lastId = 0;
};

} // namespace bask
