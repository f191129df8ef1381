#pragma once
// Runs work that the system may block for long (a disk, closing a camera), so that the caller does not wait.

#include <chrono>
#include <functional>
#include <future>
#include <memory>
#include <utility>

namespace bask {

/// Runs one task after the other on its own thread. Only wait() waits for that thread.
class BackgroundThread {
public:
    BackgroundThread();
    /// Posted tasks are still run, unless the process ends first.
    ~BackgroundThread();
    BackgroundThread(const BackgroundThread&) = delete;
    BackgroundThread& operator=(const BackgroundThread&) = delete;

    /// `work` must own what it uses, because it may outlive the caller, and must not throw.
    void post(std::function<void()> work);
    /// Posts work that returns an answer; see isReady().
    template <class Work> auto ask(Work work) -> std::future<decltype(work())> {
        auto task = std::make_shared<std::packaged_task<decltype(work())()>>(std::move(work));
        auto answer = task->get_future();
        post([task] { (*task)(); });
        return answer;
    }
    /// Deletes `owned` on the thread, so that a slow destructor blocks nobody else.
    template <class Owned> void dispose(std::unique_ptr<Owned> owned) {
        if (owned)
            post([last = std::shared_ptr<Owned>(std::move(owned))]() mutable { last.reset(); });
    }
    /// Returns false if not all posted tasks are done after `bound`.
    bool wait(std::chrono::milliseconds bound) const;

private:
    struct Queue;
    std::shared_ptr<Queue> m_queue;
};

/// Returns whether an answer was requested and has arrived.
template <class Answer> bool isReady(const std::future<Answer>& answer) {
    return answer.valid() && answer.wait_for(std::chrono::seconds(0)) == std::future_status::ready;
}

} // namespace bask
