#pragma once
// A recorded run of any length that is read on demand: a day of samples opens as quickly as a minute.
//
// How a page shows it:
// - header: facts(), all of SessionRecord except the samples, available at once;
// - plot: overview() and targetSteps(), or TracePlot::setRun(), which reads the samples that it zooms in on;
// - replay: sampleAt(time_s);
// - metrics: readSamples(path, ...) on another thread, every sample once, none stored.

#include "engine/recording/session_file.h"
#include "engine/recording/trace_overview.h"

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <stop_token>
#include <string>
#include <utility>
#include <vector>

namespace bask {

class SessionStore;
class SessionTables;

/// A recorded picture of the thermal camera.
struct RecordedFrame {
    std::int64_t number = 0; ///< of the pictures of a session, ascending
    double time_s = 0.0;
    std::string png; ///< frameOfImage() reads it
};

class RecordedSession {
public:
    /// Number of samples that are read together; the last kMaxBlocks used blocks stay in memory. The file is
    /// closed a second after the last reading, until the next one.
    static constexpr std::size_t kBlock = 256;
    static constexpr std::size_t kMaxBlocks = 160;

    /// May be called on any thread; call the other methods on one thread, the one that reads first. A file of
    /// version 1 has no overview and is read completely, as a run of up to half an hour is. Errors: those of
    /// readSession, but missing samples, and what no run records in a longer run, may be found only when that
    /// part is read.
    static Result<std::shared_ptr<RecordedSession>> open(const std::string& path);
    ~RecordedSession();
    RecordedSession(const RecordedSession&) = delete;
    RecordedSession& operator=(const RecordedSession&) = delete;

    const SessionRecord& facts() const { return m_facts; } ///< without samples
    const TraceOverview& overview() const { return m_overview; }
    /// Returns the times at which an object's target changed, with the new target, K.
    const std::vector<std::pair<double, double>>& targetSteps(std::size_t object) const {
        return m_targets[object];
    }

    /// Returns the number of samples at the time of opening.
    std::size_t size() const { return m_overview.samples(); }
    double lastTime_s() const { return m_overview.lastTime_s(); }

    /// Returns the newest sample at or before a time, else the first. Errors: a damaged file, a run without
    /// samples.
    Result<TraceSample> sampleAt(double time_s);
    /// Returns the first sample at or after a time, else the last. Errors: those of sampleAt.
    Result<TraceSample> sampleFrom(double time_s);
    /// Returns the samples with from_s <= time <= to_s.
    Result<std::vector<TraceSample>> samples(double from_s, double to_s);
    /// Returns the index of the first sample at or after a time; size() if there is none.
    Result<std::size_t> lowerIndex(double time_s);
    /// Returns the samples of block k, of which the last is shorter; valid until the next call. Null if it
    /// cannot be read; it is not tried again.
    const std::vector<TraceSample>* block(std::size_t k);
    bool holds(std::size_t k) const; ///< whether block k is in memory

    /// Whether there were pictures of the thermal camera at the time of opening.
    bool hasThermalFrames() const { return m_lastFrame > 0; }
    /// Returns the newest picture of the thermal camera at or before a time, else the first. Errors: a
    /// damaged file, a run without pictures.
    Result<RecordedFrame> thermalFrameAt(double time_s);

private:
    struct Block {
        std::size_t index = 0;
        std::uint64_t used = 0;
        std::vector<TraceSample> samples;
    };

    RecordedSession() = default;
    Result<void> readOverview(const SessionStore& store);
    Result<bool> readWhole(const SessionStore& store);
    Result<void> readTargets(const SessionStore& store);
    Result<void> countFrames(const SessionStore& store);
    void adopt(std::vector<TraceSample> samples);
    Result<std::vector<TraceSample>> readBlock(std::size_t k);
    Result<TraceSample> sample(std::size_t index);
    Result<std::size_t>
    indexFrom(double time_s); ///< of the first sample at or after a time, else of the last
    Result<SessionStore*> store();

    SessionRecord m_facts;
    std::unique_ptr<SessionTables> m_tables; ///< null if everything is in memory
    TraceOverview m_overview;
    std::vector<std::vector<std::pair<double, double>>> m_targets;
    std::int64_t m_lastFrame = 0;
    bool m_isWhole = false; ///< whether all blocks are in memory
    std::vector<Block> m_blocks;
    std::uint64_t m_uses = 0;
    std::map<std::size_t, Error> m_failed; ///< errors of blocks
    struct Reader;
    std::unique_ptr<Reader> m_reader; ///< used by the thread that reads
};

/// The events that end a run.
std::span<const MessageCode> runEnds();
/// Returns the time of the first of them since Start; infinity if there was none.
double controlledUntil_s(const SessionRecord& facts);
/// Returns the priority of the alarm for which the engine ended the run, by the event that ended it; 0 if
/// that tells none.
int endPriority(const Message& end);
/// Returns the same of a record: of the first event that ended it; 0 if there was none.
int endPriority(const SessionRecord& facts);
/// Returns when Start was pressed, s since 1970 in UTC by the computer's clock; empty in files of the first
/// versions, and before Start.
std::optional<double> startedUtc_s(const SessionRecord& facts);
/// Whether the record has no end, but tells of a Stop or STOP: what followed it, the retreat as well, may be
/// missing in part.
bool isCutAfterStop(const SessionRecord& facts);

/// Calls `take` for each sample of a session, in order, until `stop` is requested. Errors: those of
/// readSession.
Result<void> readSamples(const std::string& path, const std::function<void(const TraceSample&)>& take,
                         const std::stop_token& stop = {}, const ShareDone& done = {});

} // namespace bask
