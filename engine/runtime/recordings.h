#pragma once
// The recordings of an engine: the one that is being made, the one that is written, and those whose last rows
// are on their way.

#include "engine/runtime/session_recorder.h"

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace bask {

/// Nothing here waits for a disk, but unsaved() for as long as it is told.
class Recordings {
public:
    /// Begins to make a file; no effect on the one that is written.
    void begin(const std::string& path, const Experiment& experiment, bool isSimulated, double minDisk_MB);
    bool isBeginning() const { return m_beginning != nullptr; }
    /// Empty while the begun file is not there yet, and where none was begun.
    std::optional<Result<void>> made() const;
    /// The begun one is written from now on.
    void takeBegun();
    /// The begun one is void.
    void dropBegun();

    bool isOn() const { return m_current != nullptr; }
    const std::string& path() const { return m_current->path(); } ///< of the one that is written
    /// No effect where none is written. One that fails is given up.
    Result<void> add(LoopRecord rows);
    /// Ends the one that is written, if there is one.
    void close(const std::string& outcome);

    /// Errors of those that have been finished since the last call.
    std::vector<Error> takeFailures();
    /// Waits until all that was closed is on the disk; says in words what is not by then.
    std::vector<std::string> unsaved(std::chrono::milliseconds bound) const;
    /// The one that is written, or else the one closed last; null: there was none lately.
    const SessionRecorder* newest() const;

private:
    std::unique_ptr<SessionRecorder> m_beginning, m_current;
    std::vector<std::unique_ptr<SessionRecorder>> m_ending;
};

} // namespace bask
