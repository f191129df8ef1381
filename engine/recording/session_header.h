#pragma once
// What a recorded run says of itself in a list of many, read without its samples, and what may be changed in
// a finished file: its tags, and an end that was never written.

#include "engine/base/result.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace bask {

inline constexpr const char* kOutcomeInterrupted = "interrupted"; ///< closed by closeInterrupted()
/// Of an interrupted recording at most this is missing, s: SessionWriter's commitInterval_s.
inline constexpr double kMaxLost_s = 0.5;

/// One file of a list.
struct SessionHeader {
    std::string path;
    std::string title; ///< of the experiment
    std::vector<std::string> objects;
    std::string created; ///< ISO 8601, UTC
    bool simulated = false;
    std::string outcome; ///< empty: interrupted, or still being recorded
    std::uint64_t samples = 0;
    double end_s = 0.0; ///< of the last sample since Start; 0 without one
    std::vector<std::string> notes;
    std::vector<std::string> tags;
    std::optional<Error> error; ///< why it cannot be read; all but the path is empty then
};

/// Some milliseconds, however long the run. A damage in the midst of the samples is found by readSession()
/// only.
SessionHeader readSessionHeader(const std::string& path);

/// The *.bask files of a folder, without those in its folders, in no order. A folder that is not there has
/// none.
std::vector<std::string> sessionFiles(const std::string& folder);

/// Replaces the tags in one transaction that touches no sample. Refuses a session that has no end yet: a run
/// may be being recorded into it.
Result<void> writeSessionTags(const std::string& path, const std::vector<std::string>& tags);

/// Gives an interrupted recording its end: all of it is read first, the log is folded in, and the outcome
/// "interrupted" is put down in one transaction. Whatever fails, what was recorded stays as it was. Refuses a
/// file that is damaged or being recorded into; one that has its end is left alone.
Result<void> closeInterrupted(const std::string& path);

} // namespace bask
