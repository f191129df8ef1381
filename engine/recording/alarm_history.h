#pragma once
// The alarms of many recorded runs, and of the time without one: which were raised, how often, when and for
// how long.

#include "engine/base/share_done.h"
#include "engine/model/trace.h"
#include "engine/recording/session_header.h"

#include <cstddef>
#include <limits>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

namespace bask {

/// A time that an alarm was raised in a run.
struct AlarmSpell {
    Message message;       ///< with its values at that time
    double raised_s = 0.0; ///< since Start
    /// Time until it was over or a person reset, at the latest until the recording ends. NaN: nothing tells
    /// the end of such an alarm.
    double active_s = std::numeric_limits<double>::quiet_NaN();
    bool isCut = false; ///< the recording ended before it: it may have lasted longer
};

/// For how long an alarm was active.
struct AlarmDuration {
    double sum_s = std::numeric_limits<double>::quiet_NaN(); ///< NaN if no time of it has an end
    /// Whether it may have been active for longer: a time was cut, or has no end beside others that have one.
    bool isAtLeast = false;
};

/// An alarm in one run.
struct AlarmInRun {
    std::size_t run = 0; ///< index in AlarmHistory::runs
    std::vector<AlarmSpell> spells;

    AlarmDuration active() const; ///< of all spells
};

/// A time that an alarm was raised while nothing was recorded.
struct UnrecordedSpell {
    Message message;
    int priority = 1;
    bool isLive = false;
    double raised_s = 0.0;                                      ///< UTC seconds since 1970
    double active_s = std::numeric_limits<double>::quiet_NaN(); ///< NaN: its end is not known
};

/// An alarm in all runs, and without one. The same sentence about the same objects, or devices, is one alarm,
/// whatever its values. It has a run, or a time without one.
struct PastAlarm {
    std::vector<AlarmInRun> runs;            ///< the newest first
    std::vector<UnrecordedSpell> withoutRun; ///< the newest first

    /// Of the last time in a run; of one that was in none, of the last time.
    const Message& message() const;
    int priority() const;
    std::size_t times() const;
    AlarmDuration active() const; ///< of all times
};

struct AlarmHistory {
    std::vector<SessionHeader> runs;
    std::vector<PastAlarm> alarms;       ///< in no particular order
    std::vector<std::size_t> unreadable; ///< indices of the runs that cannot be read, which have their error
    std::size_t damagedLines = 0;        ///< that tell of alarms without a run and cannot be read
    std::optional<Error> failure;        ///< of the file of the alarms without a run
};

/// Returns the alarms among the events of a run, in their order; the recording ends at `end_s`. What counts
/// as an alarm is an event that has a priority.
/// An alarm that is told again before its end is one. Ends early once `stop` is requested.
std::vector<AlarmSpell> alarmSpells(const std::vector<TraceEvent>& events, double end_s,
                                    const std::stop_token& stop = {});

/// Returns whether two messages, whatever their values, are of one PastAlarm.
bool isSameAlarm(const Message& a, const Message& b);

/// Reads the events of one run after another, no samples: some milliseconds for a run of any length. The runs
/// come the newest first. Of one run no more than the first 10 000 events of alarms are read. A file
/// that cannot be read, now or when its header was read, is left out and named. Ends early, with the runs
/// read so far, once `stop` is requested.
AlarmHistory readAlarmHistory(std::vector<SessionHeader> runs, const std::stop_token& stop = {},
                              const ShareDone& done = {});

/// Adds the alarms that were raised while nothing was recorded, see readUnrecordedAlarms(); none if the name
/// of the file is empty.
void addUnrecorded(AlarmHistory& history, const std::string& file);

} // namespace bask
