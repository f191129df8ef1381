#pragma once
// An engine on a thread of its own, as the GUI has it.

#include "engine/base/message_code.h"
#include "engine/runtime/engine_worker.h"

#include <QCoreApplication>
#include <QElapsedTimer>
#include <QThread>

#include <algorithm>
#include <functional>
#include <iterator>
#include <optional>
#include <utility>
#include <vector>

namespace bask {

/// Worker on its thread, with everything it published.
class EngineThread : public QObject {
public:
    explicit EngineThread(const std::string& alarmFile = {}, const std::string& deviceFile = {},
                          std::unique_ptr<Clock> awake = std::make_unique<AwakeClock>(),
                          std::function<void(const Snapshot&)> watch = {})
        : m_worker(alarmFile, deviceFile, std::move(awake)) {
        m_worker.setWatch({[] { return true; }, std::move(watch)});
        m_worker.moveToThread(&m_thread);
        connect(&m_thread, &QThread::started, &m_worker, &EngineWorker::start);
        connect(&m_worker, &EngineWorker::published, this, [this](const Snapshot& snapshot) {
            last = snapshot;
            if (snapshot.refusal.code != MessageCode::None)
                refusal = snapshot.refusal;
            samples += snapshot.newSamples.size();
            if (std::exchange(m_runId, snapshot.runId) != snapshot.runId)
                firstOfRun_s.reset();
            if (!firstOfRun_s && !snapshot.newSamples.empty())
                firstOfRun_s = snapshot.newSamples.front().time_s;
            ++snapshots;
            std::ranges::copy(snapshot.newEvents, std::back_inserter(events));
            inOrder = inOrder && snapshot.sequence == m_sequence + 1;
            m_sequence = snapshot.sequence;
        });
        connect(&m_worker, &EngineWorker::looked, this,
                [this](const std::shared_ptr<const VisionView>& looked) {
                    view = looked;
                    ++views;
                });
        m_thread.start();
    }
    explicit EngineThread(std::function<void(const Snapshot&)> watch)
        : EngineThread({}, {}, std::make_unique<AwakeClock>(), std::move(watch)) {}
    ~EngineThread() override {
        QMetaObject::invokeMethod(&m_worker, &EngineWorker::shutdown, Qt::BlockingQueuedConnection);
        m_thread.quit();
        m_thread.wait();
    }
    void send(const Command& command) {
        QMetaObject::invokeMethod(&m_worker, [this, command] { m_worker.post(command); });
    }
    /// On the engine's thread; waits for it.
    template <class Work> void ask(Work work) {
        QMetaObject::invokeMethod(&m_worker, std::move(work), Qt::BlockingQueuedConnection);
    }
    template <class Condition> bool waitFor(Condition condition, int limit_ms = 60000) {
        QElapsedTimer timer;
        timer.start();
        while (!condition() && timer.elapsed() < limit_ms)
            QCoreApplication::processEvents(QEventLoop::WaitForMoreEvents, 50);
        return condition();
    }
    bool reaches(RunState state) {
        return waitFor([&] { return last.state == state; });
    }

    Snapshot last;
    Message refusal;
    std::size_t samples = 0;
    std::optional<double> firstOfRun_s; ///< time of the first sample told with the newest run's number
    std::vector<TraceEvent> events;
    std::shared_ptr<const VisionView> view; ///< handed on last
    int views = 0;
    int snapshots = 0;
    bool inOrder = true;

private:
    QThread m_thread;
    EngineWorker m_worker;
    std::uint64_t m_sequence = 0, m_runId = 0;
};

} // namespace bask
