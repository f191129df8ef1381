#pragma once
// Work off the GUI thread where only the newest answer counts: file reading, contour import, feasibility.

#include <QFutureWatcher>
#include <QObject>
#include <QThreadPool>
#include <QtConcurrentRun>

#include <functional>
#include <memory>
#include <stop_token>
#include <type_traits>
#include <utility>

namespace bask {

/// Runs one request at a time on a thread pool, the common one unless another is given: what may keep a
/// thread for long has one of its own. A newer request replaces a waiting one and discards the answer of a
/// running one. GUI thread only; `work` may use only what it captured by value. `done` is not called after
/// the owner was destroyed.
template <class Value> class LatestJob {
public:
    using Work = std::function<Value(const std::stop_token&)>;
    using Done = std::function<void(Value)>;

    LatestJob() : LatestJob(*QThreadPool::globalInstance()) {}
    explicit LatestJob(QThreadPool& pool) : m_pool(pool) {
        QObject::connect(&m_watcher, &QFutureWatcherBase::finished, &m_watcher, [this] { finish(); });
    }

    ~LatestJob() { m_stop.request_stop(); }

    /// If `work` takes a std::stop_token, it is asked to stop when its answer is no longer needed.
    template <class Task> void run(Task work, Done done) {
        if constexpr (std::is_invocable_v<Task, std::stop_token>)
            m_next = {std::move(work), std::move(done)};
        else
            m_next = {[work = std::move(work)](const std::stop_token&) { return work(); }, std::move(done)};
        m_stop.request_stop();
        if (!busy())
            startNext();
    }

    /// Call when the answer is no longer needed: drops a waiting request and discards a running one.
    void forget() {
        m_next = {};
        m_running.done = nullptr;
        m_stop.request_stop();
    }

    bool busy() const { return m_running.work != nullptr; }

private:
    struct Request {
        Work work;
        Done done;
    };

    void startNext() {
        m_running = std::exchange(m_next, {});
        m_stop = std::stop_source();
        m_watcher.setFuture(QtConcurrent::run(&m_pool, [work = m_running.work, stop = m_stop.get_token()] {
            return std::make_shared<Value>(work(stop));
        }));
    }

    void finish() {
        const std::shared_ptr<Value> value = m_watcher.result();
        const Request finished = std::exchange(m_running, {});
        if (m_next.work)
            startNext();
        else if (finished.done)
            finished.done(std::move(*value));
    }

    QThreadPool& m_pool;
    Request m_running;
    Request m_next;
    std::stop_source m_stop; ///< stop source of the running request
    QFutureWatcher<std::shared_ptr<Value>> m_watcher;
};

} // namespace bask
