#include "engine/runtime/background_thread.h"

#include "engine/base/thread_name.h"

#include <condition_variable>
#include <deque>
#include <mutex>
#include <thread>

namespace bask {

/// Shared with the thread, which may outlive the owner.
struct BackgroundThread::Queue {
    bool isIdle() const { return waiting.empty() && !isBusy; }
    void work() {
        std::unique_lock lock(mutex);
        for (;;) {
            changed.wait(lock, [this] { return isOver || !waiting.empty(); });
            if (waiting.empty())
                return;
            {
                const auto next = std::move(waiting.front());
                waiting.pop_front();
                isBusy = true;
                lock.unlock();
                next();
            }
            lock.lock();
            isBusy = false;
            changed.notify_all();
        }
    }

    std::mutex mutex; ///< protects all members below
    std::condition_variable changed;
    std::deque<std::function<void()>> waiting;
    bool isBusy = false, isOver = false;
};

BackgroundThread::BackgroundThread() : m_queue(std::make_shared<Queue>()) {
    std::thread([queue = m_queue] {
        nameThread("background");
        queue->work();
    }).detach();
}

BackgroundThread::~BackgroundThread() {
    {
        const std::lock_guard lock(m_queue->mutex);
        m_queue->isOver = true;
    }
    m_queue->changed.notify_all();
}

void BackgroundThread::post(std::function<void()> work) {
    {
        const std::lock_guard lock(m_queue->mutex);
        m_queue->waiting.push_back(std::move(work));
    }
    m_queue->changed.notify_all();
}

bool BackgroundThread::wait(std::chrono::milliseconds bound) const {
    std::unique_lock lock(m_queue->mutex);
    return m_queue->changed.wait_for(lock, bound, [this] { return m_queue->isIdle(); });
}

} // namespace bask
