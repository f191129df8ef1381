#include "engine/recording/alarm_history.h"

#include "engine/base/message_code.h"
#include "engine/recording/session_facts.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <map>
#include <numeric>
#include <string>
#include <string_view>
#include <utility>

namespace bask {
namespace {

// As in a list of runs: no more of whatever lies in the folder than fits the memory.
constexpr const char* kSelectAlarmEvents =
    "SELECT time_s, code, substr(args, 1, 65536) FROM event ORDER BY rowid LIMIT 100000";
constexpr const char* kSelectEnd = "SELECT time_s FROM step ORDER BY number DESC LIMIT 1";
constexpr const char* kSelectFirstVersionEnd = "SELECT time_s FROM pose ORDER BY rowid DESC LIMIT 1";

/// How the alarm table says that an alarm ends.
struct AlarmEnd {
    MessageCode code;
    bool isOfObject, isLoss;
    bool isLatched;  ///< until reset
    bool isSeenOver; ///< or until its condition is over
};

constexpr AlarmEnd alarmEnd(MessageCode code, unsigned traits, std::string_view reaction) {
    const bool isLatched = reaction != "Note" && reaction != "Hold";
    return {code, (traits & 1U) != 0, (traits & 2U) != 0, isLatched, !isLatched || (traits & 4U) != 0};
}

/// Null for an alarm that is not in the table: of a device, or of the engine itself.
const AlarmEnd* endOf(MessageCode code) {
    // NOLINTNEXTLINE(readability-identifier-naming): as the table writes them
    enum Trait : unsigned { Plain = 0, OfObject = 1, Loss = 2, SeenOver = 4 };
    // clang-format off
    static constexpr AlarmEnd kEnds[]{
#define ALARM(condition, name, priority, reaction, traits, ...) alarmEnd(MessageCode::name, traits, #reaction),
#define DEVICE_ALARM(...)
#include "engine/base/alarm_table.inc"
#undef ALARM
#undef DEVICE_ALARM
    };
    // clang-format on
    const auto* const found = std::ranges::find(kEnds, code, &AlarmEnd::code);
    return found == std::end(kEnds) ? nullptr : &*found;
}

/// They are told at one moment, and nothing tells their end.
bool isMoment(MessageCode code) {
    return code == MessageCode::EventNotSettled || code == MessageCode::EventCompromise;
}

bool endsWhenOver(MessageCode code) {
    const AlarmEnd* const end = endOf(code);
    return end == nullptr || end->isSeenOver;
}

bool endsByReset(MessageCode code) {
    const AlarmEnd* const end = endOf(code);
    return end == nullptr || end->isLatched;
}

/// What an alarm is about: sentences have the names of objects, ports and programs in quotes. Another number
/// of an alarm of the robot is another alarm.
std::vector<std::string> namesIn(const Message& message) {
    const std::string_view sentence = messageTemplate(message.code);
    std::vector<std::string> names;
    for (std::size_t k = 0; k < message.args.size(); ++k)
        if (sentence.find("\"%" + std::to_string(k + 1) + '"') != std::string_view::npos ||
            (message.code == MessageCode::RobotAlarm && k == 0))
            names.push_back(message.args[k].text());
    return names;
}

bool isSameAlarm(const Message& a, const Message& b) {
    return a.code == b.code && namesIn(a) == namesIn(b);
}

/// The newest words of a device's alarm, with which it ends, may be others than those it began with.
bool isOfSameDevice(const Message& a, const Message& b) {
    const std::vector<std::string> ofA = namesIn(a), ofB = namesIn(b);
    return endOf(a.code) == nullptr && endOf(b.code) == nullptr && !ofA.empty() && !ofB.empty() &&
           ofA.front() == ofB.front();
}

/// Pairs each alarm with its end.
class SpellCount {
public:
    void take(const TraceEvent& event) {
        const Message& told = event.message;
        if (alarmPriority(told.code) > 0)
            return raise(event);
        if (told.code == MessageCode::EventReset)
            return end(event.time_s, [](const Message& open) { return endsByReset(open.code); });
        if (told.code == MessageCode::EventSourcePoseBack)
            return end(event.time_s, [](const Message& open) {
                const AlarmEnd* const row = endOf(open.code);
                return row != nullptr && row->isLoss && !row->isOfObject;
            });
        if (told.code == MessageCode::EventSensorBack)
            return end(event.time_s, [&](const Message& open) {
                const AlarmEnd* const row = endOf(open.code);
                return row != nullptr && row->isLoss && row->isOfObject && !open.args.empty() &&
                       !told.args.empty() && open.args.front() == told.args.front();
            });
        if (told.code == MessageCode::EventAlarmOver)
            if (const auto over = messageWithin(told); over && endsWhenOver(over->code))
                endOne(event.time_s, *over);
    }

    /// What has no end yet lasts until the recording's.
    std::vector<AlarmSpell> all(double end_s) {
        end(end_s, [](const Message&) { return true; });
        return std::move(m_spells);
    }

private:
    void raise(const TraceEvent& event) {
        end(event.time_s, [&](const Message& open) { return isSameAlarm(open, event.message); });
        if (!isMoment(event.message.code))
            m_open.push_back(m_spells.size());
        m_spells.push_back({event.message, event.time_s});
    }

    template <class Ends> void end(double time_s, Ends ends) {
        std::erase_if(m_open, [&](std::size_t k) {
            const bool isEnded = ends(m_spells[k].message);
            if (isEnded)
                m_spells[k].active_s = std::max(time_s - m_spells[k].raised_s, 0.0);
            return isEnded;
        });
    }

    void endOne(double time_s, const Message& over) {
        const bool isOpen = std::ranges::any_of(
            m_open, [&](std::size_t k) { return isSameAlarm(m_spells[k].message, over); });
        end(time_s, [&](const Message& open) {
            return isOpen ? isSameAlarm(open, over) : isOfSameDevice(open, over);
        });
    }

    std::vector<AlarmSpell> m_spells;
    std::vector<std::size_t> m_open; ///< spells without an end
};

double sumOf(double sum_s, double part_s) {
    return std::isnan(sum_s) ? part_s : std::isnan(part_s) ? sum_s : sum_s + part_s;
}

constexpr double kNoEnd = std::numeric_limits<double>::quiet_NaN();

Result<std::vector<AlarmSpell>> readSpells(const std::string& path, const std::stop_token& stop) {
    const auto store = SessionStore::open(path);
    if (!store)
        return store.error();
    std::vector<TraceEvent> events;
    double end_s = 0.0;
    const auto takeEnd = [&](double time_s) {
        if (time_s > end_s) // not one that is not known
            end_s = time_s;
    };
    auto done = (*store)->execute("BEGIN"); // all of one moment
    if (done)
        done = (*store)->select(
            kSelectAlarmEvents,
            [&](SessionStore::Row row) {
                events.push_back(eventOf(row));
                takeEnd(events.back().time_s);
            },
            stop);
    if (done)
        done = (*store)->select((*store)->version() < 2 ? kSelectFirstVersionEnd : kSelectEnd,
                                [&](SessionStore::Row row) { takeEnd(numberOf(row[0])); });
    if (!done)
        return done.error();
    std::erase_if(events, [](const TraceEvent& event) { return !std::isfinite(event.time_s); });
    return alarmSpells(events, end_s);
}

} // namespace

double AlarmInRun::active_s() const {
    return std::accumulate(spells.begin(), spells.end(), kNoEnd, [](double sum_s, const AlarmSpell& spell) {
        return sumOf(sum_s, spell.active_s);
    });
}

int PastAlarm::priority() const {
    return alarmPriority(message().code);
}

std::size_t PastAlarm::times() const {
    return std::accumulate(runs.begin(), runs.end(), std::size_t{0},
                           [](std::size_t sum, const AlarmInRun& each) { return sum + each.spells.size(); });
}

double PastAlarm::active_s() const {
    return std::accumulate(runs.begin(), runs.end(), kNoEnd, [](double sum_s, const AlarmInRun& each) {
        return sumOf(sum_s, each.active_s());
    });
}

std::vector<AlarmSpell> alarmSpells(const std::vector<TraceEvent>& events, double end_s) {
    SpellCount count;
    for (const TraceEvent& event : events)
        count.take(event);
    return count.all(end_s);
}

AlarmHistory readAlarmHistory(std::vector<SessionHeader> runs, const std::stop_token& stop,
                              const ShareDone& done) {
    AlarmHistory history;
    history.runs = std::move(runs);
    std::vector<std::size_t> newestFirst(history.runs.size());
    std::iota(newestFirst.begin(), newestFirst.end(), std::size_t{0});
    std::ranges::stable_sort(newestFirst, std::ranges::greater(),
                             [&](std::size_t k) { return history.runs[k].created; });
    std::map<std::pair<MessageCode, std::vector<std::string>>, std::size_t> places;
    const auto add = [&](std::size_t run, const AlarmSpell& spell) {
        const auto [place, isNew] =
            places.try_emplace({spell.message.code, namesIn(spell.message)}, history.alarms.size());
        if (isNew)
            history.alarms.emplace_back();
        std::vector<AlarmInRun>& in = history.alarms[place->second].runs;
        if (in.empty() || in.back().run != run)
            in.push_back({run, {}});
        in.back().spells.push_back(spell);
    };
    ShareCount count(done, static_cast<double>(history.runs.size()));
    for (const std::size_t k : newestFirst) {
        if (stop.stop_requested())
            break;
        SessionHeader& run = history.runs[k];
        const auto spells =
            run.error ? Result<std::vector<AlarmSpell>>(*run.error) : readSpells(run.path, stop);
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

} // namespace bask
