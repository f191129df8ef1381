#pragma once
// Work that the system may keep for long (a disk, a camera that is closed), away from whoever asks for it.

#include <chrono>
#include <functional>
#include <future>
#include <memory>
#include <utility>

namespace bask {

/// Does one work after the other on a thread of its own. Nobody waits for that thread but by wait().
class BackgroundThread {
public:
    BackgroundThread();
    /// What was posted is still done, unless the process ends before.
    ~BackgroundThread();
    BackgroundThread(const BackgroundThread&) = delete;
    BackgroundThread& operator=(const BackgroundThread&) = delete;

    /// `work` owns what it uses, since it may outlive whoever posts it; it throws nothing.
    void post(std::function<void()> work);
    /// The same with an answer; see isReady().
    template <class Work> auto ask(Work work) -> std::future<decltype(work())> {
        auto task = std::make_shared<std::packaged_task<decltype(work())()>>(std::move(work));
        auto answer = task->get_future();
        post([task] { (*task)(); });
        return answer;
    }
    /// Deletes `owned` there: what its end may wait for keeps nobody else.
    template <class Owned> void dispose(std::unique_ptr<Owned> owned) {
        if (owned)
            post([last = std::shared_ptr<Owned>(std::move(owned))]() mutable { last.reset(); });
    }
    /// Returns false when not all that was posted is done after `bound`.
    bool wait(std::chrono::milliseconds bound) const;

private:
    struct Queue;
    std::shared_ptr<Queue> m_queue;
};

/// Whether an answer was asked for and is there.
template <class Answer> bool isReady(const std::future<Answer>& answer) {
    return answer.valid() && answer.wait_for(std::chrono::seconds(0)) == std::future_status::ready;
}

} // namespace bask
