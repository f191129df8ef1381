#pragma once
// A recorded run in one SQLite file (*.bask): the experiment and every sample, command, event and note in
// order of time.

#include "engine/base/share_done.h"
#include "engine/drivers/traffic_log.h"
#include "engine/model/experiment.h"
#include "engine/model/predicted_run.h"
#include "engine/model/run_labels.h"
#include "engine/model/trace.h"

#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace bask {

inline constexpr int kSessionApplicationId = 0x4261736b; ///< "Bask"
inline constexpr int kSessionVersion = 2;                ///< PRAGMA user_version
/// A number further on is of no Bask to come: a byte of the file was changed.
inline constexpr int kMaxVersionsToCome = 100;

/// The commands that were sent, as text: one row for each ("targets", "gains", "hold" ...), with its value as
/// JSON.
struct CommandRow {
    double time_s = 0.0;
    std::string name;
    std::string value;
    std::string operatorName{}; ///< who operated at this time; empty if not known
};

/// Writes a run while it happens (WAL, synchronous=FULL). Rows are committed within commitInterval_s of wall
/// time after they were added, so a killed process loses at most that. Use it only on the thread that opened
/// it.
class SessionWriter {
public:
    /// What becomes of a recording that has the name already.
    enum class Earlier { Replaced, Kept };

    /// Of several processes that make one file at a time, one gets it; the others are refused. An old one
    /// stays until the new one can be written, whenever the process is killed. Errors: SessionBusy,
    /// FileUnwritable, also where an earlier recording is to be kept.
    static Result<std::unique_ptr<SessionWriter>>
    create(const std::string& path, const Experiment& experiment, bool simulated,
           double commitInterval_s = 0.5, Earlier earlier = Earlier::Kept, const RunLabels& labels = {});
    ~SessionWriter(); ///< commits, closes and seals

    Result<void> add(const TraceSample& sample);
    Result<void> add(const TraceEvent& event);
    Result<void> add(const TraceNote& note);
    Result<void> add(const CommandRow& command);
    /// Adds a picture of the experiment's thermal camera, without loss.
    Result<void> add(const TraceFrame& frame);
    /// Adds what went over a link to a device; `start_s` is the time of Start on its clock. The first one
    /// makes the table.
    Result<void> add(const TrafficLine& line, double start_s);
    /// Adds the run as it was predicted before Start, once more if its band was found since; the last one
    /// counts. The first one makes the table.
    Result<void> add(const PredictedRun& run);
    Result<void> flush(); ///< commits now
    /// Commits and closes the file of a finished run; the destructor then only seals it, which takes as long
    /// as reading it.
    Result<void> close();
    Result<void> finish(const std::string& outcome); ///< marks the run complete ("settled", "not-settled",
                                                     ///< "stopped", "fault")

    const std::string& path() const;
    std::size_t rows() const; ///< number of samples added so far

    SessionWriter(const SessionWriter&) = delete;
    SessionWriter& operator=(const SessionWriter&) = delete;

private:
    struct Impl;
    explicit SessionWriter(std::unique_ptr<Impl> impl);
    std::unique_ptr<Impl> m_impl;
};

/// A whole recorded run, in memory.
struct SessionRecord {
    std::string path;
    Experiment experiment;
    std::string created;  ///< ISO 8601, UTC
    std::string finished; ///< the same; empty if it has no end
    std::string software; ///< "Bask 0.1.0"
    bool simulated = false;
    RunLabels labels;    ///< when the recording began; each command and note has its own operator
    std::string outcome; ///< empty: interrupted
    std::string verification = "not verified"; ///< verificationOf() the file, where an export tells it
    std::vector<TraceSample> samples;
    std::vector<TraceEvent> events;
    std::vector<TraceNote> notes;
    std::vector<CommandRow> commands;
    /// The run as it was predicted before Start, without places of the end-effector; without samples where
    /// nothing was predicted.
    PredictedRun prediction{};

    bool interrupted() const { return outcome.empty(); }
    RecordedRig rig() const { return {simulated, thermalProfile(experiment, simulated).has_value()}; }
    /// Returns the samples until Stop or STOP; the later ones are the retreat and cool-down. All samples if
    /// there was none.
    std::vector<TraceSample> controlledSamples() const;
};

/// Reads a session; refuses a file that is not one, is damaged, or comes from a newer version. Never changes
/// the file's data.
Result<SessionRecord> readSession(const std::string& path, const ShareDone& done = {});

/// Calls `take` with the time and the PNG of each recorded picture of the thermal camera, in their order.
Result<void> readThermalFrames(const std::string& path,
                               const std::function<void(double time_s, const std::string& png)>& take);

/// Copies a whole session, even one that is being written, or nothing.
Result<void> copySession(const std::string& from, const std::string& to);

/// Writes the recorded pictures of the thermal camera as TIFF of 16 bits with their times in times.csv: a
/// folder that plays as a thermal camera. Returns the files written. Error: NoThermalFrames.
Result<std::vector<std::string>> exportThermalFrames(const std::string& path, const std::string& folder,
                                                     const ShareDone& done = {});

/// The digits of the numbers in exported tables.
enum class CsvDigits {
    Meaningful, ///< csvRounding() of each column; times of the tables as they are recorded
    All         ///< as many as it takes to read the same double back; degC and errors of traces.csv to 1e-9 K
};

/// Writes traces.csv and one CSV for each table into an existing or new folder, with units in the headers.
/// Returns the files written.
Result<std::vector<std::string>> exportSessionCsv(const std::string& path, const std::string& folder,
                                                  const ShareDone& done = {},
                                                  CsvDigits digits = CsvDigits::Meaningful);

} // namespace bask
