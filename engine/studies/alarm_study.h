#pragma once
// Whether the engine's alarms are true: many runs at random on the simulated rig, healthy and with faults,
// each alarm against what the plant truly does.

#include "engine/base/result.h"
#include "engine/studies/alarm_draw.h"

#include <array>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace bask {

struct AlarmStudy {
    std::vector<Experiment> rigs; ///< see drawAlarmCase
    AlarmDraw draw = AlarmDraw::Healthy;
    int count = 200;
    std::uint64_t seed = 1;
    int first = 1; ///< draw that is run first, from 1 on
};

/// A sensor that froze or came off shows itself when its object is farther than this from what it reads.
/// Nearer, nobody who believes the rates within kAlarmBelief only can know.
inline constexpr double kAlarmShown_K = 10.0;
/// And one that came off only where its object has this view factor: without heat the object cools as its
/// sensor says, by itself or in moving air.
inline constexpr double kAlarmHeated = 0.01;

/// An alarm that began.
struct RaisedAlarm {
    double time_s = 0.0; ///< since the first Start
    int priority = 1;
    std::string name; ///< of its message
    std::string sentence;
    bool isConsequence = false; ///< it follows from another, and is listed under that one
    bool isFalse = false;       ///< it states what is not so; told of healthy draws only
};

/// One run's outcome.
struct AlarmStudyRow {
    AlarmCase drawn;
    double simulated_s = 0.0;
    std::vector<RaisedAlarm> alarms;
    bool isTripped = false;          ///< the run was held or ended by the engine
    double overTrip_K = -1e9;        ///< hottest true temperature over its object's trip limit
    double overTarget_K = -1e9;      ///< and over its target
    std::optional<double> shown_s{}; ///< when the fault showed itself, since its beginning
    std::optional<double> told_s{};  ///< when the first alarm was of it, since then too
    std::optional<double> acted_s{}; ///< when an alarm told it and the run was held or ended
    double unseen_K = 0.0;           ///< farthest that the faulty sensor was from its object until then
    std::string refusal;             ///< a run that could not be begun, in words
};

/// Runs all draws on `threads` threads (0: one a core); the rows do not depend on them. `progress` is called
/// on the calling thread with the number of runs done; may be empty. Errors: rigs that nothing can be drawn
/// from.
Result<std::vector<AlarmStudyRow>> runAlarmStudy(const AlarmStudy& study, int threads,
                                                 const std::function<void(int done)>& progress);

/// Of one fault's draws.
struct FaultSummary {
    SimulatedFault fault = SimulatedFault::None;
    int draws = 0;
    int shown = 0; ///< those that showed themselves, or were found
    int found = 0; ///< told and acted on; of a frozen sensor told, since a rest gives no more to know
    int acted = 0; ///< runs that were held or ended by it
    double median_s = 0.0, worst_s = 0.0; ///< of those found, since they showed themselves
    double unseen_K = 0.0;                ///< worst, of those that were not found
    double overTrip_K = -1e9;
};

struct AlarmSummary {
    double hours = 0.0; ///< simulated
    int falseTrips = 0, falseWords = 0;
    std::array<int, 3> alarms{}; ///< causes of priority 1, 2, 3
    std::array<double, 3> per10min{};
    std::array<double, 3>
        shares{};        ///< of the priorities where each fault is as often as alarmFaultFrequency()
    int mostIn10min = 0; ///< of all runs, consequences counted
    double overTrip_K = -1e9;
    int refused = 0;
    std::vector<FaultSummary> faults;
};
AlarmSummary summarize(const std::vector<AlarmStudyRow>& rows);

/// The table as CSV, with definitions in comment lines before the header.
std::string alarmCsv(const AlarmStudy& study, const std::vector<AlarmStudyRow>& rows);

} // namespace bask
