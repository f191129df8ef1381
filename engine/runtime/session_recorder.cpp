#include "engine/runtime/session_recorder.h"

#include "engine/base/message_code.h"
#include "engine/base/thread_name.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <condition_variable>
#include <filesystem>
#include <mutex>
#include <thread>
#include <utility>
#include <vector>

namespace bask {
namespace {

using Steady = std::chrono::steady_clock;

Result<std::unique_ptr<SessionWriter>> makeFile(const std::string& path, const Experiment& experiment,
                                                bool simulated, double minFree_MB, const RunLabels& labels,
                                                SessionWriter::Earlier earlier) {
    if (const auto free_MB = diskFree_MB(path); free_MB && *free_MB < minFree_MB)
        return Error(MessageCode::SafetyDiskLow, {},
                     {formatNumber(std::floor(*free_MB), 6), formatNumber(minFree_MB, 6)});
    return SessionWriter::create(path, experiment, simulated,
                                 std::chrono::duration<double>(SessionRecorder::kCommit).count(), earlier,
                                 labels);
}

std::size_t bytesOf(const TraceFrame& frame) {
    return frame.picture->T_K.size() * sizeof(double);
}

Error stuck(const std::string& path) {
    return {MessageCode::FileUnwritable, path, {"the disk has taken nothing for 10 s"}};
}

std::atomic<int> underWay = 0; ///< threads that write or seal

} // namespace

struct SessionRecorder::Shared {
    void record(Result<std::unique_ptr<SessionWriter>> file) {
        {
            const std::lock_guard lock(mutex);
            made = file ? Result<void>() : Result<void>(file.error());
        }
        Result<void> result = file ? writeAll(**file) : Result<void>(file.error());
        if (file)
            static_cast<void>((*file)->close());
        {
            const std::lock_guard lock(mutex);
            finished = std::move(result);
        }
        if (file)
            file->reset(); // seals it, which nobody waits for
    }
    Result<void> writeAll(SessionWriter& writer);

    std::atomic<std::size_t> rows = 0;
    std::atomic<Steady::time_point> written = Steady::time_point::min(); ///< the last rows until now
    std::mutex mutex;                                                    ///< protects all members below
    std::condition_variable wake;
    std::vector<LoopRecord> waiting;
    std::size_t pictures = 0; ///< bytes of the pictures in them
    Steady::time_point waits; ///< since when the first of them waits
    std::optional<std::string> outcome;
    std::optional<Result<void>> made, finished;
    bool isOver = false;
};

SessionRecorder::SessionRecorder(const std::string& path, const Experiment& experiment, bool simulated,
                                 double minFree_MB, const RunLabels& labels, Earlier earlier)
    : m_path(path), m_shared(std::make_shared<Shared>()) {
    ++underWay;
    std::thread([shared = m_shared, path, experiment, simulated, minFree_MB, labels, earlier] {
        nameThread("recorder");
        shared->record(makeFile(path, experiment, simulated, minFree_MB, labels, earlier));
        --underWay;
    }).detach();
}

SessionRecorder::~SessionRecorder() {
    {
        const std::lock_guard lock(m_shared->mutex);
        m_shared->isOver = true;
    }
    m_shared->wake.notify_one();
}

Result<void> SessionRecorder::Shared::writeAll(SessionWriter& writer) {
    std::unique_lock lock(mutex);
    for (;;) {
        wake.wait_for(lock, kCommit, [this] { return isOver; });
        const bool isLast = isOver;
        const auto last = outcome; // belongs to the rows taken here
        const auto taken = std::exchange(waiting, {});
        pictures = 0;
        lock.unlock();
        Result<void> done;
        for (const LoopRecord& each : taken)
            if (done) {
                done = write(each, writer);
                written = Steady::now();
            }
        if (done && !taken.empty())
            done = writer.flush();
        if (done && isLast && last)
            done = writer.finish(*last);
        if (done)
            rows = writer.rows();
        lock.lock();
        if (!done || isLast)
            return done;
    }
}

std::optional<Result<void>> SessionRecorder::made() const {
    const std::lock_guard lock(m_shared->mutex);
    if (!m_shared->made && Steady::now() - m_begun > kStuck)
        return Result<void>(stuck(m_path));
    return m_shared->made;
}

Result<void> SessionRecorder::add(LoopRecord rows) {
    const auto now = Steady::now();
    const std::lock_guard lock(m_shared->mutex);
    if (m_shared->finished)
        return *m_shared->finished;
    if (m_shared->waiting.empty())
        m_shared->waits = now;
    else if (now - std::max(m_shared->waits, m_shared->written.load()) > kStuck)
        return stuck(m_path);
    std::erase_if(rows.frames, [&](const TraceFrame& frame) {
        const bool isRoom = m_shared->pictures + bytesOf(frame) <= kMaxPictures;
        m_shared->pictures += isRoom ? bytesOf(frame) : 0;
        return !isRoom;
    });
    m_shared->waiting.push_back(std::move(rows));
    return {};
}

void SessionRecorder::finish(const std::string& outcome) {
    m_ended = Steady::now();
    {
        const std::lock_guard lock(m_shared->mutex);
        m_shared->outcome = outcome;
        m_shared->isOver = true;
    }
    m_shared->wake.notify_one();
}

std::optional<Result<void>> SessionRecorder::finished() const {
    const std::lock_guard lock(m_shared->mutex);
    if (!m_shared->finished && m_shared->isOver &&
        Steady::now() - std::max(m_ended, m_shared->written.load()) > kStuck)
        return Result<void>(stuck(m_path));
    return m_shared->finished;
}

bool SessionRecorder::waitForAll(std::chrono::milliseconds bound) {
    const auto deadline = Steady::now() + bound;
    while (underWay > 0 && Steady::now() < deadline)
        std::this_thread::sleep_for(std::chrono::milliseconds(2));
    return underWay == 0;
}

std::size_t SessionRecorder::rows() const {
    return m_shared->rows;
}

std::optional<double> diskFree_MB(const std::string& file) {
    std::error_code code;
    const auto folder = std::filesystem::absolute(file, code).parent_path();
    const auto space = std::filesystem::space(folder, code);
    return code ? std::nullopt : std::optional(static_cast<double>(space.available) * 1e-6);
}

} // namespace bask
