#pragma once
// What a list of recorded runs shows of each, read without its samples, and what may be changed in a finished
// file: its tags, and a missing end.

#include "engine/base/result.h"
#include "engine/model/run_labels.h"
#include "engine/recording/session_verify.h"

#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace bask {

inline constexpr const char* kOutcomeInterrupted = "interrupted"; ///< closed by closeInterrupted()
/// At most this part of an interrupted recording is missing, s: commitInterval_s of SessionWriter.
inline constexpr double kMaxLost_s = 0.5;

/// What a list tells of an object; what the file does not say is NaN or empty.
struct ListedObject {
    std::string name;
    double target_K = std::numeric_limits<double>::quiet_NaN(); ///< when the recording began
    std::string material{};
    double emittance = std::numeric_limits<double>::quiet_NaN();
};

/// One file of a list.
struct SessionHeader {
    std::string path;
    std::string title; ///< of the experiment
    std::vector<ListedObject> objects;
    std::string controller; ///< its name in files, when the recording began
    std::string created;    ///< ISO 8601, UTC
    bool simulated = false;
    RunLabels labels;
    std::string outcome; ///< empty: interrupted, or still being recorded
    std::uint64_t samples = 0;
    double end_s = 0.0; ///< time of the last sample since Start; 0 without one
    /// Time since Start at which the run ended: by Stop, STOP or the engine. Its record goes on until all is
    /// away, or cold. Empty if the file does not say.
    std::optional<double> stopped_s;
    /// Priority of the alarm for which the engine ended the run, 1 to 3; 0 if the file tells none.
    int endPriority = 0;
    std::vector<std::string> notes;
    std::vector<std::string> tags;
    std::optional<Error> error;  ///< why it cannot be read; all other members except the path are then empty
    std::optional<Error> damage; ///< in what a list does not read: never set by readSessionHeader()
    std::optional<SessionVerdict> alteration; ///< of a recording that is not as it was: nor set by that
    bool isVerified = false; ///< every row was looked at, and is as it was recorded: nor set by that

    /// Returns how long the run itself took, s: duration_s of its metrics.
    double length_s() const { return stopped_s.value_or(end_s); }
};

/// Takes some milliseconds for a run of any length. Damage among the samples is found only by readSession()
/// and checkSession().
SessionHeader readSessionHeader(const std::string& path);

/// Looks at the structure of the whole file, not at its values; takes a second for some 200 MB. Errors:
/// SessionDamaged, or it cannot be read.
Result<void> checkSession(const std::string& path);

/// Returns the *.bask files of a folder, without subfolders, in no particular order. None if the folder does
/// not exist.
std::vector<std::string> sessionFiles(const std::string& folder);

/// Replaces the tags in one transaction that does not touch samples. Refuses a session without an end,
/// because it may still be recorded.
Result<void> writeSessionTags(const std::string& path, const std::vector<std::string>& tags);

/// Writes the missing end of an interrupted recording: reads all of it, merges the log, and stores the
/// outcome "interrupted" in one transaction. On failure the recorded data is unchanged. Refuses a file that
/// is damaged or being recorded; a file with an end is not changed.
Result<void> closeInterrupted(const std::string& path);

} // namespace bask
