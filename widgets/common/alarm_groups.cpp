#include "widgets/common/alarm_groups.h"

#include "engine/model/alarm_root.h"

#include <algorithm>
#include <tuple>

namespace bask {
bool AlarmGroup::isActive() const {
    return alarm.isActive || std::ranges::any_of(consequences, &Alarm::isActive);
}

bool AlarmGroup::isCalling() const {
    return isActive() && !alarm.isAcknowledged;
}

const AlarmGroup* gravest(const AlarmGroups& groups) {
    const auto rank = [](const AlarmGroup& group) {
        const Alarm& alarm = group.alarm;
        return std::tuple(!group.isActive(), alarm.priority, alarm.raised_s, alarm.id);
    };
    const auto found = std::ranges::min_element(groups.present, {}, rank);
    return found == groups.present.end() ? nullptr : &*found;
}

const AlarmGroup* callingFirst(const AlarmGroups& groups) {
    const AlarmGroup* const first = gravest(groups);
    if (first == nullptr || first->isCalling())
        return first;
    const auto calling = std::ranges::find_if(groups.present, [first](const AlarmGroup& group) {
        return group.isCalling() && group.alarm.priority == first->alarm.priority;
    });
    return calling == groups.present.end() ? first : &*calling;
}

AlarmGroups groupAlarms(const std::vector<Alarm>& alarms) {
    std::vector<std::size_t> roots(alarms.size());
    for (std::size_t i = 0; i < alarms.size(); ++i)
        roots[i] = rootOf(alarms, i);
    AlarmGroups groups;
    for (std::size_t i = 0; i < alarms.size(); ++i) {
        if (std::ranges::find(roots, i) == roots.end())
            continue;
        AlarmGroup group{alarms[i], {}};
        for (std::size_t k = 0; k < alarms.size(); ++k)
            if (k != i && roots[k] == i)
                group.consequences.push_back(alarms[k]);
        (alarms[i].shelvedUntil_s > 0.0 ? groups.shelved : groups.present).push_back(std::move(group));
    }
    std::stable_partition(groups.present.begin(), groups.present.end(), // clang 14 has no other
                          [](const AlarmGroup& group) { return group.isActive(); });
    return groups;
}

int reasonPriority(const Message& reason, const std::vector<Alarm>& alarms) {
    const auto found =
        std::ranges::find_if(alarms, [&](const Alarm& alarm) { return alarm.message.code == reason.code; });
    return found != alarms.end() ? found->priority : alarmPriority(reason.code);
}

int gravestPriority(const std::vector<Message>& reasons, const std::vector<Alarm>& alarms) {
    int gravest = 0;
    for (const Message& reason : reasons)
        if (const int priority = reasonPriority(reason, alarms);
            priority > 0 && (gravest == 0 || priority < gravest))
            gravest = priority;
    return gravest;
}

} // namespace bask
