#pragma once
// Makes alarms from conditions: raised, over, acknowledged, repeated, and which came first.

#include "engine/base/result.h"
#include "engine/model/alarm.h"

#include <string>
#include <vector>

namespace bask {

/// A condition that is true now and needs an alarm.
struct AlarmCondition {
    std::string key;
    Message message;
    int priority = 1;
    std::string cause{}; ///< key of its cause, which is or was active; empty if it has none
};

/// Pure: conditions in, alarms out. An alarm stays until it is over and a person has acknowledged it.
class AlarmLog {
public:
    /// Adds alarms kept from an earlier session: those that were active are over now and are marked as from
    /// before. An alarm that is already in the list is not replaced.
    void addFromBefore(std::vector<Alarm> before);

    /// Selects the alarms of the real rig or of the simulated one; the log starts with the simulated one.
    /// Alarms that were active are marked as from before when their rig is selected again. Heat that was left
    /// without being known to be off (MessageCode::HeatLeftUnknown) stays active while the simulated rig is
    /// selected, until it is acknowledged there.
    void use(bool isLive);
    /// Returns the alarms of both kinds of rig.
    std::vector<Alarm> all() const;

    /// Takes all conditions that are true now, the most serious first, each key once. Returns whether the
    /// alarms have changed, other than in the values of their messages.
    bool update(double utc_s, const std::vector<AlarmCondition>& conditions);
    /// Acknowledges the alarm and the consequences that are listed under it. Returns false if there is no
    /// such alarm or it is already acknowledged.
    bool acknowledge(std::uint64_t id, const std::string& operatorName = {});
    bool acknowledgeAll(const std::string& operatorName = {});

    /// Shelves the alarm for a time. Refuses a missing reason, a time that is too short or too long, and an
    /// alarm that does not exist or is listed under its cause. A consequence of priority 1 that comes while
    /// its cause is shelved is not acknowledged by that, and stands by itself.
    Result<void> shelve(std::uint64_t id, double utc_s, double for_s, const std::string& reason,
                        const std::string& operatorName = {});
    /// Returns false if the alarm is not shelved.
    bool unshelve(std::uint64_t id);

    /// Sorted: not acknowledged first, then by priority, then the newest first. Consequences follow their
    /// cause.
    const std::vector<Alarm>& alarms() const { return m_alarms; }

private:
    Alarm* find(const std::string& key);
    std::string causeInList(const AlarmCondition& condition, const Alarm* known);
    void raise(const AlarmCondition& condition, const std::string& causeKey, double utc_s);
    bool markFirst(double utc_s); ///< once others have come soon after it, while it is active
    void acknowledgeWithConsequences(Alarm& alarm, const std::string& operatorName);
    static void takeBack(Alarm& alarm); ///< ends the shelving
    void leave();
    bool isKept(const Alarm& alarm) const; ///< stays active while the simulated rig is selected
    bool forgetOver();
    void sort();

    std::vector<Alarm> m_alarms, m_others; ///< of the rig in use, and of the other kind of rig
    bool m_isLive = false;
    std::uint64_t m_lastId = 0;
    std::string m_first; ///< key of the alarm that came when none was active; empty: not known
};

} // namespace bask
