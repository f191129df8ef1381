#include "engine/recording/alarm_history.h"

#include "engine/base/alarm_entry.h"
#include "engine/base/message_code.h"
#include "engine/experiment/unrecorded_alarms.h"
#include "engine/recording/session_facts.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <numeric>
#include <string>
#include <string_view>
#include <tuple>
#include <utility>

namespace bask {
namespace {

// As in a list of runs: no more of whatever lies in the folder than fits the memory, and a moment.
constexpr const char* kSelectEvents =
    "SELECT time_s, code, substr(args, 1, 8192) FROM event WHERE rowid BETWEEN 1 AND 100000 AND code IN (";
constexpr const char* kUpToEvents = ") ORDER BY rowid LIMIT 10000";
constexpr std::size_t kMaxArgs = 10; ///< the name of another sentence, and the nine of that one
constexpr const char* kSelectLastEvent = "SELECT time_s FROM event ORDER BY rowid DESC LIMIT 1";
constexpr const char* kSelectEnd = "SELECT time_s FROM step ORDER BY number DESC LIMIT 1";
constexpr const char* kSelectFirstVersionEnd = "SELECT time_s FROM pose ORDER BY rowid DESC LIMIT 1";

/// Null for an alarm that is not in the table: of a device, or of the engine itself.
const AlarmEntry* entryOf(MessageCode code) {
    const auto entries = alarmEntries();
    const auto found = std::ranges::find(entries, code, &AlarmEntry::code);
    return code == MessageCode::None || found == entries.end() ? nullptr : &*found;
}

/// Whether it stays until reset.
bool isLatched(const AlarmEntry& entry) {
    return entry.reaction != SafetyReaction::Note && entry.reaction != SafetyReaction::Hold;
}

/// They are told at one moment, and nothing tells their end.
bool isMoment(MessageCode code) {
    return code == MessageCode::EventNotSettled || code == MessageCode::EventCompromise;
}

bool endsWhenOver(MessageCode code) {
    const AlarmEntry* const entry = entryOf(code);
    return entry == nullptr || !isLatched(*entry) || entry->isSeenOver;
}

bool isEnd(MessageCode code) {
    return code == MessageCode::EventReset || code == MessageCode::EventSourcePoseBack ||
           code == MessageCode::EventSensorBack || code == MessageCode::EventAlarmOver;
}

/// Sentences have the names of objects, ports and programs in quotes.
std::vector<std::string> quotedNames(const Message& message) {
    const std::string_view sentence = messageTemplate(message.code);
    std::vector<std::string> names;
    for (std::size_t k = 0; k < message.args.size(); ++k)
        if (sentence.find("\"%" + std::to_string(k + 1) + '"') != std::string_view::npos)
            names.push_back(message.args[k].text());
    return names;
}

/// What an alarm that is not in the table speaks of, whatever its words; empty for any other alarm.
std::string deviceOf(const Message& message) {
    if (entryOf(message.code) != nullptr)
        return {};
    const std::string_view name = messageName(message.code);
    if (name.starts_with("Robot") || message.code == MessageCode::ReasonRobotLost)
        return "robot";
    if (name.starts_with("HeaterGuard"))
        return "guard";
    if (name.starts_with("Device") && !message.args.empty()) // its port, which is not always in quotes
        return message.args.front().text();
    const std::vector<std::string> names = quotedNames(message);
    return names.empty() ? std::string() : names.front();
}

/// What an alarm is about. What a device says of itself does not count, but another number of an alarm of the
/// robot is another alarm.
std::vector<std::string> aboutOf(const Message& message) {
    if (message.code == MessageCode::RobotAlarm && !message.args.empty())
        return {message.args.front().text()};
    if (std::string_view(messageName(message.code)).starts_with("Device"))
        return {deviceOf(message)};
    return quotedNames(message);
}

using AlarmKey = std::pair<MessageCode, std::vector<std::string>>;

AlarmKey keyOf(const Message& message) {
    return {message.code, aboutOf(message)};
}

/// Pairs each alarm with its end.
class SpellCount {
public:
    void take(const TraceEvent& event) {
        const Message& told = event.message;
        if (alarmPriority(told.code) > 0)
            return raise(event);
        if (told.code == MessageCode::EventReset)
            return reset(event.time_s);
        if (told.code == MessageCode::EventSourcePoseBack)
            return end(event.time_s, [](const Unended& open) {
                return open.row != nullptr && open.row->isLoss && !open.row->isOfObject;
            });
        if (told.code == MessageCode::EventSensorBack && !told.args.empty())
            return end(event.time_s, [&](const Unended& open) {
                return open.row != nullptr && open.row->isLoss && open.row->isOfObject &&
                       open.object == told.args.front().text();
            });
        if (told.code == MessageCode::EventAlarmOver)
            if (const auto over = messageWithin(told); over && endsWhenOver(over->code))
                endOne(event.time_s, *over);
    }

    /// What has no end yet lasts until the recording's.
    std::vector<AlarmSpell> all(double end_s) {
        for (const auto& [key, open] : m_open)
            m_spells[open.spell].isCut = true;
        end(end_s, [](const Unended&) { return true; });
        return std::move(m_spells);
    }

private:
    struct Unended {
        std::size_t spell;
        const AlarmEntry* row;
        std::string object, device;
    };
    using Unendeds = std::map<AlarmKey, Unended>;

    /// One that is told again before its end goes on: a loss is told when a run holds for it, and when it
    /// ends for it.
    void raise(const TraceEvent& event) {
        const Message& message = event.message;
        AlarmKey key = keyOf(message);
        if (m_open.contains(key))
            return;
        m_reset.erase(key);
        if (!isMoment(message.code))
            m_open.emplace(std::move(key),
                           Unended{m_spells.size(), entryOf(message.code),
                                   message.args.empty() ? std::string() : message.args.front().text(),
                                   deviceOf(message)});
        m_spells.push_back({message, event.time_s});
    }

    void setEnd(const Unended& open, double time_s) {
        AlarmSpell& spell = m_spells[open.spell];
        spell.active_s = std::max(time_s - spell.raised_s, 0.0);
    }

    template <class Ends> void end(double time_s, Ends ends) {
        std::erase_if(m_open, [&](const auto& each) {
            const bool isEnded = ends(each.second);
            if (isEnded)
                setEnd(each.second, time_s);
            return isEnded;
        });
    }

    /// A device's alarm may go on after it: whether it halts the robot or is a note, its sentence does not
    /// tell.
    void reset(double time_s) {
        for (const auto& [key, open] : m_open)
            if (open.row == nullptr)
                m_reset.insert_or_assign(key, open);
        end(time_s, [](const Unended& open) { return open.row == nullptr || isLatched(*open.row); });
    }

    /// The newest words of a device's alarm, with which it ends, may be others than those it began with.
    void endOne(double time_s, const Message& over) {
        const AlarmKey key = keyOf(over);
        if (const auto open = m_open.find(key); open != m_open.end()) {
            setEnd(open->second, time_s);
            m_open.erase(open);
            return;
        }
        const std::string device = deviceOf(over);
        if (device.empty())
            return endAfterReset(time_s, m_reset.find(key));
        const std::size_t before = m_open.size();
        end(time_s, [&](const Unended& open) { return open.device == device; });
        if (m_open.size() < before)
            return;
        auto newest = m_reset.end();
        for (auto each = m_reset.begin(); each != m_reset.end(); ++each)
            if (each->second.device == device &&
                (newest == m_reset.end() || each->second.spell > newest->second.spell))
                newest = each;
        endAfterReset(time_s, newest);
    }

    void endAfterReset(double time_s, Unendeds::iterator goesOn) {
        if (goesOn == m_reset.end())
            return;
        setEnd(goesOn->second, time_s);
        m_reset.erase(goesOn);
    }

    std::vector<AlarmSpell> m_spells;
    Unendeds m_open;  ///< without an end
    Unendeds m_reset; ///< whose end is a reset
};

/// Adds up what an alarm was active.
class DurationSum {
public:
    void add(double active_s, bool isCut) {
        m_hasNoEnd = m_hasNoEnd || std::isnan(active_s);
        m_isCut = m_isCut || isCut;
        if (!std::isnan(active_s))
            m_sum_s = std::isnan(m_sum_s) ? active_s : m_sum_s + active_s;
    }
    void add(const AlarmInRun& in) {
        for (const AlarmSpell& spell : in.spells)
            add(spell.active_s, spell.isCut);
    }
    AlarmDuration sum() const { return {m_sum_s, m_isCut || (m_hasNoEnd && !std::isnan(m_sum_s))}; }

private:
    double m_sum_s = std::numeric_limits<double>::quiet_NaN();
    bool m_hasNoEnd = false;
    bool m_isCut = false;
};

/// Returns the query of the events that tell alarms and their ends.
const std::string& selectAlarmEvents() {
    static const std::string kQuery = [] {
        std::string codes;
        for (int k = 1; messageCodeFromName(messageName(static_cast<MessageCode>(k))) != MessageCode::None;
             ++k) {
            const auto code = static_cast<MessageCode>(k);
            if (alarmPriority(code) > 0 || isEnd(code))
                codes += (codes.empty() ? "" : ", ") + sqlText(messageName(code));
        }
        return kSelectEvents + codes + kUpToEvents;
    }();
    return kQuery;
}

Result<std::vector<AlarmSpell>> readSpells(const std::string& path, const std::stop_token& stop) {
    const auto store = SessionStore::open(path);
    if (!store)
        return store.error();
    std::vector<TraceEvent> events;
    double end_s = 0.0;
    const auto takeEnd = [&](double time_s) {
        if (std::isfinite(time_s) && time_s > end_s)
            end_s = time_s;
    };
    auto done = (*store)->execute("BEGIN"); // all of one moment
    if (done)
        done = (*store)->select(
            selectAlarmEvents(),
            [&](SessionStore::Row row) {
                TraceEvent event = eventOf(row);
                std::vector<MessageArg>& args = event.message.args;
                if (args.size() > kMaxArgs)
                    args.erase(args.begin() + kMaxArgs, args.end());
                if (std::isfinite(event.time_s))
                    events.push_back(std::move(event));
            },
            stop);
    if (done)
        done = (*store)->select(kSelectLastEvent, [&](SessionStore::Row row) { takeEnd(numberOf(row[0])); });
    if (done)
        done = (*store)->select((*store)->version() < 2 ? kSelectFirstVersionEnd : kSelectEnd,
                                [&](SessionStore::Row row) { takeEnd(numberOf(row[0])); });
    if (!done)
        return done.error();
    return alarmSpells(events, end_s, stop);
}

} // namespace

AlarmDuration AlarmInRun::active() const {
    DurationSum sum;
    sum.add(*this);
    return sum.sum();
}

const Message& PastAlarm::message() const {
    return runs.empty() ? withoutRun.front().message : runs.front().spells.back().message;
}

/// Some sentences of devices have one as an alarm alone.
int PastAlarm::priority() const {
    const int ofSentence = alarmPriority(message().code);
    return ofSentence > 0 || withoutRun.empty() ? ofSentence : withoutRun.front().priority;
}

std::size_t PastAlarm::times() const {
    return std::accumulate(runs.begin(), runs.end(), withoutRun.size(),
                           [](std::size_t sum, const AlarmInRun& each) { return sum + each.spells.size(); });
}

AlarmDuration PastAlarm::active() const {
    DurationSum sum;
    for (const AlarmInRun& each : runs)
        sum.add(each);
    for (const UnrecordedSpell& each : withoutRun)
        sum.add(each.active_s, false);
    return sum.sum();
}

std::vector<AlarmSpell> alarmSpells(const std::vector<TraceEvent>& events, double end_s,
                                    const std::stop_token& stop) {
    SpellCount count;
    for (const TraceEvent& event : events) {
        if (stop.stop_requested())
            break;
        count.take(event);
    }
    return count.all(end_s);
}

bool isSameAlarm(const Message& a, const Message& b) {
    return keyOf(a) == keyOf(b);
}

AlarmHistory readAlarmHistory(std::vector<SessionHeader> runs, const std::stop_token& stop,
                              const ShareDone& done) {
    AlarmHistory history;
    history.runs = std::move(runs);
    std::map<AlarmKey, std::size_t> places;
    const auto add = [&](std::size_t run, const AlarmSpell& spell) {
        const auto [place, isNew] = places.try_emplace(keyOf(spell.message), history.alarms.size());
        if (isNew)
            history.alarms.emplace_back();
        std::vector<AlarmInRun>& in = history.alarms[place->second].runs;
        if (in.empty() || in.back().run != run)
            in.push_back({run, {}});
        in.back().spells.push_back(spell);
    };
    ShareCount count(done, static_cast<double>(history.runs.size()));
    for (std::size_t k = 0; k < history.runs.size(); ++k) {
        if (stop.stop_requested())
            break;
        SessionHeader& run = history.runs[k];
        const auto spells =
            run.error ? Result<std::vector<AlarmSpell>>(*run.error) : readSpells(run.path, stop);
        if (stop.stop_requested())
            break; // it was not read to its end
        if (spells) {
            for (const AlarmSpell& spell : *spells)
                add(k, spell);
        } else {
            run.error = spells.error();
            history.unreadable.push_back(k);
        }
        count.add();
    }
    return history;
}

void addUnrecorded(AlarmHistory& history, const std::string& file) {
    if (file.empty())
        return;
    const auto read = readUnrecordedAlarms(file);
    if (!read) {
        history.failure = read.error();
        return;
    }
    history.damagedLines = read->damaged;
    std::map<AlarmKey, std::size_t> places;
    for (std::size_t k = 0; k < history.alarms.size(); ++k)
        places.try_emplace(keyOf(history.alarms[k].message()), k);
    struct Unended {
        std::size_t alarm, spell;
    };
    std::map<std::tuple<std::string, bool, double>, Unended> open;
    for (const UnrecordedChange& change : read->changes) {
        const std::tuple which(change.key, change.isLive, change.raised_s);
        if (change.change == AlarmChange::Raised) {
            const auto [place, isNew] = places.try_emplace(keyOf(change.message), history.alarms.size());
            if (isNew)
                history.alarms.emplace_back();
            auto& spells = history.alarms[place->second].withoutRun;
            open.insert_or_assign(which, Unended{place->second, spells.size()});
            spells.push_back({change.message, change.priority, change.isLive, change.raised_s});
        } else if (const auto of = open.find(which); change.change == AlarmChange::Over && of != open.end()) {
            history.alarms[of->second.alarm].withoutRun[of->second.spell].active_s =
                std::max(change.utc_s - change.raised_s, 0.0);
            open.erase(of);
        }
    }
    for (PastAlarm& alarm : history.alarms)
        std::ranges::stable_sort(alarm.withoutRun, std::ranges::greater(), &UnrecordedSpell::raised_s);
}

} // namespace bask
