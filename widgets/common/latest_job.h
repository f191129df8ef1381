#pragma once
// Work off the GUI thread where only the newest answer counts: file reading, contour import, feasibility.

#include <QFutureWatcher>
#include <QObject>
#include <QtConcurrentRun>

#include <functional>
#include <memory>
#include <utility>

namespace bask {

/// Runs one request at a time on the thread pool. A newer request replaces one that waits and silences one
/// that runs. GUI thread only; `work` sees nothing but what it captured by value. `done` is not called after
/// the owner's end.
template <class Value> class LatestJob {
public:
    using Work = std::function<Value()>;
    using Done = std::function<void(Value)>;

    LatestJob() {
        QObject::connect(&m_watcher, &QFutureWatcherBase::finished, &m_watcher, [this] { finish(); });
    }

    void run(Work work, Done done) {
        m_next = {std::move(work), std::move(done)};
        if (!busy())
            startNext();
    }

    /// Nobody wants the answer any more: drops what waits and silences what runs.
    void forget() {
        m_next = {};
        m_running.done = nullptr;
    }

    bool busy() const { return m_running.work != nullptr; }

private:
    struct Request {
        Work work;
        Done done;
    };

    void startNext() {
        m_running = std::exchange(m_next, {});
        m_watcher.setFuture(
            QtConcurrent::run([work = m_running.work] { return std::make_shared<Value>(work()); }));
    }

    void finish() {
        const std::shared_ptr<Value> value = m_watcher.result();
        const Request finished = std::exchange(m_running, {});
        if (m_next.work)
            startNext();
        else if (finished.done)
            finished.done(std::move(*value));
    }

    Request m_running;
    Request m_next;
    QFutureWatcher<std::shared_ptr<Value>> m_watcher;
};

} // namespace bask
