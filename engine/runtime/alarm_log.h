#pragma once
// Alarms out of conditions: raised, over, acknowledged, repeated; the first of those that came together.

#include "engine/base/result.h"
#include "engine/model/alarm.h"

#include <string>
#include <vector>

namespace bask {

/// What holds now and is worth an alarm.
struct AlarmCondition {
    std::string key;
    Message message;
    int priority = 1;
    std::string cause{}; ///< key of the one that it follows from, which holds or held; empty: none
};

/// Pure: conditions in, alarms out. An alarm stays until it is over and a person has acknowledged it.
class AlarmLog {
public:
    /// Alarms kept from before: those that were active are over now, and say so. One that is there already
    /// stays as it is.
    void addFromBefore(std::vector<Alarm> before);

    /// From now on those of a real rig, or of the simulated one. What was active is from before when its rig
    /// is there again; it starts with the simulated one. Heat that was left without being known to be off
    /// (MessageCode::HeatLeftUnknown) stays active over the simulated rig, until it is acknowledged there.
    void use(bool isLive);
    /// Also those of the other kind of rig.
    std::vector<Alarm> all() const;

    /// All conditions that hold at this moment, the gravest first; each key once. True: the alarms have
    /// changed.
    bool update(double utc_s, const std::vector<AlarmCondition>& conditions);
    /// False: there is none such that is not acknowledged.
    bool acknowledge(std::uint64_t id);
    bool acknowledgeAll();

    /// Refused without a reason, for too short or too long, and for an alarm that is not there or follows
    /// from another one.
    Result<void> shelve(std::uint64_t id, double utc_s, double for_s, const std::string& reason);
    /// False: it is not shelved.
    bool unshelve(std::uint64_t id);

    /// Those not acknowledged first, then by priority, then the newest first.
    /// What follows from another one comes after it.
    const std::vector<Alarm>& alarms() const { return m_alarms; }

private:
    Alarm* find(const std::string& key);
    void raise(const AlarmCondition& condition, const std::string& causeKey, double utc_s, bool isFirst);
    void acknowledgeWithConsequences(Alarm& alarm);
    static void takeBack(Alarm& alarm); ///< from the shelf
    void leave();
    bool isKept(const Alarm& alarm) const; ///< active over the simulated rig
    bool forgetOver();
    void sort();

    std::vector<Alarm> m_alarms, m_others; ///< of the rig in use, and of the other kind
    bool m_isLive = false;
    std::uint64_t m_lastId = 0;
};

} // namespace bask
