#pragma once
// A recorded run of any length, read as it is looked at: a day of samples opens as quickly as a minute.
//
// How a page shows one:
// - header: facts(), all of SessionRecord but the samples, there at once;
// - plot: overview() and targetSteps(), or TracePlot::setRun(), which reads the samples it comes close to;
// - replay: sampleAt(time_s);
// - metrics: readSamples(path, ...) on another thread, every sample once, none kept.

#include "engine/recording/session_file.h"
#include "engine/recording/trace_overview.h"

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <stop_token>
#include <string>
#include <utility>
#include <vector>

namespace bask {

class SessionStore;
class SessionTables;

class RecordedSession {
public:
    /// Samples read at once and kept; the last kMaxBlocks looked at stay in memory. A second after the last
    /// reading the file is let go until the next.
    static constexpr std::size_t kBlock = 256;
    static constexpr std::size_t kMaxBlocks = 160;

    /// On any thread; the methods below on one thread, the one that reads first. A file of version 1 has no
    /// overview and is read whole. Errors: those of readSession, but damage inside may show only where it is
    /// read.
    static Result<std::shared_ptr<RecordedSession>> open(const std::string& path);
    ~RecordedSession();
    RecordedSession(const RecordedSession&) = delete;
    RecordedSession& operator=(const RecordedSession&) = delete;

    const SessionRecord& facts() const { return m_facts; } ///< without samples
    const TraceOverview& overview() const { return m_overview; }
    /// Times at which an object's target changed, with the new target, K.
    const std::vector<std::pair<double, double>>& targetSteps(std::size_t object) const {
        return m_targets[object];
    }

    /// Samples at the time of opening.
    std::size_t size() const { return m_overview.samples(); }
    double lastTime_s() const { return m_overview.lastTime_s(); }

    /// The newest sample at or before a time, else the first. Errors: a damaged file, a run without samples.
    Result<TraceSample> sampleAt(double time_s);
    /// Samples with from_s <= time <= to_s.
    Result<std::vector<TraceSample>> samples(double from_s, double to_s);
    /// First sample not before a time; size() when there is none.
    Result<std::size_t> lowerIndex(double time_s);
    /// Samples of block k, the last one shorter; valid until the next call. Null: it cannot be read, and is
    /// not tried again.
    const std::vector<TraceSample>* block(std::size_t k);
    bool holds(std::size_t k) const; ///< block k needs no reading

private:
    struct Block {
        std::size_t index = 0;
        std::uint64_t used = 0;
        std::vector<TraceSample> samples;
    };

    RecordedSession() = default;
    Result<void> readOverview(const SessionStore& store);
    Result<void> readTargets(const SessionStore& store);
    void adopt(std::vector<TraceSample> samples);
    Result<std::vector<TraceSample>> readBlock(std::size_t k);

    SessionRecord m_facts;
    std::unique_ptr<SessionTables> m_tables; ///< null: all is in memory
    TraceOverview m_overview;
    std::vector<std::vector<std::pair<double, double>>> m_targets;
    bool m_isWhole = false; ///< all blocks are in memory
    std::vector<Block> m_blocks;
    std::uint64_t m_uses = 0;
    std::map<std::size_t, Error> m_failed; ///< blocks
    struct Reader;
    std::unique_ptr<Reader> m_reader; ///< of the thread that reads
};

/// When Stop or STOP came; infinity when there was none.
double controlledUntil_s(const SessionRecord& facts);

/// Calls `take` for each sample of a session, in order, until it is asked to stop. Errors: those of
/// readSession.
Result<void> readSamples(const std::string& path, const std::function<void(const TraceSample&)>& take,
                         const std::stop_token& stop = {});

} // namespace bask
