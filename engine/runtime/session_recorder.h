#pragma once
// Writes a run into its session file on a thread of its own. Nothing here waits for the disk.

#include "engine/runtime/loop_record.h"

#include <chrono>
#include <memory>
#include <optional>
#include <string>

namespace bask {

class SessionRecorder {
public:
    static constexpr std::chrono::milliseconds kCommit{500}; ///< rows wait so long at the most for the disk
    static constexpr std::chrono::seconds kStuck{
        10}; ///< a disk that has taken nothing for so long has failed

    /// Begins to make the file. It is not made where less than `minFree_MB` of room is left.
    SessionRecorder(const std::string& path, const Experiment& experiment, bool simulated,
                    double minFree_MB = 0.0);
    /// What was added is still written, by a thread that nobody waits for. One whose file was not finished
    /// reads as interrupted.
    ~SessionRecorder();
    SessionRecorder(const SessionRecorder&) = delete;
    SessionRecorder& operator=(const SessionRecorder&) = delete;

    /// Empty until the file is there. Errors: those of SessionWriter::create, SafetyDiskLow, and
    /// FileUnwritable after kStuck.
    std::optional<Result<void>> made() const;
    /// Also before the file is made. Errors: what has failed since the last call.
    Result<void> add(LoopRecord rows);
    /// Marks the run complete, as SessionWriter::finish, once all that was added is written.
    void finish(const std::string& outcome);
    /// Empty until finish() is carried out and the file closed. Errors: what has failed, and FileUnwritable
    /// after kStuck.
    std::optional<Result<void>> finished() const;

    const std::string& path() const { return m_path; }
    /// Samples that a killed program, or a power cut, does not lose any more.
    std::size_t rows() const;

private:
    struct Shared;
    std::string m_path;
    std::chrono::steady_clock::time_point m_begun = std::chrono::steady_clock::now(), m_ended;
    std::shared_ptr<Shared> m_shared; ///< with the thread, which may outlive this
};

/// Room that is left where a file is or will be; empty when the system does not tell. It may take as long as
/// a network does.
std::optional<double> diskFree_MB(const std::string& file);

} // namespace bask
