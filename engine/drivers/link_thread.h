#pragma once
// A thread of its own for one link: what a terminal of the system holds up, it holds up there.
//
// Asking a terminal whether bytes have come may take a tenth of a second on a busy machine: the kernel hands
// them over in a worker of its own, and the one who asks waits for it (Linux: n_tty_poll, flush_work). The
// engine's thread must not.

#include <QObject>
#include <QThread>

#include <functional>

namespace bask {

class LinkThread {
public:
    LinkThread();
    ~LinkThread();

    /// Done there, one after the other; returns at once.
    void post(std::function<void()> task);
    /// From now on, or no more, every few milliseconds. There only.
    void repeat(std::function<void()> turn);
    /// Waits for all that was posted, and for `last`. Nothing may be posted after it.
    void finish(const std::function<void()>& last);

private:
    static constexpr int kTurn_ms = 4;

    QThread m_thread;
    QObject* m_there; ///< lives on that thread
};

} // namespace bask
