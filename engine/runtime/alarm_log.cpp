#include "engine/runtime/alarm_log.h"

#include "engine/base/message_code.h"
#include "engine/base/words.h"
#include "engine/model/alarm_root.h"
#include "engine/runtime/command.h"

#include <algorithm>
#include <map>
#include <tuple>

namespace bask {

/// A consequence that appears within this time was acknowledged together with its cause, unless that was
/// shelved; a serious one that comes later was not. What comes later is no consequence of the first alarm.
constexpr double kAtOnce_s = 30.0;

namespace {

void acknowledgeOne(Alarm& alarm, const std::string& operatorName) {
    if (!alarm.isAcknowledged)
        alarm.seenBy = operatorName;
    alarm.isAcknowledged = true;
}

bool outlastsItsRig(const Alarm& alarm) {
    return alarm.isLive && alarm.message.code == MessageCode::HeatLeftUnknown;
}

} // namespace

void AlarmLog::addFromBefore(std::vector<Alarm> before) {
    for (Alarm& alarm : before) {
        auto& kept = alarm.isLive == m_isLive || outlastsItsRig(alarm) ? m_alarms : m_others;
        if (alarm.isAcknowledged || std::ranges::find(kept, alarm.key, &Alarm::key) != kept.end())
            continue;
        alarm.isFromBefore = alarm.isFromBefore || alarm.isActive;
        alarm.isActive = isKept(alarm);
        alarm.id = ++m_lastId;
        kept.push_back(std::move(alarm));
    }
    forgetOver();
    sort();
}

void AlarmLog::leave() {
    for (Alarm& alarm : m_alarms) {
        alarm.isFromBefore = alarm.isFromBefore || alarm.isActive;
        alarm.isActive = false;
    }
    forgetOver();
    sort();
}

void AlarmLog::use(bool isLive) {
    if (isLive == m_isLive)
        return;
    std::vector<Alarm> along;
    std::ranges::copy_if(m_alarms, std::back_inserter(along), outlastsItsRig);
    std::erase_if(m_alarms, outlastsItsRig);
    leave();
    std::swap(m_alarms, m_others);
    m_isLive = isLive;
    m_first.clear();
    std::ranges::move(along, std::back_inserter(m_alarms));
    if (m_isLive) // the real rig's own checks decide now
        leave();
    forgetOver();
    sort();
}

// Nobody monitors that source any more.
bool AlarmLog::isKept(const Alarm& alarm) const {
    return !m_isLive && outlastsItsRig(alarm);
}

std::vector<Alarm> AlarmLog::all() const {
    std::vector<Alarm> out = m_alarms;
    out.insert(out.end(), m_others.begin(), m_others.end());
    return out;
}

bool AlarmLog::update(double utc_s, const std::vector<AlarmCondition>& conditions) {
    const bool isQuiet = std::ranges::none_of(m_alarms, &Alarm::isActive);
    bool isFirst = isQuiet && !conditions.empty();
    if (isFirst)
        m_first.clear();
    bool changed = false;
    for (Alarm& alarm : m_alarms) {
        const bool holds = std::ranges::any_of(
            conditions, [&](const AlarmCondition& condition) { return condition.key == alarm.key; });
        if (alarm.isActive && !holds && !isKept(alarm)) {
            alarm.isActive = false;
            alarm.cleared_s = utc_s;
            changed = true;
        }
        if (alarm.shelvedUntil_s > 0.0 && utc_s >= alarm.shelvedUntil_s) {
            takeBack(alarm);
            changed = true;
        }
        alarm.isFirst = alarm.isFirst && !isFirst;
    }
    // Causes first, so that their consequences find them.
    for (const bool isCause : {true, false})
        for (const AlarmCondition& condition : conditions) {
            if (condition.cause.empty() != isCause)
                continue;
            const Alarm* const known = find(condition.key);
            const std::string cause = causeInList(condition, known);
            if (known == nullptr || !known->isActive) {
                raise(condition, cause, utc_s);
                if (m_first == condition.key) // others came before it
                    m_first.clear();
                if (isFirst && isCause)
                    m_first = condition.key;
                isFirst = isFirst && !isCause;
                changed = true;
            } else if (known->message.code != condition.message.code || (!isCause && known->cause != cause)) {
                Alarm& alarm = *find(condition.key);
                alarm.message = condition.message;
                alarm.cause = isCause ? alarm.cause : cause;
                changed = true;
            } else {
                find(condition.key)->message = condition.message; // its newest values
            }
        }
    changed = markFirst(utc_s) || changed;
    changed = forgetOver() || changed;
    if (changed)
        sort();
    return changed;
}

/// The key of its cause; empty where none is listed. Who shelved a cause has not seen a grave alarm that
/// comes up afterwards: that one stands by itself, also once it is acknowledged.
std::string AlarmLog::causeInList(const AlarmCondition& condition, const Alarm* known) {
    const Alarm* const cause = find(condition.cause);
    if (cause == nullptr)
        return {};
    const bool wasUnder = known != nullptr && known->isActive && known->cause == condition.cause;
    const bool isPutAside = cause->shelvedUntil_s > 0.0;
    return condition.priority == 1 && isPutAside && !wasUnder ? std::string() : condition.cause;
}

// One alone is the cause of nothing, and hardly of what comes long after it.
bool AlarmLog::markFirst(double utc_s) {
    Alarm* const first = find(m_first);
    if (first == nullptr || first->isFirst || !first->isActive || utc_s - first->raised_s > kAtOnce_s ||
        std::ranges::count_if(m_alarms, &Alarm::isActive) < 2)
        return false;
    first->isFirst = true;
    return true;
}

Alarm* AlarmLog::find(const std::string& key) {
    const auto found = std::ranges::find(m_alarms, key, &Alarm::key);
    return found == m_alarms.end() ? nullptr : &*found;
}

void AlarmLog::raise(const AlarmCondition& condition, const std::string& causeKey, double utc_s) {
    Alarm* alarm = find(condition.key);
    if (alarm == nullptr) {
        m_alarms.push_back({++m_lastId, condition.key, condition.message, condition.priority});
        alarm = &m_alarms.back();
        alarm->isLive = m_isLive;
    } else {
        alarm->message = condition.message;
        alarm->isActive = true;
        alarm->isFromBefore = false;
        ++alarm->count;
    }
    alarm->raised_s = utc_s;
    alarm->isFirst = false;
    alarm->cause = causeKey;
    const Alarm* const cause = find(causeKey);
    const bool isSeen = cause != nullptr && cause->isAcknowledged &&
                        (condition.priority > 1 || utc_s - cause->raised_s <= kAtOnce_s);
    alarm->isAcknowledged = alarm->shelvedUntil_s > 0.0 || isSeen;
    if (alarm->shelvedUntil_s == 0.0)
        alarm->seenBy = isSeen ? cause->seenBy : std::string();
}

// Alarms that are over and acknowledged are removed; their consequences then stand alone.
bool AlarmLog::forgetOver() {
    const auto erased = std::erase_if(m_alarms, [this](const Alarm& alarm) {
        return alarm.isAcknowledged && (!alarm.isActive || isKept(alarm)) && alarm.shelvedUntil_s == 0.0;
    });
    for (Alarm& alarm : m_alarms)
        if (!alarm.cause.empty() && find(alarm.cause) == nullptr)
            alarm.cause.clear();
    return erased > 0;
}

/// Not of what stands by itself: its row is another one.
void AlarmLog::acknowledgeWithConsequences(Alarm& alarm, const std::string& operatorName) {
    const auto own = static_cast<std::size_t>(&alarm - m_alarms.data());
    std::vector<Alarm*> under;
    for (std::size_t i = 0; i < m_alarms.size(); ++i)
        if (i != own && rootOf(m_alarms, i) == own)
            under.push_back(&m_alarms[i]);
    acknowledgeOne(alarm, operatorName);
    for (Alarm* const other : under)
        acknowledgeOne(*other, operatorName);
}

bool AlarmLog::acknowledge(std::uint64_t id, const std::string& operatorName) {
    const auto alarm = std::ranges::find(m_alarms, id, &Alarm::id);
    if (alarm == m_alarms.end() || alarm->isAcknowledged)
        return false;
    acknowledgeWithConsequences(*alarm, operatorName);
    forgetOver();
    sort();
    return true;
}

bool AlarmLog::acknowledgeAll(const std::string& operatorName) {
    if (std::ranges::all_of(m_alarms, &Alarm::isAcknowledged))
        return false;
    for (Alarm& alarm : m_alarms)
        acknowledgeOne(alarm, operatorName);
    forgetOver();
    sort();
    return true;
}

Result<void> AlarmLog::shelve(std::uint64_t id, double utc_s, double for_s, const std::string& reason,
                              const std::string& operatorName) {
    const auto alarm = std::ranges::find(m_alarms, id, &Alarm::id);
    const auto at = static_cast<std::size_t>(alarm - m_alarms.begin());
    if (alarm == m_alarms.end() || rootOf(m_alarms, at) != at)
        return Error(MessageCode::CommandNotNow, {}, {verbArg(CommandVerb::Shelve), "Over"});
    if (std::ranges::all_of(reason, [](char letter) { return letter == ' '; }))
        return Error(MessageCode::ShelfReasonMissing, {});
    constexpr double kShortest_s = 60.0;
    const double longest_s = alarm->priority == 1 ? ShelveAlarm::kLongestGrave_s : ShelveAlarm::kLongest_s;
    if (!(for_s >= kShortest_s && for_s <= longest_s))
        return Error(MessageCode::ValueOutOfRange, {},
                     {formatNumber(for_s / 60.0), formatNumber(kShortest_s / 60.0),
                      formatNumber(longest_s / 60.0), "min"});
    acknowledgeWithConsequences(*alarm, operatorName);
    alarm->seenBy = operatorName; // whoever shelves it has seen it last
    alarm->shelvedUntil_s = utc_s + for_s;
    alarm->shelfReason = reason;
    sort();
    return {};
}

bool AlarmLog::unshelve(std::uint64_t id) {
    const auto alarm = std::ranges::find(m_alarms, id, &Alarm::id);
    if (alarm == m_alarms.end() || alarm->shelvedUntil_s == 0.0)
        return false;
    takeBack(*alarm);
    forgetOver();
    sort();
    return true;
}

void AlarmLog::takeBack(Alarm& alarm) {
    alarm.shelvedUntil_s = 0.0;
    alarm.shelfReason.clear();
    alarm.isAcknowledged = !alarm.isActive; // what is over by now counts as seen
    alarm.seenBy.clear();
}

void AlarmLog::sort() {
    const auto rank = [](const Alarm& alarm) {
        return std::tuple(alarm.isAcknowledged, alarm.priority, -alarm.raised_s, alarm.id);
    };
    std::map<std::string, decltype(rank(Alarm()))> ranks;
    for (const Alarm& alarm : m_alarms)
        ranks[alarm.key] = rank(alarm);
    std::map<std::string, std::string> roots; // before the sorting moves them
    for (std::size_t i = 0; i < m_alarms.size(); ++i)
        roots[m_alarms[i].key] = m_alarms[rootOf(m_alarms, i)].key;
    std::ranges::stable_sort(m_alarms, {}, [&](const Alarm& alarm) {
        const std::string& root = roots.at(alarm.key);
        return std::tuple(ranks.at(root), root != alarm.key, rank(alarm));
    });
}

} // namespace bask
