#pragma once
// A thread for one link, so that a terminal of the system delays only this thread.
//
// Asking a terminal whether bytes have arrived may take a tenth of a second on a busy machine: the kernel
// passes them on in its own worker, and the caller waits for it (Linux: n_tty_poll, flush_work). The engine's
// thread must not wait.

#include <functional>
#include <memory>

namespace bask {

class LinkThread {
public:
    /// `turn` is called on the thread every few milliseconds between start() and stop().
    explicit LinkThread(std::function<void()> turn);
    ~LinkThread();

    /// Queues a task for the thread; returns at once.
    void post(std::function<void()> task);
    void start(); ///< call on the thread only
    void stop();  ///< call on the thread only; also in a turn
    /// Waits for all queued tasks, and for `last`. Nothing may be queued after it.
    void finish(const std::function<void()>& last);

private:
    struct Parts;
    std::unique_ptr<Parts> m_parts;
};

} // namespace bask
