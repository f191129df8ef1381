#include "engine/model/alarm_root.h"

#include <algorithm>

namespace bask {

bool standsByItself(const Alarm& alarm, const Alarm& cause) {
    if (alarm.shelvedUntil_s > 0.0)
        return true;
    if (!alarm.isActive)
        return false;
    const bool isPutAside = cause.shelvedUntil_s > 0.0;
    const bool isUnheard = cause.isAcknowledged || (alarm.priority == 1 && cause.priority > 1);
    return (!cause.isActive && !isPutAside) || (!alarm.isAcknowledged && isUnheard);
}

std::size_t rootOf(const std::vector<Alarm>& alarms, std::size_t i) {
    for (std::size_t steps = 0; steps < alarms.size() && !alarms[i].cause.empty(); ++steps) {
        const auto cause = std::ranges::find(alarms, alarms[i].cause, &Alarm::key);
        if (cause == alarms.end() || standsByItself(alarms[i], *cause))
            break;
        i = static_cast<std::size_t>(cause - alarms.begin());
    }
    return i;
}

} // namespace bask
