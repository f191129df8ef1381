#include "engine/runtime/alarm_log.h"

#include <algorithm>
#include <tuple>

namespace bask {

AlarmLog::AlarmLog(std::vector<Alarm> before) : m_alarms(std::move(before)) {
    for (Alarm& alarm : m_alarms) {
        alarm.isFromBefore = alarm.isFromBefore || alarm.isActive;
        alarm.isActive = false;
        alarm.id = ++m_lastId;
    }
    std::erase_if(m_alarms, &Alarm::isAcknowledged);
    sort();
}

bool AlarmLog::update(double utc_s, const std::vector<AlarmCondition>& conditions) {
    const bool isQuiet = std::ranges::none_of(m_alarms, &Alarm::isActive);
    bool isFirst = isQuiet && !conditions.empty();
    bool changed = false;
    for (Alarm& alarm : m_alarms) {
        const bool holds = std::ranges::any_of(
            conditions, [&](const AlarmCondition& condition) { return condition.key == alarm.key; });
        if (alarm.isActive && !holds) {
            alarm.isActive = false;
            alarm.cleared_s = utc_s;
            changed = true;
        }
        alarm.isFirst = alarm.isFirst && !isFirst;
    }
    for (const AlarmCondition& condition : conditions) {
        const auto known = std::ranges::find(m_alarms, condition.key, &Alarm::key);
        if (known == m_alarms.end()) {
            m_alarms.push_back({++m_lastId, condition.key, condition.message, condition.priority});
            m_alarms.back().raised_s = utc_s;
            m_alarms.back().isFirst = isFirst;
        } else if (!known->isActive) {
            known->isActive = true;
            known->isAcknowledged = false;
            known->isFromBefore = false;
            known->isFirst = isFirst;
            known->message = condition.message;
            known->raised_s = utc_s;
            ++known->count;
        } else {
            continue;
        }
        isFirst = false;
        changed = true;
    }
    const auto erased =
        std::erase_if(m_alarms, [](const Alarm& alarm) { return alarm.isAcknowledged && !alarm.isActive; });
    if (changed || erased > 0)
        sort();
    return changed || erased > 0;
}

bool AlarmLog::acknowledge(std::uint64_t id) {
    const auto alarm = std::ranges::find(m_alarms, id, &Alarm::id);
    if (alarm == m_alarms.end() || alarm->isAcknowledged)
        return false;
    alarm->isAcknowledged = true;
    if (!alarm->isActive)
        m_alarms.erase(alarm);
    sort();
    return true;
}

bool AlarmLog::acknowledgeAll() {
    if (std::ranges::all_of(m_alarms, &Alarm::isAcknowledged))
        return false;
    for (Alarm& alarm : m_alarms)
        alarm.isAcknowledged = true;
    std::erase_if(m_alarms, [](const Alarm& alarm) { return !alarm.isActive; });
    sort();
    return true;
}

void AlarmLog::sort() {
    std::ranges::stable_sort(m_alarms, {}, [](const Alarm& alarm) {
        return std::tuple(alarm.isAcknowledged, alarm.priority, -alarm.raised_s, alarm.id);
    });
}

} // namespace bask
