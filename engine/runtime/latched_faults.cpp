#include "engine/runtime/latched_faults.h"

#include "engine/base/message_code.h"
#include "engine/runtime/alarm_causes.h"

#include <algorithm>
#include <utility>

namespace bask {
namespace {

/// Returns the priority of its message, which may be lower than that of its condition.
int priorityOf(const LatchedFault& fault) {
    const int ofWords = alarmPriority(fault.message.code);
    return ofWords > 0 ? ofWords : fault.finding ? alarmEntry(fault.finding->condition).priority : 1;
}

// These are seen over a working link, so a latched earlier loss is not their cause.
bool heatsByItself(SafetyCondition condition) {
    return condition == SafetyCondition::SourceHeatsUnasked || condition == SafetyCondition::SourceNotCooling;
}

/// A retreat is not explained by a cause that asks for none.
bool isSaidBesideCause(const SafetyFinding& finding, const SafetyFinding& cause) {
    const AlarmEntry& own = alarmEntry(finding.condition);
    return own.priority == 1 && own.reaction > alarmEntry(cause.condition).reaction;
}

} // namespace

LatchedFault latchedFault(Message reason) {
    std::string key = messageName(reason.code);
    return {std::move(reason), std::move(key), std::nullopt};
}

LatchedFault latchedFault(const SafetyFinding& finding, const Experiment& experiment) {
    return {finding.message, alarmKey(finding, experiment), finding};
}

LatchedFaults::LatchedFaults(const Experiment& experiment, const SafetyMonitor& safety)
    : m_experiment(experiment), m_safety(safety) {}

bool LatchedFaults::add(LatchedFault fault) {
    const auto latched = std::ranges::find(m_faults, fault.key, &LatchedFault::key);
    if (latched != m_faults.end())
        return std::exchange(latched->wasOver, false);
    m_faults.push_back(std::move(fault));
    return true;
}

void LatchedFaults::noteOver(const SafetyFinding& finding) {
    const AlarmEntry& row = alarmEntry(finding.condition);
    if (row.reaction < SafetyReaction::Stop || !row.isSeenOver) // others are recorded each time, or once
        return;
    const auto latched = std::ranges::find(m_faults, keyOf(finding), &LatchedFault::key);
    if (latched != m_faults.end())
        latched->wasOver = true;
}

void LatchedFaults::use(std::vector<LatchedFault> faults) {
    m_faults = std::move(faults);
    for (LatchedFault& fault : m_faults)
        if (fault.finding && fault.finding->object >= m_experiment.objects.size())
            fault.finding.reset();
}

std::string LatchedFaults::keyOf(const SafetyFinding& finding) const {
    return alarmKey(finding, m_experiment);
}

const SafetyFinding* LatchedFaults::activeOne(const std::string& key) const {
    const auto& active = m_safety.active();
    const auto found =
        std::ranges::find(active, key, [this](const SafetyFinding& finding) { return keyOf(finding); });
    return found == active.end() ? nullptr : &*found;
}

/// Returns its message with the newest values if the condition is still present.
Message LatchedFaults::newest(const LatchedFault& fault) const {
    const SafetyFinding* const finding = activeOne(fault.key);
    return finding != nullptr ? finding->message : fault.message;
}

/// Returns whether the end of its condition can be observed and was; the fault stays latched.
bool LatchedFaults::isSeenOver(const LatchedFault& fault) const {
    return fault.finding && alarmEntry(fault.finding->condition).isSeenOver &&
           activeOne(fault.key) == nullptr;
}

std::vector<SafetyFinding> LatchedFaults::foundOrLatched() const {
    std::vector<SafetyFinding> out = m_safety.active();
    for (const LatchedFault& fault : m_faults)
        if (fault.finding)
            out.push_back(*fault.finding);
    return out;
}

std::vector<Message> LatchedFaults::reasons() const {
    const auto isSaid = [this](const SafetyFinding& finding) {
        const SafetyFinding* const cause = causeOf(finding, m_safety.active(), m_experiment);
        return cause == nullptr || isSaidBesideCause(finding, *cause);
    };
    std::vector<Message> out;
    for (const LatchedFault& fault : m_faults) // also those that a retreat will end in
        if (!fault.finding || isSaid(*fault.finding))
            out.push_back(newest(fault));
    for (const SafetyFinding& finding : m_safety.active()) {
        const AlarmEntry& row = alarmEntry(finding.condition);
        const bool isLatched =
            std::ranges::find(m_faults, keyOf(finding), &LatchedFault::key) != m_faults.end();
        if ((row.reaction >= SafetyReaction::Hold || row.priority == 1) && !isLatched && isSaid(finding))
            out.push_back(finding.message);
    }
    return out;
}

std::vector<AlarmCondition> LatchedFaults::alarmConditions() const {
    const std::vector<SafetyFinding> present = foundOrLatched();
    std::vector<AlarmCondition> out;
    const auto add = [&](std::string key, const Message& message, int priority,
                         const std::optional<SafetyFinding>& finding) {
        if (std::ranges::find(out, key, &AlarmCondition::key) != out.end())
            return;
        const auto& causes = finding && heatsByItself(finding->condition) ? m_safety.active() : present;
        const SafetyFinding* cause = finding ? causeOf(*finding, causes, m_experiment) : nullptr;
        out.push_back({std::move(key), message, priority, cause ? keyOf(*cause) : ""});
    };
    for (const LatchedFault& fault : m_faults)
        if (!isSeenOver(fault))
            add(fault.key, newest(fault), priorityOf(fault), fault.finding);
    for (const SafetyFinding& finding : m_safety.active())
        add(keyOf(finding), finding.message, alarmEntry(finding.condition).priority, finding);
    return out;
}

} // namespace bask
