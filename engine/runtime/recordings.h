#pragma once
// The recordings of an engine: the one that is being created, the one that is being written, and those whose
// last rows are still being saved.

#include "engine/runtime/session_recorder.h"

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace bask {

/// Nothing here waits for a disk, except unsaved() within its time limit.
class Recordings {
public:
    /// Starts to create a file; no effect on the recording that is being written.
    void begin(const std::string& path, const Experiment& experiment, bool isSimulated, double minDisk_MB,
               const RunLabels& labels, SessionRecorder::Earlier earlier);
    bool isBeginning() const { return m_beginning != nullptr; }
    /// Returns the result of creating the file; empty while it does not exist yet, and if none was started.
    std::optional<Result<void>> made() const;
    /// Writes into the new recording from now on.
    void takeBegun();
    /// Gives up the new recording.
    void dropBegun();

    bool isOn() const { return m_current != nullptr; }
    /// path of the recording that is being written; only while isOn()
    const std::string& path() const { return m_current->path(); }
    /// Adds rows; no effect if nothing is being recorded. A recording that fails is given up.
    Result<void> add(LoopRecord rows);
    /// Ends the recording that is being written, if there is one.
    void close(const std::string& outcome);

    /// Returns the errors of the recordings that have finished since the last call.
    std::vector<Error> takeFailures();
    /// Waits until all closed recordings are on the disk, at most `bound`. Returns in words which are not.
    std::vector<std::string> unsaved(std::chrono::milliseconds bound) const;
    /// Returns the recording that is being written, or the last closed one that is not yet finished; null if
    /// there is none.
    const SessionRecorder* newest() const;

private:
    std::unique_ptr<SessionRecorder> m_beginning, m_current;
    std::vector<std::unique_ptr<SessionRecorder>> m_ending;
};

} // namespace bask
