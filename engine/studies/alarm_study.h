#pragma once
// Checks whether the engine's alarms are true: many random runs on the simulated rig, healthy and with
// faults, in which each alarm is compared with the true state of the plant.

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
    int first = 1; ///< first draw to run, counted from 1
    ReadBy readBy = ReadBy::Contact;
};

/// A sensor that froze or came off is visible when its object is farther than this from the reading, two that
/// were swapped when their objects are farther than this from one another and the thermal camera reads both.
/// Below this it cannot be detected with rates that are known only within kAlarmEstimateFactor.
inline constexpr double kAlarmShown_K = 10.0;
/// A sensor that came off is visible only if its object has at least this view factor: without heat the
/// object cools as its sensor says, by itself or in moving air.
inline constexpr double kAlarmHeated = 0.01;

inline constexpr double kAlarmSoon_s = 7.0;

/// An alarm that was raised.
struct RaisedAlarm {
    double time_s = 0.0; ///< since the first Start
    int priority = 1;
    std::string name; ///< name of its message
    std::string sentence;
    bool isConsequence = false; ///< it follows from another alarm, and is listed under that one
    bool isFalse = false;       ///< what it states is not true; only for healthy draws
};

/// What the table says of an experiment that was drawn.
struct AlarmRunFacts {
    std::string controller; ///< its key
    int objects = 0;
    double source_K = 0.0;
    SourceModel sourceModel = SourceModel::Gray;
    double noise_K = 0.0, lag_s = 0.0, convection_W_m2K = 0.0;
    ReadBy readBy = ReadBy::Contact;
    double cameraNoise_K = 0.0;
    double emittanceError = 0.0; ///< largest of the objects', of what is believed
    SimulatedFault fault = SimulatedFault::None;
    std::string object; ///< that has the fault; empty: none
    double fault_s = 0.0;
};

/// The result of one run.
struct AlarmStudyRow {
    AlarmRunFacts drawn;
    double simulated_s = 0.0;
    std::vector<RaisedAlarm> alarms;
    bool isTripped = false;          ///< the engine paused or ended the run
    double overTrip_K = -1e9;        ///< highest true temperature above its object's trip limit
    double overTarget_K = -1e9;      ///< and above its target
    std::optional<double> shown_s{}; ///< when the fault became visible, since its start
    std::optional<double> told_s{};  ///< when the first alarm of it was raised, since its start
    std::optional<double> acted_s{}; ///< when an alarm of it was raised and the run was paused or ended
    double unseen_K = 0.0;           ///< largest distance of the faulty sensor from its object until then
    /// Largest distance of the objects of swapped sensors in the first kAlarmSoon_s, where the camera reads
    /// both: what it takes to tell them soon.
    double apartSoon_K = 0.0;
    std::string refusal; ///< why a run could not be started, in words
};

/// Errors: rigs from which nothing can be drawn.
Result<void> check(const AlarmStudy& study);
/// Returns the row of the study's run number `index` (from 0), which depends on nothing else. Thread-safe.
AlarmStudyRow runAlarmCase(const AlarmStudy& study, int index);
/// Runs all draws on `threads` threads (0: one for each core); the rows do not depend on their number.
/// `progress` may be empty; it is called on the calling thread with the number of finished runs. Errors:
/// those of check().
Result<std::vector<AlarmStudyRow>> runAlarmStudy(const AlarmStudy& study, int threads,
                                                 const std::function<void(int done)>& progress);

/// Results of one fault's draws.
struct FaultSummary {
    SimulatedFault fault = SimulatedFault::None;
    int draws = 0;
    int shown = 0; ///< faults that became visible, or were found
    /// Faults with an alarm and a reaction; only the alarm for a frozen sensor, because nothing more can be
    /// known at rest, and for a lost thermal camera where sensors tell the temperatures.
    int found = 0;
    int acted = 0;                        ///< runs that were paused or ended by it
    double median_s = 0.0, worst_s = 0.0; ///< of those found, since they became visible
    double unseen_K = 0.0;                ///< worst of those that were not found
    double overTrip_K = -1e9;
};

struct AlarmSummary {
    double hours = 0.0; ///< simulated
    int falseTrips = 0, falseWords = 0;
    std::array<int, 3> alarms{}; ///< number of alarms of priority 1, 2, 3 that are causes
    std::array<double, 3> per10min{};
    std::array<double, 3>
        shares{};       ///< shares of the priorities if each fault is as frequent as alarmFaultFrequency()
    int maxIn10min = 0; ///< of all runs, with consequences
    double overTrip_K = -1e9;
    int refused = 0;
    std::vector<FaultSummary> faults;
};
AlarmSummary summarize(const std::vector<AlarmStudyRow>& rows);

/// Returns the table as CSV, with definitions in comment lines before the header.
std::string alarmCsv(const AlarmStudy& study, const std::vector<AlarmStudyRow>& rows);

} // namespace bask
