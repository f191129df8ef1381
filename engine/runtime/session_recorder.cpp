#include "engine/runtime/session_recorder.h"

#include "engine/base/message_code.h"

#include <future>
#include <utility>

namespace bask {

Result<std::unique_ptr<SessionRecorder>>
SessionRecorder::create(const std::string& path, const Experiment& experiment, bool simulated) {
    std::unique_ptr<SessionRecorder> recorder(new SessionRecorder(path));
    std::promise<Result<void>> made;
    auto answer = made.get_future();
    recorder->m_thread = std::thread([raw = recorder.get(), &made, path, experiment, simulated] {
        const auto writer = SessionWriter::create(path, experiment, simulated); // its own thread's
        made.set_value(writer ? Result<void>() : Result<void>(writer.error()));
        if (writer)
            raw->writeAll(**writer);
    });
    if (const auto done = answer.get(); !done)
        return done.error();
    return recorder;
}

SessionRecorder::~SessionRecorder() {
    end();
}

void SessionRecorder::end() {
    {
        const std::lock_guard lock(m_mutex);
        m_isOver = true;
    }
    m_wake.notify_one();
    if (m_thread.joinable())
        m_thread.join();
}

void SessionRecorder::writeAll(SessionWriter& writer) {
    std::unique_lock lock(m_mutex);
    while (!m_failed) {
        m_wake.wait_for(lock, kCommit, [this] { return m_isOver; });
        const bool isLast = m_isOver;
        const auto rows = std::exchange(m_waiting, {});
        lock.unlock();
        Result<void> done;
        for (const LoopRecord& each : rows)
            if (done)
                done = write(each, writer);
        if (done && !rows.empty())
            done = writer.flush();
        if (done && isLast && m_outcome) // set before the end, and not since
            done = writer.finish(*m_outcome);
        if (done)
            m_rows = writer.rows();
        lock.lock();
        if (!done)
            m_failed = done.error();
        if (isLast)
            return;
    }
}

Result<void> SessionRecorder::add(LoopRecord rows) {
    const auto now = std::chrono::steady_clock::now();
    const std::lock_guard lock(m_mutex);
    if (m_failed)
        return *m_failed;
    if (m_waiting.empty())
        m_waits = now;
    else if (now - m_waits > kStuck)
        return Error(MessageCode::FileUnwritable, m_path, {"the disk has taken nothing for 10 s"});
    m_waiting.push_back(std::move(rows));
    return {};
}

Result<void> SessionRecorder::finish(const std::string& outcome) {
    {
        const std::lock_guard lock(m_mutex);
        m_outcome = outcome;
    }
    end();
    return m_failed ? Result<void>(*m_failed) : Result<void>();
}

} // namespace bask
