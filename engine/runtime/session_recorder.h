#pragma once
// Writes a run into its session file on its own thread. No call waits for the disk.

#include "engine/runtime/loop_record.h"

#include <chrono>
#include <memory>
#include <optional>
#include <string>

namespace bask {

class SessionRecorder {
public:
    /// longest time that rows wait before they are written
    static constexpr std::chrono::milliseconds kCommit{500};
    static constexpr std::chrono::seconds kStuck{
        10}; ///< a disk that has taken nothing for so long has failed
    /// How much memory thermal pictures take that wait, bytes; later ones are left out until there is room.
    static constexpr std::size_t kMaxPictures = 128 << 20;

    using Earlier = SessionWriter::Earlier;
    /// Starts to create the file. It is not created if less than `minFree_MB` of disk space is left.
    SessionRecorder(const std::string& path, const Experiment& experiment, bool simulated,
                    double minFree_MB = 0.0, const RunLabels& labels = {}, Earlier earlier = Earlier::Kept);
    /// Rows that were added are still written, by a thread that nobody waits for. A file without finish()
    /// reads as interrupted.
    ~SessionRecorder();
    SessionRecorder(const SessionRecorder&) = delete;
    SessionRecorder& operator=(const SessionRecorder&) = delete;

    /// Returns the result of creating the file; empty until then. Errors: those of SessionWriter::create,
    /// SafetyDiskLow, and FileUnwritable after kStuck.
    std::optional<Result<void>> made() const;
    /// Adds rows, also before the file exists; pictures only within kMaxPictures. Errors: the failure that
    /// ended the writing, and FileUnwritable after kStuck.
    Result<void> add(LoopRecord rows);
    /// Marks the run as complete, as SessionWriter::finish does, after all added rows are written.
    void finish(const std::string& outcome);
    /// Returns the result of the writing; empty until the file is closed. Errors: what has failed, and
    /// FileUnwritable kStuck after finish().
    std::optional<Result<void>> finished() const;

    const std::string& path() const { return m_path; }
    /// Number of samples that are safe on the disk, even if the program is killed or the power fails.
    std::size_t rows() const;

    /// Waits until no thread of any recorder writes or seals a file, at most `bound`; returns whether that is
    /// so. A program that ends earlier takes its database from under a seal.
    static bool waitForAll(std::chrono::milliseconds bound);

private:
    struct Shared;
    std::string m_path;
    std::chrono::steady_clock::time_point m_begun = std::chrono::steady_clock::now(), m_ended;
    std::shared_ptr<Shared> m_shared; ///< shared with the thread, which may outlive this object
};

/// Returns the free disk space where a file is or will be; empty if the system does not tell. May take as
/// long as a network disk takes.
std::optional<double> diskFree_MB(const std::string& file);

} // namespace bask
