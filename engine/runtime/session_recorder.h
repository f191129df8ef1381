#pragma once
// Writes a run into its session file on a thread of its own: a slow disk does not hold up the engine.

#include "engine/runtime/loop_record.h"

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

namespace bask {

class SessionRecorder {
public:
    static constexpr std::chrono::milliseconds kCommit{500}; ///< rows wait so long at the most for the disk
    static constexpr std::chrono::seconds kStuck{
        10}; ///< a disk that has taken nothing for so long has failed

    /// Waits for the file to be made. Errors: those of SessionWriter::create.
    static Result<std::unique_ptr<SessionRecorder>> create(const std::string& path,
                                                           const Experiment& experiment, bool simulated);
    ~SessionRecorder(); ///< waits until what was added is written
    SessionRecorder(const SessionRecorder&) = delete;
    SessionRecorder& operator=(const SessionRecorder&) = delete;

    /// Never waits for the disk. Errors: what has failed since the last call.
    Result<void> add(LoopRecord rows);
    /// Marks the run complete, as SessionWriter::finish; waits.
    Result<void> finish(const std::string& outcome);

    const std::string& path() const { return m_path; }
    /// Samples that a killed program, or a power cut, does not lose any more.
    std::size_t rows() const { return m_rows; }

private:
    explicit SessionRecorder(std::string path) : m_path(std::move(path)) {}
    void writeAll(SessionWriter& writer);
    void end();

    std::string m_path;
    std::atomic<std::size_t> m_rows = 0;
    std::mutex m_mutex; ///< of all below
    std::condition_variable m_wake;
    std::vector<LoopRecord> m_waiting;
    std::chrono::steady_clock::time_point m_waits; ///< since when the first of them does
    std::optional<std::string> m_outcome;
    std::optional<Error> m_failed;
    bool m_isOver = false;
    std::thread m_thread;
};

} // namespace bask
