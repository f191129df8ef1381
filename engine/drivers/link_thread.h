#pragma once
// A thread of its own for one link: what a terminal of the system holds up, it holds up there.
//
// Asking a terminal whether bytes have come may take a tenth of a second on a busy machine: the kernel hands
// them over in a worker of its own, and the one who asks waits for it (Linux: n_tty_poll, flush_work). The
// engine's thread must not.

#include <QThread>
#include <QTimer>

#include <functional>

namespace bask {

class LinkThread {
public:
    /// `turn` is done there every few milliseconds between start() and stop().
    explicit LinkThread(std::function<void()> turn);
    ~LinkThread();

    /// Done there, one after the other; returns at once.
    void post(std::function<void()> task);
    void start(); ///< there only
    void stop();  ///< there only; also in a turn
    /// Waits for all that was posted, and for `last`. Nothing may be posted after it.
    void finish(const std::function<void()>& last);

private:
    static constexpr int kTurn_ms = 4;

    QThread m_thread;
    QTimer* m_timer; ///< lives on that thread
};

} // namespace bask
